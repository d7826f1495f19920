/*
 * rewind.c - see rewind.h.
 *
 * The block contains struct rewind, the list of key frames, the pads, and slots of equal size for the snapshots. When a
 * snapshot is larger than a slot, all slots are enlarged and their contents moved. Nothing here depends on a clock: the
 * distance between key frames is such that copying them is cheap compared with ticking.
 */
#include "rewind.h"

#include <string.h>
#include "../base/fx.h"
#include "../base/int.h"

enum {
    BYTES_PER_KEY = 16384,    /* memory per entry of the list of key frames; snapshots are larger */
    MAX_PADS = 1 << 24,       /* frames of pads: three days */
    MIN_APART = 4,            /* frames between key frames */
    BYTES_PER_FRAME = 1 << 16 /* bytes of key frame per frame of the run */
};

struct rewind *rewind_open(void *memory, size_t size, uint32_t recent)
{
    struct rewind *r = memory;

    *r = (struct rewind){ .size = size, .recent = recent, .apart = REWIND_APART, .pads_cap = 1 };
    r->max_keys = (uint32_t)(size / BYTES_PER_KEY);
    while (r->pads_cap < MAX_PADS && r->pads_cap * sizeof *r->pads * 2 <= size / 16)
        r->pads_cap *= 2;
    r->key = (struct rewind_key *)(r + 1);
    r->pads = (uint16_t(*)[MAX_PLAYERS])(r->key + r->max_keys);
    r->snapshots = (uint8_t *)(uintptr_t)int_align_cache_line((uintptr_t)(r->pads + r->pads_cap));
    return r;
}

/* ---- key frames ---- */

static uint8_t *slot_of(const struct rewind *r, uint32_t slot)
{
    return r->snapshots + slot * r->slot_size;
}

