/*
 * rewind.h - the past of a run: key frames and the pads between them, in a fixed budget of memory, so that frames that
 * were can be brought back.
 *
 * A key frame is a snapshot. To go back to a frame, the key frame at or before it is restored and the pads since are
 * ticked again; the board is deterministic, so what comes is that frame. Key frames lie close together near the present
 * and ever farther apart away from it. Going back into a gap puts key frames into it, so that a run played backwards
 * costs each gap once and not once a frame.
 *
 * Frames are counted as board_frame does. The past ends where pads were pushed last; what is beyond the present is
 * there until other pads than those that led to it are pushed.
 */
#ifndef CAB_REWIND_H
#define CAB_REWIND_H

#include "../../board/board.h"

enum {
    REWIND_KEYS = 1024, /* key frames at most */
    REWIND_APART = 60,  /* frames between two key frames when they are taken, at most */
    REWIND_BYTES = 64 << 20
};

struct rewind_key {
    uint32_t frame;
    size_t room; /* bytes at `at` */
    void *block; /* malloc; `at` is the 64-byte aligned part of it */
    uint8_t *at;
};

struct rewind {
    size_t budget; /* bytes of key frames and pads; one key frame is kept whatever it takes */
    size_t held;   /* bytes that are */
    int n;
    struct rewind_key key[REWIND_KEYS]; /* ascending */
    uint32_t end;                       /* pads are there of frames from the first key frame's to before this */
    uint16_t (*pads)[MAX_PLAYERS];      /* of frame f: entry f modulo room, a power of two */
    uint32_t pads_room;
    uint32_t apart; /* frames between key frames, for the size of a snapshot */
    uint64_t again; /* ticks that rewind_to has run so far */
};

/* An empty past that may grow to `budget` bytes; 0: one key frame, no older than REWIND_APART frames. Takes no memory
 * yet. */
void rewind_open(struct rewind *r, size_t budget);

/* Gives the memory back. Harmless on one of zeroes, or twice. */
void rewind_close(struct rewind *r);

/* Call it before each tick: `pads` are what the tick will get. Takes a key frame when one is due. What was after the
 * present is forgotten, unless it began with the same pads; so is everything when the board is at a frame that is not
 * of this past. False: there is no memory for one key frame, nothing is remembered. */
bool rewind_push(struct rewind *r, const struct board *b, const uint16_t pads[MAX_PLAYERS]);

/* The frames that can be brought back are first to end, both included, but for one whose tick ended in a fault. */
uint32_t rewind_first(const struct rewind *r);
uint32_t rewind_end(const struct rewind *r);

/* The pads of the tick after a frame of it, but the last. */
const uint16_t *rewind_pads(const struct rewind *r, uint32_t frame);

/* Brings the board to a frame of its past, from any other, from a fault too. False: no such frame, and nothing was
 * done; or a tick on the way ended in a fault, as it did before, which stands in board_last_output. What ticks on the
 * way hand out is lost. */
bool rewind_to(struct rewind *r, struct board *b, uint32_t frame);

/* Forgets what is after frame `present`; all of it when that is before the first. */
void rewind_drop(struct rewind *r, uint32_t present);

/* Forgets everything: the board was changed by other means than ticks. */
void rewind_forget(struct rewind *r);

#endif
