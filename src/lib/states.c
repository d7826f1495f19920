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

enum { HEADER_SIZE = 56, STATE_FORMAT = 1 };
static const uint8_t magic[8] = { 'C', 'U', 'R', 'T', 'A', 'I', 'N', 'S' };

void lib_take_key_snapshot(struct curtain *c)
{
    if (c->run_pads.frames > 0 && c->run_pads.frames % LIB_KEY_SNAPSHOT_INTERVAL == 0 && !c->run_pads.incomplete)
        rewind_add(c->past, c->board, c->run_pads.digest, false);
}

/* ---- seeking ---- */

/* Where a replay starts: at the last of its frames that has a snapshot or is the board's current frame (`is_current`),
 * or at power-on when there is none. */
struct replay_start {
    struct rewind_key *snapshot;
    bool is_current;
    uint32_t frame;
};

/* Finds the frame to start replaying the pads from. start_hash: the hash of the start of the pads' run. current: the
 * log of the board's run up to its current frame; NULL: the current frame cannot be used. */
static struct replay_start find_replay_start(struct curtain *c, struct pads_reader pads, uint64_t start_hash,
                                             const struct pads_log *current)
{
    struct pads_log empty = { 0 };
    struct replay_start start = { NULL, false, 0 };

    pads_log_begin(&empty, start_hash);
    uint64_t digest = empty.digest;
    uint32_t frame = 0;
    start.is_current = current && current->frames == 0 && current->digest == digest;
    while (pads_reader_next(&pads))
        for (uint32_t i = 0; i < pads.frames; i++) {
            digest = pads_log_update_digest(digest, pads.pads);
            frame++;
            const bool is_current = current && current->frames == frame && current->digest == digest;
            struct rewind_key *snapshot = is_current ? NULL : rewind_find(c->past, frame, digest);
            if (is_current || snapshot)
                start = (struct replay_start){ snapshot, is_current, frame };
        }
    return start;
}

/* Puts the board at the frame to replay from. Returns false and sets err when the run cannot be powered up. */
static bool seek_to_start(struct curtain *c, const struct replay_start *start, char *err, size_t err_size)
{
    c->drawn = c->mixed = false;
    if (start->snapshot) {
        rewind_restore(c->past, start->snapshot, c->board);
    } else if (!start->is_current) {
        struct board *board = c->board;
        if (!lib_power_on(c, err, err_size)) {
            c->board = board; /* in the memory that lib_power_on has overwritten; valid again only after a restore */
            return false;
        }
    }
    return true;
}

/* Replays the pads after frame start->frame; c->log becomes the log of all the pads. Returns false and sets err on
 * failure. */
static bool replay(struct curtain *c, struct pads_reader pads, const struct replay_start *start, char *err,
                   size_t err_size)
{
    pads_log_begin(&c->run_pads, c->run_start.hash);
    if (!seek_to_start(c, start, err, err_size))
        return false;
    while (pads_reader_next(&pads))
        for (uint32_t i = 0; i < pads.frames; i++) {
            if (c->run_pads.frames >= start->frame) {
                if (board_last_output(c->board)->fault)
                    return err_set(err, err_size, "invalid state: it has input after a fault in the game");
                lib_take_key_snapshot(c);
                board_tick(c->board, pads.pads);
            }
            pads_log_add(&c->run_pads, pads.pads);
        }
    return true;
}

/* ---- states ---- */

size_t curtain_state_size(const struct curtain *c)
{
    return HEADER_SIZE + lib_start_max_size(&c->run_start) + c->run_pads.cap + PADS_LOG_RUN_BYTES;
}

size_t curtain_save(struct curtain *c, void *state, size_t size, char *err, size_t err_size)
{
    uint8_t *out = state;

    if (c->run_pads.incomplete) {
        err_set(err, err_size, "too many input changes for a state of %zu bytes; raise state_room",
                curtain_state_size(c));
        return 0;
    }
    if (size < HEADER_SIZE + lib_start_max_size(&c->run_start) + c->run_pads.used + PADS_LOG_RUN_BYTES) {
        err_set(err, err_size, "buffer for the state: expected %zu bytes, got %zu", curtain_state_size(c), size);
        return 0;
    }
    const size_t start = lib_start_serialize(&c->run_start, out + HEADER_SIZE),
                 pads = pads_log_write(&c->run_pads, out + HEADER_SIZE + start);
    memcpy(out, magic, sizeof magic);
    bytes_put32(out + 8, STATE_FORMAT);
    bytes_put32(out + 12, CORE_VERSION);
    bytes_put64(out + 16, c->game_hash);
    bytes_put32(out + 24, c->run_pads.frames);
    bytes_put32(out + 28, (uint32_t)start);
    bytes_put32(out + 32, (uint32_t)pads);
    bytes_put32(out + 36, 0);
    bytes_put64(out + 40, board_hash(c->board));
    bytes_put32(out + 48, hash_crc32(out + HEADER_SIZE, start + pads));
    bytes_put32(out + 52, hash_crc32(out, 52));
    if (!board_last_output(c->board)->fault)
        rewind_add(c->past, c->board, c->run_pads.digest, true);
    return HEADER_SIZE + start + pads;
}

