/*
 * bullets_move.c - a frame of all bullets.
 *
 * One pass over the blocks of 64 runs programs, moves, and tests each bullet for two things at once: is it outside of
 * the keep box, and is it near a player (the broad phase)? Its loops have restrict parameters and a constant trip
 * count, the form that gcc and clang vectorise at -O2 without flags. Only blocks with a yes are looked at twice.
 *
 * A range is asked about in one subtraction and one signed comparison: lo <= v <= lo + size, of which size < 2^32, is
 * (uint32_t)(v - lo) <= size, and a comparison of unsigned numbers is one of signed numbers when 2^31 is added to both.
 */
#include "bullets_parts.h"
#include <string.h>

enum {
    AHEAD = 4,           /* blocks */
    NEAR_BLOCKS = 1 << 7 /* the columns of so many are mostly in the first cache: asking for them takes longer */
};

/* The word as 8 x 8 bits, a byte a row: rows become columns. */
static uint64_t transposed(uint64_t v)
{
    uint64_t t = (v ^ v >> 7) & 0x00aa00aa00aa00aa;

    v ^= t ^ t << 7;
    t = (v ^ v >> 14) & 0x0000cccc0000cccc;
    v ^= t ^ t << 14;
    t = (v ^ v >> 28) & 0x00000000f0f0f0f0;
    return v ^ t ^ t << 28;
}

/* Those of a block that are due now. Four slots, 16 apart, are the even bits of a byte; two words of these are shifted
 * into one, in which a bit of all bytes is what a byte of the answer is. */
static uint64_t due_block(const uint8_t *restrict due, uint8_t now)
{
    uint8_t is[16];

    for (int i = 0; i < 16; i++)
        is[i] = (uint8_t)((-(due[i] == now) & 1) | (-(due[i + 16] == now) & 4) | (-(due[i + 32] == now) & 16) |
                          (-(due[i + 48] == now) & 64));
    return transposed(bytes_get64(is) | bytes_get64(is + 8) << 1);
}

/* Prefetches what a program reads or writes of a bullet. Where there are more bullets than the caches hold, this saves
 * half the time. */
static void prefetch(const struct bullets *b, uint32_t i)
{
    slots_prefetch(&b->motion[i]);
    slots_prefetch(&b->pc[i]);
    slots_prefetch(&b->step_flags[i]);
    slots_prefetch(&b->step_end[i]);
    slots_prefetch(&b->step_start[i]);
    slots_prefetch(&b->rounds[i * MOTION_DEPTH]);
    slots_prefetch(&b->dir[i]);
    slots_prefetch(&b->speed[i]);
    slots_prefetch(&b->flags[i]);
}

/* Those of a block that may have waited long enough. */
static uint64_t awake(const struct bullets *b, uint32_t block, uint32_t clock)
{
    if (!b->idle[block])
        return 0;
    const uint64_t found = due_block(b->due + block * SLOTS_BLOCK, (uint8_t)clock) & b->idle[block];
    for (uint64_t m = b->s.top > NEAR_BLOCKS * SLOTS_BLOCK ? found : 0; m; m &= m - 1)
        prefetch(b, block * SLOTS_BLOCK + bits_lowest(m));
    return found;
}

/* ---- steps that have begun ---- */

/*
 * What the bullets of one ring do in the middle of a step is the same for all; so is what those do that are fine and
 * have no step to run: they fly. Those of a block that are alike are done together, column by column. It comes to what
 * go_on does of each, whenever that is: what it writes no other of its block reads before the block moves.
 */
struct course {
    uint32_t motion, pc; /* those of the bullets it is for, and */
    unsigned mute;
    bool fine;
    bool is, timed;    /* there is one; it is a step's, which ends at `step_end` */
    bool never;        /* nobody at this step has one */
    uint32_t st, does; /* the step, and of DOES_DRIVE what it does and is not muted */
    bool steers;       /* even if that is muted */
};

/* Some bullets of a block: those from slot `first` on, or else each in `slot`. */
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

