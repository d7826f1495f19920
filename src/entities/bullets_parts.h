/*
 * bullets_parts.h - what bullets.c, bullets_program.c and bullets_move.c share. All of it is inline: it runs for each
 * bullet of a frame.
 */
#ifndef ENTITIES_BULLETS_PARTS_H
#define ENTITIES_BULLETS_PARTS_H

#include "../base/int.h"
#include "bullets.h"

/* The bit of slot i in its block's word. */
static inline uint64_t bullets_bit(uint32_t i)
{
    return 1ull << (i % SLOTS_BLOCK);
}

/* Busy: the program or the fine move of bullet i runs in the next frame. Not busy: it has neither. In both cases its
 * program no longer waits. */
static inline void bullets_set_busy(struct bullets *b, uint32_t i, bool busy)
{
    uint32_t block = i / SLOTS_BLOCK;

    b->busy[block] = busy ? b->busy[block] | bullets_bit(i) : b->busy[block] & ~bullets_bit(i);
    b->idle[block] &= ~bullets_bit(i);
}

/* One more live bullet of a kind (by: 1), or one less (-1). */
static inline void bullets_count_kind(struct bullets *b, uint16_t kind, int by)
{
    if (b->of_kind)
        b->of_kind[kind] += (uint32_t)by;
}

/* Gives live bullet i another row of the kinds. */
static inline void bullets_change_kind(struct bullets *b, uint32_t i, unsigned kind)
{
    bullets_count_kind(b, b->kind[i], -1);
    b->kind[i] = (uint16_t)kind;
    bullets_count_kind(b, b->kind[i], 1);
}

static inline bool bullets_stands(const struct bullets *b, uint32_t i)
{
    return b->stands && b->stands[i];
}

static inline void bullets_store_velocity(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    fx a = fx_max(fx_abs(vx), fx_abs(vy));

    if (bullets_stands(b, i)) {
        b->kept_vx[i] = vx;
        b->kept_vy[i] = vy;
        return;
    }
    b->vx[i] = vx;
    b->vy[i] = vy;
    if (a > b->fastest)
        b->fastest = a;
}

static inline void bullets_velocity_from_dir(struct bullets *b, uint32_t i)
{
    fx vx, vy;

    if (b->flags[i] & (BULLET_FINE | BULLET_DELAYED)) /* bullets_program.c steers those */
        return;
    trig_polar(b->speed[i], b->dir[i], &vx, &vy);
    bullets_store_velocity(b, i, vx, vy);
}

static inline int64_t bullets_clamp_pace(int64_t v)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;

    return int64_clamp(v, -most, most);
}

/* The fx nearest to a clamped pace, ties to even. */
static inline fx bullets_pace_fx(int64_t pace)
{
    return (fx)((pace + 0x7fff + (pace >> PACE_BITS & 1)) >> PACE_BITS);
}

/* A place as the nearest fx and what is more. */
static inline fx bullets_split(int64_t v, int16_t *more)
{
    *more = (int16_t)v;
    return (fx)((v - *more) >> PACE_BITS);
}

/* Squared distance; positions are within the world: below 2^63. */
static inline uint64_t bullets_target_distance(const struct targets *t, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)t->x[i] - x, dy = (int64_t)t->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* A block's programs: of those that are busy, and of those that may have waited long enough. */
void bullets_run_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken);

/* A frame begins for those that stand. */
void bullets_stand(struct bullets *b);

static inline fx bullets_fastest_block(const fx *restrict vx, const fx *restrict vy)
{
    fx most = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        fx ax = vx[i] < 0 ? -vx[i] : vx[i], ay = vy[i] < 0 ? -vy[i] : vy[i];
        most = ax > most ? ax : most;
        most = ay > most ? ay : most;
    }
    return most;
}

#endif
