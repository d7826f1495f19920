/*
 * lib.h - libcurtain internals: a board, its memory, and its history.
 */
#ifndef LIB_H
#define LIB_H

#include "../board/board.h"
#include "../rom/cart.h"
#include "../demo/demo.h"
#include "curtain.h"
#include "pads_log.h"

enum {
    LIB_ALIGN = 64,
    LIB_STATE_ROOM = 128 << 10, /* defaults for config.state_room and config.snapshots */
    LIB_SNAPSHOTS = 16,
    LIB_MOST_SNAPSHOTS = 4096,
    LIB_KEY = 600 /* frames between snapshots taken along the way */
};

/* A saved frame: the board after `frame` ticks, when the pads log had this digest. */
struct lib_snapshot {
    uint32_t frame;
    uint64_t digest;
    uint64_t used; /* value of `clock` at its last use; 0: empty slot */
    uint8_t *at;
};

/* How a run starts, in full; pointers in board_start point into `nvram`. */
struct lib_start {
    struct board_start start;
    uint8_t *nvram; /* `room` bytes */
    size_t room;
    uint64_t hash;
};

struct curtain {
    struct rom rom;
    struct cart cart;
    uint64_t game_hash;
    struct lib_start begin, spare; /* of this run; of a state that is being read */
    struct board *board;
    uint8_t *ram, *scratch, *tables; /* tables NULL: the game has no sound */
    size_t ram_size;
    struct fb fb;
    uint32_t rgb[256];
    bool drawn;    /* fb and rgb hold this frame */
    bool sounding; /* lr holds this frame's sound */
    size_t taken;  /* stereo frames of lr the host has read */
    int16_t lr[2 * BOARD_SOUND];
    uint32_t writes;               /* writes to nvram, as last reported */
    bool saved;                    /* nvram changed since then, because a state restored its own */
    struct demo demo;              /* the demo that is playing; frames 0: none */
    struct pads_log log, other;    /* of this run; buffer for the log of a state that is being loaded */
    struct lib_snapshot *snapshot; /* n of them: the first `keys` are taken along the way, the rest with saved states */
    uint32_t n, keys;
    uint64_t clock; /* counts uses of snapshots */
    uint8_t *before,
        *before_out; /* a snapshot and the last frame's output, to restore when a state turns out to be bad */
    char log_text[LOG_BYTES + 4096];
    char fault[sizeof(struct board_fault)];
};

/* ---- start.c ---- */

/* Fills in the start the configuration asks for, or the demo's start if demo is not NULL. Returns false and sets err
 * for a start the game does not support. */
bool lib_start_of(struct lib_start *out, const struct cart *cart, const struct curtain_config *config,
                  const struct demo *demo, char *err, size_t err_size);

/* The start as bytes: its maximum size, writing it, and reading it. */
size_t lib_start_room(const struct lib_start *s);
size_t lib_start_write(const struct lib_start *s, uint8_t *out);
bool lib_start_read(struct lib_start *out, const uint8_t *bytes, size_t size);

/* ---- curtain.c ---- */

/* Powers the board up again from c->begin. Returns false when Lua cannot start. */
bool lib_power(struct curtain *c, char *err, size_t err_size);

/* ---- states.c ---- */

/* Takes a snapshot of the current frame, if one is due along the way. */
void lib_keep_key(struct curtain *c);

#endif
