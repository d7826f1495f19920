/*
 * rewind.h - the past of a run, in one block of memory: snapshots (key frames), and the pads between them.
 *
 * To go back to a frame, the last key frame before it is restored and the pads since then are ticked again; the board
 * is deterministic, so the result is that frame. A key frame is identified by its frame number and a digest of the run
 * up to it. When the memory is full, the key frame is removed whose removal leaves the smallest gap relative to the
 * gap's distance from the present, so gaps grow with age. The first key frame is removed only when every gap is as
 * large as its distance, or when there is no memory for the pads since then. Key frames that were used recently stay
 * (`recent` of rewind_open).
 *
 * A caller with a single line of history (the program) calls rewind_push before each tick, then rewind_to; the digest
 * of its key frames is 0. A caller that switches between runs and has their pads (libcurtain) calls rewind_add,
 * rewind_find and rewind_restore. Frames are counted as by board_frame.
 */
#ifndef DEMO_REWIND_H
#define DEMO_REWIND_H

#include "../board/board.h"

enum { REWIND_APART = 60 }; /* most frames between two key frames when rewind_push takes them */

struct rewind_key {
    uint32_t frame;
    uint32_t slot; /* of the snapshot */
    uint64_t digest;
    uint64_t last_used; /* value of `uses`; 0: never */
};

struct rewind {
    size_t size;            /* of the whole block, in bytes */
    struct rewind_key *key; /* n of them, with ascending frames; then entries for the free slots, `slots` in all */
    uint32_t n, slots, max_keys;
    uint32_t recent;
    uint64_t uses;      /* counts uses of key frames */
    uint8_t *snapshots; /* the slots */
    size_t slot_size;
    uint32_t end;                  /* the last frame of the past */
    uint16_t (*pads)[MAX_PLAYERS]; /* of frame f before the end: entry f modulo pads_cap, a power of two */
    uint32_t pads_cap;
    uint32_t apart;    /* frames between key frames, for the size of a snapshot */
    uint64_t replayed; /* ticks that rewind_to has run */
};

/* Turns memory, aligned for any type, into an empty past. The `recent` key frames that were used last are removed
 * only when there is no other. Memory that isn't needed yet isn't written. */
struct rewind *rewind_open(void *memory, size_t size, uint32_t recent);

/* ---- one line of history ---- */

/* Stores the pads that the next tick will get, and takes a key frame when one is due. Frames after the present are
 * dropped unless they began with the same pads; everything is dropped when the board is at a frame after the end of
 * the past. Returns false when there is no memory for a single key frame; then nothing is stored. */
bool rewind_push(struct rewind *r, const struct board *b, const uint16_t pads[MAX_PLAYERS]);

/* rewind_to reaches all frames from the first to the end, except one whose tick ended in a fault. */
uint32_t rewind_first(const struct rewind *r);
uint32_t rewind_end(const struct rewind *r);

/* Returns the pads of the tick after `frame`, which is before the end. */
const uint16_t *rewind_pads(const struct rewind *r, uint32_t frame);

/* Takes the board to a frame of its past, from any other frame, even after a fault. Returns false when there is no such
 * frame, and changes nothing; or when a tick on the way faults, as it did before. Output of the ticks on the way is
 * lost. Going back into a gap takes key frames in it, so playing backwards replays each gap once. */
bool rewind_to(struct rewind *r, struct board *b, uint32_t frame);

/* Drops the whole past of a board that was changed by other means than ticks and is now at frame `present`. */
void rewind_forget(struct rewind *r, uint32_t present);

/* ---- key frames ---- */

/* Takes a key frame of the board, unless there is one with this digest or no memory for it. is_use: counts as a use of
 * the key frame. */
void rewind_add(struct rewind *r, const struct board *b, uint64_t digest, bool is_use);

/* Returns the key frame, valid until the next rewind_add, or NULL. */
struct rewind_key *rewind_find(const struct rewind *r, uint32_t frame, uint64_t digest);

void rewind_restore(struct rewind *r, struct rewind_key *k, struct board *b);

#endif
