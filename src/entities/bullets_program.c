/*
 * bullets_program.c - runs motion programs (motion.h) on bullets.
 */
#include "bullets_parts.h"
#include <string.h>

enum program_state {
    PROGRAM_NEXT,  /* the next step follows in this frame */
    PROGRAM_OVER,  /* the program ended, or the bullet was removed */
    PROGRAM_RUNS,  /* the program runs in the next frame too */
    PROGRAM_WAITS, /* the program does nothing until the clock reaches `step_end` */
};

/* Returns the cost of a search for the nearest target, in motion steps. */
static uint64_t steps_of_aim(const struct targets *t)
{
    return t->s->used ? t->s->top / (SLOTS_BLOCK / 2) : 0;
}

static ang toward(ang dir, ang goal, ang most)
{
    int32_t gap = trig_difference(dir, goal);
    uint32_t angle = gap < 0 ? 0u - (uint32_t)gap : (uint32_t)gap;

    if (angle <= most)
        return goal;
    return gap < 0 ? dir - most : dir + most;
}

enum { DOES_STEER = DOES_DIR | DOES_AIM | DOES_TURN | DOES_HOME, DOES_DRIVE = DOES_STEER | DOES_SPEED | DOES_ACCEL };

/* Changes the direction and speed of bullet i in the k-th of the n frames of step st. Returns whether the caller must
 * recompute the velocity. */
static inline __attribute__((always_inline)) bool turn_and_speed(struct bullets *b, const struct motion_world *w,
                                                                 uint32_t i, unsigned step_flags, uint32_t st,
                                                                 uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    const unsigned does = s->does[st];

    if (!(step_flags & OVERRIDE_DIR)) {
        if (does & (DOES_AIM | DOES_HOME))
            b->ran += steps_of_aim(&w->targets);
        if (does & DOES_DIR)
            b->dir[i] = s->dir[st];
        if (does & DOES_AIM)
            b->dir[i] = targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]);
        if (does & DOES_TURN)
            b->dir[i] += (ang)s->turn[st];
        if (does & DOES_HOME)
            b->dir[i] = toward(b->dir[i], targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]), s->home[st]);
    }
    if (!(does & (DOES_SPEED | DOES_ACCEL)) || step_flags & OVERRIDE_SPEED)
        return does & DOES_STEER;
    const bool fine = b->flags[i] & BULLET_FINE;
    const int shift = fine ? 0 : PACE_BITS; /* rounds down to the unit of the bullet's speed: fx unless fine */
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

/* Prepares a move of fine bullet i by (dx, dy) in Q32: sets the fraction bits to those after the move, vx and vy to the
 * move in whole units of fx, and `travel_q32` to `way`, modulo 2^48. */
static void fly_by(struct bullets *b, uint32_t i, int64_t way, int64_t dx, int64_t dy)
{
    int64_t x, y;

    bullets_place(b, i, &x, &y);
    const fx nx = bullets_split(x + dx, &b->x_more[i]), ny = bullets_split(y + dy, &b->y_more[i]);
    bullets_store_velocity(b, i, nx - b->x[i], ny - b->y[i]);
    b->travel_q32[i] = (int64_t)((uint64_t)way << 16) >> 16;
}

/* Prepares a move of fine bullet i along dir by its speed. */
static void fly(struct bullets *b, uint32_t i)
{
    const int64_t to = b->travel_q32[i] + b->speed_q32[i];
    int64_t dx, dy;

    trig_stride(b->travel_q32[i], to, b->dir[i], &dx, &dy);
    fly_by(b, i, to, dx, dy);
}

/* Sets bullet i's kind and bank as step st specifies. */
static void restyle(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;

    if (s->does[st] & DOES_KIND && w->kinds)
        bullets_set_kind(b, w->kinds, i, s->kind[st]);
    if (s->does[st] & DOES_BANK)
        b->bank[i] = s->bank[st];
}

static void drive(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st,
                  uint32_t k, uint32_t n)
{
    if (turn_and_speed(b, w, i, step_flags, st, k, n))
        bullets_velocity_from_dir(b, i);
}

/* A step whose named numbers are replaced by a bullet's values. `steps` is a list whose entry 0 is `step`; `w` is the
 * world with that list. */
struct own_step {
    struct motion_step step;
    struct steps steps;
    struct motion_world w;
};

/* Builds *own: step st with its named numbers replaced by bullet i's values as they were when the step began. If the
 * step has not `begun` yet, it begins now, and the present values are saved first. */
static void own_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, bool begun,
                     struct own_step *own)
{
    struct motion_step *p = &own->step;

