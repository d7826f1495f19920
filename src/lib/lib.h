/*
 * lib.h - the insides of libcurtain: a board, its memory, and its past.
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
    LIB_STATE_ROOM = 128 << 10, /* what config.state_room and config.snapshots are when they are 0 */
    LIB_SNAPSHOTS = 16,
    LIB_MOST_SNAPSHOTS = 4096,
    LIB_KEY = 600 /* frames between snapshots that are taken on the way */
};

/* A frame that can be come back to: that of `frame` ticks after which the log had that digest. */
struct lib_snapshot {
    uint32_t frame;
    uint64_t digest;
    uint64_t used; /* when it was last wanted, 0: it is empty */
    uint8_t *at;
};

/* How a run begins, all of it; what board_start points to lies in `nvram`. */
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
    uint8_t *ram, *scratch, *tables; /* tables NULL: the game is silent */
    size_t ram_size;
    struct fb fb;
    uint32_t rgb[256];
    bool drawn;    /* fb and rgb are of this frame */
    bool sounding; /* lr is of this frame */
    size_t taken;  /* of lr, frames */
    int16_t lr[2 * BOARD_SOUND];
    uint32_t writes;               /* to nvram, as last told */
    bool saved;                    /* nvram is another since then: a state has brought its own */
    struct demo demo;              /* that plays: frames 0: none */
    struct pads_log log, other;    /* of this run; room for that of a state that is being loaded */
    struct lib_snapshot *snapshot; /* n of them: the first keys are taken on the way, the others with states */
    uint32_t n, keys;
    uint64_t clock; /* counts what snapshots are wanted for */
    uint8_t *before,
        *before_out; /* a snapshot, and what the last frame handed out: should a state turn out to be bad */
    char log_text[LOG_BYTES + 4096];
    char fault[sizeof(struct board_fault)];
};

/* ---- start.c ---- */

/* The start that a configuration asks for, or that of a demo, NULL: there is none. False and a sentence for one the
 * game does not have. */
bool lib_start_of(struct lib_start *out, const struct cart *cart, const struct curtain_config *config,
                  const struct demo *demo, char *err, size_t err_size);

/* As bytes: how many at most, writing them, and reading them. */
size_t lib_start_room(const struct lib_start *s);
size_t lib_start_write(const struct lib_start *s, uint8_t *out);
bool lib_start_read(struct lib_start *out, const uint8_t *bytes, size_t size);

/* ---- curtain.c ---- */

/* Powers the board anew from c->begin. False: it cannot start Lua. */
bool lib_power(struct curtain *c, char *err, size_t err_size);

/* ---- states.c ---- */

/* Keeps the frame that is, if one is due on the way. */
void lib_keep_key(struct curtain *c);

#endif
