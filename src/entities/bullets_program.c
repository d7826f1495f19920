/*
 * bullets_program.c - runs motion programs (motion.h) on bullets.
 */
#include "bullets_parts.h"
#include <string.h>

enum program_state {
    PROGRAM_NEXT,  /* the next step follows in this frame */
    PROGRAM_ENDED, /* the program ended, or the bullet was removed */
    PROGRAM_RUNS,  /* the program runs in the next frame too */
    PROGRAM_WAITS, /* the program does nothing until the clock reaches `step_end` */
};

/* Returns the cost of a search for the nearest target, in motion steps. */
static uint64_t aim_cost(const struct targets *t)
{
    return t->s->live_bits ? t->s->top / (SLOTS_BLOCK / 2) : 0;
}

static ang turn_toward(ang dir, ang goal, ang limit)
{
    int32_t gap = trig_difference(dir, goal);
    uint32_t angle = gap < 0 ? 0u - (uint32_t)gap : (uint32_t)gap;

    if (angle <= limit)
        return goal;
    return gap < 0 ? dir - limit : dir + limit;
}

enum { DOES_STEER = DOES_DIR | DOES_AIM | DOES_TURN | DOES_HOME, DOES_DRIVE = DOES_STEER | DOES_SPEED | DOES_ACCEL };

/* Changes the direction and speed of bullet i in the k-th of the n frames of step st. Returns whether the caller must
 * recompute the velocity. */
static inline __attribute__((always_inline)) bool change_dir_and_speed(struct bullets *b, const struct motion_world *w,
                                                                       uint32_t i, unsigned step_flags, uint32_t st,
                                                                       uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    const unsigned actions = s->actions[st];

    if (!(step_flags & OVERRIDE_DIR)) {
        if (actions & (DOES_AIM | DOES_HOME))
            b->work_done += aim_cost(&w->targets);
        if (actions & DOES_DIR)
            b->dir[i] = s->dir[st];
        if (actions & DOES_AIM)
            b->dir[i] = targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]);
        if (actions & DOES_TURN)
            b->dir[i] += (ang)s->turn[st];
        if (actions & DOES_HOME)
            b->dir[i] = turn_toward(b->dir[i], targets_aim(&w->targets, b->x[i], b->y[i], b->dir[i]), s->home[st]);
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

/* Prepares a move of fine bullet i by (dx, dy) in Q32: sets the fraction bits to those after the move, vx and vy to the
 * move in whole units of fx, and `travel_q32` to `travel`, modulo 2^48. */
static void prepare_fine_move(struct bullets *b, uint32_t i, int64_t travel, int64_t dx, int64_t dy)
{
    int64_t x, y;

    bullets_get_position(b, i, &x, &y);
    const fx nx = bullets_split_coordinate(x + dx, &b->x_low[i]), ny = bullets_split_coordinate(y + dy, &b->y_low[i]);
    bullets_store_velocity(b, i, nx - b->x[i], ny - b->y[i]);
    b->travel_q32[i] = (int64_t)((uint64_t)travel << 16) >> 16;
}

/* Prepares a move of fine bullet i along dir by its speed. */
static void prepare_flight(struct bullets *b, uint32_t i)
{
    const int64_t to = b->travel_q32[i] + b->speed_q32[i];
    int64_t dx, dy;

    trig_stride(b->travel_q32[i], to, b->dir[i], &dx, &dy);
    prepare_fine_move(b, i, to, dx, dy);
}

/* Sets bullet i's kind and bank as step st specifies. */
static void set_kind_and_bank(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;

    if (s->actions[st] & DOES_KIND && w->kinds)
        bullets_set_kind(b, w->kinds, i, s->kind[st]);
    if (s->actions[st] & DOES_BANK)
        b->bank[i] = s->bank[st];
}

static void drive(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st,
                  uint32_t k, uint32_t n)
{
    if (change_dir_and_speed(b, w, i, step_flags, st, k, n))
        bullets_set_velocity_from_dir(b, i);
}

/* A step whose named numbers are replaced by a bullet's values. `steps` is a list whose entry 0 is `step`; `w` is the
 * world with that list. */
struct resolved_step {
    struct motion_step step;
    struct steps steps;
    struct motion_world w;
};

/* Builds *resolved: step st with its named numbers replaced by bullet i's values as they were when the step began. If
 * the step has not `begun` yet, it begins now, and the present values are saved first. */
static void resolve_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, bool begun,
                         struct resolved_step *resolved)
{
    struct motion_step *p = &resolved->step;

    for (int k = 0; !begun && k < MAX_VALUES && bullets_value_column(b, k); k++)
        bullets_step_value_column(b, k)[i] = bullets_value_column(b, k)[i];
    motion_get_step(w->steps, st, p);
    for (uint64_t remaining = p->named_values; remaining;) {
        const int n = (int)bits_lowest(remaining) / NAMED_VALUE_BITS;
        bool is_named;
        const int k = motion_value_column(remaining, n, w->is_shots, &is_named);
        motion_set_number(p, (enum step_number)n,
                          k < 0 || !bullets_step_value_column(b, k) ? 0 : bullets_step_value_column(b, k)[i]);
        remaining &= ~(((uint64_t)(1 << NAMED_VALUE_BITS) - 1) << n * NAMED_VALUE_BITS);
    }
    resolved->steps = (struct steps){ .actions = &p->actions,
                                      .duration = &p->duration,
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
                                      .named_values = &p->named_values,
                                      .x = &p->x,
                                      .y = &p->y,
                                      .size = &p->size,
                                      .size_to = &p->size_to,
                                      .mode = &p->mode };
    resolved->w = *w;
    resolved->w.steps = &resolved->steps;
}

