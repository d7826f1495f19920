/*
 * states.c - states (the start of a run and its pads), and the snapshots held in this process.
 *
 *      0  "CURTAINS"                    24  u32 frames             48  u32 CRC32 of all from byte 56 on
 *      8  u32 format (1)                28  u32 bytes of the start 52  u32 CRC32 of the first 52 bytes
 *     12  u32 core version              32  u32 bytes of the pads  56  the start (start.c)
 *     16  u64 game hash of the ROM      40  u64 state hash             the pads (pads_log.h)
 *                                          (36: u32 zero)
 *
 * Little-endian. A snapshot is identified by its frame and by the digest of the start and the pads up to that frame.
 * The board is deterministic, so a snapshot that matches both is that frame, whichever run it was taken in.
 */
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/hash.h"
#include "lib.h"

enum { HEAD = 56, FORMAT = 1 };
static const uint8_t magic[8] = { 'C', 'U', 'R', 'T', 'A', 'I', 'N', 'S' };

/* ---- snapshots ---- */

static struct lib_snapshot *find(struct curtain *c, uint32_t frame, uint64_t digest)
{
    for (uint32_t i = 0; i < c->n; i++) {
        struct lib_snapshot *s = &c->snapshot[i];
        if (s->used > 0 && s->frame == frame && s->digest == digest)
            return s;
    }
    return NULL;
}

/* Returns the least recently used snapshot in from..to - 1. */
static struct lib_snapshot *oldest(struct curtain *c, uint32_t from, uint32_t to)
{
    struct lib_snapshot *best = NULL;

    for (uint32_t i = from; i < to; i++)
        if (!best || c->snapshot[i].used < best->used)
            best = &c->snapshot[i];
    return best;
}

/* Returns the key snapshot to replace: an empty one, or one of a later frame than `present`, if there is one; otherwise
 * the one with the smallest gap between its neighbours relative to its age, so that gaps between snapshots grow with
 * age. */
static struct lib_snapshot *least_missed(struct curtain *c, uint32_t present)
{
    struct lib_snapshot *best = NULL;
    uint64_t best_gap = 0, best_far = 1;

    for (uint32_t i = 0; i < c->keys; i++) {
        struct lib_snapshot *s = &c->snapshot[i];
        uint32_t before = 0, after = present;
        if (s->used == 0 || s->frame > present)
            return s;
        for (uint32_t k = 0; k < c->keys; k++) {
            const uint32_t frame = c->snapshot[k].frame;
            before = frame < s->frame && frame > before ? frame : before;
            after = frame > s->frame && frame < after ? frame : after;
        }
        const uint64_t gap = after - before, far = (uint64_t)(present - s->frame) + LIB_KEY;
        if (!best || gap * best_far < best_gap * far) {
            best = s;
            best_gap = gap;
            best_far = far;
        }
    }
    return best;
}

static void keep(struct curtain *c, struct lib_snapshot *s)
{
    board_save(c->board, s->at);
    s->frame = c->log.frames;
    s->digest = c->log.digest;
    s->used = ++c->clock;
}

void lib_keep_key(struct curtain *c)
{
    if (c->keys > 0 && c->log.frames > 0 && c->log.frames % LIB_KEY == 0 && !c->log.full &&
        !find(c, c->log.frames, c->log.digest))
        keep(c, least_missed(c, c->log.frames));
}

/* ---- seeking ---- */

/* Where a replay starts: at the last of its frames that has a snapshot or is the board's current frame (`present`), or
 * at power-on when there is none. */
struct from {
    struct lib_snapshot *snapshot;
    bool present;
    uint32_t frame;
};

/* Finds the frame to start replaying the pads from. begin: the hash of the start of the pads' run. now: the log of the
 * board's run up to its current frame; NULL: the current frame cannot be used. */
static struct from search(struct curtain *c, struct pads_run pads, uint64_t begin, const struct pads_log *now)
{
    struct pads_log empty = { 0 };
    struct from from = { NULL, false, 0 };

    pads_log_begin(&empty, begin);
    uint64_t digest = empty.digest;
    uint32_t frame = 0;
    from.present = now && now->frames == 0 && now->digest == digest;
    while (pads_run_next(&pads))
        for (uint32_t i = 0; i < pads.frames; i++) {
            digest = pads_log_fold(digest, pads.pads);
            frame++;
            const bool present = now && now->frames == frame && now->digest == digest;
            struct lib_snapshot *s = present ? NULL : find(c, frame, digest);
            if (present || s)
                from = (struct from){ s, present, frame };
        }
    return from;
}

/* Puts the board at the frame to replay from. Returns false and sets err when the run cannot be powered up. */
static bool set_out(struct curtain *c, const struct from *from, char *err, size_t err_size)
{
    c->drawn = c->sounding = false;
    if (from->snapshot) {
        from->snapshot->used = ++c->clock;
        board_restore(c->board, from->snapshot->at);
    } else if (!from->present) {
        struct board *was = c->board;
        if (!lib_power(c, err, err_size)) {
            c->board = was; /* in the memory that lib_power has overwritten; valid again only after a restore */
            return false;
        }
    }
    return true;
}

/* Replays the pads after frame from->frame; c->log becomes the log of all the pads. Returns false and sets err on
 * failure. */
static bool go(struct curtain *c, struct pads_run pads, const struct from *from, char *err, size_t err_size)
{
    pads_log_begin(&c->log, c->begin.hash);
    if (!set_out(c, from, err, err_size))
        return false;
    while (pads_run_next(&pads))
        for (uint32_t i = 0; i < pads.frames; i++) {
            if (c->log.frames >= from->frame) {
                if (board_last(c->board)->fault)
                    return err_set(err, err_size, "invalid state: it has input after a fault in the game");
                lib_keep_key(c);
                board_tick(c->board, pads.pads);
            }
            pads_log_add(&c->log, pads.pads);
        }
    return true;
}

