/*
 * pads_log.h - the pads of a run so far: in runs, in memory of a fixed size.
 *
 * A run of frames with the same pads is a varint, how many (7 bits a byte, lowest first), and a u16 of each pad,
 * little-endian. digest folds how the run began and each frame's pads, so that two logs with the same digest at a frame
 * are the same up to it.
 */
#ifndef LIB_PADS_LOG_H
#define LIB_PADS_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/hash.h"
#include "../base/pads.h"

enum {
    PADS_LOG_RUN = 5 + 2 * PADS, /* bytes a run takes at most */
    PADS_LOG_FRAMES = 1 << 23    /* 38 hours: more are not read */
};

struct pads_log {
    uint8_t *bytes; /* `room` of them, the caller's: runs that are over */
    size_t room, used;
    uint16_t pads[PADS]; /* of the run that goes on, */
    uint32_t run;        /* so many frames so far */
    uint32_t frames;     /* in all */
    uint64_t digest;
    bool full; /* runs were lost: it says no more what was played */
};

/* Empties it. start: a hash of how the run began. */
void pads_log_begin(struct pads_log *log, uint64_t start);

void pads_log_add(struct pads_log *log, const uint16_t pads[PADS]);

static inline uint64_t pads_log_fold(uint64_t digest, const uint16_t pads[PADS])
{
    return hash_fold(digest, (uint64_t)pads[0] << 16 | pads[1]);
}

/* All of it as bytes, at most log->room + PADS_LOG_RUN; returns how many. */
size_t pads_log_write(const struct pads_log *log, uint8_t *out);

/* Reading such bytes, and behind them a run that goes on. */
struct pads_run {
    const uint8_t *at, *end;
    uint16_t last_pads[PADS];
    uint32_t last; /* frames of that one; 0: there is none */
    uint16_t pads[PADS];
    uint32_t frames; /* of the run that was read last */
};
struct pads_run pads_log_read(const struct pads_log *log);

/* The next run; false: there is none, or, with at != end, what stands there is none. */
bool pads_run_next(struct pads_run *r);

#endif
