/*
 * rooms.h - what of the capacities in rom.lua runs of a game used, and what would do.
 */
#ifndef WORKBENCH_ROOMS_H
#define WORKBENCH_ROOMS_H

#include "measure.h"

enum { ROOMS = 15 };

struct room {
    const char *name;    /* as rom.lua has it: "board.bullets" */
    size_t offset;       /* of the number in struct manifest */
    int64_t asked, most; /* most: that were there at the end of a frame; of board.lua_kib at any time */
    uint32_t refused;    /* how often there was no room */
    int64_t would_do; /* the same runs would go as they did, with a quarter more than was used, of board.lua_kib three
                       * quarters more; never more than asked */
    uint64_t saves;   /* bytes of RAM, with would_do in place of asked */
};

/* Those that the game has; returns how many. */
int rooms_of(const struct measure *m, struct room out[ROOMS]);

/* Bytes of RAM that all would_do together save. */
uint64_t rooms_saved(const struct measure *m, const struct room *room, int n);

#endif
