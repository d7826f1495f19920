/*
 * bullets_program.c - runs motion programs (motion.h) on one bullet after another. bullets_batch.c does the same for
 * several bullets together.
 */
#include "bullets_parts.h"
#include <string.h>

void bullets_prepare_fine_move(struct bullets *b, uint32_t i, int64_t travel, int64_t dx, int64_t dy)
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
    bullets_prepare_fine_move(b, i, to, dx, dy);
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
    if (bullets_change_dir_and_speed(b, w, i, step_flags, st, k, n))
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
#define POINT_TO(type, name) .name = &p->name,
    resolved->steps = (struct steps){ STEP_FIELDS(POINT_TO) };
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

    if (actions & DOES_ACCEL_XY) {
        l.vx = b->vx[i];
        l.vy = b->vy[i];
    }
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

/* Sets dir and speed to those of the velocity (vx, vy). */
static void set_course(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    if (vx || vy)
        b->dir[i] = trig_atan2(vy, vx);
    b->speed[i] = fx_min(fx_hypot(vx, vy), MAX_SPEED << 16);
}

/* Sets the velocity with which bullet i ends this frame at (x, y), and, unless the step does that, dir and speed. If
 * the velocity would exceed MAX_SPEED on an axis, places the bullet at (x, y) at once, with velocity 0. */
static void lead_to(struct bullets *b, uint32_t i, bool has_course, fx x, fx y)
{
    const int64_t limit = (int64_t)MAX_SPEED << 16, dx = (int64_t)x - b->x[i], dy = (int64_t)y - b->y[i];

    if (int64_abs(dx) > limit || int64_abs(dy) > limit) {
        b->x[i] = x;
        b->y[i] = y;
        b->vx[i] = b->vy[i] = 0;
        return;
    }
    bullets_store_velocity(b, i, (fx)dx, (fx)dy);
    if (!has_course)
        set_course(b, i, (fx)dx, (fx)dy);
}

/* Converts a velocity of motion_accelerate, clamped to MAX_SPEED. */
static void round_velocity(const int64_t v[2], fx *vx, fx *vy)
{
    const int64_t limit = (int64_t)MAX_SPEED << 32;

    *vx = bullets_speed_to_fx(int64_clamp(v[0], -limit, limit));
    *vy = bullets_speed_to_fx(int64_clamp(v[1], -limit, limit));
}

/* Runs the k-th of n frames of a step that leads bullet i. Returns false if the orbit target has despawned. */
static bool lead_frame(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, uint32_t k, uint32_t n)
{
    const struct steps *s = w->steps;
    struct motion_lead l = load_lead(b, i);
    int64_t velocity[2];
    fx x, y;

    if (s->actions[st] & DOES_ORBIT && !(s->mode[st] & MODE_HAS_CENTRE) &&
        !find_orbit_centre(b, w, i, false, &l.x, &l.y))
        return false;
    motion_lead_position(s, st, &l, k, n, &x, &y, velocity);
    lead_to(b, i, s->actions[st] & (DOES_WAVE | DOES_ACCEL_XY), x, y);
    if (s->actions[st] & DOES_ACCEL_XY) {
        round_velocity(velocity, &x, &y);
        set_course(b, i, x, y);
    }
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

/* Ends a leading step of n frames. The bullet keeps the velocity of the last frame, without the rounding of its
 * positions if the step accelerated; after a wave it flies along dir. */
static void end_lead(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned step_flags, uint32_t st,
                     uint32_t n)
{
    const uint32_t actions =
        step_flags & (OVERRIDE_DIR | OVERRIDE_SPEED | OVERRIDE_POSITION) ? 0 : w->steps->actions[st];
    int64_t velocity[2], distance[2];
    fx vx, vy;

    if (actions & DOES_WAVE)
        bullets_update_velocity(b, i);
    if (actions & DOES_ACCEL_XY) {
        const struct motion_lead l = load_lead(b, i);
        motion_accelerate(w->steps, st, &l, n ? n : 1, n ? n : 1, velocity, distance);
        round_velocity(velocity, &vx, &vy);
        bullets_set_velocity(b, i, (int64_t)vx * (1 << Q32_EXTRA_BITS), (int64_t)vy * (1 << Q32_EXTRA_BITS));
    }
    b->travel_q32[i] = 0;
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
        b->work_done += bullets_aim_cost(&w->targets);
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
    if (actions & DOES_LEAD && (n || actions & DOES_ACCEL_XY))
        end_lead(b, w, i, r->step_flags, st, n);
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

enum program_state bullets_step(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    enum program_state state = b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_ENDED;

    if (b->motion[i])
        state = run_program(b, w, i);
    if (b->flags[i] & BULLET_FINE)
        prepare_flight(b, i);
    return state;
}

/* Runs the woken bullets of a block that has no busy bullets, the most common case. */
static void run_woken(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    uint64_t busy = 0, idle = b->idle[block] & ~woken;

    for (uint64_t m = woken; m; m &= m - 1) {
        const uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        const enum program_state state = bullets_finish_wait(b, w, i) ? bullets_step(b, w, i) : PROGRAM_WAITS;
        busy |= state == PROGRAM_RUNS ? bullets_bit(i) : 0;
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
    }
    b->busy[block] = busy;
    b->idle[block] = idle;
}

void bullets_run_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    if (b->busy[block])
        bullets_run_busy_block(b, w, block, woken);
    else if (woken)
        run_woken(b, w, block, woken);
}

bool bullets_move_one(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t block = i / SLOTS_BLOCK;

    if (b->busy[block] & bullets_bit(i) || (b->idle[block] & bullets_bit(i) && bullets_finish_wait(b, w, i))) {
        enum program_state state = bullets_step(b, w, i);
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