/* ---- steps that lead a bullet ---- */

/* Saves the state of a leading step in `step_start` and `travel_q32`. Both are unused at that time, because a leading
 * step has no DOES_DRIVE actions and does not occur in a fine motion. */
static void save_lead(struct bullets *b, uint32_t i, const struct motion_lead *l)
{
    b->step_start[i] = (int64_t)((uint64_t)(uint32_t)l->x << 32 | (uint32_t)l->y);
    b->travel_q32[i] = (int64_t)((uint64_t)(uint32_t)l->radius << 32 | l->angle);
}

static struct motion_lead load_lead(const struct bullets *b, uint32_t i)
{
    return (struct motion_lead){ .x = (fx)(b->step_start[i] >> 32),
                                 .y = (fx)b->step_start[i],
                                 .radius = (fx)(b->travel_q32[i] >> 32),
                                 .angle = (ang)b->travel_q32[i],
                                 .speed = b->speed[i] };
}

/* Sets (*x, *y) to the position of bullet i's `orbit_target` in this frame or, if `previous_frame`, in the previous
 * frame. Returns false if the target has despawned or is not set. */
static bool find_orbit_centre(const struct bullets *b, const struct motion_world *w, uint32_t i, bool previous_frame,
                              fx *x, fx *y)
{
    return b->orbit_target && b->orbit_target[i] &&
           w->get_position(w, b->orbit_target[i], i / SLOTS_BLOCK * SLOTS_BLOCK, previous_frame, x, y);
}

/* Returns the number of frames that the go_to step st takes from (x, y) at the step's speed, rounded up, at least 1. */
static uint32_t frames_to_goal(const struct steps *s, uint32_t st, fx x, fx y)
{
    const uint32_t d = (uint32_t)fx_hypot(fx_sub(s->x[st], x), fx_sub(s->y[st], y));
    const uint32_t speed = s->speed[st] < FX_ONE ? 1 : (uint32_t)(s->speed[st] >> Q32_EXTRA_BITS);

    return d ? (d - 1) / speed + 1 : 1;
}

/* Returns the total number of frames for which step st, which has begun, leads bullet i. */
static uint32_t lead_duration(const struct bullets *b, const struct steps *s, uint32_t i, uint32_t st)
{
    return s->mode[st] & MODE_SPEED ? (uint32_t)(b->travel_q32[i] >> 32) : s->duration[st];
}

/* Starts a step that leads bullet i. Returns the step's length in frames, or 0 if the orbit target has despawned. */
static uint32_t begin_lead(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;
    const uint32_t actions = s->actions[st];
    const bool has_centre = actions & DOES_ORBIT || s->mode[st] & MODE_HAS_CENTRE;
    struct motion_lead l = { .x = b->x[i], .y = b->y[i], .angle = b->dir[i] };
    uint32_t n = s->duration[st];

    if (s->mode[st] & MODE_HAS_CENTRE) {
        l.x = s->x[st];
        l.y = s->y[st];
    } else if (actions & DOES_ORBIT && !find_orbit_centre(b, w, i, true, &l.x, &l.y))
        return 0;
    if (has_centre) {
        fx dx = fx_sub(b->x[i], l.x), dy = fx_sub(b->y[i], l.y);
        l.radius = fx_hypot(dx, dy);
        l.angle = dx || dy ? trig_atan2(dy, dx) : l.angle;
    }
    if (s->mode[st] & MODE_SPEED) {
        n = frames_to_goal(s, st, l.x, l.y);
        l.radius = (fx)n;
    }
    save_lead(b, i, &l);
    return n;
}

/* Sets the velocity with which bullet i ends this frame at (x, y), and, except in a wave, dir and speed. If the
 * velocity would exceed MAX_SPEED on an axis, places the bullet at (x, y) at once, with velocity 0. */
static void lead_to(struct bullets *b, uint32_t i, bool is_wave, fx x, fx y)
{
    const int64_t limit = (int64_t)MAX_SPEED << 16, dx = (int64_t)x - b->x[i], dy = (int64_t)y - b->y[i];

    if (int64_abs(dx) > limit || int64_abs(dy) > limit) {
        b->x[i] = x;
        b->y[i] = y;
        b->vx[i] = b->vy[i] = 0;
        return;
    }
    bullets_store_velocity(b, i, (fx)dx, (fx)dy);
    if (is_wave)
        return;
    if (dx || dy)
        b->dir[i] = trig_atan2((fx)dy, (fx)dx);
    b->speed[i] = fx_min(fx_hypot((fx)dx, (fx)dy), (fx)limit);
}

