/*
 * capacities.h - how much of the capacities in rom.lua the measured runs used, and which values are enough.
 */
#ifndef WORKBENCH_CAPACITIES_H
#define WORKBENCH_CAPACITIES_H

#include "measure.h"

enum { CAPACITIES = 15 };

struct capacity {
    const char *name;    /* in rom.lua: "board.bullets" */
    size_t offset;       /* of the number in struct manifest */
    int64_t asked, most; /* asked: in rom.lua; most: the peak at the end of a frame, of board.lua_kib at any time */
    uint32_t refused;    /* how often the pool was full */
    int64_t would_do; /* enough for the same runs: a quarter more than the peak, three quarters more of board.lua_kib,
                       * never more than asked */
    uint64_t saves;   /* bytes of RAM that would_do saves */
};

/* Stores the capacities that the game has; returns how many. */
int capacities_measure(const struct measure *m, struct capacity out[CAPACITIES]);

/* Returns the bytes of RAM that all would_do together save. */
uint64_t capacities_save(const struct measure *m, const struct capacity *room, int n);

#endif