    for (int k = 0; !begun && k < MAX_VALUES && bullets_value(b, k); k++)
        bullets_begun(b, k)[i] = bullets_value(b, k)[i];
    motion_step_at(w->steps, st, p);
    for (uint64_t left = p->named; left;) {
        const int n = (int)bits_lowest(left) / NAMED_BITS;
        bool is;
        const int k = motion_named(left, n, w->shots, &is);
        motion_set_number(p, (enum step_number)n, k < 0 || !bullets_begun(b, k) ? 0 : bullets_begun(b, k)[i]);
        left &= ~(((uint64_t)(1 << NAMED_BITS) - 1) << n * NAMED_BITS);
    }
    own->steps = (struct steps){ .does = &p->does,
                                 .over = &p->over,
                                 .kind = &p->kind,
                                 .bank = &p->bank,
                                 .dir = &p->dir,
                                 .turn = &p->turn,
                                 .home = &p->home,
                                 .speed = &p->speed,
                                 .accel = &p->accel,
                                 .count = &p->count,
                                 .jump = &p->jump,
                                 .depth = &p->depth,
                                 .named = &p->named,
                                 .x = &p->x,
                                 .y = &p->y,
                                 .size = &p->size,
                                 .size_to = &p->size_to,
                                 .how = &p->how };
    own->w = *w;
    own->w.steps = &own->steps;
}

/* ---- steps that lead a bullet ---- */

/* Saves the state of a leading step in `step_start` and `travel_q32`. Both are unused at that time, because a leading
 * step has no DOES_DRIVE actions and does not occur in a fine motion. */
static void keep_lead(struct bullets *b, uint32_t i, const struct motion_lead *l)
{
    b->step_start[i] = (int64_t)((uint64_t)(uint32_t)l->x << 32 | (uint32_t)l->y);
    b->travel_q32[i] = (int64_t)((uint64_t)(uint32_t)l->radius << 32 | l->angle);
}

static struct motion_lead kept_lead(const struct bullets *b, uint32_t i)
{
    return (struct motion_lead){ .x = (fx)(b->step_start[i] >> 32),
                                 .y = (fx)b->step_start[i],
                                 .radius = (fx)(b->travel_q32[i] >> 32),
                                 .angle = (ang)b->travel_q32[i],
                                 .speed = b->speed[i] };
}

/* Sets (*x, *y) to the position of bullet i's `orbit_target` in this frame or, if `before`, in the previous frame.
 * Returns false if the target has despawned or is not set. */
static bool around(const struct bullets *b, const struct motion_world *w, uint32_t i, bool before, fx *x, fx *y)
{
    return b->orbit_target && b->orbit_target[i] &&
           w->where(w, b->orbit_target[i], i / SLOTS_BLOCK * SLOTS_BLOCK, before, x, y);
}

/* Returns the number of frames that the go_to step st takes from (x, y) at the step's speed, rounded up, at least 1. */
static uint32_t frames_to(const struct steps *s, uint32_t st, fx x, fx y)
{
    const uint32_t d = (uint32_t)fx_hypot(fx_sub(s->x[st], x), fx_sub(s->y[st], y));
    const uint32_t speed = s->speed[st] < FX_ONE ? 1 : (uint32_t)(s->speed[st] >> PACE_BITS);

    return d ? (d - 1) / speed + 1 : 1;
}

/* Returns the total number of frames for which step st, which has begun, leads bullet i. */
static uint32_t frames_led(const struct bullets *b, const struct steps *s, uint32_t i, uint32_t st)
{
    return s->how[st] & HOW_SPEED ? (uint32_t)(b->travel_q32[i] >> 32) : s->over[st];
}

/* Starts a step that leads bullet i. Returns the step's length in frames, or 0 if the orbit target has despawned. */
static uint32_t begin_lead(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;
    const uint32_t does = s->does[st];
    const bool round = does & DOES_ORBIT || s->how[st] & HOW_AT;
    struct motion_lead l = { .x = b->x[i], .y = b->y[i], .angle = b->dir[i] };
    uint32_t n = s->over[st];

    if (s->how[st] & HOW_AT) {
        l.x = s->x[st];
        l.y = s->y[st];
    } else if (does & DOES_ORBIT && !around(b, w, i, true, &l.x, &l.y))
        return 0;
    if (round) {
        fx dx = fx_sub(b->x[i], l.x), dy = fx_sub(b->y[i], l.y);
        l.radius = fx_hypot(dx, dy);
        l.angle = dx || dy ? trig_atan2(dy, dx) : l.angle;
    }
    if (s->how[st] & HOW_SPEED) {
        n = frames_to(s, st, l.x, l.y);
        l.radius = (fx)n;
    }
    keep_lead(b, i, &l);
    return n;
}

/* Sets the velocity with which bullet i ends this frame at (x, y), and, except in a wave, dir and speed. If the
 * velocity would exceed MAX_SPEED on an axis, places the bullet at (x, y) at once, with velocity 0. */
static void lead_to(struct bullets *b, uint32_t i, bool wave, fx x, fx y)
{
    const int64_t most = (int64_t)MAX_SPEED << 16, dx = (int64_t)x - b->x[i], dy = (int64_t)y - b->y[i];

    if (int64_abs(dx) > most || int64_abs(dy) > most) {
        b->x[i] = x;
        b->y[i] = y;
        b->vx[i] = b->vy[i] = 0;
        return;
    }
    bullets_store_velocity(b, i, (fx)dx, (fx)dy);
    if (wave)
        return;
    if (dx || dy)
        b->dir[i] = trig_atan2((fx)dy, (fx)dx);
    b->speed[i] = fx_min(fx_hypot((fx)dx, (fx)dy), (fx)most);
}