/* Runs the k-th of n frames of a step that leads bullet i. Returns false if the orbit target has despawned. */
static bool lead_frame(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    struct motion_lead l = load_lead(b, i);
    fx x, y;

    if (s->actions[st] & DOES_ORBIT && !(s->mode[st] & MODE_HAS_CENTRE) &&
        !find_orbit_centre(b, w, i, false, &l.x, &l.y))
        return false;
    motion_lead_position(s, st, &l, k, n, &x, &y);
    lead_to(b, i, s->actions[st] & DOES_WAVE, x, y);
    return true;
}

/* Runs a frame of a step that leads bullet i, unless a script has overridden the step. Returns false if the step
 * ends early. */
static bool run_lead(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st,
                     uint32_t n)
{
    if (step_flags & (OVERRIDE_DIR | OVERRIDE_SPEED | OVERRIDE_POSITION))
        return true;
    if (lead_frame(b, w, i, st, n - (b->step_end[i] - w->clock) + 1, n))
        return true;
    b->travel_q32[i] = 0;
    return false;
}

/* Ends a leading step. The bullet keeps the velocity of the last frame; after a wave it flies along dir. */
static void end_lead(struct bullets *b, uint32_t i, uint32_t actions)
{
    b->travel_q32[i] = 0;
    if (actions & DOES_WAVE)
        bullets_update_velocity(b, i);
}

/* ---- bounces ---- */

/* Reflects a move from `from` to *to, at velocity *v, off the walls at lo (if has_lo) and hi (if has_hi). Returns
 * whether the move was reflected. A move that starts outside the walls is not reflected. */
static bool reflect(fx from, int64_t *to, fx *v, fx lo, fx hi, bool has_lo, bool has_hi)
{
    bool reflected = false;

    if (from < lo || from > hi)
        return false;
    for (;; reflected = true) {
        if (has_lo && *v < 0 && *to < lo)
            *to = 2 * (int64_t)lo - *to;
        else if (has_hi && *v > 0 && *to > hi)
            *to = 2 * (int64_t)hi - *to;
        else
            return reflected;
        *v = -*v;
    }
}

/* Reflects bullet i off the walls that this frame's move would cross. The bullet ends the frame at the reflected
 * position. `travel_q32` stores the velocity after the bounce until the next frame. */
static void bounce(struct bullets *b, const struct box *f, uint32_t i, unsigned walls)
{
    int64_t x = (int64_t)b->x[i] + b->vx[i], y = (int64_t)b->y[i] + b->vy[i];
    fx vx = b->vx[i], vy = b->vy[i];
    const bool bounced_x = reflect(b->x[i], &x, &vx, f->x0, f->x1, walls & MODE_LEFT, walls & MODE_RIGHT);
    const bool bounced_y = reflect(b->y[i], &y, &vy, f->y0, f->y1, walls & MODE_TOP, walls & MODE_BOTTOM);

    if (!bounced_x && !bounced_y)
        return;
    if (vx != b->vx[i])
        b->dir[i] = ANG_HALF - b->dir[i];
    if (vy != b->vy[i])
        b->dir[i] = 0u - b->dir[i];
    b->travel_q32[i] = (int64_t)((uint64_t)(uint32_t)vx << 32 | (uint32_t)vy);
    bullets_store_velocity(b, i, (fx)(x - b->x[i]), (fx)(y - b->y[i]));
}

/* In the frame after a bounce, restores the velocity stored by `bounce`, unless a script has set the velocity. */
static void end_bounce(struct bullets *b, uint32_t i, unsigned step_flags)
{
    if (!(step_flags & (OVERRIDE_DIR | OVERRIDE_SPEED)))
        bullets_store_velocity(b, i, (fx)(b->travel_q32[i] >> 32), (fx)b->travel_q32[i]);
    b->travel_q32[i] = 0;
}

/* Runs a frame of bullet i's flight to a wall. The step's `duration` frames count from the start of the loop of
 * bounces, at clock `speed_q32` - 1. Returns pc if the flight continues, otherwise the step to run next in this
 * frame. */
static uint32_t fly_to_wall(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags,
                            uint32_t pc)
{
    const struct steps *s = w->steps;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + pc;

    if (b->travel_q32[i]) {
        end_bounce(b, i, step_flags);
        return pc + 1;
    }
    if (w->clock + 1 - (uint32_t)b->speed_q32[i] >= s->duration[st])
        return s->jump[st];
    bounce(b, &w->field, i, s->mode[st]);
    return pc;
}

/* ---- waiting ---- */

/* Returns whether `now` is at `line`, or beyond `line` as seen from `from`. */
static bool has_crossed(fx from, fx now, fx line)
{
    return from <= line ? now >= line : now <= line;
}

