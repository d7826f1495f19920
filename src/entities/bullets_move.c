/*
 * bullets_move.c - moves all bullets by a frame.
 * One pass over the blocks of 64 slots runs the programs, moves the bullets, and tests each bullet for two conditions:
 * being outside the keep box, and being near player 1 (the broad phase). The loops have restrict parameters and a
 * constant trip count, a form that gcc and clang vectorise at -O2 without further flags. A block is scanned again only
 * for the broad phase of player 2, and to remove bullets outside the keep box.
 *
 * A range test takes one subtraction and one signed comparison: lo <= v <= lo + size, with size < 2^32, is equivalent
 * to (uint32_t)(v - lo) <= size, and adding 2^31 to both sides turns the unsigned comparison into a signed one.
 */
#include "bullets_parts.h"
#include <string.h>

enum {
    LOOKAHEAD_BLOCKS = 4,  /* number of blocks whose woken bullets are found in advance */
    CACHED_BLOCKS = 1 << 7 /* the columns of this many blocks are mostly in the L1 cache: prefetching would cost more */
};

/* Transposes a word, taken as a matrix of 8 x 8 bits with a byte per row. */
static uint64_t transpose_bits(uint64_t v)
{
    uint64_t t = (v ^ v >> 7) & 0x00aa00aa00aa00aa;

    v ^= t ^ t << 7;
    t = (v ^ v >> 14) & 0x0000cccc0000cccc;
    v ^= t ^ t << 14;
    t = (v ^ v >> 28) & 0x00000000f0f0f0f0;
    return v ^ t ^ t << 28;
}

/* Returns, as bits, the bullets of a block whose `due` is `now`. The even bits of each byte of `packed` represent four
 * slots that are 16 apart. The two words of `packed` are interleaved into one, whose transpose is the result. */
static uint64_t due_mask(const uint8_t *restrict due, uint8_t now)
{
    uint8_t packed[16];

    for (int i = 0; i < 16; i++)
        packed[i] = (uint8_t)((-(due[i] == now) & 1) | (-(due[i + 16] == now) & 4) | (-(due[i + 32] == now) & 16) |
                              (-(due[i + 48] == now) & 64));
    return transpose_bits(bytes_get64(packed) | bytes_get64(packed + 8) << 1);
}

/* Prefetches the columns of bullet i that a program reads or writes. This halves the time if the bullets don't fit in
 * the caches. */
static void prefetch_program(const struct bullets *b, uint32_t i)
{
    slots_prefetch(&b->motion[i]);
    slots_prefetch(&b->pc[i]);
    slots_prefetch(&b->step_flags[i]);
    slots_prefetch(&b->step_end[i]);
    slots_prefetch(&b->step_start[i]);
    slots_prefetch(&b->rounds_left[i * MOTION_MAX_DEPTH]);
    slots_prefetch(&b->dir[i]);
    slots_prefetch(&b->speed[i]);
    slots_prefetch(&b->flags[i]);
}

/* Returns, as bits, the idle bullets of a block whose wait may be over, because `step_end_low` is the clock's low byte.
 * Prefetches their columns if the pool is large. */
static uint64_t find_woken(const struct bullets *b, uint32_t block, uint32_t clock)
{
    if (!b->idle[block])
        return 0;
    const uint64_t found = due_mask(b->step_end_low + block * SLOTS_BLOCK, (uint8_t)clock) & b->idle[block];
    for (uint64_t m = b->s.top > CACHED_BLOCKS * SLOTS_BLOCK ? found : 0; m; m &= m - 1)
        prefetch_program(b, block * SLOTS_BLOCK + bits_lowest(m));
    return found;
}

/* A rectangle in the form that needs one comparison per axis; see the top of the file. */
struct range {
    uint32_t x, y;
    int32_t w, h;
};

enum { SIGN_BIT = -0x7fffffff - 1 };

static struct range make_range(int64_t x, int64_t y, uint32_t w, uint32_t h)
{
    return (struct range){ (uint32_t)x ^ (uint32_t)SIGN_BIT, (uint32_t)y ^ (uint32_t)SIGN_BIT,
                           (int32_t)(w ^ (uint32_t)SIGN_BIT), (int32_t)(h ^ (uint32_t)SIGN_BIT) };
}

static struct range keep_range(const struct box *k)
{
    return make_range(k->x0, k->y0, (uint32_t)k->x1 - (uint32_t)k->x0, (uint32_t)k->y1 - (uint32_t)k->y0);
}

/* Returns the range of the broad phase for query q: every bullet near the player ends its move in this range. */
static struct range near_range(const struct bullets_query *q, fx max_speed)
{
    int64_t reach = q->reach + max_speed;

    if (q->reach < 0) /* a single point, where no bullet is */
        return make_range(FX_MIN, FX_MIN, 0, 0);
    if (reach > FX_MAX) /* 2 * reach would wrap: the range is everywhere */
        return make_range(FX_MIN, FX_MIN, UINT32_MAX, UINT32_MAX);
    return make_range(q->x - reach, q->y - reach, 2 * (uint32_t)reach, 2 * (uint32_t)reach);
}