/* Runs the k-th of n frames of a step that leads bullet i. Returns false if the orbit target has despawned. */
static bool lead(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    struct motion_lead l = kept_lead(b, i);
    fx x, y;

    if (s->does[st] & DOES_ORBIT && !(s->how[st] & HOW_AT) && !around(b, w, i, false, &l.x, &l.y))
        return false;
    motion_lead_place(s, st, &l, k, n, &x, &y);
    lead_to(b, i, s->does[st] & DOES_WAVE, x, y);
    return true;
}

/* Runs a frame of a step that leads bullet i, unless a script has overridden the step. Returns false if the step
 * ends early. */
static bool lead_on(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st,
                    uint32_t n)
{
    if (step_flags & (OVERRIDE_DIR | OVERRIDE_SPEED | OVERRIDE_PLACE))
        return true;
    if (lead(b, w, i, st, n - (b->step_end[i] - w->clock) + 1, n))
        return true;
    b->travel_q32[i] = 0;
    return false;
}

/* Ends a leading step. The bullet keeps the velocity of the last frame; after a wave it flies along dir. */
static void let_go(struct bullets *b, uint32_t i, uint32_t does)
{
    b->travel_q32[i] = 0;
    if (does & DOES_WAVE)
        bullets_steer(b, i);
}

/* ---- bounces ---- */

/* Reflects a move from `from` to *to, at speed *v, off the walls at lo (if at_lo) and hi (if at_hi). Returns whether
 * the move was reflected. A move that starts outside the walls is not reflected. */
static bool reflect(fx from, int64_t *to, fx *v, fx lo, fx hi, bool at_lo, bool at_hi)
{
    bool any = false;

    if (from < lo || from > hi)
        return false;
    for (;; any = true) {
        if (at_lo && *v < 0 && *to < lo)
            *to = 2 * (int64_t)lo - *to;
        else if (at_hi && *v > 0 && *to > hi)
            *to = 2 * (int64_t)hi - *to;
        else
            return any;
        *v = -*v;
    }
}

/* Reflects bullet i off the walls that this frame's move would cross. The bullet ends the frame at the reflected
 * position. `travel_q32` stores the velocity after the bounce until the next frame. */
static void bounce(struct bullets *b, const struct box *f, uint32_t i, unsigned walls)
{
    int64_t x = (int64_t)b->x[i] + b->vx[i], y = (int64_t)b->y[i] + b->vy[i];
    fx vx = b->vx[i], vy = b->vy[i];
    const bool side = reflect(b->x[i], &x, &vx, f->x0, f->x1, walls & HOW_LEFT, walls & HOW_RIGHT);
    const bool end = reflect(b->y[i], &y, &vy, f->y0, f->y1, walls & HOW_TOP, walls & HOW_BOTTOM);

    if (!side && !end)
        return;
    if (vx != b->vx[i])
        b->dir[i] = 0x80000000u - b->dir[i];
    if (vy != b->vy[i])
        b->dir[i] = 0u - b->dir[i];
    b->travel_q32[i] = (int64_t)((uint64_t)(uint32_t)vx << 32 | (uint32_t)vy);
    bullets_store_velocity(b, i, (fx)(x - b->x[i]), (fx)(y - b->y[i]));
}

/* In the frame after a bounce, restores the velocity stored by `bounce`, unless a script has set the velocity. */
static void bounced(struct bullets *b, uint32_t i, unsigned step_flags)
{
    if (!(step_flags & (OVERRIDE_DIR | OVERRIDE_SPEED)))
        bullets_store_velocity(b, i, (fx)(b->travel_q32[i] >> 32), (fx)b->travel_q32[i]);
    b->travel_q32[i] = 0;
}

/* Runs a frame of bullet i's flight to a wall. The step's `over` frames count from the start of the loop of bounces, at
 * clock `speed_q32` - 1. Returns pc if the flight continues, otherwise the step to run next in this frame. */
static uint32_t fly_to_wall(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags,
                            uint32_t pc)
{
    const struct steps *s = w->steps;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + pc;

    if (b->travel_q32[i]) {
        bounced(b, i, step_flags);
        return pc + 1;
    }
    if (w->clock + 1 - (uint32_t)b->speed_q32[i] >= s->over[st])
        return s->jump[st];
    bounce(b, &w->field, i, s->how[st]);
    return pc;
}

/* ---- waiting ---- */

/* Returns whether `now` is at `line`, or beyond `line` as seen from `from`. */
static bool crossed(fx from, fx now, fx line)
{
    return from <= line ? now >= line : now <= line;
}

