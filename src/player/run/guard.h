/*
 * guard.h - a board, its RAM, and its past if that is wanted.
 */
#ifndef PLAYER_GUARD_H
#define PLAYER_GUARD_H

#include "../../board/board.h"
#include "../../demo/rewind.h"

enum { GUARD_PAST_MIB = 64 };

struct guard {
    const struct rom *rom;
    struct board *board;
    void *block; /* malloc; RAM is the 64-byte aligned part of it */
    void *ram;
    size_t ram_size;
    struct rewind *past;           /* NULL before guard_remember */
    void (*before)(void *context); /* called before each tick; may be NULL */
    void *context;
};

/* Takes RAM and powers a board in it. False and one sentence for a ROM that cannot run or too little memory; a script
 * fault is in board_last_output(g->board)->fault, as after board_power_on. The ROM must outlive the guard. */
bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size);

/* The same once more, in the RAM that guard_power took: for one run after another of the same ROM. Without a board
 * afterwards the guard is closed. */
bool guard_again(struct guard *g, const struct board_start *start, char *err, size_t err_size);

/* board_tick, which the past remembers. */
const struct board_out *guard_tick(struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Ticks once for a caller that has a snapshot and restores it: the past does not remember this tick, and nobody
 * measures its phases. False: the tick ended in a fault. */
bool guard_ahead(struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Stores the past from now on, for guard_back. Returns false when out of memory. Call rewind_forget after anything
 * other than a tick has changed the board, also after guard_again. */
bool guard_remember(struct guard *g);

/* Back to a frame of the past, as rewind_to says. */
bool guard_back(struct guard *g, uint32_t frame);

/* Gives the RAM back. Harmless on a guard of zeroes, or twice. */
void guard_close(struct guard *g);

#endif