#define OUT_OF_RANGE_MASK(v, lo, size) -((int32_t)((uint32_t)(v) - (lo)) > (size))

enum { HALF_BLOCK = SLOTS_BLOCK / 2 };

/* The bit of each slot in half a block, so that a vectorised loop can OR the bits of the slots found. */
static const uint32_t half_block_bits[HALF_BLOCK] = {
    0x1,       0x2,       0x4,       0x8,       0x10,       0x20,       0x40,       0x80,
    0x100,     0x200,     0x400,     0x800,     0x1000,     0x2000,     0x4000,     0x8000,
    0x10000,   0x20000,   0x40000,   0x80000,   0x100000,   0x200000,   0x400000,   0x800000,
    0x1000000, 0x2000000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000, 0x80000000,
};

/* Returns -1 (all bits set) if a bullet that moves to (x, y) stays inside the keep box (outside is 0) and is outside
 * the range *n, otherwise 0. */
static inline int32_t uneventful_mask(int32_t outside, int32_t x, int32_t y, const struct range *n)
{
    return (OUT_OF_RANGE_MASK(x, n->x, n->w) | OUT_OF_RANGE_MASK(y, n->y, n->h)) & ~outside;
}

/* Moves a block, both halves in one loop. Returns, as bits, the slots that are then outside *bounds or inside *near.
 * Sets *any_outside to whether any slot is outside *bounds. */
static inline uint64_t move_block(fx *restrict x, fx *restrict y, const fx *restrict vx, const fx *restrict vy,
                                  const struct range *bounds, const struct range *near, bool *restrict any_outside)
{
    const struct range k = *bounds, n = *near;
    uint32_t low = 0, high = 0;
    int32_t outside = 0;

    for (int i = 0; i < HALF_BLOCK; i++) {
        const int j = i + HALF_BLOCK;
        const int32_t ax = x[i] + vx[i], ay = y[i] + vy[i], bx = x[j] + vx[j], by = y[j] + vy[j];
        const int32_t a_outside = OUT_OF_RANGE_MASK(ax, k.x, k.w) | OUT_OF_RANGE_MASK(ay, k.y, k.h);
        const int32_t b_outside = OUT_OF_RANGE_MASK(bx, k.x, k.w) | OUT_OF_RANGE_MASK(by, k.y, k.h);
        x[i] = ax;
        y[i] = ay;
        x[j] = bx;
        y[j] = by;
        low |= (uint32_t)uneventful_mask(a_outside, ax, ay, &n) & half_block_bits[i];
        high |= (uint32_t)uneventful_mask(b_outside, bx, by, &n) & half_block_bits[i];
        outside |= a_outside | b_outside;
    }
    *any_outside = outside;
    return ~((uint64_t)high << HALF_BLOCK | low);
}

static int32_t mark_near_block(const fx *restrict x, const fx *restrict y, uint8_t *restrict out,
                               const struct range *near)
{
    const struct range n = *near;
    int32_t any = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        int32_t is_near = ~(OUT_OF_RANGE_MASK(x[i], n.x, n.w) | OUT_OF_RANGE_MASK(y[i], n.y, n.h)) & 1;
        out[i] = (uint8_t)is_near;
        any |= is_near;
    }
    return any;
}

/* Prefetches the columns of a block that the narrow phase reads in addition to the positions. */
static void prefetch_near(const struct bullets *b, uint32_t first)
{
    slots_prefetch(&b->kind[first]);
    slots_prefetch(&b->kind[first + SLOTS_BLOCK / 2]);
    slots_prefetch(&b->flags[first]);
}

/* Returns, as bits, the bullets of a block that may touch or graze the player of the query. */
static uint64_t find_near(const struct bullets *b, const struct bullets_query *q, uint32_t block)
{
    const uint32_t first = block * SLOTS_BLOCK;
    uint8_t out[SLOTS_BLOCK];

    if (q->reach < 0) /* nobody is there */
        return 0;
    const struct range r = near_range(q, b->speed_bound);
    return mark_near_block(b->x + first, b->y + first, out, &r) ? slots_pack_flags(out) : 0;
}

uint64_t bullets_find_near(const struct bullets *b, uint32_t block, fx x, fx y, int64_t reach)
{
    struct range r = near_range(&(struct bullets_query){ .x = x, .y = y, .reach = reach }, b->speed_bound);
    uint32_t first = block * SLOTS_BLOCK;
    uint8_t out[SLOTS_BLOCK];

    return mark_near_block(b->x + first, b->y + first, out, &r)
               ? slots_pack_flags(out) & slots_live_or_held_mask(&b->s, block)
               : 0;
}

