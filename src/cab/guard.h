/*
 * guard.h - a board with a watchman: it owns the RAM, and finds endless loops without counting every instruction.
 * floor: cab    used by: cab, cli, everything that runs a board
 *
 * Counting a tick's VM instructions costs up to 2.3 times on tight loops, so it is done only when a tick takes
 * suspiciously long: plat_alarm interrupts it, the guard goes back to its last key frame and runs the frames since
 * again, counting. Over 10^9 in one tick is FAULT_LOOP; under it the machine is only slow, and the run goes on as if
 * nothing had happened. The clock decides whether to look, never what is found. Loading always counts, and so does a
 * host without alarms.
 */
#ifndef CAB_GUARD_H
#define CAB_GUARD_H

#include "../board/board.h"

/* A tick that runs longer is looked at. Tests of the guards lower it. */
#ifndef GUARD_MS
#define GUARD_MS 1000
#endif

enum { GUARD_KEY = 60 /* frames between key frames */ };

struct guard {
    const struct rom *rom;
    struct board *board;
    void *block; /* malloc; RAM is the 16-byte aligned part of it */
    void *ram;
    size_t ram_size;
    uint8_t *key; /* the last key frame; key_cap bytes are there */
    size_t key_cap;
    uint16_t pads[GUARD_KEY][PADS]; /* of the frames since */
    int since;
    bool counting; /* until the next key frame */
    int ms;        /* GUARD_MS; tests lower it */
    uint32_t interrupts;
};

/* Takes RAM and powers a board in it. False and one sentence for a ROM that cannot run or too little memory; a script
 * fault stands in board_last(g->board)->fault as after board_power. The ROM must outlive the guard. */
bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size);

/* board_tick, and never FAULT_INTERRUPTED. */
const struct board_out *guard_tick(struct guard *g, const uint16_t pads[PADS]);

/* Takes a key frame here: call it after board_restore or anything else that changed the board between frames. */
void guard_mark(struct guard *g);

/* Gives the RAM back. Harmless on a guard of zeroes, or twice. */
void guard_close(struct guard *g);

#endif