/* Returns whether the wait condition of step st holds for bullet i. */
static bool wait_condition_holds(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags,
                                 uint32_t st)
{
    const struct steps *s = w->steps;

    switch (s->mode[st]) {
    case MODE_X:
        return has_crossed((fx)(b->step_start[i] >> 32), b->x[i], s->x[st]);
    case MODE_Y:
        return has_crossed((fx)b->step_start[i], b->y[i], s->y[st]);
    case MODE_TARGET_NEAR: {
        const int32_t t = targets_find_nearest(&w->targets, b->x[i], b->y[i]);
        b->work_done += aim_cost(&w->targets);
        return t != NO_SLOT && bullets_target_distance_squared(&w->targets, (uint32_t)t, b->x[i], b->y[i]) <
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
    if (!(w->steps->actions[st] & DOES_AWAIT) || w->steps->mode[st] != MODE_SIGNAL)
        return;
    if (tag && w->steps->count[st] != tag)
        return;
    b->step_flags[i] |= STEP_SIGNALLED;
    if (!bullets_is_frozen(b, i))
        bullets_set_busy(b, i, true);
}

/* ---- steps of one bullet ---- */

/* Runs step st, which opens or closes a loop. Returns the next step, relative to the program's first step. */
static inline uint32_t run_loop_step(const struct steps *s, uint16_t *rounds, uint32_t st, uint32_t pc)
{
    uint16_t *rounds_left = &rounds[s->depth[st]];

    if (s->actions[st] & DOES_LOOP) {
        *rounds_left = s->count[st];
        return *rounds_left ? pc + 1 : s->jump[st];
    }
    return *rounds_left == MOTION_FOREVER || --*rounds_left ? s->jump[st] : pc + 1;
}

/* The state of a running program, which save_program saves in the columns `pc` and `step_flags`. */
struct program_run {
    uint32_t pc;
    unsigned step_flags;
};

static void save_program(struct bullets *b, uint32_t i, const struct program_run *r)
{
    b->pc[i] = (uint16_t)r->pc;
    b->step_flags[i] = (uint8_t)r->step_flags;
}

static enum program_state advance_to_next_step(struct program_run *r)
{
    r->step_flags = 0;
    r->pc++;
    return PROGRAM_NEXT;
}

/* Runs a step of a loop, bounce or emit. */
static enum program_state run_control_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                           struct program_run *r)
{
    const unsigned actions = w->steps->actions[st];

    if (actions & (DOES_LOOP | DOES_LOOP_END)) {
        r->pc = run_loop_step(w->steps, &b->rounds_left[i * MOTION_MAX_DEPTH], st, r->pc);
        if (actions & DOES_BOUNCE)
            b->speed_q32[i] = (int64_t)w->clock + 1;
        return PROGRAM_NEXT;
    }
    if (actions & DOES_EMIT) {
        w->emit(w, b, i, st);
        r->pc += EMIT_STEPS;
        return PROGRAM_NEXT;
    }
    const uint32_t next = fly_to_wall(b, w, i, r->step_flags, r->pc);
    const bool flies = next == r->pc;
    r->step_flags = flies ? r->step_flags | STEP_BEGUN : 0;
    save_program(b, i, r);
    r->pc = next;
    return flies ? PROGRAM_RUNS : PROGRAM_NEXT;
}

/* Starts step st. Returns the length of the step in frames. */
static inline uint32_t begin_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                  unsigned actions)
{
    uint32_t n = w->steps->duration[st];

    b->step_start[i] = bullets_speed(b, i);
    if (actions & DOES_LEAD)
        n = begin_lead(b, w, i, st);
    else if (actions & DOES_AWAIT)
        b->step_start[i] = (int64_t)((uint64_t)(uint32_t)b->x[i] << 32 | (uint32_t)b->y[i]);
    b->step_end[i] = w->clock + n;
    if (actions & (DOES_KIND | DOES_BANK))
        set_kind_and_bank(b, w, i, st);
    return n;
}

/* Runs a step other than a loop, bounce or emit. `actions` has the step's actions. Inlined, because a caller that masks
 * `actions` with a constant gets no code for the other actions. */
__attribute__((always_inline)) static inline enum program_state do_step(struct bullets *b, const struct motion_world *w,
                                                                        uint32_t i, uint32_t st, unsigned actions,
                                                                        struct program_run *r)
{
    uint32_t n;

    if (!(r->step_flags & STEP_BEGUN))
        n = begin_step(b, w, i, st, actions);
    else
        n = actions & DOES_LEAD ? lead_duration(b, w->steps, i, st) : w->steps->duration[st];
    if (actions & DOES_DIE) {
        bullets_drop(b, i);
        return PROGRAM_ENDED;
    }
    if (n && b->step_end[i] != w->clock) {
        r->step_flags |= STEP_BEGUN;
        save_program(b, i, r);
        if (actions & DOES_DRIVE)
            drive(b, w, i, r->step_flags, st, n - (b->step_end[i] - w->clock) + 1, n);
        else if (actions & (DOES_LEAD | DOES_AWAIT)) {
            if (actions & DOES_LEAD ? !run_lead(b, w, i, r->step_flags, st, n)
                                    : wait_condition_holds(b, w, i, r->step_flags, st))
                return advance_to_next_step(r);
        }
        b->step_end_low[i] = (uint8_t)b->step_end[i];
        const bool acts =
            actions & (DOES_DRIVE | DOES_LEAD) || (actions & DOES_AWAIT && w->steps->mode[st] != MODE_SIGNAL);
        return acts || b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_WAITS;
    }
    if (!n && actions & DOES_DRIVE)
        drive(b, w, i, r->step_flags, st, 1, 1);
    if (actions & DOES_LEAD && n)
        end_lead(b, i, r->step_flags & OVERRIDE_POSITION ? 0 : actions);
    return advance_to_next_step(r);
}

static enum program_state run_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                   struct program_run *r)
{
    return do_step(b, w, i, st, w->steps->actions[st], r);
}

