/*
 * rewind.c - see rewind.h.
 *
 * When the budget is spent, the key frame goes whose removal leaves the smallest gap in relation to its distance from
 * the present: so gaps come to grow in proportion to age, and an hour takes little more than a minute. The first key
 * frame goes, and with it the oldest frames, only when gaps would be as large as their distance. No clock is asked: a
 * key frame is taken every so many frames as make copying it cheap beside ticking.
 */
#include "rewind.h"

#include <stdlib.h>
#include <string.h>

enum {
    ALIGN = 64,       /* board_save is fastest so */
    PADS_ROOM = 64,   /* frames of pads at first: more than REWIND_APART */
    NEAREST = 4,      /* frames between key frames at least */
    A_FRAME = 1 << 16 /* bytes of key frame that a frame may cost */
};

void rewind_open(struct rewind *r, size_t budget)
{
    memset(r, 0, sizeof *r);
    r->budget = budget;
    r->apart = REWIND_APART;
}

static void release(struct rewind *r, const struct rewind_key *k)
{
    r->held -= k->room;
    free(k->block);
}

void rewind_forget(struct rewind *r)
{
    while (r->n > 0)
        release(r, &r->key[--r->n]);
}

void rewind_close(struct rewind *r)
{
    rewind_forget(r);
    free(r->pads);
    memset(r, 0, sizeof *r);
}

uint32_t rewind_first(const struct rewind *r)
{
    return r->n > 0 ? r->key[0].frame : r->end;
}

uint32_t rewind_end(const struct rewind *r)
{
    return r->end;
}