/* Returns whether the wait condition of step st holds for bullet i. */
static bool has_come(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st)
{
    const struct steps *s = w->steps;

    switch (s->how[st]) {
    case HOW_X:
        return crossed((fx)(b->step_start[i] >> 32), b->x[i], s->x[st]);
    case HOW_Y:
        return crossed((fx)b->step_start[i], b->y[i], s->y[st]);
    case HOW_NEAR: {
        const int32_t t = targets_nearest(&w->targets, b->x[i], b->y[i]);
        b->ran += steps_of_aim(&w->targets);
        return t != NO_SLOT && bullets_target_distance(&w->targets, (uint32_t)t, b->x[i], b->y[i]) <
                                   (uint64_t)((int64_t)s->size[st] * s->size[st]);
    }
    default:
        return step_flags & STEP_SIGNALLED;
    }
}

void bullets_signal(struct bullets *b, const struct motion_world *w, uint32_t i, uint16_t tag)
{
    if (!b->motion[i] || !(b->step_flags[i] & STEP_BEGUN))
        return;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + b->pc[i];
    if (!(w->steps->does[st] & DOES_AWAIT) || w->steps->how[st] != HOW_SIGNAL)
        return;
    if (tag && w->steps->count[st] != tag)
        return;
    b->step_flags[i] |= STEP_SIGNALLED;
    if (!bullets_stands(b, i))
        bullets_set_busy(b, i, true);
}

/* ---- steps of one bullet ---- */

/* Runs step st, which opens or closes a loop. Returns the next step, relative to the program's first step. */
static inline uint32_t loop_step(const struct steps *s, uint16_t *rounds, uint32_t st, uint32_t pc)
{
    uint16_t *left = &rounds[s->depth[st]];

    if (s->does[st] & DOES_LOOP) {
        *left = s->count[st];
        return *left ? pc + 1 : s->jump[st];
    }
    return *left == MOTION_FOREVER || --*left ? s->jump[st] : pc + 1;
}

/* The state of a running program, which keep_run saves in the columns `pc` and `step_flags`. */
struct run {
    uint32_t pc;
    unsigned step_flags;
};

static void keep_run(struct bullets *b, uint32_t i, const struct run *r)
{
    b->pc[i] = (uint16_t)r->pc;
    b->step_flags[i] = (uint8_t)r->step_flags;
}

static enum program_state step_over(struct run *r)
{
    r->step_flags = 0;
    r->pc++;
    return PROGRAM_NEXT;
}

/* Runs a step of a loop, bounce or emit. */
static enum program_state run_turn(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                   struct run *r)
{
    const unsigned does = w->steps->does[st];

    if (does & (DOES_LOOP | DOES_NEXT)) {
        r->pc = loop_step(w->steps, &b->rounds[i * MOTION_DEPTH], st, r->pc);
        if (does & DOES_BOUNCE)
            b->speed_q32[i] = (int64_t)w->clock + 1;
        return PROGRAM_NEXT;
    }
    if (does & DOES_EMIT) {
        w->emit(w, b, i, st);
        r->pc += EMIT_ROWS;
        return PROGRAM_NEXT;
    }
    const uint32_t next = fly_to_wall(b, w, i, r->step_flags, r->pc);
    const bool flies = next == r->pc;
    r->step_flags = flies ? r->step_flags | STEP_BEGUN : 0;
    keep_run(b, i, r);
    r->pc = next;
    return flies ? PROGRAM_RUNS : PROGRAM_NEXT;
}

/* Starts step st. Returns the length of the step in frames. */
static inline uint32_t begin_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                  unsigned does)
{
    uint32_t n = w->steps->over[st];

    b->step_start[i] = bullets_speed(b, i);
    if (does & DOES_LEAD)
        n = begin_lead(b, w, i, st);
    else if (does & DOES_AWAIT)
        b->step_start[i] = (int64_t)((uint64_t)(uint32_t)b->x[i] << 32 | (uint32_t)b->y[i]);
    b->step_end[i] = w->clock + n;
    if (does & (DOES_KIND | DOES_BANK))
        restyle(b, w, i, st);
    return n;
}

/* Runs a step other than a loop, bounce or emit. `does` has the step's actions. Inlined, because a caller that masks
 * `does` with a constant gets no code for the other actions. */
__attribute__((always_inline)) static inline enum program_state
do_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, unsigned does, struct run *r)
{
    uint32_t n;

    if (!(r->step_flags & STEP_BEGUN))
        n = begin_step(b, w, i, st, does);
    else
        n = does & DOES_LEAD ? frames_led(b, w->steps, i, st) : w->steps->over[st];
    if (does & DOES_DIE) {
        bullets_drop(b, i);
        return PROGRAM_OVER;
    }
    if (n && b->step_end[i] != w->clock) {
        r->step_flags |= STEP_BEGUN;
        keep_run(b, i, r);
        if (does & DOES_DRIVE)
            drive(b, w, i, r->step_flags, st, n - (b->step_end[i] - w->clock) + 1, n);
        else if (does & (DOES_LEAD | DOES_AWAIT)) {
            if (does & DOES_LEAD ? !lead_on(b, w, i, r->step_flags, st, n) : has_come(b, w, i, r->step_flags, st))
                return step_over(r);
        }
        b->due[i] = (uint8_t)b->step_end[i];
        const bool acts = does & (DOES_DRIVE | DOES_LEAD) || (does & DOES_AWAIT && w->steps->how[st] != HOW_SIGNAL);
        return acts || b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_WAITS;
    }
    if (!n && does & DOES_DRIVE)
        drive(b, w, i, r->step_flags, st, 1, 1);
    if (does & DOES_LEAD && n)
        let_go(b, i, r->step_flags & OVERRIDE_PLACE ? 0 : does);
    return step_over(r);
}

