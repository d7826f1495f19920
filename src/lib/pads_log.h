/*
 * pads_log.h - the pads of a run so far, run-length encoded in a fixed amount of memory.
 *
 * Consecutive frames with the same pads are stored as one entry: the number of frames as a varint (7 bits a byte,
 * lowest first), then a little-endian u16 for each pad. `digest` hashes the start of the run and each frame's pads, so
 * two logs with the same digest at a frame are identical up to that frame.
 */
#ifndef LIB_PADS_LOG_H
#define LIB_PADS_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/hash.h"
#include "../base/pads.h"

enum {
    PADS_LOG_RUN_BYTES = 5 + 2 * MAX_PLAYERS, /* maximum size of an entry, in bytes */
    PADS_LOG_MAX_FRAMES = 1 << 23             /* 38 hours; longer logs are rejected */
};

struct pads_log {
    uint8_t *bytes; /* the finished entries; `cap` bytes, owned by the caller */
    size_t cap, used;
    uint16_t pads[MAX_PLAYERS]; /* of the current entry */
    uint32_t run_frames;        /* frames of the current entry so far */
    uint32_t frames;            /* all frames logged */
    uint64_t digest;
    bool incomplete; /* entries were dropped, or `frames` exceeds PADS_LOG_MAX_FRAMES */
};

/* Empties the log. start_hash: a hash of how the run began. */
void pads_log_begin(struct pads_log *log, uint64_t start_hash);

void pads_log_add(struct pads_log *log, const uint16_t pads[MAX_PLAYERS]);

static inline uint64_t pads_log_update_digest(uint64_t digest, const uint16_t pads[MAX_PLAYERS])
{
    return hash_fold(digest, (uint64_t)pads[0] << 16 | pads[1]);
}

/* Writes the whole log to out, at most log->cap + PADS_LOG_RUN_BYTES bytes; returns the number written. */
size_t pads_log_write(const struct pads_log *log, uint8_t *out);

/* Reads the entries of a log: first the finished ones, then the current one. */
struct pads_reader {
    const uint8_t *at, *end;
    uint16_t last_pads[MAX_PLAYERS];
    uint32_t last_frames; /* frames of the log's current entry; 0: none, or already read */
    uint16_t pads[MAX_PLAYERS];
    uint32_t frames; /* frames of the last entry read */
};
struct pads_reader pads_log_reader(const struct pads_log *log);

/* Reads the next entry. Returns false at the end, or when the bytes are invalid (then at != end). */
bool pads_reader_next(struct pads_reader *r);

#endif
