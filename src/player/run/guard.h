/*
 * guard.h - owns a running board, its RAM and, if requested, its past.
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
    struct rewind *past;           /* NULL before guard_store_past */
    void (*before)(void *context); /* called before each tick; may be NULL */
    void *context;
};

/* Allocates RAM and powers on a board in it. Returns false and sets err if the ROM cannot run or memory is short. A
 * script fault is in board_last_output(g->board)->fault, as after board_power_on. The ROM must outlive the guard. */
bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size);

/* Like guard_power, but reuses the RAM, for another run of the same ROM. On failure, closes the guard. */
bool guard_restart(struct guard *g, const struct board_start *start, char *err, size_t err_size);

/* Calls board_tick, and stores the tick in the past. */
const struct board_out *guard_tick(struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Ticks once for a caller that restores a snapshot afterwards: the tick is not stored in the past, and its phases are
 * not measured. Returns false if the tick faulted. */
bool guard_tick_ahead(struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Stores the past from now on, for guard_rewind. Returns false when out of memory. Call rewind_forget after anything
 * other than a tick has changed the board, including guard_restart. */
bool guard_store_past(struct guard *g);

/* Goes back to a frame of the past (rewind_to). */
bool guard_rewind(struct guard *g, uint32_t frame);

/* Frees the RAM. Does nothing if *g is zeroed. */
void guard_close(struct guard *g);

#endif