/* Those of the block from slot `first` on that `who` names; it is not 0. */
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
    c->mute = b->step_flags[i];
    c->fine = b->flags[i] & BULLET_FINE;
    c->does = 0;
    c->steers = c->never = false;
    c->timed = c->motion && c->pc < w->motions->length[c->motion - 1];
    c->is = c->fine;
    if (!c->timed)
        return;
    const uint32_t st = w->motions->first[c->motion - 1] + c->pc, does = s->does[st];
    c->never = does & others;
    c->is = c->mute & STEP_BEGUN && !c->never && (c->fine || does & DOES_DRIVE);
    if (!c->is)
        return;
    c->does = does & DOES_DRIVE;
    c->steers = does & DOES_STEER;
    if (c->mute & OVERRIDE_DIR)
        c->does &= ~(uint32_t)DOES_STEER;
    if (c->mute & OVERRIDE_SPEED)
        c->does &= ~(uint32_t)(DOES_SPEED | DOES_ACCEL);
    c->st = st;
}

static inline bool on_course(const struct bullets *b, const struct course *c, uint32_t i)
{
    return b->motion[i] == c->motion && b->pc[i] == c->pc && b->step_flags[i] == c->mute &&
           !(b->flags[i] & BULLET_FINE) == !c->fine;
}

/* out[k] = 1 for those of a block on that course. */
static void course_block(const uint16_t *restrict motion, const uint16_t *restrict pc, const uint8_t *restrict mute,
                         const uint8_t *restrict flags, const struct course *c, uint8_t *restrict out)
{
    const uint16_t is_motion = (uint16_t)c->motion, is_pc = (uint16_t)c->pc;
    const uint8_t is_mute = (uint8_t)c->mute, is_fine = c->fine ? BULLET_FINE : 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = (uint8_t)((motion[k] == is_motion) & (pc[k] == is_pc));
    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] &= (uint8_t)((mute[k] == is_mute) & ((flags[k] & BULLET_FINE) == is_fine));
}

/* Where a step of theirs ends in this frame go_on has to look at them. */
static uint64_t ends_block(const uint32_t *restrict end, uint32_t clock)
{
    uint8_t out[SLOTS_BLOCK];

    for (int k = 0; k < SLOTS_BLOCK; k++)
        out[k] = end[k] == clock;
    return slots_gather(out);
}

enum { WORTH = 6 /* alike in a block: if there are so many, one by one takes longer */ };

/* Is one of the next few of `rest`, out of the block from slot `first` on, on that course? */
static bool has_company(const struct bullets *b, const struct course *c, uint32_t first, uint64_t rest, int few)
{
    for (; rest && few > 0; few--, rest &= rest - 1)
        if (on_course(b, c, first + bits_lowest(rest)))
            return true;
    return false;
}

/* Those of the block from slot `first` on that take a course. Called, so that what is done one by one stays in
 * registers. */
__attribute__((noinline)) static uint64_t all_alike(const struct bullets *b, const struct motion_world *w,
                                                    const struct course *c, uint32_t first)
{
    uint8_t out[SLOTS_BLOCK];

    course_block(b->motion + first, b->pc + first, b->step_flags + first, b->flags + first, c, out);
    return slots_gather(out) & (c->timed ? ~ends_block(b->step_end + first, w->clock) : UINT64_MAX);
}

/* Those of a block, out of `of`, the first of which is bullet i, that take the same course as i; 0: it takes none. To
 * ask all is dear, so the next *few are asked first; and where none of these was on it, from then on one. */
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

/* The targets there are, FEW + 1: more than that. */
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

/* targets_aim for all of them: dir, what it is without a target, becomes the direction. */
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
        dir[k] = bullets_toward(dir[k], goal[k], w->steps->home[c->st]);
}

/* Those that began alike have one speed: it is found once for them. */
static void speed_some(struct bullets *b, const struct motion_world *w, const struct course *c, const struct some *s)
{
    const int shift = c->fine ? 0 : PACE_BITS;
    const int64_t most = (int64_t)MAX_SPEED << (c->fine ? 32 : 16);
    const int64_t goal = w->steps->speed[c->st] >> shift, accel = w->steps->accel[c->st] >> shift;
    const uint32_t over = w->steps->over[c->st];
    int64_t from = 0, reached = 0;
    uint32_t end = w->clock; /* nobody's */

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

/* bullets_fly for all of them. */
static void fly_some(struct bullets *b, const struct some *s, const ang *dir)
{
    int64_t from[SLOTS_BLOCK], to[SLOTS_BLOCK], dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];

    for (int k = 0; k < s->n; k++) {
        from[k] = b->travel_q32[nth(s, k)];
        to[k] = from[k] + b->speed_q32[nth(s, k)];
    }
    trig_strides(from, to, dir, dx, dy, s->n);
    for (int k = 0; k < s->n; k++)
        bullets_fly_by(b, nth(s, k), to[k], dx[k], dy[k]);
}