/* Returns the number of key frames before `frame`. */
static uint32_t keys_before(const struct rewind *r, uint32_t frame)
{
    uint32_t lo = 0, hi = r->n;

    while (lo < hi) {
        const uint32_t mid = (lo + hi) / 2;
        if (r->key[mid].frame < frame)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

struct rewind_key *rewind_find(const struct rewind *r, uint32_t frame, uint64_t digest)
{
    for (uint32_t i = keys_before(r, frame); i < r->n && r->key[i].frame == frame; i++)
        if (r->key[i].digest == digest)
            return &r->key[i];
    return NULL;
}

void rewind_restore(struct rewind *r, struct rewind_key *k, struct board *b)
{
    board_restore(b, slot_of(r, k->slot));
    k->last_used = ++r->uses;
}

static void remove_key(struct rewind *r, uint32_t i)
{
    const struct rewind_key removed = r->key[i];

    memmove(&r->key[i], &r->key[i + 1], (--r->n - i) * sizeof removed);
    r->key[r->n] = removed;
}

static bool is_recent(const struct rewind *r, uint32_t i)
{
    return r->key[i].last_used && r->uses - r->key[i].last_used < r->recent;
}

/* Returns the key frame to remove, seen from the present. If all that may go were used recently, that is the one whose
 * last use is the longest ago. */
static uint32_t find_expendable(const struct rewind *r, uint32_t present)
{
    uint32_t best = 0;
    uint64_t best_gap = 1, best_far = 1; /* compared as fractions; 1 is that of the first key frame */

    for (uint32_t i = 1; i < r->n; i++) {
        const uint32_t frame = r->key[i].frame, after = i + 1 < r->n ? r->key[i + 1].frame : r->end;
        const uint64_t gap = after - r->key[i - 1].frame,
                       far = (uint64_t)(frame < present ? present - frame : frame - present) + REWIND_APART;
        if (!is_recent(r, i) && gap * best_far <= best_gap * far) {
            best_gap = gap;
            best_far = far;
            best = i;
        }
    }
    if (best > 0 || !is_recent(r, 0))
        return best;
    for (uint32_t i = 1; i < r->n; i++)
        if (r->key[i].last_used < r->key[best].last_used)
            best = i;
    return best;
}

/* Moves the snapshots in slots from r->n on to free slots below. */
static void move_down(struct rewind *r)
{
    const struct rewind_key *vacant = &r->key[r->n];

    for (uint32_t i = 0; i < r->n; i++)
        if (r->key[i].slot >= r->n) {
            while (vacant->slot >= r->n)
                vacant++;
            memcpy(slot_of(r, vacant->slot), slot_of(r, r->key[i].slot), r->slot_size);
            r->key[i].slot = vacant++->slot;
        }
}

/* Enlarges the slots for snapshots of `size` bytes that may still grow by an eighth. */
static void enlarge_slots(struct rewind *r, size_t size, uint32_t present)
{
    const size_t old_size = r->slot_size, new_size = (size_t)int_align_cache_line(size + size / 8),
                 cap = (r->size - (size_t)(r->snapshots - (uint8_t *)r)) / new_size;

    if (cap == 0 || r->max_keys == 0)
        return;
    while (r->n > cap)
        remove_key(r, find_expendable(r, present));
    move_down(r);
    r->slot_size = new_size;
    for (uint32_t i = r->n; i-- > 0;)
        memmove(slot_of(r, i), r->snapshots + i * old_size, old_size);
    r->slots = cap < r->max_keys ? (uint32_t)cap : r->max_keys;
    for (uint32_t i = r->n; i < r->slots; i++)
        r->key[i].slot = i;
}

void rewind_add(struct rewind *r, const struct board *b, uint64_t digest, bool is_use)
{
    const uint32_t frame = board_frame(b);
    const size_t size = board_snapshot_size(b);
    struct rewind_key *existing = rewind_find(r, frame, digest);

    if (existing) {
        if (is_use)
            existing->last_used = ++r->uses;
        return;
    }
    r->end = frame > r->end ? frame : r->end;
    if (size > r->slot_size)
        enlarge_slots(r, size, frame);
    if (size > r->slot_size)
        return;
    if (r->n == r->slots)
        remove_key(r, find_expendable(r, frame));
    const struct rewind_key k = { frame, r->key[r->n].slot, digest, is_use ? ++r->uses : 0 };
    board_save(b, slot_of(r, k.slot));
    const uint32_t i = keys_before(r, frame);
    memmove(&r->key[i + 1], &r->key[i], (r->n++ - i) * sizeof k);
    r->key[i] = k;
}

/* ---- one line of history ---- */

uint32_t rewind_first(const struct rewind *r)
{
    return r->n > 0 ? r->key[0].frame : r->end;
}

uint32_t rewind_end(const struct rewind *r)
{
    return r->end;
}

/* Drops the frames after the present. */
static void drop_future(struct rewind *r, uint32_t present)
{
    while (r->n > 0 && r->key[r->n - 1].frame > present)
        remove_key(r, r->n - 1);
    if (r->n == 0 || present < r->end)
        r->end = present;
}

void rewind_forget(struct rewind *r, uint32_t present)
{
    while (r->n > 0)
        remove_key(r, r->n - 1);
    r->end = present;
}

/* Returns the frames between key frames of this size: few, but copying must stay cheap; many when only a few key frames
 * fit into the memory. */
static uint32_t frames_apart(const struct rewind *r, size_t size)
{
    const size_t n = size / BYTES_PER_FRAME;

    if (size > r->size / 8 || n > REWIND_APART)
        return REWIND_APART;
    return n < MIN_APART ? MIN_APART : (uint32_t)n;
}

static uint16_t *pads_of(const struct rewind *r, uint32_t frame)
{
    return r->pads[frame & (r->pads_cap - 1)];
}

bool rewind_push(struct rewind *r, const struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    const uint32_t now = board_frame(b);

    if (now > r->end)
        rewind_forget(r, now);
    if (now >= rewind_first(r) && now < r->end && memcmp(pads_of(r, now), pads, sizeof *r->pads) == 0)
        return true; /* the future is the stored one */
    drop_future(r, now);
    if (r->n == 0 || now - r->key[r->n - 1].frame >= r->apart) {
        rewind_add(r, b, 0, false);
        r->apart = frames_apart(r, board_snapshot_size(b));
    }
    while (r->n > 0 && r->end - rewind_first(r) >= r->pads_cap)
        remove_key(r, 0);
    if (r->n == 0)
        return false;
    memcpy(pads_of(r, r->end++), pads, sizeof *r->pads);
    return true;
}

/* Returns the frames between the key frames to take when going back into a gap of n frames, or 0 for none. With a
 * distance of sqrt(n), the replays between two new key frames cost as much as the one that takes them; but these take
 * at most a quarter of the slots. */
static uint32_t fill_apart(const struct rewind *r, uint32_t n)
{
    const uint32_t most = r->slots / 4, apart = (uint32_t)fx_root(n);

    if (n < MIN_APART || most == 0)
        return 0;
    return n / apart <= most ? apart : n / most + 1;
}

const uint16_t *rewind_pads(const struct rewind *r, uint32_t frame)
{
    return pads_of(r, frame);
}

bool rewind_to(struct rewind *r, struct board *b, uint32_t frame)
{
    if (r->n == 0 || frame < rewind_first(r) || frame > r->end)
        return false;
    struct rewind_key *k = &r->key[keys_before(r, frame + 1) - 1];
    uint32_t from = board_frame(b), fill = 0;
    if (board_last_output(b)->fault || from > frame || from < k->frame) {
        rewind_restore(r, k, b);
        from = k->frame;
        fill = fill_apart(r, frame - from);
    }
    for (uint32_t f = from; f < frame; f++) {
        if (fill && f > from && (f - from) % fill == 0)
            rewind_add(r, b, 0, false);
        r->replayed++;
        if (board_tick(b, pads_of(r, f))->fault)
            return false;
    }
    return true;
}
