/*
 * bullets_parts.h - declarations shared by bullets.c, bullets_program.c and bullets_move.c. The functions that run once
 * per bullet and frame are inline.
 */
#ifndef ENTITIES_BULLETS_PARTS_H
#define ENTITIES_BULLETS_PARTS_H

#include "../base/int.h"
#include "bullets.h"

/* Returns the bit of slot i in its block's word. */
static inline uint64_t bullets_bit(uint32_t i)
{
    return 1ull << (i % SLOTS_BLOCK);
}

/* Marks bullet i as busy (its program or fine move runs in the next frame) or not busy. Either way it is not idle. */
static inline void bullets_set_busy(struct bullets *b, uint32_t i, bool busy)
{
    uint32_t block = i / SLOTS_BLOCK;

    b->busy[block] = busy ? b->busy[block] | bullets_bit(i) : b->busy[block] & ~bullets_bit(i);
    b->idle[block] &= ~bullets_bit(i);
}

/* Adds `delta`, 1 or -1, to the number of live bullets of a kind, if the pool counts its kinds. */
static inline void bullets_adjust_kind_count(struct bullets *b, uint16_t kind, int delta)
{
    if (b->kind_counts)
        b->kind_counts[kind] += (uint32_t)delta;
}

/* Changes live bullet i's row in the table of kinds. */
static inline void bullets_set_kind_row(struct bullets *b, uint32_t i, unsigned kind)
{
    bullets_adjust_kind_count(b, b->kind[i], -1);
    b->kind[i] = (uint16_t)kind;
    bullets_adjust_kind_count(b, b->kind[i], 1);
}

static inline bool bullets_is_frozen(const struct bullets *b, uint32_t i)
{
    return b->freeze_flags && b->freeze_flags[i];
}

static inline void bullets_store_velocity(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    fx a = fx_max(fx_abs(vx), fx_abs(vy));

    if (bullets_is_frozen(b, i)) {
        b->saved_vx[i] = vx;
        b->saved_vy[i] = vy;
        return;
    }
    b->vx[i] = vx;
    b->vy[i] = vy;
    if (a > b->speed_bound)
        b->speed_bound = a;
}

static inline void bullets_set_velocity_from_dir(struct bullets *b, uint32_t i)
{
    fx vx, vy;

    if (b->flags[i] & (BULLET_FINE | BULLET_DELAYED)) /* bullets_program.c sets their velocity */
        return;
    trig_polar(b->speed[i], b->dir[i], &vx, &vy);
    bullets_store_velocity(b, i, vx, vy);
}

static inline int64_t bullets_clamp_speed(int64_t v)
{
    const int64_t limit = (int64_t)MAX_SPEED << 32;

    return int64_clamp(v, -limit, limit);
}

/* Returns the fx nearest to a clamped Q32 speed, ties to even. */
static inline fx bullets_speed_to_fx(int64_t speed_q32)
{
    return (fx)((speed_q32 + 0x7fff + (speed_q32 >> Q32_EXTRA_BITS & 1)) >> Q32_EXTRA_BITS);
}

/* Returns the fx nearest to a Q32 coordinate, and sets *low to the rest, in Q32. */
static inline fx bullets_split_coordinate(int64_t v, int16_t *low)
{
    *low = (int16_t)v;
    return (fx)((v - *low) >> Q32_EXTRA_BITS);
}

/* Returns the squared distance of target i from (x, y), which is below 2^63 because positions are within the world. */
static inline uint64_t bullets_target_distance_squared(const struct targets *t, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)t->x[i] - x, dy = (int64_t)t->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* Runs the programs of a block's busy bullets and of the idle bullets in `woken` (bits) whose wait is over. */
void bullets_run_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken);

/* Called at the start of a move. Unfreezes the frozen bullets that have no frames left, and counts down the frames of
 * the others. */
void bullets_step_freeze(struct bullets *b);

static inline fx bullets_block_max_speed(const fx *restrict vx, const fx *restrict vy)
{
    fx max_component = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        fx ax = vx[i] < 0 ? -vx[i] : vx[i], ay = vy[i] < 0 ? -vy[i] : vy[i];
        max_component = ax > max_component ? ax : max_component;
        max_component = ay > max_component ? ay : max_component;
    }
    return max_component;
}

#endif
