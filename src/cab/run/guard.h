/*
 * guard.h - a board, its RAM and its past; endless loops are found without counting every instruction.
 * floor: cab
 *
 * Counting a tick's VM instructions costs up to 2.3 times on tight loops, so it is done only when a tick takes
 * suspiciously long: plat_alarm interrupts it, the guard goes back to the last key frame of its past and runs the
 * frames since again, counting. Over 2 * 10^8 in one tick is FAULT_LOOP (a server of 2.6 GHz takes 0.6 s for so many);
 * under it the machine is only slow, and the run goes on as if nothing had happened. The clock decides whether to look,
 * never what is found. Loading always counts, and so does a host without alarms.
 */
#ifndef CAB_GUARD_H
#define CAB_GUARD_H

#include "../../board/board.h"
#include "rewind.h"

/* A tick that runs longer is looked at. Tests of the guards lower it. */
#ifndef GUARD_MS
#define GUARD_MS 200
#endif

enum { GUARD_COUNTS = 60 /* frames, once a tick was interrupted */ };

struct guard {
    const struct rom *rom;
    struct board *board;
    void *block; /* malloc; RAM is the 64-byte aligned part of it */
    void *ram;
    size_t ram_size;
    struct rewind past; /* one key frame, unless guard_remember said more */
    bool counting;
    int counts; /* frames left to count */
    int ms;     /* GUARD_MS; tests lower it */
    uint32_t interrupts;
    void (*before)(void *context); /* called before each tick; may be NULL */
    void *context;
};

/* Takes RAM and powers a board in it. False and one sentence for a ROM that cannot run or too little memory; a script
 * fault stands in board_last(g->board)->fault as after board_power. The ROM must outlive the guard. */
bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size);

/* The same once more, in the RAM that guard_power took: for one run after another of the same ROM. Without a board
 * afterwards the guard is closed. */
bool guard_again(struct guard *g, const struct board_start *start, char *err, size_t err_size);

/* board_tick, and never FAULT_INTERRUPTED. */
const struct board_out *guard_tick(struct guard *g, const uint16_t pads[PADS]);

/* Ticks once for somebody who has a snapshot and goes back to it: the past is not told, and nobody measures the phases.
 * False: the tick faulted, or it takes too long. */
bool guard_ahead(struct guard *g, const uint16_t pads[PADS]);

/* Forgets the past: call it after board_restore or anything else that changed the board between frames. */
void guard_forget(struct guard *g);

/* Keeps so many bytes of past from now on, for guard_back. */
void guard_remember(struct guard *g, size_t bytes);

/* Back to a frame of the past, as rewind_to says. */
bool guard_back(struct guard *g, uint32_t frame);

/* Gives the RAM back. Harmless on a guard of zeroes, or twice. */
void guard_close(struct guard *g);

#endif