static uint64_t solid_mask(const int32_t *restrict hp, const uint8_t *restrict flags)
{
    uint8_t out[SLOTS_BLOCK];

    for (int i = 0; i < SLOTS_BLOCK; i++)
        out[i] = (uint8_t)((hp[i] != 0) & !(flags[i] & BULLET_DELAYED));
    return slots_pack_flags(out);
}

bool bullets_update_solid(struct bullets *b)
{
    uint64_t any = 0;

    for (uint32_t block = 0; block < b->s.top / SLOTS_BLOCK; block++) {
        uint32_t first = block * SLOTS_BLOCK;
        b->solid[block] = solid_mask(b->hp + first, b->flags + first) & slots_live_or_held_mask(&b->s, block);
        any |= b->solid[block];
    }
    return any != 0;
}

/* Removes the bullets in `candidates` (bits) that are outside *keep_box: holds bullets near a player, or all if
 * hold_all is set, and drops the others. */
static void remove_outside(struct bullets *b, uint64_t candidates, uint32_t first, const struct box *keep_box,
                           bool hold_all)
{
    const uint64_t *near = &b->near_player[first / SLOTS_BLOCK * MAX_PLAYERS];
    uint64_t hold = hold_all ? UINT64_MAX : 0;

    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        hold |= near[p];
    for (uint64_t m = candidates & b->s.live_bits[first / SLOTS_BLOCK]; m; m &= m - 1) {
        uint32_t i = first + bits_lowest(m);
        fx x = b->x[i], y = b->y[i];
        if (x >= keep_box->x0 && x <= keep_box->x1 && y >= keep_box->y0 && y <= keep_box->y1)
            continue;
        b->n_moved++;
        if (hold & bullets_bit(i))
            bullets_hold(b, i);
        else
            bullets_drop(b, i);
    }
}

/* `speed_bound` is recomputed every SPEED_BOUND_INTERVAL frames; in between it only grows. */
enum { SPEED_BOUND_INTERVAL = 64 };

static fx find_speed_bound(const struct bullets *b)
{
    fx bound = 0;

    for (uint32_t i = 0; i < b->s.top; i += SLOTS_BLOCK) {
        fx v = bullets_block_max_speed(b->vx + i, b->vy + i);
        bound = v > bound ? v : bound;
    }
    return bound;
}

void bullets_move(struct bullets *b, const struct motion_world *w, const struct box *keep_box,
                  const struct bullets_query query[MAX_PLAYERS], bool hold_all)
{
    static const struct bullets_query no_queries[MAX_PLAYERS] = { { .reach = -1 }, { .reach = -1 } };
    struct range keep_limits = keep_range(keep_box), near;
    uint32_t blocks = b->s.top / SLOTS_BLOCK;
    uint64_t woken[LOOKAHEAD_BLOCKS]; /* woken bullets of the present block and the AHEAD - 1 blocks after it */
    fx near_bound = -1;

    if (!query)
        query = no_queries;
    if (w->clock % SPEED_BOUND_INTERVAL == 0)
        b->speed_bound = find_speed_bound(b);
    b->n_moved = 0;
    b->holds_all = hold_all;
    b->work_done = 0;
    if (b->n_frozen)
        bullets_step_freeze(b);
    for (uint32_t block = 0; block < LOOKAHEAD_BLOCKS && block < blocks; block++)
        woken[block] = find_woken(b, block, w->clock);
    for (uint32_t block = 0; block < blocks; block++) {
        uint32_t i = block * SLOTS_BLOCK;
        uint64_t woken_now = woken[block % LOOKAHEAD_BLOCKS];

        if (block + LOOKAHEAD_BLOCKS < blocks) {
            woken[block % LOOKAHEAD_BLOCKS] = find_woken(b, block + LOOKAHEAD_BLOCKS, w->clock);
            prefetch_near(b, i + LOOKAHEAD_BLOCKS * SLOTS_BLOCK);
        }
        if (b->work_done > w->work_limit) /* over the limit: the frame ends in a fault */
            break;
        if (b->busy[block] || woken_now)
            bullets_run_block(b, w, block, woken_now);
        if (b->speed_bound != near_bound) { /* a program may have raised the bound */
            near_bound = b->speed_bound;
            near = near_range(&query[0], near_bound);
        }
        bool any_outside;
        const uint64_t candidates =
            move_block(b->x + i, b->y + i, b->vx + i, b->vy + i, &keep_limits, &near, &any_outside);
        uint64_t *found = b->near_player + block * MAX_PLAYERS;
        found[0] = query[0].reach < 0 ? 0 : candidates & b->s.live_bits[block];
        for (uint32_t p = 1; p < MAX_PLAYERS; p++)
            found[p] = find_near(b, &query[p], block) & b->s.live_bits[block];
        if (any_outside)
            remove_outside(b, candidates, i, keep_box, hold_all);
    }
    b->n_moved += b->s.live;
    slots_trim(&b->s);
}

void bullets_begin_move(struct bullets *b)
{
    b->n_moved = 0;
    b->work_done = 0;
    if (b->n_frozen)
        bullets_step_freeze(b);
}