/* Checks the bytes of a state, reads its start into c->state_start and points *pads at its pads. Returns false and
 * sets err for any bytes that cannot be loaded. */
static bool read_state(struct curtain *c, const uint8_t *in, size_t size, struct pads_reader *pads, char *err,
                       size_t err_size)
{
    if (size < HEADER_SIZE || memcmp(in, magic, sizeof magic) != 0)
        return err_set(err, err_size, "not a Curtain state");
    if (hash_crc32(in, 52) != bytes_get32(in + 52))
        return err_set(err, err_size, "damaged state: the checksum does not match");
    if (bytes_get32(in + 8) != STATE_FORMAT || bytes_get32(in + 36) != 0)
        return err_set(err, err_size, "state format: expected %d, got %u", STATE_FORMAT, (unsigned)bytes_get32(in + 8));
    if (bytes_get32(in + 12) != CORE_VERSION)
        return err_set(err, err_size, "state core version: expected %d, got %u", CORE_VERSION,
                       (unsigned)bytes_get32(in + 12));
    if (bytes_get64(in + 16) != c->game_hash)
        return err_set(err, err_size, "the state belongs to a different game or a different build of this game");
    const size_t start = bytes_get32(in + 28), length = bytes_get32(in + 32);
    if (start > size - HEADER_SIZE || length > size - HEADER_SIZE - start)
        return err_set(err, err_size, "the state is truncated");
    if (hash_crc32(in + HEADER_SIZE, start + length) != bytes_get32(in + 48))
        return err_set(err, err_size, "damaged state: the checksum does not match");
    if (!lib_start_read(&c->state_start, in + HEADER_SIZE, start))
        return err_set(err, err_size, "invalid state: bad start data");
    *pads = (struct pads_reader){ .at = in + HEADER_SIZE + start, .end = in + HEADER_SIZE + start + length };
    struct pads_reader scan = *pads;
    uint64_t frames = 0;
    while (pads_reader_next(&scan))
        frames += scan.frames;
    if (scan.at != scan.end || frames != bytes_get32(in + 24) || frames > PADS_LOG_MAX_FRAMES)
        return err_set(err, err_size, "invalid state: bad input data");
    return length <= c->run_pads.cap ? true : err_set(err, err_size, "the state's run is too long; raise state_room");
}

/* Returns a hash of nvram, and sets *writes to the number of writes to nvram. If the hash differs after a load, the
 * next frame reports CURTAIN_SAVED. */
static uint64_t hash_nvram(const struct curtain *c, uint32_t *writes)
{
    size_t size;
    const void *nvram = board_nvram(c->board, &size, writes);

    return hash_bytes(HASH_START, nvram, size);
}

/* Swaps the present run with the one that is being loaded. */
static void swap_runs(struct curtain *c)
{
    struct lib_start start = c->run_start;
    struct pads_log log = c->run_pads;

    c->run_start = c->state_start;
    c->state_start = start;
    c->run_pads = c->state_pads;
    c->state_pads = log;
}

bool curtain_load(struct curtain *c, const void *state, size_t size, char *err, size_t err_size)
{
    struct pads_reader pads;
    const uint8_t *in = state;

    if (!read_state(c, in, size, &pads, err, err_size))
        return false;
    board_save(c->board, c->backup);
    board_output_save(c->board, c->backup_output);
    const uint64_t old_hash = hash_nvram(c, &c->nvram_writes);
    const struct replay_start start =
        find_replay_start(c, pads, c->state_start.hash, board_last_output(c->board)->fault ? NULL : &c->run_pads);
    swap_runs(c);
    if (replay(c, pads, &start, err, err_size) &&
        (board_hash(c->board) == bytes_get64(in + 40) ||
         err_set(err, err_size, "replaying the state produced a different hash"))) {
        c->nvram_changed = hash_nvram(c, &c->nvram_writes) != old_hash || c->nvram_changed;
        return true;
    }
    swap_runs(c);
    board_restore(c->board, c->backup);
    board_output_restore(c->board, c->backup_output);
    c->drawn = c->mixed = false;
    return false;
}
