/*
 * replay.h - a demo played again and compared, frame by frame, with what it was recorded with.
 */
#ifndef PLAYER_REPLAY_H
#define PLAYER_REPLAY_H

#include "../rom/cart.h"
#include "../demo/demo.h"
#include "../common/result.h"
#include "run/guard.h"

enum verdict_kind {
    VERDICT_HOLDS,    /* every checksum and row, and the fault if it ends in one */
    VERDICT_DIFFERS,  /* .parts */
    VERDICT_FAULT,    /* a fault that is not in the demo */
    VERDICT_NO_FAULT, /* the fault it was recorded with does not happen */
};

struct verdict {
    enum verdict_kind kind;
    uint32_t first, frame; /* it happened in one of these frames; the same where each frame has checksums */
    uint64_t parts;        /* VERDICT_DIFFERS: of the demo's parts, 1 << part */
    uint64_t missing;      /* those of them that this build's board does not have */
};

struct replay {
    struct guard guard;         /* the board as it was at the verdict; its RAM is kept from one replay to the next */
    void *hash_cache;           /* of board_hashes_cached */
    uint64_t board[MAX_PARTS];  /* hashes in the order of the board's parts */
    uint64_t hashes[MAX_PARTS]; /* the same in the order of the demo's; 0 for what is missing */
    enum demo_checksum_rate prints; /* of what is recorded again; DEMO_CHECKSUMS_AUTO: as the demo has them */
    int difficulty;                 /* of the last game in it, an index; before one, of its start */
    void (*ticked)(void *context, uint32_t frame); /* called after each tick; may be NULL */
    void *context;
};

/* Plays d, which fits the cart (demo_check_cart), until its end or the first frame that differs. again: records the
 * replay in memory, for it to be saved in the newest format; may be NULL. Returns RESULT_DONE, or with one sentence
 * RESULT_REFUSED (its board cannot be powered) or RESULT_HOST_FAILED (no memory). r is zeroes before the first replay;
 * all replays of a struct are of one ROM. */
enum result replay_run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                       struct verdict *v, char *err, size_t err_size);

/* A replay on to the end, whatever differs on the way. */
struct rerun {
    struct verdict first; /* what replay_run would have said */
    struct verdict end;   /* VERDICT_HOLDS: it has all its frames, and the fault if it ends in one; else how it ended */
    bool held; /* the part with the points was as recorded in frame .alike, and in none after it is that known */
    uint32_t alike;
    int64_t points[MAX_PLAYERS]; /* in that frame */
};

/* The same, of a replay that goes on to the demo's end or a fault. */
enum result replay_whole(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                         struct rerun *o, char *err, size_t err_size);

/* A verdict as words: "frame 12: input, player differ", "holds, 600 frames". r is as the verdict left it. */
void replay_text(const struct replay *r, const struct demo *d, const struct verdict *v, char *out, size_t size);

/* The fault the board is in, or NULL. */
const struct board_fault *replay_fault(const struct replay *r);

/* Gives the RAM back; harmless on zeroes. */
void replay_close(struct replay *r);

#endif