static enum program_state run_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                   struct run *r)
{
    return do_step(b, w, i, st, w->steps->does[st], r);
}

/* Runs a step with named values. Not inlined, because own_step's work would slow down all other steps. */
__attribute__((noinline)) static enum program_state run_named(struct bullets *b, const struct motion_world *w,
                                                              uint32_t i, uint32_t st, struct run *r)
{
    struct own_step own;

    own_step(b, w, i, st, r->step_flags & STEP_BEGUN, &own);
    return run_step(b, &own.w, i, 0, r);
}

/* Runs bullet i's program in this frame. */
static enum program_state run_program(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t program = b->motion[i] - 1u, first = w->motions->first[program],
                   length = w->motions->length[program];
    const bool fine = b->flags[i] & BULLET_FINE;
    struct run r = { b->pc[i], b->step_flags[i] };

    while (r.pc < length) {
        const uint32_t st = first + r.pc;
        const unsigned does = w->steps->does[st];
        enum program_state state = PROGRAM_NEXT;

        b->ran++;
        if (!(does & ~(unsigned)(DOES_DRIVE | DOES_WAIT))) /* most steps */
            state = do_step(b, w, i, st, does & (DOES_DRIVE | DOES_WAIT), &r);
        else if (does == DOES_NEXT && b->ran <= w->most)
            r.pc = loop_step(w->steps, &b->rounds[i * MOTION_DEPTH], st, r.pc);
        else if (b->ran > w->most) /* over the limit: the frame ends in a fault */
            return PROGRAM_RUNS;
        else {
            struct run other = r; /* a copy, so that r stays in registers for most steps */
            if (does & (DOES_LOOP | DOES_NEXT | DOES_BOUNCE | DOES_EMIT))
                state = run_turn(b, w, i, st, &other);
            else if (does & DOES_NAMED)
                state = run_named(b, w, i, st, &other);
            else
                state = run_step(b, w, i, st, &other);
            r = other;
        }
        if (state != PROGRAM_NEXT)
            return state;
    }
    keep_run(b, i, &r);
    if (!fine)
        b->motion[i] = 0;
    return fine ? PROGRAM_RUNS : PROGRAM_OVER;
}

/* Returns whether the wait of idle bullet i is over. If it was a delay, the bullet gets the row of its kind instead of
 * the cloud's and starts to move. */
static inline bool is_over(struct bullets *b, const struct motion_world *w, uint32_t i)
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

/* Runs bullet i's program, if it has one, and prepares its fine move, if it is fine. */
static enum program_state go_on(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    enum program_state state = b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_OVER;

    if (b->motion[i])
        state = run_program(b, w, i);
    if (b->flags[i] & BULLET_FINE)
        fly(b, i);
    return state;
}

/* ---- steps that have begun, for several bullets together ---- */

/* In the middle of a step, all bullets of one ring do the same work; so do fine bullets without a step to run, which
 * only fly. Bullets of a block that do the same work are on the same "course" and are processed together, column by
 * column. The result equals that of go_on for each bullet, in any order, because until the block moves no bullet of the
 * block reads a value that another one writes.
 */
struct course {
    uint32_t motion, pc; /* motion, pc and step_flags of every bullet on the course */
    unsigned step_flags;
    bool fine;
    bool is, timed;    /* whether the course exists; whether it is in a step, which ends at `step_end` */
    bool never;        /* no bullet at this step can be on a course */
    uint32_t st, does; /* the step, and its DOES_DRIVE actions that no script has overridden */
    bool has_steering; /* the step has DOES_STEER actions, even if overridden */
};

/* A set of n bullets of a block: if `row`, the n slots from `first` on, otherwise the slots in `slot`. */
struct some {
    int n;
    bool row;
    uint32_t first;
    uint32_t slot[SLOTS_BLOCK];
};

static inline uint32_t nth(const struct some *s, int k)
{
    return s->row ? s->first + (uint32_t)k : s->slot[k];
}

/* Sets *s to the bullets in `who`: bits, not all 0, of the block that starts at slot `first`. */
static void take_some(struct some *s, uint32_t first, uint64_t who)
{
    const uint32_t low = bits_lowest(who);
    const uint64_t row = who >> low;

    s->first = first + low;
    s->row = !(row & (row + 1));
    if (s->row) {
        s->n = ~row ? (int)bits_lowest(~row) : SLOTS_BLOCK;
        return;
    }
    for (s->n = 0; who; who &= who - 1)
        s->slot[s->n++] = first + bits_lowest(who);
}

