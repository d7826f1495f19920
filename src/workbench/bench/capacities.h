/*
 * capacities.h - how much of the capacities in rom.lua the measured runs used, and which values are enough.
 */
#ifndef WORKBENCH_CAPACITIES_H
#define WORKBENCH_CAPACITIES_H

#include "measure.h"

enum { CAPACITIES = 15 };

struct capacity {
    const char *name;    /* in rom.lua, such as "board.bullets" */
    size_t offset;       /* of the number in struct manifest */
    int64_t limit, peak; /* limit: in rom.lua; peak: at the end of a frame, of board.lua_kib at any time */
    uint32_t refused;    /* how often the pool was full */
    int64_t enough;      /* suggested limit: a quarter more than the peak, of board.lua_kib three quarters more,
                       * never above `limit` */
    uint64_t saves;      /* bytes of RAM saved if the limit is `enough` */
};

/* Stores the capacities that the game uses; returns how many. */
int capacities_measure(const struct measure *m, struct capacity out[CAPACITIES]);

/* Returns the bytes of RAM saved if every limit is `enough`. */
uint64_t capacities_saved(const struct measure *m, const struct capacity *list, int n);

#endif