static fx fastest_block(const fx *restrict vx, const fx *restrict vy)
{
    fx most = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        fx ax = vx[i] < 0 ? -vx[i] : vx[i], ay = vy[i] < 0 ? -vy[i] : vy[i];
        most = ax > most ? ax : most;
        most = ay > most ? ay : most;
    }
    return most;
}

/* bullets_steer for all of them. None stands, for whose program runs does not. */
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
        most = fx_max(most, fastest_block(vx, vy));
    else
        for (int k = 0; k < s->n; k++)
            most = fx_max(most, fx_max(fx_abs(vx[k]), fx_abs(vy[k])));
    b->fastest = most;
}

/* A frame of some that take a course. Called, as all_alike is. */
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
            b->ran += (uint64_t)s->n * bullets_target_steps(&w->targets);
        turn_some(b, w, c, s, dir);
        for (int k = 0; !s->row && k < s->n; k++)
            b->dir[s->slot[k]] = dir[k];
    }
    if (c->does & (DOES_SPEED | DOES_ACCEL))
        speed_some(b, w, c, s);
    if (c->fine)
        fly_some(b, s, dir);
    else if (c->steers || c->does & (DOES_SPEED | DOES_ACCEL))
        steer_some(b, s, dir);
}

/* The same of one that is alone in it, but for its velocity, which it gets later with others. */
static void keep_alone(struct bullets *b, const struct motion_world *w, const struct course *c, uint32_t i,
                       struct some *later)
{
    const uint32_t n = w->steps->over[c->st];

    b->ran++;
    if (bullets_turn_and_speed(b, w, i, c->mute, c->st, n - (b->step_end[i] - w->clock) + 1, n))
        later->slot[later->n++] = i;
}

static void steer_later(struct bullets *b, struct some *later)
{
    ang dir[SLOTS_BLOCK];

    for (int k = 0; k < later->n; k++)
        dir[k] = b->dir[later->slot[k]];
    steer_some(b, later, dir);
}

