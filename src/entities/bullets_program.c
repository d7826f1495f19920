/*
 * bullets_program.c - motion programs (motion.h), as bullets run them.
 */
#include "bullets_parts.h"
#include <string.h>

static void restyle(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;

    if (s->does[st] & DOES_KIND && w->kinds)
        bullets_set_kind(b, w->kinds, i, s->kind[st]);
    if (s->does[st] & DOES_BANK)
        b->bank[i] = s->bank[st];
}

static void drive(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t st, uint32_t k,
                  uint32_t n)
{
    if (bullets_turn_and_speed(b, w, i, mute, st, k, n))
        bullets_velocity_from_dir(b, i);
}

/* A step with a bullet's values in the place of names: steps.does[0] and so on are those of `step`. */
struct own_step {
    struct motion_step step;
    struct steps steps;
    struct motion_world w;
};

static fx in_range(fx v, int lo, int hi)
{
    return fx_clamp(v, lo * FX_ONE, hi * FX_ONE);
}

static void set_lead_number(struct motion_step *p, enum step_number number, fx v)
{
    switch (number) {
    case NUMBER_X:
        p->x = in_range(v, -WORLD, WORLD);
        break;
    case NUMBER_Y:
        p->y = in_range(v, -WORLD, WORLD);
        break;
    case NUMBER_SIZE:
        p->size = in_range(v, p->does & DOES_WAVE ? -MAX_SPEED : 0, MAX_SPEED);
        break;
    case NUMBER_SIZE_TO:
        p->size_to = in_range(v, 0, MAX_SPEED);
        break;
    default:
        p->count = v < FX_ONE ? 1 : (uint16_t)(v / FX_ONE);
    }
}

static void set_number(struct motion_step *p, enum step_number number, fx v)
{
    const fx pace = in_range(v, -MAX_SPEED, MAX_SPEED);

    switch (number) {
    case NUMBER_OVER:
        p->over = v < FX_ONE ? 1 : (uint32_t)v / FX_ONE;
        break;
    case NUMBER_BANK:
        p->bank = (uint8_t)(v >> 16 & 15);
        break;
    case NUMBER_DIR:
        p->dir = motion_angle(v);
        break;
    case NUMBER_TURN:
        p->turn = (int32_t)motion_angle(v);
        break;
    case NUMBER_HOME:
        p->home = motion_angle(in_range(v, 0, 180));
        break;
    case NUMBER_SPEED:
        p->speed = (int64_t)pace * (1 << PACE_BITS);
        break;
    case NUMBER_ACCEL:
        p->accel = (int64_t)pace * (1 << PACE_BITS);
        break;
    default:
        set_lead_number(p, number, v);
    }
}

/* Step st for bullet i, with the values that it had when the step began: this frame's, unless it is `begun`. */
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
        set_number(p, (enum step_number)n, k < 0 || !bullets_begun(b, k) ? 0 : bullets_begun(b, k)[i]);
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

/* While a step leads a bullet, `step_start` and `travel_q32`, which its drive and fine motion would use, keep what it
 * found. */
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

/* Where the thing is, or was a frame before, that bullet i is to go round; false: it is not there. */
static bool around(const struct bullets *b, const struct motion_world *w, uint32_t i, bool before, fx *x, fx *y)
{
    return b->orbit_target && b->orbit_target[i] &&
           w->where(w, b->orbit_target[i], i / SLOTS_BLOCK * SLOTS_BLOCK, before, x, y);
}

/* The frames that go_to takes at its speed, rounded up. */
static uint32_t frames_to(const struct steps *s, uint32_t st, fx x, fx y)
{
    const uint32_t d = (uint32_t)fx_hypot(fx_sub(s->x[st], x), fx_sub(s->y[st], y));
    const uint32_t speed = s->speed[st] < FX_ONE ? 1 : (uint32_t)(s->speed[st] >> PACE_BITS);

    return d ? (d - 1) / speed + 1 : 1;
}