static void take_course(struct course *c, const struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const struct steps *s = w->steps;
    const uint32_t others =
        DOES_NAMED | DOES_DIE | DOES_LEAD | DOES_AWAIT | DOES_LOOP | DOES_NEXT | DOES_BOUNCE | DOES_EMIT;

    c->motion = b->motion[i];
    c->pc = b->pc[i];
    c->step_flags = b->step_flags[i];
    c->fine = b->flags[i] & BULLET_FINE;
    c->does = 0;
    c->has_steering = c->never = false;
    c->timed = c->motion && c->pc < w->motions->length[c->motion - 1];
    c->is = c->fine;
    if (!c->timed)
        return;
    const uint32_t st = w->motions->first[c->motion - 1] + c->pc, does = s->does[st];
    c->never = does & others;
    c->is = c->step_flags & STEP_BEGUN && !c->never && (c->fine || does & DOES_DRIVE);
    if (!c->is)
        return;
    c->does = does & DOES_DRIVE;
    c->has_steering = does & DOES_STEER;
    if (c->step_flags & OVERRIDE_DIR)
        c->does &= ~(uint32_t)DOES_STEER;
    if (c->step_flags & OVERRIDE_SPEED)
        c->does &= ~(uint32_t)(DOES_SPEED | DOES_ACCEL);
    c->st = st;
}

static inline bool on_course(const struct bullets *b, const struct course *c, uint32_t i)
{
    return b->motion[i] == c->motion && b->pc[i] == c->pc && b->step_flags[i] == c->step_flags &&
           !(b->flags[i] & BULLET_FINE) == !c->fine;
}

/* Sets out[k] to 1 for the bullets of a block on course c, otherwise to 0. */
static void course_block(const uint16_t *restrict motion, const uint16_t *restrict pc,
                         const uint8_t *restrict step_flags, const uint8_t *restrict flags, const struct course *c,
                         uint8_t *restrict out)
{
    const uint16_t is_motion = (uint16_t)c->motion, is_pc = (uint16_t)c->pc;
    const uint8_t is_mute = (uint8_t)c->step_flags, is_fine = c->fine ? BULLET_FINE : 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = (uint8_t)((motion[k] == is_motion) & (pc[k] == is_pc));
    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] &= (uint8_t)((step_flags[k] == is_mute) & ((flags[k] & BULLET_FINE) == is_fine));
}

/* Returns, as bits, the bullets of a block whose step ends in this frame, which must be run by go_on. */
static uint64_t ends_block(const uint32_t *restrict end, uint32_t clock)
{
    uint8_t out[SLOTS_BLOCK];

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = end[k] == clock;
    return slots_gather(out);
}

enum { WORTH = 6 /* number of bullets of a block on one course from which processing them together is faster */ };

/* Returns whether any of the lowest `few` bullets in `rest`, the bits of the block at slot `first`, is on course c. */
static bool has_company(const struct bullets *b, const struct course *c, uint32_t first, uint64_t rest, int few)
{
    for (; rest && few > 0; few--, rest &= rest - 1)
        if (on_course(b, c, first + bits_lowest(rest)))
            return true;
    return false;
}

/* Returns, as bits, the bullets of the block at slot `first` that are on course c and whose step does not end in this
 * frame. Not inlined, so that run_programs' loop over single bullets has enough registers. */
__attribute__((noinline)) static uint64_t all_alike(const struct bullets *b, const struct motion_world *w,
                                                    const struct course *c, uint32_t first)
{
    uint8_t out[SLOTS_BLOCK];

    course_block(b->motion + first, b->pc + first, b->step_flags + first, b->flags + first, c, out);
    return slots_gather(out) & (c->timed ? ~ends_block(b->step_end + first, w->clock) : UINT64_MAX);
}

/* Returns, as bits, the bullets in `of` that are on bullet i's course, or 0 if i is on none. The bits in `of` are of
 * i's block, and i is the lowest. Scanning the whole block is expensive, so the next *few bullets in `of` are probed
 * first. If none of them is on the course, sets *few to 1 and returns i alone. */
static uint64_t alike(const struct bullets *b, const struct motion_world *w, struct course *c, uint32_t i, uint64_t of,
                      int *few)
{
    const uint32_t first = i / SLOTS_BLOCK * SLOTS_BLOCK;

    if (c->never && b->motion[i] == c->motion && b->pc[i] == c->pc)
        return 0;
    if (!on_course(b, c, i))
        take_course(c, b, w, i);
    if (!c->is || (c->timed && b->step_end[i] == w->clock))
        return 0;
    if (!has_company(b, c, first, of & (of - 1), *few)) {
        *few = 1;
        return bullets_bit(i);
    }
    return of & all_alike(b, w, c, first);
}

enum { FEW = 4 };

/* Returns the number of targets, or FEW + 1 if there are more than FEW, and stores the slots of the first FEW. */
static int few_targets(const struct targets *t, uint32_t found[FEW])
{
    const uint32_t end = t->s->used ? t->s->top : t->s->live;
    int n = 0;

    for (uint32_t i = 0; i < end && n <= FEW; i++) {
        if (t->s->used && !(t->s->used[i / SLOTS_BLOCK] & bullets_bit(i))) {
            if (!t->s->used[i / SLOTS_BLOCK])
                i |= SLOTS_BLOCK - 1;
        } else if (!t->in || t->in[i]) {
            if (n < FEW)
                found[n] = i;
            n++;
        }
    }
    return n;
}