/* Runs a step with named values. Not inlined, because resolve_step's work would slow down all other steps. */
__attribute__((noinline)) static enum program_state run_named_step(struct bullets *b, const struct motion_world *w,
                                                                   uint32_t i, uint32_t st, struct program_run *r)
{
    struct resolved_step resolved;

    resolve_step(b, w, i, st, r->step_flags & STEP_BEGUN, &resolved);
    return run_step(b, &resolved.w, i, 0, r);
}

/* Runs bullet i's program in this frame. */
static enum program_state run_program(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t program = b->motion[i] - 1u, first = w->motions->first[program],
                   length = w->motions->length[program];
    const bool fine = b->flags[i] & BULLET_FINE;
    struct program_run r = { b->pc[i], b->step_flags[i] };

    while (r.pc < length) {
        const uint32_t st = first + r.pc;
        const unsigned actions = w->steps->actions[st];
        enum program_state state = PROGRAM_NEXT;

        b->work_done++;
        if (!(actions & ~(unsigned)(DOES_DRIVE | DOES_WAIT))) /* most steps */
            state = do_step(b, w, i, st, actions & (DOES_DRIVE | DOES_WAIT), &r);
        else if (actions == DOES_LOOP_END && b->work_done <= w->work_limit)
            r.pc = run_loop_step(w->steps, &b->rounds_left[i * MOTION_MAX_DEPTH], st, r.pc);
        else if (b->work_done > w->work_limit) /* over the limit: the frame ends in a fault */
            return PROGRAM_RUNS;
        else {
            struct program_run copy = r; /* a copy, so that r stays in registers for most steps */
            if (actions & (DOES_LOOP | DOES_LOOP_END | DOES_BOUNCE | DOES_EMIT))
                state = run_control_step(b, w, i, st, &copy);
            else if (actions & DOES_USE_VALUES)
                state = run_named_step(b, w, i, st, &copy);
            else
                state = run_step(b, w, i, st, &copy);
            r = copy;
        }
        if (state != PROGRAM_NEXT)
            return state;
    }
    save_program(b, i, &r);
    if (!fine)
        b->motion[i] = 0;
    return fine ? PROGRAM_RUNS : PROGRAM_ENDED;
}

/* Returns whether the wait of idle bullet i is over. If it was a delay, the bullet gets the row of its kind instead of
 * the cloud's and starts to move. */
static inline bool finish_wait(struct bullets *b, const struct motion_world *w, uint32_t i)
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

/* Runs bullet i's program, if it has one, and prepares its fine move, if it is fine. */
static enum program_state step_bullet(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    enum program_state state = b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_ENDED;

    if (b->motion[i])
        state = run_program(b, w, i);
    if (b->flags[i] & BULLET_FINE)
        prepare_flight(b, i);
    return state;
}

/* ---- steps that have begun, for several bullets together ---- */

/* In the middle of a step, all bullets of one ring do the same work; so do fine bullets without a step to run, which
 * only fly. Bullets of a block that do the same work are in the same "cohort" and are processed together, column by
 * column. The result equals that of step_bullet for each bullet, in any order, because until the block moves no bullet
 * of the block reads a value that another one writes.
 */
struct cohort {
    uint32_t motion, pc; /* motion, pc and step_flags of every bullet of the cohort */
    unsigned step_flags;
    bool is_fine;
    bool exists, timed;   /* whether the cohort exists; whether it is in a step, which ends at `step_end` */
    bool is_unbatchable;  /* no bullet at this step can be in a cohort */
    uint32_t st, actions; /* the step, and its DOES_DRIVE actions that no script has overridden */
    bool has_steering;    /* the step has DOES_STEER actions, even if overridden */
};

/* A set of n bullets of a block: if `is_contiguous`, the n slots from `first` on, otherwise the slots in `slot`. */
struct batch {
    int n;
    bool is_contiguous;
    uint32_t first;
    uint32_t slot[SLOTS_BLOCK];
};

static inline uint32_t batch_slot(const struct batch *s, int k)
{
    return s->is_contiguous ? s->first + (uint32_t)k : s->slot[k];
}

/* Sets *s to the bullets in `mask`: bits, not all 0, of the block that starts at slot `first`. */
static void fill_batch(struct batch *s, uint32_t first, uint64_t mask)
{
    const uint32_t low = bits_lowest(mask);
    const uint64_t shifted = mask >> low;

    s->first = first + low;
    s->is_contiguous = !(shifted & (shifted + 1));
    if (s->is_contiguous) {
        s->n = ~shifted ? (int)bits_lowest(~shifted) : SLOTS_BLOCK;
        return;
    }
    for (s->n = 0; mask; mask &= mask - 1)
        s->slot[s->n++] = first + bits_lowest(mask);
}