/* The frames that a step which has begun leads bullet i. */
static uint32_t frames_led(const struct bullets *b, const struct steps *s, uint32_t i, uint32_t st)
{
    return s->how[st] & HOW_SPEED ? (uint32_t)(b->travel_q32[i] >> 32) : s->over[st];
}

/* Begins to lead bullet i; returns for how many frames, 0: there is nothing to go round. */
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

/* Gives bullet i the velocity that ends this frame at (x, y). What is more than a speed may be is a jump. */
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

/* The k-th of n frames of a step that leads bullet i; false: what it goes round is not there any more. */
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

/* A frame of a step that leads bullet i, unless a script has taken it away. False: the step is over. */
static bool lead_on(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t st, uint32_t n)
{
    if (mute & (OVERRIDE_DIR | OVERRIDE_SPEED | OVERRIDE_PLACE))
        return true;
    if (lead(b, w, i, st, n - (b->step_end[i] - w->clock) + 1, n))
        return true;
    b->travel_q32[i] = 0;
    return false;
}

/* What a step has led is let go. It flies on as it did in the last frame; a wave along its way. */
static void let_go(struct bullets *b, uint32_t i, uint32_t does)
{
    b->travel_q32[i] = 0;
    if (does & DOES_WAVE)
        bullets_steer(b, i);
}

/* ---- bounces ---- */

/* Reflects a move from `from` to *to, at speed *v, at the walls lo and hi, those that are. What begins outside is let
 * pass. */
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

/* Turns bullet i back where this frame's move would lead it out. It ends the frame at the reflected place; `travel_q32`
 * keeps the velocity that it has then, till the next frame. */
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

/* The frame after a bounce: it has its velocity, unless a script has given it another. */
static void bounced(struct bullets *b, uint32_t i, unsigned mute)
{
    if (!(mute & (OVERRIDE_DIR | OVERRIDE_SPEED)))
        bullets_store_velocity(b, i, (fx)(b->travel_q32[i] >> 32), (fx)b->travel_q32[i]);
    b->travel_q32[i] = 0;
}

/* A frame of bullet i on its way to a wall, since the clock before `speed_q32`. Returns the step that it goes on with
 * in this frame; pc: none. */
static uint32_t fly_to_wall(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t pc)
{
    const struct steps *s = w->steps;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + pc;

    if (b->travel_q32[i]) {
        bounced(b, i, mute);
        return pc + 1;
    }
    if (w->clock + 1 - (uint32_t)b->speed_q32[i] >= s->over[st])
        return s->jump[st];
    bounce(b, &w->field, i, s->how[st]);
    return pc;
}

/* ---- waiting ---- */

/* Is a number that was `from` at `line`, or beyond it? */
static bool crossed(fx from, fx now, fx line)
{
    return from <= line ? now >= line : now <= line;
}

