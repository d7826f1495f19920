/*
 * replay.h - plays a demo again and compares each frame with the recording.
 */
#ifndef PLAYER_REPLAY_H
#define PLAYER_REPLAY_H

#include "../rom/cart.h"
#include "../demo/demo.h"
#include "../common/result.h"
#include "run/guard.h"

enum verdict_kind {
    VERDICT_HOLDS,    /* all checksums and rows match, and the recorded fault occurs */
    VERDICT_DIFFERS,  /* the parts .parts differ */
    VERDICT_FAULT,    /* a fault that is not in the demo */
    VERDICT_NO_FAULT, /* the recorded fault does not occur */
};

struct verdict {
    enum verdict_kind kind;
    uint32_t first, frame; /* the difference began in one of these frames; equal if every frame has checksums */
    uint64_t parts;        /* VERDICT_DIFFERS: the demo's parts, 1 << part */
    uint64_t missing;      /* those parts that this build's board does not have */
};

struct replay {
    struct guard guard;         /* the board at the time of the verdict; its RAM is reused by the next replay */
    void *hash_cache;           /* for board_hashes_cached */
    uint64_t board[MAX_PARTS];  /* hashes in the order of the board's parts */
    uint64_t hashes[MAX_PARTS]; /* hashes in the order of the demo's parts; 0 for missing parts */
    enum demo_checksum_rate checksum_rate;         /* of a new recording; DEMO_CHECKSUMS_AUTO: that of the demo */
    int difficulty;                                /* index; of the last game, or at power-on if there was no game */
    void (*ticked)(void *context, uint32_t frame); /* called after each tick; may be NULL */
    void *context;
};

/* Plays d, which must match the cart (demo_check_cart), until its end or the first frame that differs. again: records
 * the replay in memory in the newest format; may be NULL. Returns RESULT_DONE, or sets err and returns RESULT_REFUSED
 * (the board cannot be powered on) or RESULT_HOST_FAILED (out of memory). Zero *r before the first replay; all replays
 * with the same *r must use the same ROM. */
enum result replay_run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                       struct verdict *v, char *err, size_t err_size);

/* The result of replay_whole. */
struct rerun {
    struct verdict first; /* the verdict that replay_run would have returned */
    struct verdict end;   /* how the replay ended; VERDICT_HOLDS: it has all frames, and the recorded fault */
    bool held;            /* the part with the points matches the recording up to frame held_until */
    uint32_t held_until;
    int64_t points[MAX_PLAYERS]; /* in that frame */
};

/* Like replay_run, but continues after a difference, to the demo's end or a fault. */
enum result replay_whole(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                         struct rerun *o, char *err, size_t err_size);

/* Writes a verdict as text: "frame 12: input, player differ", "holds, 600 frames". r must not have been used since. */
void replay_text(const struct replay *r, const struct demo *d, const struct verdict *v, char *out, size_t size);

/* Returns the board's fault, or NULL. */
const struct board_fault *replay_fault(const struct replay *r);

/* Frees the RAM. Does nothing if *r is zeroed. */
void replay_close(struct replay *r);

#endif