static void set_cohort(struct cohort *c, const struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const struct steps *s = w->steps;
    const uint32_t excluded =
        DOES_USE_VALUES | DOES_DIE | DOES_LEAD | DOES_AWAIT | DOES_LOOP | DOES_LOOP_END | DOES_BOUNCE | DOES_EMIT;

    c->motion = b->motion[i];
    c->pc = b->pc[i];
    c->step_flags = b->step_flags[i];
    c->is_fine = b->flags[i] & BULLET_FINE;
    c->actions = 0;
    c->has_steering = c->is_unbatchable = false;
    c->timed = c->motion && c->pc < w->motions->length[c->motion - 1];
    c->exists = c->is_fine;
    if (!c->timed)
        return;
    const uint32_t st = w->motions->first[c->motion - 1] + c->pc, actions = s->actions[st];
    c->is_unbatchable = actions & excluded;
    c->exists = c->step_flags & STEP_BEGUN && !c->is_unbatchable && (c->is_fine || actions & DOES_DRIVE);
    if (!c->exists)
        return;
    c->actions = actions & DOES_DRIVE;
    c->has_steering = actions & DOES_STEER;
    if (c->step_flags & OVERRIDE_DIR)
        c->actions &= ~(uint32_t)DOES_STEER;
    if (c->step_flags & OVERRIDE_SPEED)
        c->actions &= ~(uint32_t)(DOES_SPEED | DOES_ACCEL);
    c->st = st;
}

static inline bool is_in_cohort(const struct bullets *b, const struct cohort *c, uint32_t i)
{
    return b->motion[i] == c->motion && b->pc[i] == c->pc && b->step_flags[i] == c->step_flags &&
           !(b->flags[i] & BULLET_FINE) == !c->is_fine;
}

/* Sets out[k] to 1 for the bullets of a block in cohort c, otherwise to 0. */
static void match_cohort(const uint16_t *restrict motion, const uint16_t *restrict pc,
                         const uint8_t *restrict step_flags, const uint8_t *restrict flags, const struct cohort *c,
                         uint8_t *restrict out)
{
    const uint16_t want_motion = (uint16_t)c->motion, want_pc = (uint16_t)c->pc;
    const uint8_t want_flags = (uint8_t)c->step_flags, want_fine = c->is_fine ? BULLET_FINE : 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = (uint8_t)((motion[k] == want_motion) & (pc[k] == want_pc));
    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] &= (uint8_t)((step_flags[k] == want_flags) & ((flags[k] & BULLET_FINE) == want_fine));
}

/* Returns, as bits, the bullets of a block whose step ends in this frame, which must be run by step_bullet. */
static uint64_t ending_mask(const uint32_t *restrict step_end, uint32_t clock)
{
    uint8_t out[SLOTS_BLOCK];

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = step_end[k] == clock;
    return slots_pack_flags(out);
}

enum { MIN_BATCH = 6 /* fewest bullets of a block in one cohort for which a batch is faster */ };

/* Returns whether any of the lowest `probes` bullets in `candidates`, the bits of the block at slot `first`, is in
 * cohort c. */
static bool has_peer(const struct bullets *b, const struct cohort *c, uint32_t first, uint64_t candidates, int probes)
{
    for (; candidates && probes > 0; probes--, candidates &= candidates - 1)
        if (is_in_cohort(b, c, first + bits_lowest(candidates)))
            return true;
    return false;
}

/* Returns, as bits, the bullets of the block at slot `first` that are in cohort c and whose step does not end in this
 * frame. Not inlined, so that run_programs' loop over single bullets has enough registers. */
__attribute__((noinline)) static uint64_t cohort_mask(const struct bullets *b, const struct motion_world *w,
                                                      const struct cohort *c, uint32_t first)
{
    uint8_t out[SLOTS_BLOCK];

    match_cohort(b->motion + first, b->pc + first, b->step_flags + first, b->flags + first, c, out);
    return slots_pack_flags(out) & (c->timed ? ~ending_mask(b->step_end + first, w->clock) : UINT64_MAX);
}

/* Returns, as bits, the bullets in `candidates` that are in bullet i's cohort, or 0 if i is in none or its step ends
 * in this frame. The bits in `candidates` are of i's block, and i is the lowest. Scanning the whole block is expensive,
 * so the next *probes bullets in `candidates` are probed first. If none of them is in the cohort, sets *probes to 1 and
 * returns i alone. */
static uint64_t same_step_mask(const struct bullets *b, const struct motion_world *w, struct cohort *c, uint32_t i,
                               uint64_t candidates, int *probes)
{
    const uint32_t first = i / SLOTS_BLOCK * SLOTS_BLOCK;

    if (c->is_unbatchable && b->motion[i] == c->motion && b->pc[i] == c->pc)
        return 0;
    if (!is_in_cohort(b, c, i))
        set_cohort(c, b, w, i);
    if (!c->exists || (c->timed && b->step_end[i] == w->clock))
        return 0;
    if (!has_peer(b, c, first, candidates & (candidates - 1), *probes)) {
        *probes = 1;
        return bullets_bit(i);
    }
    return candidates & cohort_mask(b, w, c, first);
}

enum { MAX_FEW_TARGETS = 4 };

/* Returns the number of targets, or MAX_FEW_TARGETS + 1 if there are more, and stores the slots of the first
 * MAX_FEW_TARGETS. */
static int collect_few_targets(const struct targets *t, uint32_t found[MAX_FEW_TARGETS])
{
    const uint32_t end = t->s->live_bits ? t->s->top : t->s->live;
    int n = 0;

    for (uint32_t i = 0; i < end && n <= MAX_FEW_TARGETS; i++) {
        if (t->s->live_bits && !(t->s->live_bits[i / SLOTS_BLOCK] & bullets_bit(i))) {
            if (!t->s->live_bits[i / SLOTS_BLOCK])
                i |= SLOTS_BLOCK - 1;
        } else if (!t->included || t->included[i]) {
            if (n < MAX_FEW_TARGETS)
                found[n] = i;
            n++;
        }
    }
    return n;
}