/* The number of key frames before `frame`. */
static int keys_before(const struct rewind *r, uint32_t frame)
{
    int lo = 0, hi = r->n;

    while (lo < hi) {
        int mid = (lo + hi) / 2;
        if (r->key[mid].frame < frame)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

void rewind_drop(struct rewind *r, uint32_t present)
{
    while (r->n > 0 && r->key[r->n - 1].frame > present)
        release(r, &r->key[--r->n]);
    r->end = r->n > 0 && present < r->end ? present : r->end;
}

/* ---- memory ---- */

static uint64_t distance(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* The key frame that is missed least, seen from the present. */
static int least_missed(const struct rewind *r, uint32_t present)
{
    int best = 0;
    uint64_t best_gap = 1, best_far = 1; /* compared as fractions; worse than 1, and the first goes */

    for (int i = 1; i < r->n; i++) {
        uint32_t next = i + 1 < r->n ? r->key[i + 1].frame : present > r->end ? present : r->end;
        uint64_t gap = next - r->key[i - 1].frame, far = distance(r->key[i].frame, present) + REWIND_APART;
        if (gap * best_far <= best_gap * far) {
            best_gap = gap;
            best_far = far;
            best = i;
        }
    }
    return best;
}

static struct rewind_key take_out(struct rewind *r, int i)
{
    struct rewind_key k = r->key[i];

    memmove(&r->key[i], &r->key[i + 1], (size_t)(--r->n - i) * sizeof k);
    return k;
}

static bool allocate(struct rewind *r, struct rewind_key *k, size_t room)
{
    k->block = room <= SIZE_MAX - ALIGN ? malloc(room + ALIGN - 1) : NULL;
    if (!k->block)
        return false;
    k->at = (uint8_t *)(((uintptr_t)k->block + ALIGN - 1) & ~(uintptr_t)(ALIGN - 1));
    k->room = room;
    r->held += room;
    return true;
}

/* Memory for a snapshot: new, or that of key frames given up for it. */
static bool make_room(struct rewind *r, size_t size, uint32_t present, struct rewind_key *k)
{
    size_t room = size + size / 8; /* so that it serves again when the board has grown a little */

    while (r->n > 0 && (r->n == REWIND_KEYS || r->held > r->budget || room > r->budget - r->held)) {
        *k = take_out(r, least_missed(r, present));
        if (r->held <= r->budget && k->room >= size && k->room / 2 <= room)
            return true;
        release(r, k);
    }
    while (!allocate(r, k, room)) {
        if (r->n == 0)
            return false;
        struct rewind_key old = take_out(r, least_missed(r, present));
        release(r, &old);
    }
    return true;
}

/* Frames between key frames of this size: near, but copying must stay cheap; far when there is no room for a few. */
static uint32_t frames_apart(const struct rewind *r, size_t size)
{
    size_t n = size / A_FRAME;

    if (size > r->budget / 8 || n > REWIND_APART)
        return REWIND_APART;
    return n < NEAREST ? NEAREST : (uint32_t)n;
}

static void put_key(struct rewind *r, const struct board *b)
{
    uint32_t frame = board_frame(b);
    size_t size = board_snapshot_size(b);
    struct rewind_key k;
    int i = keys_before(r, frame);

    if ((i < r->n && r->key[i].frame == frame) || !make_room(r, size, frame, &k))
        return;
    board_save(b, k.at);
    k.frame = frame;
    i = keys_before(r, frame);
    memmove(&r->key[i + 1], &r->key[i], (size_t)(r->n++ - i) * sizeof k);
    r->key[i] = k;
    r->apart = frames_apart(r, size);
}

static uint16_t *pads_of(const struct rewind *r, uint32_t frame)
{
    return r->pads[frame & (r->pads_room - 1)];
}

/* Twice the room for pads; false: no memory, or more than its share. */
static bool more_pads(struct rewind *r)
{
    uint32_t room = r->pads_room ? r->pads_room * 2 : PADS_ROOM, old = r->pads_room;
    size_t bytes = room * sizeof *r->pads;

    if (old && (room == 0 || bytes > r->budget / 8))
        return false;
    uint16_t(*pads)[MAX_PLAYERS] = malloc(bytes);
    if (!pads)
        return false;
    for (uint32_t f = rewind_first(r); f != r->end; f++)
        memcpy(pads[f & (room - 1)], pads_of(r, f), sizeof *pads);
    free(r->pads);
    r->held += bytes - old * sizeof *pads;
    r->pads = pads;
    r->pads_room = room;
    while (r->n > 1 && r->held > r->budget) {
        struct rewind_key lost = take_out(r, least_missed(r, r->end));
        release(r, &lost);
    }
    return true;
}

/* Room for the pads of frame r->end. */
static bool room_for_pads(struct rewind *r)
{
    while (r->n > 0 && r->end - rewind_first(r) >= r->pads_room) {
        if (more_pads(r))
            continue;
        struct rewind_key old = take_out(r, 0);
        release(r, &old);
    }
    return r->n > 0;
}

/* ---- the past ---- */

bool rewind_push(struct rewind *r, const struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    uint32_t now = board_frame(b);

    if (now < rewind_first(r) || now > r->end)
        rewind_forget(r);
    if (r->n > 0 && now < r->end && memcmp(pads_of(r, now), pads, sizeof *r->pads) == 0)
        return true; /* what comes is known already */
    rewind_drop(r, now);
    if (r->n == 0)
        r->end = now;
    if (r->n == 0 || now - r->key[r->n - 1].frame >= r->apart)
        put_key(r, b);
    if (!room_for_pads(r))
        return false;
    memcpy(pads_of(r, r->end++), pads, sizeof *r->pads);
    return true;
}

static uint32_t root(uint32_t n)
{
    uint32_t r = 1;

    while ((r + 1) * (r + 1) <= n)
        r++;
    return r;
}

/* Frames between the key frames that are put into a gap of n when it is gone back into, so many that steps cost as much
 * to the next of them as in between; but they may take no more than a quarter of the budget. 0: none. */
static uint32_t fill_apart(const struct rewind *r, uint32_t n, size_t size)
{
    size_t most = size > 0 ? r->budget / 4 / size : 0;
    uint32_t apart = root(n);

    if (n < NEAREST || most == 0)
        return 0;
    return n / apart <= most ? apart : n / (uint32_t)most + 1;
}

const uint16_t *rewind_pads(const struct rewind *r, uint32_t frame)
{
    return pads_of(r, frame);
}

bool rewind_to(struct rewind *r, struct board *b, uint32_t frame)
{
    if (r->n == 0 || frame < rewind_first(r) || frame > r->end)
        return false;
    const struct rewind_key *k = &r->key[keys_before(r, frame + 1) - 1];
    uint32_t from = board_frame(b), fill = 0;
    if (board_last_output(b)->fault || from > frame || from < k->frame) {
        board_restore(b, k->at);
        from = k->frame;
        fill = fill_apart(r, frame - from, k->room);
    }
    for (uint32_t f = from; f < frame; f++) {
        if (fill && f > from && (f - from) % fill == 0)
            put_key(r, b);
        r->again++;
        if (board_tick(b, pads_of(r, f))->fault)
            return false;
    }
    return true;
}
