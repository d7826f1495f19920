/*
 * bullets_parts.h - what bullets.c, bullets_program.c and bullets_move.c share. All of it is inline: it runs for each
 * bullet of a frame.
 */
#ifndef BULLETS_PARTS_H
#define BULLETS_PARTS_H

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

    if (b->flags[i] & (BULLET_FINE | BULLET_DELAYED)) /* bullets_fly and bullets_wait_over steer those */
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

/* Looking for the nearest of them takes as long as so many steps more. */
static inline uint64_t bullets_target_steps(const struct targets *t)
{
    return t->s->used ? t->s->top / (SLOTS_BLOCK / 2) : 0;
}

static inline ang bullets_toward(ang dir, ang goal, ang most)
{
    int32_t gap = trig_difference(dir, goal);
    uint32_t angle = gap < 0 ? 0u - (uint32_t)gap : (uint32_t)gap;

    if (angle <= most)
        return goal;
    return gap < 0 ? dir - most : dir + most;
}

enum { DOES_STEER = DOES_DIR | DOES_AIM | DOES_TURN | DOES_HOME, DOES_DRIVE = DOES_STEER | DOES_SPEED | DOES_ACCEL };

/* What a step does to direction and speed in one of its frames: the k-th of n. True: the velocity is to follow. */
static inline __attribute__((always_inline)) bool bullets_turn_and_speed(struct bullets *b,
                                                                         const struct motion_world *w, uint32_t i,
                                                                         unsigned mute, uint32_t st, uint32_t k,
                                                                         uint32_t n)
{
    const struct steps *s = w->steps;
    const unsigned does = s->does[st];

    if (!(mute & OVERRIDE_DIR)) {
        if (does & (DOES_AIM | DOES_HOME))
            b->ran += bullets_target_steps(&w->targets);
        if (does & DOES_DIR)
            b->dir[i] = s->dir[st];
        if (does & DOES_AIM)
            b->dir[i] = targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]);
        if (does & DOES_TURN)
            b->dir[i] += (ang)s->turn[st];
        if (does & DOES_HOME)
            b->dir[i] = bullets_toward(b->dir[i], targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]), s->home[st]);
    }
    if (!(does & (DOES_SPEED | DOES_ACCEL)) || mute & OVERRIDE_SPEED)
        return does & DOES_STEER;
    const bool fine = b->flags[i] & BULLET_FINE;
    const int shift = fine ? 0 : PACE_BITS; /* rounded to the unit this bullet keeps: Q32 if fine, else fx */
    int64_t v = bullets_speed(b, i) >> shift;
    if (does & DOES_SPEED)
        v = motion_part_way(b->step_start[i] >> shift, s->speed[st] >> shift, k, n);
    if (does & DOES_ACCEL)
        v += s->accel[st] >> shift;
    v = bullets_clamp_pace(v * ((int64_t)1 << shift));
    b->speed[i] = bullets_pace_fx(v);
    if (fine)
        b->speed_q32[i] = v;
    return true;
}

/* Moves a fine bullet on to `travel_q32`, that far. vx, vy become what that is in whole units. */
static inline void bullets_fly_by(struct bullets *b, uint32_t i, int64_t way, int64_t dx, int64_t dy)
{
    int64_t x, y;

    bullets_place(b, i, &x, &y);
    const fx nx = bullets_split(x + dx, &b->x_more[i]), ny = bullets_split(y + dy, &b->y_more[i]);
    bullets_store_velocity(b, i, nx - b->x[i], ny - b->y[i]);
    b->travel_q32[i] = (int64_t)((uint64_t)way << 16) >> 16;
}

/* Moves a fine bullet on by its pace. */
static inline void bullets_fly(struct bullets *b, uint32_t i)
{
    const int64_t to = b->travel_q32[i] + b->speed_q32[i];
    int64_t dx, dy;

    trig_stride(b->travel_q32[i], to, b->dir[i], &dx, &dy);
    bullets_fly_by(b, i, to, dx, dy);
}

/* A program after a step of this frame. */
enum program_state {
    PROGRAM_NEXT,  /* the next step follows in this frame */
    PROGRAM_OVER,  /* it is over, or the bullet gone */
    PROGRAM_RUNS,  /* it runs in the next frame too */
    PROGRAM_WAITS, /* it does nothing until the clock is `step_end` */
};

/* Runs the program of bullet i, and moves it if it is fine. */
enum program_state bullets_run(struct bullets *b, const struct motion_world *w, uint32_t i);

/* A frame begins for those that stand. */
void bullets_stand(struct bullets *b);

/* Is what bullet i waited for over? A delay: then it is what was fired, from this frame on. */
static inline bool bullets_wait_over(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    if (b->step_end[i] != w->clock)
        return false;
    if (b->flags[i] & BULLET_DELAYED) {
        b->flags[i] &= (uint8_t)~BULLET_DELAYED;
        if (w->kinds)
            bullets_change_kind(b, i, bullets_kind(b, w->kinds, i));
        b->born[i] = w->clock;
        b->step_end[i] = 0;
        bullets_steer(b, i);
    }
    return true;
}

#endif