/* Sets dir[k] to the result of targets_aim for the k-th bullet of s, with the old dir[k] as `none`. */
static void aim_some(const struct bullets *b, const struct targets *t, const struct some *s, ang *dir)
{
    uint32_t few[FEW];
    fx dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];
    ang to[SLOTS_BLOCK];
    const int n = s->n > 1 ? few_targets(t, few) : FEW + 1;

    for (int k = 0; n > FEW && k < s->n; k++)
        dir[k] = targets_aim(t, b->x[nth(s, k)], b->y[nth(s, k)], dir[k]);
    if (!n || n > FEW)
        return;
    for (int k = 0; n == 1 && k < s->n; k++) {
        dx[k] = fx_sub(t->x[few[0]], b->x[nth(s, k)]);
        dy[k] = fx_sub(t->y[few[0]], b->y[nth(s, k)]);
    }
    for (int k = 0; n > 1 && k < s->n; k++) {
        const fx x = b->x[nth(s, k)], y = b->y[nth(s, k)];
        uint32_t nearest = few[0];
        for (int other = 1; other < n; other++)
            if (bullets_target_distance(t, few[other], x, y) < bullets_target_distance(t, nearest, x, y))
                nearest = few[other];
        dx[k] = fx_sub(t->x[nearest], x);
        dy[k] = fx_sub(t->y[nearest], y);
    }
    trig_atan2s(dy, dx, to, s->n);
    for (int k = 0; k < s->n; k++)
        dir[k] = dx[k] | dy[k] ? to[k] : dir[k];
}

static void turn_some(const struct bullets *b, const struct motion_world *w, const struct course *c,
                      const struct some *s, ang *dir)
{
    ang goal[SLOTS_BLOCK];

    if (c->does & DOES_DIR)
        for (int k = 0; k < s->n; k++)
            dir[k] = w->steps->dir[c->st];
    if (c->does & DOES_AIM)
        aim_some(b, &w->targets, s, dir);
    if (c->does & DOES_TURN)
        for (int k = 0; k < s->n; k++)
            dir[k] += (ang)w->steps->turn[c->st];
    if (!(c->does & DOES_HOME))
        return;
    memcpy(goal, dir, (size_t)s->n * sizeof *dir);
    aim_some(b, &w->targets, s, goal);
    for (int k = 0; k < s->n; k++)
        dir[k] = toward(dir[k], goal[k], w->steps->home[c->st]);
}

/* Changes the speed of all bullets of s. For consecutive bullets with equal step_start and step_end, the result of
 * motion_part_way is computed once. */
static void speed_some(struct bullets *b, const struct motion_world *w, const struct course *c, const struct some *s)
{
    const int shift = c->fine ? 0 : PACE_BITS;
    const int64_t most = (int64_t)MAX_SPEED << (c->fine ? 32 : 16);
    const int64_t goal = w->steps->speed[c->st] >> shift, accel = w->steps->accel[c->st] >> shift;
    const uint32_t over = w->steps->over[c->st];
    int64_t from = 0, reached = 0;
    uint32_t end = w->clock; /* matches no bullet: a bullet whose step ends now is on no course */
    for (int k = 0; k < s->n; k++) {
        const uint32_t i = nth(s, k);
        int64_t v = c->fine ? b->speed_q32[i] : b->speed[i];
        if (c->does & DOES_SPEED) {
            const int64_t began = b->step_start[i] >> shift;
            if (b->step_end[i] != end || began != from) {
                from = began;
                end = b->step_end[i];
                reached = motion_part_way(from, goal, over - (end - w->clock) + 1, over);
            }
            v = reached;
        }
        v = int64_clamp(c->does & DOES_ACCEL ? v + accel : v, -most, most);
        if (c->fine)
            b->speed_q32[i] = v;
        b->speed[i] = c->fine ? bullets_pace_fx(v) : (fx)v;
    }
}

/* Runs `fly` for all bullets of s. */
static void fly_some(struct bullets *b, const struct some *s, const ang *dir)
{
    int64_t from[SLOTS_BLOCK], to[SLOTS_BLOCK], dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];

    for (int k = 0; k < s->n; k++) {
        from[k] = b->travel_q32[nth(s, k)];
        to[k] = from[k] + b->speed_q32[nth(s, k)];
    }
    trig_strides(from, to, dir, dx, dy, s->n);
    for (int k = 0; k < s->n; k++)
        fly_by(b, nth(s, k), to[k], dx[k], dy[k]);
}

