/*
 * lib.h - libcurtain internals: a board, its memory, and its history.
 */
#ifndef LIB_H
#define LIB_H

#include "../board/board.h"
#include "../rom/cart.h"
#include "../demo/demo.h"
#include "../demo/rewind.h"
#include "curtain.h"
#include "pads_log.h"

enum {
    LIB_ALIGN = 64,
    LIB_DEFAULT_STATE_BYTES = 128 << 10, /* defaults for config.state_room and config.snapshots */
    LIB_DEFAULT_SNAPSHOTS = 16,
    LIB_MAX_SNAPSHOTS = 4096,
    LIB_KEY_SNAPSHOT_INTERVAL = 600 /* frames between key snapshots, which are taken during play */
};

/* Everything that determines how a run starts. start.nvram points to `nvram`, or is NULL. */
struct lib_start {
    struct board_start start;
    uint8_t *nvram; /* `nvram_cap` bytes */
    size_t nvram_cap;
    uint64_t hash;
};

struct curtain {
    struct rom rom;
    struct cart cart;
    uint64_t game_hash;
    struct lib_start run_start, state_start; /* start of this run; buffer for the start in a state that is being read */
    struct board *board;
    uint8_t *ram, *scratch, *sound_tables; /* sound_tables NULL: the game has no sound */
    size_t ram_size;
    struct fb fb;
    uint32_t rgb[256];
    bool drawn;         /* fb and rgb hold this frame */
    bool mixed;         /* lr holds this frame's sound */
    size_t frames_read; /* stereo frames of lr the host has read */
    int16_t lr[2 * BOARD_SOUND_FRAMES];
    uint32_t nvram_writes;                /* number of writes to nvram when last checked */
    bool nvram_changed;                   /* loading a state has changed nvram, which the next frame reports */
    struct demo demo;                     /* the demo that is playing; frames 0: none */
    struct pads_log run_pads, state_pads; /* log of this run; buffer for the log of a state that is being loaded */
    struct rewind *past;                  /* snapshots, of any run; identified by the digest of the pads log */
    uint8_t *backup, *backup_output;      /* snapshot and output of the current frame, restored after curtain_demo and
                                           * when a load fails */
    char log_text[LOG_BYTES + 4096];
    char fault[sizeof(struct board_fault)];
};

/* ---- start.c ---- */

/* Fills in the start the configuration asks for, or the demo's start if demo is not NULL. Returns false and sets err
 * for a start the game does not support. */
bool lib_start_init(struct lib_start *out, const struct cart *cart, const struct curtain_config *config,
                    const struct demo *demo, char *err, size_t err_size);

/* The start in serialized form. lib_start_max_size returns its maximum size in bytes, lib_start_serialize the size
 * written. lib_start_read returns false when the bytes are not a valid start. */
size_t lib_start_max_size(const struct lib_start *s);
size_t lib_start_serialize(const struct lib_start *s, uint8_t *out);
bool lib_start_read(struct lib_start *out, const uint8_t *bytes, size_t size);

/* ---- curtain.c ---- */

/* Powers the board up from c->run_start. Returns false and sets err when Lua cannot start. */
bool lib_power_on(struct curtain *c, char *err, size_t err_size);

/* ---- states.c ---- */

/* Takes a key snapshot of the current frame if one is due (every LIB_KEY_SNAPSHOT_INTERVAL frames). */
void lib_take_key_snapshot(struct curtain *c);

#endif