/* Of a block in which nobody is busy, as most are. */
static void run_woken(struct bullets *b, const struct motion_world *w, uint32_t block, uint64_t woken)
{
    uint64_t busy = 0, idle = b->idle[block] & ~woken;

    for (uint64_t m = woken; m; m &= m - 1) {
        const uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
        const enum program_state state = bullets_wait_over(b, w, i) ? bullets_run(b, w, i) : PROGRAM_WAITS;
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
    struct course c = { .motion = UINT32_MAX }; /* nobody's */
    struct some some, later;
    int few = 1 + bits_count(busy) / WORTH;

    later.n = 0;
    later.row = false;
    for (uint64_t m = busy | woken; m;) {
        const uint32_t i = first + bits_lowest(m);
        const uint64_t who = woken & bullets_bit(i) ? 0 : alike(b, w, &c, i, m & ~woken, &few);
        if (who) { /* they are busy, and stay so */
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
        if (!(woken & bullets_bit(i)) || bullets_wait_over(b, w, i))
            state = bullets_run(b, w, i);
        busy = state == PROGRAM_RUNS ? busy | bullets_bit(i) : busy & ~bullets_bit(i);
        idle |= state == PROGRAM_WAITS ? bullets_bit(i) : 0;
        m &= m - 1;
    }
    if (later.n)
        steer_later(b, &later);
    b->busy[block] = busy;
    b->idle[block] = idle;
}

/* A range of places a comparison on each axis away; see the top of the file. */
struct range {
    uint32_t x, y;
    int32_t w, h;
};

enum { SIGN = -0x7fffffff - 1 };

static struct range range_of(int64_t x, int64_t y, uint32_t w, uint32_t h)
{
    return (struct range){ (uint32_t)x ^ (uint32_t)SIGN, (uint32_t)y ^ (uint32_t)SIGN, (int32_t)(w ^ (uint32_t)SIGN),
                           (int32_t)(h ^ (uint32_t)SIGN) };
}

static struct range keep_range(const struct box *k)
{
    return range_of(k->x0, k->y0, (uint32_t)k->x1 - (uint32_t)k->x0, (uint32_t)k->y1 - (uint32_t)k->y0);
}

/* The broad phase: a bullet that is near ends its move in this range. */
static struct range near_range(const struct bullets_query *q, fx fastest)
{
    int64_t reach = q->reach + fastest;

    if (q->reach < 0) /* one place, where nothing is */
        return range_of(FX_MIN, FX_MIN, 0, 0);
    if (reach > FX_MAX) /* 2 * reach would wrap */
        return range_of(FX_MIN, FX_MIN, UINT32_MAX, UINT32_MAX);
    return range_of(q->x - reach, q->y - reach, 2 * (uint32_t)reach, 2 * (uint32_t)reach);
}

#define OUTSIDE(v, lo, size) -((int32_t)((uint32_t)(v) - (lo)) > (size))

enum { HALF = SLOTS_BLOCK / 2 };

/* The bit of each slot of half a block: a vectorised loop ORs the bits of those that it finds. */
static const uint32_t HALF_BIT[HALF] = {
    0x1,       0x2,       0x4,       0x8,       0x10,       0x20,       0x40,       0x80,
    0x100,     0x200,     0x400,     0x800,     0x1000,     0x2000,     0x4000,     0x8000,
    0x10000,   0x20000,   0x40000,   0x80000,   0x100000,   0x200000,   0x400000,   0x800000,
    0x1000000, 0x2000000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000, 0x80000000,
};

/* All bits: the bullet that goes on to (x, y) stays in keep, and comes near nobody. */
static inline int32_t is_usual(int32_t far, int32_t x, int32_t y, const struct range *n)
{
    return (OUTSIDE(x, n->x, n->w) | OUTSIDE(y, n->y, n->h)) & ~far;
}

/* Moves a block, both halves in one go. Returns those that are outside keep or inside near; *lost: some are outside
 * keep. */
static inline uint64_t move_block(fx *restrict x, fx *restrict y, const fx *restrict vx, const fx *restrict vy,
                                  const struct range *keep, const struct range *near, bool *restrict lost)
{
    const struct range k = *keep, n = *near;
    uint32_t low = 0, high = 0;
    int32_t out = 0;

    for (int i = 0; i < HALF; i++) {
        const int j = i + HALF;
        const int32_t ax = x[i] + vx[i], ay = y[i] + vy[i], bx = x[j] + vx[j], by = y[j] + vy[j];
        const int32_t a_far = OUTSIDE(ax, k.x, k.w) | OUTSIDE(ay, k.y, k.h);
        const int32_t b_far = OUTSIDE(bx, k.x, k.w) | OUTSIDE(by, k.y, k.h);
        x[i] = ax;
        y[i] = ay;
        x[j] = bx;
        y[j] = by;
        low |= (uint32_t)is_usual(a_far, ax, ay, &n) & HALF_BIT[i];
        high |= (uint32_t)is_usual(b_far, bx, by, &n) & HALF_BIT[i];
        out |= a_far | b_far;
    }
    *lost = out;
    return ~((uint64_t)high << HALF | low);
}

static int32_t near_block(const fx *restrict x, const fx *restrict y, uint8_t *restrict out, const struct range *near)
{
    const struct range n = *near;
    int32_t any = 0;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        int32_t is = ~(OUTSIDE(x[i], n.x, n.w) | OUTSIDE(y[i], n.y, n.h)) & 1;
        out[i] = (uint8_t)is;
        any |= is;
    }
    return any;
}

/* What the narrow phase will read of a block's bullets besides where they are. */
static void prefetch_near(const struct bullets *b, uint32_t first)
{
    slots_prefetch(&b->kind[first]);
    slots_prefetch(&b->kind[first + SLOTS_BLOCK / 2]);
    slots_prefetch(&b->flags[first]);
}

/* The bullets of a block, as bits, that may touch or graze a player. */
static uint64_t find_near(const struct bullets *b, const struct bullets_query *q, uint32_t block)
{
    const uint32_t first = block * SLOTS_BLOCK;
    const struct range r = near_range(q, b->fastest);
    uint8_t out[SLOTS_BLOCK];

    return q->reach >= 0 && near_block(b->x + first, b->y + first, out, &r) ? slots_gather(out) : 0;
}

uint64_t bullets_near(const struct bullets *b, uint32_t block, fx x, fx y, int64_t reach)
{
    struct range r = near_range(&(struct bullets_query){ .x = x, .y = y, .reach = reach }, b->fastest);
    uint32_t first = block * SLOTS_BLOCK;
    uint8_t out[SLOTS_BLOCK];

    return near_block(b->x + first, b->y + first, out, &r) ? slots_gather(out) & slots_live_or_held(&b->s, block) : 0;
}

static uint64_t solid_block(const int32_t *restrict hp, const uint8_t *restrict flags)
{
    uint8_t out[SLOTS_BLOCK];

    for (int i = 0; i < SLOTS_BLOCK; i++)
        out[i] = (uint8_t)((hp[i] != 0) & !(flags[i] & BULLET_DELAYED));
    return slots_gather(out);
}

bool bullets_find_solid(struct bullets *b)
{
    uint64_t any = 0;

    for (uint32_t block = 0; block < b->s.top / SLOTS_BLOCK; block++) {
        uint32_t first = block * SLOTS_BLOCK;
        b->solid[block] = solid_block(b->hp + first, b->flags + first) & slots_live_or_held(&b->s, block);
        any |= b->solid[block];
    }
    return any != 0;
}

/* Of those that a moved block names, drops the ones outside keep, but holds those that are near a player or, with
 * hold_all, every one. */
static void leave(struct bullets *b, uint64_t named, uint32_t first, const struct box *keep, bool hold_all)
{
    const uint64_t *near = &b->near[first / SLOTS_BLOCK * PADS];
    uint64_t hold = hold_all ? UINT64_MAX : 0;

    for (uint32_t p = 0; p < PADS; p++)
        hold |= near[p];
    for (uint64_t m = named & b->s.used[first / SLOTS_BLOCK]; m; m &= m - 1) {
        uint32_t i = first + bits_lowest(m);
        fx x = b->x[i], y = b->y[i];
        if (x >= keep->x0 && x <= keep->x1 && y >= keep->y0 && y <= keep->y1)
            continue;
        b->moved++;
        if (hold & bullets_bit(i))
            bullets_hold(b, i);
        else
            bullets_drop(b, i);
    }
}

/* The bound on speeds follows slowly: it is found anew every FASTEST_AGE frames. */
enum { FASTEST_AGE = 64 };

static fx fastest_of(const struct bullets *b)
{
    fx most = 0;

    for (uint32_t i = 0; i < b->s.top; i += SLOTS_BLOCK) {
        fx v = fastest_block(b->vx + i, b->vy + i);
        most = v > most ? v : most;
    }
    return most;
}

void bullets_move(struct bullets *b, const struct motion_world *w, const struct box *keep,
                  const struct bullets_query query[PADS], bool hold_all)
{
    static const struct bullets_query none[PADS] = { { .reach = -1 }, { .reach = -1 } };
    struct range kept = keep_range(keep), near;
    uint32_t blocks = b->s.top / SLOTS_BLOCK;
    uint64_t woken[AHEAD]; /* of the blocks from the present one on */
    fx fastest = -1;

    if (!query)
        query = none;
    if (w->clock % FASTEST_AGE == 0)
        b->fastest = fastest_of(b);
    b->moved = 0;
    b->ran = 0;
    if (b->standing)
        bullets_stand(b);
    for (uint32_t block = 0; block < AHEAD && block < blocks; block++)
        woken[block] = awake(b, block, w->clock);
    for (uint32_t block = 0; block < blocks; block++) {
        uint32_t i = block * SLOTS_BLOCK;
        uint64_t now = woken[block % AHEAD];

        if (block + AHEAD < blocks) {
            woken[block % AHEAD] = awake(b, block + AHEAD, w->clock);
            prefetch_near(b, i + AHEAD * SLOTS_BLOCK);
        }
        if (b->ran > w->most) /* the frame ends in a fault */
            break;
        if (b->busy[block])
            run_programs(b, w, block, now);
        else if (now)
            run_woken(b, w, block, now);
        if (b->fastest != fastest) { /* a program may have made one faster */
            fastest = b->fastest;
            near = near_range(&query[0], fastest);
        }
        bool lost;
        const uint64_t named = move_block(b->x + i, b->y + i, b->vx + i, b->vy + i, &kept, &near, &lost);
        uint64_t *found = b->near + block * PADS;
        found[0] = query[0].reach < 0 ? 0 : named & b->s.used[block];
        for (uint32_t p = 1; p < PADS; p++)
            found[p] = find_near(b, &query[p], block) & b->s.used[block];
        if (lost)
            leave(b, named, i, keep, hold_all);
    }
    b->moved += b->s.live;
    slots_trim(&b->s);
}

void bullets_begin(struct bullets *b)
{
    b->moved = 0;
    b->ran = 0;
    if (b->standing)
        bullets_stand(b);
}

bool bullets_go_on(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t block = i / SLOTS_BLOCK;

    if (b->busy[block] & bullets_bit(i) || (b->idle[block] & bullets_bit(i) && bullets_wait_over(b, w, i))) {
        enum program_state state = bullets_run(b, w, i);
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
