/*
 * measure.h - how hard a section is, measured by the bullets in the run that was found.
 */
#ifndef WORKBENCH_MEASURE_H
#define WORKBENCH_MEASURE_H

#include "bots.h"

struct measure {
    struct bots bots;
    uint32_t seconds100; /* length in hundredths of a second, from when the ship could be steered */
    uint32_t fired;      /* bullets and lasers */
    uint32_t most;       /* maximum number of dangerous shapes at a time */
    int gap;             /* tenths of a px: a ship of this width has a path; a wider ship may have one. 0: unknown */
    int ship;            /* width of the ship in tenths of a px */
    int aimed;           /* bullets that would have hit the ship at its position when they spawned */
    int reaction;        /* 10th percentile of the frames from spawn to hit of these bullets; 0: none */
};

/* Measures a run by its forecast; the ship starts at (x, y). Doesn't set `bots`. */
void measure_run(struct measure *m, const struct forecast *course, fx x, fx y);

/* Returns bullets per second in hundredths. */
uint32_t measure_per_second(const struct measure *m);

/* Writes why the easier difficulty is harder than the next one; "": it is not. */
void measure_compare(const struct measure *easier, const struct measure *harder, char *why, size_t size);

#endif