/* ---- states ---- */

size_t curtain_state_size(const struct curtain *c)
{
    return HEAD + lib_start_room(&c->begin) + c->log.room + PADS_LOG_RUN;
}

size_t curtain_save(struct curtain *c, void *state, size_t size, char *err, size_t err_size)
{
    uint8_t *out = state;

    if (c->log.full) {
        err_set(err, err_size, "too many input changes for a state of %zu bytes; raise state_room",
                curtain_state_size(c));
        return 0;
    }
    if (size < HEAD + lib_start_room(&c->begin) + c->log.used + PADS_LOG_RUN) {
        err_set(err, err_size, "buffer for the state: expected %zu bytes, got %zu", curtain_state_size(c), size);
        return 0;
    }
    const size_t start = lib_start_write(&c->begin, out + HEAD), pads = pads_log_write(&c->log, out + HEAD + start);
    memcpy(out, magic, sizeof magic);
    bytes_put32(out + 8, FORMAT);
    bytes_put32(out + 12, CORE_VERSION);
    bytes_put64(out + 16, c->game_hash);
    bytes_put32(out + 24, c->log.frames);
    bytes_put32(out + 28, (uint32_t)start);
    bytes_put32(out + 32, (uint32_t)pads);
    bytes_put32(out + 36, 0);
    bytes_put64(out + 40, board_hash(c->board));
    bytes_put32(out + 48, hash_crc32(out + HEAD, start + pads));
    bytes_put32(out + 52, hash_crc32(out, 52));
    if (c->n > c->keys && !board_last(c->board)->fault && !find(c, c->log.frames, c->log.digest))
        keep(c, oldest(c, c->keys, c->n));
    return HEAD + start + pads;
}

/* Checks the bytes of a state, reads its start into c->spare and points *pads at its pads. Returns false and sets err
 * for any bytes that cannot be loaded. */
static bool read_state(struct curtain *c, const uint8_t *in, size_t size, struct pads_run *pads, char *err,
                       size_t err_size)
{
    if (size < HEAD || memcmp(in, magic, sizeof magic) != 0)
        return err_set(err, err_size, "not a Curtain state");
    if (hash_crc32(in, 52) != bytes_get32(in + 52))
        return err_set(err, err_size, "damaged state: the checksum does not match");
    if (bytes_get32(in + 8) != FORMAT || bytes_get32(in + 36) != 0)
        return err_set(err, err_size, "state format: expected %d, got %u", FORMAT, (unsigned)bytes_get32(in + 8));
    if (bytes_get32(in + 12) != CORE_VERSION)
        return err_set(err, err_size, "state core version: expected %d, got %u", CORE_VERSION,
                       (unsigned)bytes_get32(in + 12));
    if (bytes_get64(in + 16) != c->game_hash)
        return err_set(err, err_size, "the state belongs to a different game or a different build of this game");
    const size_t start = bytes_get32(in + 28), length = bytes_get32(in + 32);
    if (start > size - HEAD || length > size - HEAD - start)
        return err_set(err, err_size, "the state is truncated");
    if (hash_crc32(in + HEAD, start + length) != bytes_get32(in + 48))
        return err_set(err, err_size, "damaged state: the checksum does not match");
    if (!lib_start_read(&c->spare, in + HEAD, start))
        return err_set(err, err_size, "invalid state: bad start data");
    *pads = (struct pads_run){ .at = in + HEAD + start, .end = in + HEAD + start + length };
    struct pads_run all = *pads;
    uint64_t frames = 0;
    while (pads_run_next(&all))
        frames += all.frames;
    if (all.at != all.end || frames != bytes_get32(in + 24) || frames > PADS_LOG_FRAMES)
        return err_set(err, err_size, "invalid state: bad input data");
    return length <= c->log.room ? true : err_set(err, err_size, "the state's run is too long; raise state_room");
}

/* Returns a hash of nvram, and sets *writes to the number of writes to nvram. If the hash differs after a load, the
 * next frame reports CURTAIN_SAVED. */
static uint64_t hash_of_saves(const struct curtain *c, uint32_t *writes)
{
    size_t size;
    const void *nvram = board_nvram(c->board, &size, writes);

    return hash_bytes(HASH_START, nvram, size);
}

static void swap_starts(struct curtain *c)
{
    struct lib_start start = c->begin;

    c->begin = c->spare;
    c->spare = start;
}

static void swap_logs(struct curtain *c)
{
    struct pads_log log = c->log;

    c->log = c->other;
    c->other = log;
}

bool curtain_load(struct curtain *c, const void *state, size_t size, char *err, size_t err_size)
{
    struct pads_run pads;
    const uint8_t *in = state;

    if (!read_state(c, in, size, &pads, err, err_size))
        return false;
    board_save(c->board, c->before);
    board_output_save(c->board, c->before_out);
    const uint64_t saves = hash_of_saves(c, &c->writes);
    const struct from from = search(c, pads, c->spare.hash, board_last(c->board)->fault ? NULL : &c->log);
    swap_starts(c);
    swap_logs(c);
    if (go(c, pads, &from, err, err_size) &&
        (board_hash(c->board) == bytes_get64(in + 40) ||
         err_set(err, err_size, "replaying the state produced a different hash"))) {
        c->saved = hash_of_saves(c, &c->writes) != saves || c->saved;
        return true;
    }
    swap_logs(c);
    swap_starts(c);
    board_restore(c->board, c->before);
    board_output_restore(c->board, c->before_out);
    c->drawn = c->sounding = false;
    return false;
}
