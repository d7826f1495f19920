/*
 * bullets_batch.c - runs a frame of motion programs for several bullets together.
 *
 * In the middle of a step, all bullets of one ring do the same work; so do fine bullets without a step to run, which
 * only fly. Bullets of a block that do the same work are in the same "cohort" and are processed together, column by
 * column. The result equals that of bullets_step for each bullet, in any order, because until the block moves no bullet
 * of the block reads a value that another one writes.
 *
 * Kept because a tick of the boss fight takes 0.6 to 0.75 times as long (rows "boss" of `make compare`). Of its parts,
 * aim_batch is kept for homing bullets (row "price home": 0.62 times) and step_alone for blocks in which half of the
 * bullets wait (row "price half": 0.81 times). cohort_mask and step_batch are not inlined, because the loop over single
 * bullets then has enough registers (rows "price mixed" and "price half": 0.8 times).
 */
#include "bullets_parts.h"
#include <string.h>

/* What the bullets of a cohort have in common. */
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
    const uint32_t excluded = DOES_USE_VALUES | DOES_DIE | DOES_LEAD | DOES_AWAIT | DOES_LOOP | DOES_LOOP_END |
                              DOES_BOUNCE | DOES_EMIT | DOES_TURN_TO;

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

/* Returns, as bits, the bullets of a block whose step ends in this frame, which must be run by bullets_step. */
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
 * frame. */
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
        dir[k] = bullets_turn_toward(dir[k], goal[k], w->steps->home[c->st]);
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
        bullets_prepare_fine_move(b, batch_slot(s, k), to[k], dx[k], dy[k]);
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

/* Runs a frame of the bullets of s, which are in cohort c. */
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
            b->work_done += (uint64_t)s->n * bullets_aim_cost(&w->targets);
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
    if (bullets_change_dir_and_speed(b, w, i, c->step_flags, c->st, n - (b->step_end[i] - w->clock) + 1, n))
        deferred->slot[deferred->n++] = i;
}

static void update_deferred_velocity(struct bullets *b, struct batch *deferred)
{
    ang dir[SLOTS_BLOCK];

    for (int k = 0; k < deferred->n; k++)
        dir[k] = b->dir[deferred->slot[k]];
    update_batch_velocity(b, deferred, dir);
}

void bullets_run_busy_block(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
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
        if (!(woken & bullets_bit(i)) || bullets_finish_wait(b, w, i))
            state = bullets_step(b, w, i);
        busy = state == PROGRAM_RUNS ? busy | bullets_bit(i) : busy & ~bullets_bit(i);
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
        m &= m - 1;
    }
    if (deferred.n)
        update_deferred_velocity(b, &deferred);
    b->busy[block] = busy;
    b->idle[block] = idle;
}