/* Like bullets_steer, for all bullets of s. None of them is frozen, because frozen bullets run no program. */
static void steer_some(struct bullets *b, const struct some *s, const ang *dir)
{
    fx speed[SLOTS_BLOCK], to_x[SLOTS_BLOCK], to_y[SLOTS_BLOCK], most = b->fastest;
    fx *vx = s->row ? b->vx + s->first : to_x, *vy = s->row ? b->vy + s->first : to_y;

    for (int k = 0; !s->row && k < s->n; k++)
        speed[k] = b->speed[s->slot[k]];
    trig_polars(s->row ? b->speed + s->first : speed, dir, vx, vy, s->n);
    for (int k = 0; !s->row && k < s->n; k++) {
        b->vx[s->slot[k]] = vx[k];
        b->vy[s->slot[k]] = vy[k];
    }
    if (s->n == SLOTS_BLOCK)
        most = fx_max(most, bullets_fastest_block(vx, vy));
    else
        for (int k = 0; k < s->n; k++)
            most = fx_max(most, fx_max(fx_abs(vx[k]), fx_abs(vy[k])));
    b->fastest = most;
}

/* Runs a frame of the bullets of s, which are on course c. Not inlined, for the same reason as all_alike. */
__attribute__((noinline)) static void keep_course(struct bullets *b, const struct motion_world *w,
                                                  const struct course *c, const struct some *s)
{
    ang gathered[SLOTS_BLOCK], *dir = s->row ? b->dir + s->first : gathered;

    for (int k = 0; !s->row && k < s->n; k++)
        dir[k] = b->dir[s->slot[k]];
    if (c->timed)
        b->ran += (uint64_t)s->n;
    if (c->does & DOES_STEER) {
        if (c->does & (DOES_AIM | DOES_HOME))
            b->ran += (uint64_t)s->n * steps_of_aim(&w->targets);
        turn_some(b, w, c, s, dir);
        for (int k = 0; !s->row && k < s->n; k++)
            b->dir[s->slot[k]] = dir[k];
    }
    if (c->does & (DOES_SPEED | DOES_ACCEL))
        speed_some(b, w, c, s);
    if (c->fine)
        fly_some(b, s, dir);
    else if (c->has_steering || c->does & (DOES_SPEED | DOES_ACCEL))
        steer_some(b, s, dir);
}

/* Runs a frame of bullet i, alone on course c. Adds the bullet to `later` if its velocity must be recomputed. */
static void keep_alone(struct bullets *b, const struct motion_world *w, const struct course *c, uint32_t i,
                       struct some *later)
{
    const uint32_t n = w->steps->over[c->st];

    b->ran++;
    if (turn_and_speed(b, w, i, c->step_flags, c->st, n - (b->step_end[i] - w->clock) + 1, n))
        later->slot[later->n++] = i;
}

static void steer_later(struct bullets *b, struct some *later)
{
    ang dir[SLOTS_BLOCK];

    for (int k = 0; k < later->n; k++)
        dir[k] = b->dir[later->slot[k]];
    steer_some(b, later, dir);
}

/* Runs the woken bullets of a block that has no busy bullets, the most common case. */
static void run_woken(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    uint64_t busy = 0, idle = b->idle[block] & ~woken;

    for (uint64_t m = woken; m; m &= m - 1) {
        const uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        const enum program_state state = is_over(b, w, i) ? go_on(b, w, i) : PROGRAM_WAITS;
        busy |= state == PROGRAM_RUNS ? bullets_bit(i) : 0;
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
    }
    b->busy[block] = busy;
    b->idle[block] = idle;
}

static void run_programs(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    const uint32_t first = block * SLOTS_BLOCK;
    uint64_t busy = b->busy[block], idle = b->idle[block] & ~woken;
    struct course c = { .motion = UINT32_MAX }; /* matches no bullet */
    struct some some, later;
    int few = 1 + bits_count(busy) / WORTH;

    later.n = 0;
    later.row = false;
    for (uint64_t m = busy | woken; m;) {
        const uint32_t i = first + bits_lowest(m);
        const uint64_t who = woken & bullets_bit(i) ? 0 : alike(b, w, &c, i, m & ~woken, &few);
        if (who) { /* the bullets in `who` are busy and stay busy */
            if (who == bullets_bit(i) && !c.fine)
                keep_alone(b, w, &c, i, &later);
            else {
                take_some(&some, first, who);
                keep_course(b, w, &c, &some);
            }
            m &= ~who;
            continue;
        }
        enum program_state state = PROGRAM_WAITS;
        if (!(woken & bullets_bit(i)) || is_over(b, w, i))
            state = go_on(b, w, i);
        busy = state == PROGRAM_RUNS ? busy | bullets_bit(i) : busy & ~bullets_bit(i);
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
        m &= m - 1;
    }
    if (later.n)
        steer_later(b, &later);
    b->busy[block] = busy;
    b->idle[block] = idle;
}

void bullets_run_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    if (b->busy[block])
        run_programs(b, w, block, woken);
    else if (woken)
        run_woken(b, w, block, woken);
}

bool bullets_go_on(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t block = i / SLOTS_BLOCK;

    if (b->busy[block] & bullets_bit(i) || (b->idle[block] & bullets_bit(i) && is_over(b, w, i))) {
        enum program_state state = go_on(b, w, i);
        if (!(b->s.used[block] & bullets_bit(i)))
            return false;
        bullets_set_busy(b, i, state == PROGRAM_RUNS);
        b->idle[block] |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
    }
    b->x[i] += b->vx[i];
    b->y[i] += b->vy[i];
    b->moved++;
    return true;
}
