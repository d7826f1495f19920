/*
 * bullets_parts.h - declarations shared by bullets.c, bullets_program.c, bullets_batch.c and bullets_move.c. The
 * functions that run once per bullet and frame are inline.
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

enum program_state {
    PROGRAM_NEXT,  /* the next step follows in this frame */
    PROGRAM_ENDED, /* the program ended, or the bullet was removed */
    PROGRAM_RUNS,  /* the program runs in the next frame too */
    PROGRAM_WAITS, /* the program does nothing until the clock reaches `step_end` */
};

/* Returns the cost of a search for the nearest target, in motion steps. */
static inline uint64_t bullets_aim_cost(const struct targets *t)
{
    return t->s->live_bits ? t->s->top / (SLOTS_BLOCK / 2) : 0;
}

static inline ang bullets_turn_toward(ang dir, ang goal, ang limit)
{
    int32_t gap = trig_difference(dir, goal);
    uint32_t angle = gap < 0 ? 0u - (uint32_t)gap : (uint32_t)gap;

    if (angle <= limit)
        return goal;
    return gap < 0 ? dir - limit : dir + limit;
}

enum {
    DOES_STEER = DOES_DIR | DOES_AIM | DOES_TURN | DOES_TURN_TO | DOES_HOME,
    DOES_DRIVE = DOES_STEER | DOES_SPEED | DOES_ACCEL
};

/* Changes the direction and speed of bullet i in the k-th of the n frames of step st. Returns whether the caller must
 * recompute the velocity. */
static inline __attribute__((always_inline)) bool bullets_change_dir_and_speed(struct bullets *b,
                                                                               const struct motion_world *w, uint32_t i,
                                                                               unsigned step_flags, uint32_t st,
                                                                               uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    const unsigned actions = s->actions[st];

    if (!(step_flags & OVERRIDE_DIR)) {
        if (actions & (DOES_AIM | DOES_HOME))
            b->work_done += bullets_aim_cost(&w->targets);
        if (actions & DOES_DIR)
            b->dir[i] = s->dir[st];
        if (actions & DOES_AIM)
            b->dir[i] = targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]);
        if (actions & DOES_TURN)
            b->dir[i] += (ang)s->turn[st];
        if (actions & DOES_TURN_TO)
            b->dir[i] += (ang)motion_lerp(s->turn[st], (int32_t)s->dir[st], k - 1, n > 1 ? n - 1 : 1);
        if (actions & DOES_HOME)
            b->dir[i] =
                bullets_turn_toward(b->dir[i], targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]), s->home[st]);
    }
    if (!(actions & (DOES_SPEED | DOES_ACCEL)) || step_flags & OVERRIDE_SPEED)
        return actions & DOES_STEER;
    const bool fine = b->flags[i] & BULLET_FINE;
    const int shift = fine ? 0 : Q32_EXTRA_BITS; /* rounds down to the unit of the bullet's speed: fx unless fine */
    int64_t v = bullets_speed(b, i) >> shift;
    if (actions & DOES_SPEED)
        v = motion_lerp(b->step_start[i] >> shift, s->speed[st] >> shift, k, n);
    if (actions & DOES_ACCEL)
        v += s->accel[st] >> shift;
    v = bullets_clamp_speed(v * ((int64_t)1 << shift));
    b->speed[i] = bullets_speed_to_fx(v);
    if (fine)
        b->speed_q32[i] = v;
    return true;
}

/* Returns whether the wait of idle bullet i is over. If it was a delay, the bullet gets the row of its kind instead of
 * the cloud's and starts to move. */
static inline bool bullets_finish_wait(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    if (b->step_end[i] != w->clock)
        return false;
    if (b->flags[i] & BULLET_DELAYED) {
        b->flags[i] &= (uint8_t)~BULLET_DELAYED;
        if (w->kinds)
            bullets_set_kind_row(b, i, bullets_kind(b, w->kinds, i));
        b->born[i] = w->clock;
        b->step_end[i] = 0;
        bullets_update_velocity(b, i);
    }
    return true;
}

/* Runs a frame of bullet i's program, if it has one, and prepares its fine move, if it is fine. */
enum program_state bullets_step(struct bullets *b, const struct motion_world *w, uint32_t i);

/* Prepares a move of fine bullet i by (dx, dy) in Q32: sets the fraction bits to those after the move, vx and vy to the
 * move in whole units of fx, and `travel_q32` to `travel`, modulo 2^48. */
void bullets_prepare_fine_move(struct bullets *b, uint32_t i, int64_t travel, int64_t dx, int64_t dy);

/* Like bullets_run_block, for a block with busy bullets. */
void bullets_run_busy_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken);

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