/* Has what bullet i waits for come? */
static bool has_come(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t st)
{
    const struct steps *s = w->steps;

    switch (s->how[st]) {
    case HOW_X:
        return crossed((fx)(b->step_start[i] >> 32), b->x[i], s->x[st]);
    case HOW_Y:
        return crossed((fx)b->step_start[i], b->y[i], s->y[st]);
    case HOW_NEAR: {
        const int32_t t = targets_nearest(&w->targets, b->x[i], b->y[i]);
        b->ran += bullets_target_steps(&w->targets);
        return t != NO_SLOT && bullets_target_distance(&w->targets, (uint32_t)t, b->x[i], b->y[i]) <
                                   (uint64_t)((int64_t)s->size[st] * s->size[st]);
    }
    default:
        return mute & STEP_SIGNALLED;
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

/* ---- running ---- */

/* The step after one that opens or closes a loop. */
static inline uint32_t loop_step(const struct steps *s, uint16_t *rounds, uint32_t st, uint32_t pc)
{
    uint16_t *left = &rounds[s->depth[st]];

    if (s->does[st] & DOES_LOOP) {
        *left = s->count[st];
        return *left ? pc + 1 : s->jump[st];
    }
    return *left == MOTION_FOREVER || --*left ? s->jump[st] : pc + 1;
}

/* Where a bullet's program is while it runs: `pc` and `step_flags`, kept when it waits for the next frame. */
struct run {
    uint32_t pc;
    unsigned mute;
};

static void keep_run(struct bullets *b, uint32_t i, const struct run *r)
{
    b->pc[i] = (uint16_t)r->pc;
    b->step_flags[i] = (uint8_t)r->mute;
}

static enum program_state step_over(struct run *r)
{
    r->mute = 0;
    r->pc++;
    return PROGRAM_NEXT;
}

/* Loops, bounces and emits. */
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
    const uint32_t next = fly_to_wall(b, w, i, r->mute, r->pc);
    const bool flies = next == r->pc;
    r->mute = flies ? r->mute | STEP_BEGUN : 0;
    keep_run(b, i, r);
    r->pc = next;
    return flies ? PROGRAM_RUNS : PROGRAM_NEXT;
}

/* Returns the frames that the step takes. */
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

/* Any other step. `does` is what it does; where this is called, what it may do is a constant. */
__attribute__((always_inline)) static inline enum program_state
do_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st, unsigned does, struct run *r)
{
    uint32_t n;

    if (!(r->mute & STEP_BEGUN))
        n = begin_step(b, w, i, st, does);
    else
        n = does & DOES_LEAD ? frames_led(b, w->steps, i, st) : w->steps->over[st];
    if (does & DOES_DIE) {
        bullets_drop(b, i);
        return PROGRAM_OVER;
    }
    if (n && b->step_end[i] != w->clock) {
        r->mute |= STEP_BEGUN;
        keep_run(b, i, r);
        if (does & DOES_DRIVE)
            drive(b, w, i, r->mute, st, n - (b->step_end[i] - w->clock) + 1, n);
        else if (does & (DOES_LEAD | DOES_AWAIT)) {
            if (does & DOES_LEAD ? !lead_on(b, w, i, r->mute, st, n) : has_come(b, w, i, r->mute, st))
                return step_over(r);
        }
        b->due[i] = (uint8_t)b->step_end[i];
        const bool acts = does & (DOES_DRIVE | DOES_LEAD) || (does & DOES_AWAIT && w->steps->how[st] != HOW_SIGNAL);
        return acts || b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_WAITS;
    }
    if (!n && does & DOES_DRIVE)
        drive(b, w, i, r->mute, st, 1, 1);
    if (does & DOES_LEAD && n)
        let_go(b, i, r->mute & OVERRIDE_PLACE ? 0 : does);
    return step_over(r);
}

static enum program_state run_step(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st,
                                   struct run *r)
{
    return do_step(b, w, i, st, w->steps->does[st], r);
}

/* A step with names, whose numbers are the bullet's. Called, for what prepares them would go before all other steps. */
__attribute__((noinline)) static enum program_state run_named(struct bullets *b, const struct motion_world *w,
                                                              uint32_t i, uint32_t st, struct run *r)
{
    struct own_step own;

    own_step(b, w, i, st, r->mute & STEP_BEGUN, &own);
    return run_step(b, &own.w, i, 0, r);
}

/* Runs bullet i's program for this frame. */
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
        if (!(does & ~(unsigned)(DOES_DRIVE | DOES_WAIT))) /* most */
            state = do_step(b, w, i, st, does & (DOES_DRIVE | DOES_WAIT), &r);
        else if (does == DOES_NEXT && b->ran <= w->most)
            r.pc = loop_step(w->steps, &b->rounds[i * MOTION_DEPTH], st, r.pc);
        else if (b->ran > w->most) /* the frame ends in a fault */
            return PROGRAM_RUNS;
        else {
            struct run other = r; /* a copy, so that of the others `run` stays in registers */
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

enum program_state bullets_run(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    enum program_state state = b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_OVER;

    if (b->motion[i])
        state = run_program(b, w, i);
    if (b->flags[i] & BULLET_FINE)
        bullets_fly(b, i);
    return state;
}