/* Sets dir[k] to the result of targets_aim for the k-th bullet of s, with the old dir[k] as `fallback`. */
static void aim_batch(const struct bullets *b, const struct targets *t, const struct batch *s, ang *dir)
{
    uint32_t target[MAX_FEW_TARGETS];
    fx dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];
    ang to[SLOTS_BLOCK];
    const int n = s->n > 1 ? collect_few_targets(t, target) : MAX_FEW_TARGETS + 1;

    for (int k = 0; n > MAX_FEW_TARGETS && k < s->n; k++)
        dir[k] = targets_aim(t, b->x[batch_slot(s, k)], b->y[batch_slot(s, k)], dir[k]);
    if (!n || n > MAX_FEW_TARGETS)
        return;
    for (int k = 0; n == 1 && k < s->n; k++) {
        dx[k] = fx_sub(t->x[target[0]], b->x[batch_slot(s, k)]);
        dy[k] = fx_sub(t->y[target[0]], b->y[batch_slot(s, k)]);
    }
    for (int k = 0; n > 1 && k < s->n; k++) {
        const fx x = b->x[batch_slot(s, k)], y = b->y[batch_slot(s, k)];
        uint32_t nearest = target[0];
        for (int m = 1; m < n; m++)
            if (bullets_target_distance_squared(t, target[m], x, y) < bullets_target_distance_squared(t, nearest, x, y))
                nearest = target[m];
        dx[k] = fx_sub(t->x[nearest], x);
        dy[k] = fx_sub(t->y[nearest], y);
    }
    trig_atan2s(dy, dx, to, s->n);
    for (int k = 0; k < s->n; k++)
        dir[k] = dx[k] | dy[k] ? to[k] : dir[k];
}

static void turn_batch(const struct bullets *b, const struct motion_world *w, const struct cohort *c,
                       const struct batch *s, ang *dir)
{
    ang goal[SLOTS_BLOCK];

    if (c->actions & DOES_DIR)
        for (int k = 0; k < s->n; k++)
            dir[k] = w->steps->dir[c->st];
    if (c->actions & DOES_AIM)
        aim_batch(b, &w->targets, s, dir);
    if (c->actions & DOES_TURN)
        for (int k = 0; k < s->n; k++)
            dir[k] += (ang)w->steps->turn[c->st];
    if (!(c->actions & DOES_HOME))
        return;
    memcpy(goal, dir, (size_t)s->n * sizeof *dir);
    aim_batch(b, &w->targets, s, goal);
    for (int k = 0; k < s->n; k++)
        dir[k] = turn_toward(dir[k], goal[k], w->steps->home[c->st]);
}

/* Changes the speed of all bullets of s. For consecutive bullets with equal step_start and step_end, the result of
 * motion_lerp is computed once. */
static void change_batch_speed(struct bullets *b, const struct motion_world *w, const struct cohort *c,
                               const struct batch *s)
{
    const int shift = c->is_fine ? 0 : Q32_EXTRA_BITS;
    const int64_t limit = (int64_t)MAX_SPEED << (c->is_fine ? 32 : 16);
    const int64_t goal = w->steps->speed[c->st] >> shift, accel = w->steps->accel[c->st] >> shift;
    const uint32_t duration = w->steps->duration[c->st];
    int64_t from = 0, reached = 0;
    uint32_t end = w->clock; /* matches no bullet: a bullet whose step ends now is in no cohort */
    for (int k = 0; k < s->n; k++) {
        const uint32_t i = batch_slot(s, k);
        int64_t v = c->is_fine ? b->speed_q32[i] : b->speed[i];
        if (c->actions & DOES_SPEED) {
            const int64_t start = b->step_start[i] >> shift;
            if (b->step_end[i] != end || start != from) {
                from = start;
                end = b->step_end[i];
                reached = motion_lerp(from, goal, duration - (end - w->clock) + 1, duration);
            }
            v = reached;
        }
        v = int64_clamp(c->actions & DOES_ACCEL ? v + accel : v, -limit, limit);
        if (c->is_fine)
            b->speed_q32[i] = v;
        b->speed[i] = c->is_fine ? bullets_speed_to_fx(v) : (fx)v;
    }
}

/* Runs prepare_flight for all bullets of s. */
static void prepare_batch_flight(struct bullets *b, const struct batch *s, const ang *dir)
{
    int64_t from[SLOTS_BLOCK], to[SLOTS_BLOCK], dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];

    for (int k = 0; k < s->n; k++) {
        from[k] = b->travel_q32[batch_slot(s, k)];
        to[k] = from[k] + b->speed_q32[batch_slot(s, k)];
    }
    trig_strides(from, to, dir, dx, dy, s->n);
    for (int k = 0; k < s->n; k++)
        prepare_fine_move(b, batch_slot(s, k), to[k], dx[k], dy[k]);
}

