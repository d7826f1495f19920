/*
 * measure.h - how hard a section is, by what its bullets did in the run that was found.
 */
#ifndef WORKBENCH_MEASURE_H
#define WORKBENCH_MEASURE_H

#include "bots.h"

struct measure {
    struct bots bots;
    uint32_t seconds100; /* hundredths of a second that the run was steered */
    uint32_t fired;      /* bullets and lasers in it */
    uint32_t most;       /* shapes at once that could hit */
    int gap;             /* tenths of a px: a ship so wide could fly through; wider ones may too. 0: not known */
    int ship;            /* tenths of a px that it is wide */
    int aimed;           /* bullets that would have hit the ship where it was as they began */
    int reaction;        /* frames from a beginning to that hit: of the aimed ones a tenth had no more; 0: none */
};

/* Of what happened in a run, while it was steered; its first place is (x, y). The bots are for the caller. */
void measure_run(struct measure *m, const struct forecast *course, fx x, fx y);

/* In hundredths. */
uint32_t measure_per_second(const struct measure *m);

/* Is this, at an easier difficulty, harder than that, at the next one? Says why in at most a line; "": no. */
void measure_compare(const struct measure *easier, const struct measure *harder, char *why, size_t size);

#endif