/* Like bullets_update_velocity, for all bullets of s. None of them is frozen, because frozen bullets run no program. */
static void update_batch_velocity(struct bullets *b, const struct batch *s, const ang *dir)
{
    fx speed[SLOTS_BLOCK], to_x[SLOTS_BLOCK], to_y[SLOTS_BLOCK], bound = b->speed_bound;
    fx *vx = s->is_contiguous ? b->vx + s->first : to_x, *vy = s->is_contiguous ? b->vy + s->first : to_y;

    for (int k = 0; !s->is_contiguous && k < s->n; k++)
        speed[k] = b->speed[s->slot[k]];
    trig_polars(s->is_contiguous ? b->speed + s->first : speed, dir, vx, vy, s->n);
    for (int k = 0; !s->is_contiguous && k < s->n; k++) {
        b->vx[s->slot[k]] = vx[k];
        b->vy[s->slot[k]] = vy[k];
    }
    if (s->n == SLOTS_BLOCK)
        bound = fx_max(bound, bullets_block_max_speed(vx, vy));
    else
        for (int k = 0; k < s->n; k++)
            bound = fx_max(bound, fx_max(fx_abs(vx[k]), fx_abs(vy[k])));
    b->speed_bound = bound;
}

/* Runs a frame of the bullets of s, which are in cohort c. Not inlined, for the same reason as cohort_mask. */
__attribute__((noinline)) static void step_batch(struct bullets *b, const struct motion_world *w,
                                                 const struct cohort *c, const struct batch *s)
{
    ang gathered[SLOTS_BLOCK], *dir = s->is_contiguous ? b->dir + s->first : gathered;

    for (int k = 0; !s->is_contiguous && k < s->n; k++)
        dir[k] = b->dir[s->slot[k]];
    if (c->timed)
        b->work_done += (uint64_t)s->n;
    if (c->actions & DOES_STEER) {
        if (c->actions & (DOES_AIM | DOES_HOME))
            b->work_done += (uint64_t)s->n * aim_cost(&w->targets);
        turn_batch(b, w, c, s, dir);
        for (int k = 0; !s->is_contiguous && k < s->n; k++)
            b->dir[s->slot[k]] = dir[k];
    }
    if (c->actions & (DOES_SPEED | DOES_ACCEL))
        change_batch_speed(b, w, c, s);
    if (c->is_fine)
        prepare_batch_flight(b, s, dir);
    else if (c->has_steering || c->actions & (DOES_SPEED | DOES_ACCEL))
        update_batch_velocity(b, s, dir);
}

/* Runs a frame of bullet i, alone in cohort c. Adds the bullet to `deferred` if its velocity must be recomputed. */
static void step_alone(struct bullets *b, const struct motion_world *w, const struct cohort *c, uint32_t i,
                       struct batch *deferred)
{
    const uint32_t n = w->steps->duration[c->st];

    b->work_done++;
    if (change_dir_and_speed(b, w, i, c->step_flags, c->st, n - (b->step_end[i] - w->clock) + 1, n))
        deferred->slot[deferred->n++] = i;
}

static void update_deferred_velocity(struct bullets *b, struct batch *deferred)
{
    ang dir[SLOTS_BLOCK];

    for (int k = 0; k < deferred->n; k++)
        dir[k] = b->dir[deferred->slot[k]];
    update_batch_velocity(b, deferred, dir);
}

/* Runs the woken bullets of a block that has no busy bullets, the most common case. */
static void run_woken(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    uint64_t busy = 0, idle = b->idle[block] & ~woken;

    for (uint64_t m = woken; m; m &= m - 1) {
        const uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        const enum program_state state = finish_wait(b, w, i) ? step_bullet(b, w, i) : PROGRAM_WAITS;
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
    struct cohort c = { .motion = UINT32_MAX }; /* matches no bullet */
    struct batch batch, deferred;
    int probes = 1 + bits_count(busy) / MIN_BATCH;

    deferred.n = 0;
    deferred.is_contiguous = false;
    for (uint64_t m = busy | woken; m;) {
        const uint32_t i = first + bits_lowest(m);
        const uint64_t peers = woken & bullets_bit(i) ? 0 : same_step_mask(b, w, &c, i, m & ~woken, &probes);
        if (peers) { /* the bullets in `peers` are busy and stay busy */
            if (peers == bullets_bit(i) && !c.is_fine)
                step_alone(b, w, &c, i, &deferred);
            else {
                fill_batch(&batch, first, peers);
                step_batch(b, w, &c, &batch);
            }
            m &= ~peers;
            continue;
        }
        enum program_state state = PROGRAM_WAITS;
        if (!(woken & bullets_bit(i)) || finish_wait(b, w, i))
            state = step_bullet(b, w, i);
        busy = state == PROGRAM_RUNS ? busy | bullets_bit(i) : busy & ~bullets_bit(i);
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
        m &= m - 1;
    }
    if (deferred.n)
        update_deferred_velocity(b, &deferred);
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

bool bullets_move_one(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t block = i / SLOTS_BLOCK;

    if (b->busy[block] & bullets_bit(i) || (b->idle[block] & bullets_bit(i) && finish_wait(b, w, i))) {
        enum program_state state = step_bullet(b, w, i);
        if (!(b->s.live_bits[block] & bullets_bit(i)))
            return false;
        bullets_set_busy(b, i, state == PROGRAM_RUNS);
        b->idle[block] |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
    }
    b->x[i] += b->vx[i];
    b->y[i] += b->vy[i];
    b->n_moved++;
    return true;
}
