/*
 * bullets.c - see bullets.h.
 *
 * One pass over the blocks of 64 runs programs, moves, and tests each bullet for two things at once: is it outside of
 * the keep box, and is it near a player (the broad phase)? Its loops have restrict parameters and a constant trip
 * count, the form that gcc and clang vectorise at -O2 without flags. Only blocks with a yes are looked at twice.
 *
 * A range is asked about in one subtraction and one signed comparison: lo <= v <= lo + size, of which size < 2^32, is
 * (uint32_t)(v - lo) <= size, and a comparison of unsigned numbers is one of signed numbers when 2^31 is added to both.
 */
#include "bullets.h"
#include <string.h>
#include "../base/int.h"

static const struct column kind_columns[] = {
    COLUMN(bullet_kinds, sprite),
    COLUMN(bullet_kinds, shape),
    COLUMN(bullet_kinds, a),
    COLUMN(bullet_kinds, b),
    COLUMN(bullet_kinds, x),
    COLUMN(bullet_kinds, y),
    COLUMN(bullet_kinds, flags),
    COLUMN(bullet_kinds, bank),
    COLUMN(bullet_kinds, damage),
    COLUMN(bullet_kinds, spin),
    COLUMN(bullet_kinds, order),
    COLUMN(bullet_kinds, vanish),
    GROUP_COLUMN(bullet_kinds, hp, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, score, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, spark, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, pierce, GROUP_PIERCE),
    GROUP_COLUMN(bullet_kinds, every, GROUP_PIERCE),
    DERIVED(bullet_kinds, live, "counts the live bullets of each kind"),
};

static const struct column columns[] = {
    COLUMN(bullets, x),
    COLUMN(bullets, y),
    COLUMN(bullets, vx),
    COLUMN(bullets, vy),
    COLUMN(bullets, dir),
    COLUMN(bullets, speed),
    COLUMN(bullets, kind),
    COLUMN(bullets, bank),
    COLUMN(bullets, tag),
    COLUMN(bullets, flags),
    COLUMN(bullets, born),
    COLUMN(bullets, by),
    COLUMN(bullets, player),
    COLUMN(bullets, motion),
    COLUMN(bullets, pc),
    COLUMN(bullets, end),
    COLUMN(bullets, from),
    COLUMN(bullets, mute), /* flags of the step at pc, see bullets.h */
    COLUMN(bullets, pace),
    COLUMN(bullets, way),
    COLUMN(bullets, x_more),
    COLUMN(bullets, y_more),
    COLUMNS(bullets, rounds, MOTION_DEPTH),
    GROUP_COLUMN(bullets, value1, GROUP_VALUE + 0),
    GROUP_COLUMN(bullets, value2, GROUP_VALUE + 1),
    GROUP_COLUMN(bullets, value3, GROUP_VALUE + 2),
    GROUP_COLUMN(bullets, value4, GROUP_VALUE + 3),
    GROUP_COLUMN(bullets, around, GROUP_AROUND),
    GROUP_COLUMN(bullets, begun1, GROUP_VALUE + 0),
    GROUP_COLUMN(bullets, begun2, GROUP_VALUE + 1),
    GROUP_COLUMN(bullets, begun3, GROUP_VALUE + 2),
    GROUP_COLUMN(bullets, begun4, GROUP_VALUE + 3),
    GROUP_COLUMN(bullets, hp, GROUP_HP),
    GROUP_COLUMN(bullets, frozen, GROUP_FROZEN),
    GROUP_COLUMN(bullets, stands, GROUP_FROZEN),
    GROUP_COLUMN(bullets, kept_vx, GROUP_FROZEN),
    GROUP_COLUMN(bullets, kept_vy, GROUP_FROZEN),
    GROUP_COLUMN(bullets, pierce, GROUP_PIERCE),
    GROUP_COLUMNS(bullets, pierced, PIERCED, GROUP_PIERCE),
    GROUP_COLUMNS(bullets, again, PIERCED, GROUP_PIERCE),
    DERIVED_BLOCKS(bullets, busy, 1, "computed from motion, pc, mute and flags"),
    DERIVED_BLOCKS(bullets, idle, 1, "computed from motion, pc, mute and flags"),
    DERIVED_BLOCKS(bullets, near, PADS, "rewritten by every move before hit tests read it"),
    DERIVED_BLOCKS(bullets, grazes, PADS, "rewritten by every move before hit tests read it"),
    DERIVED_BLOCKS(bullets, leaving, 1, "empty between frames"),
    GROUP_BLOCKS(bullets, solid, GROUP_HP, "rewritten in every frame before hit tests read it"),
    GROUP_REGISTER(bullets, meets, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_first, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_second, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_spark, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_flags, GROUP_MEET),
    GROUP_DERIVED(bullets, next, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    GROUP_BLOCKS(bullets, met, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    GROUP_BLOCKS(bullets, taken, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    DERIVED(bullets, due, "the low byte of `end`, only for idle bullets"),
    DERIVED_REGISTERS(bullets, value_start, "set only while scripts load, like names"),
    DERIVED_REGISTER(bullets, fastest, "an upper bound for the broad phase; the narrow phase decides what is hit"),
    DERIVED_REGISTER(bullets, standing, "the number of standing bullets, counted from the column `stands`"),
    DERIVED_REGISTER(bullets, moved, "a count for benchmarks, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, ran, "a counter for the work limit, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, of_kind, "the address of the kinds' column `live`, computed from the address of RAM"),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip bullets_chip = { "bullets", columns, COUNT(columns), false, false };
const struct chip shots_chip = { "shots", columns, COUNT(columns), false, false };
const struct chip laser_heads_chip = { "laser_heads", columns, COUNT(columns), false, false };
const struct chip bullet_kinds_chip = { "bullet_kinds", kind_columns, COUNT(kind_columns), true, false };
const struct chip shot_kinds_chip = { "shot_kinds", kind_columns, COUNT(kind_columns), true, false };

/* The bit of slot i in its block's word. */
static uint64_t bit(uint32_t i)
{
    return 1ull << (i % SLOTS_BLOCK);
}

/* Busy: the program or the fine move of bullet i runs in the next frame. Not busy: it has neither. In both cases its
 * program no longer waits. */
static void set_busy(struct bullets *b, uint32_t i, bool busy)
{
    uint32_t block = i / SLOTS_BLOCK;

    b->busy[block] = busy ? b->busy[block] | bit(i) : b->busy[block] & ~bit(i);
    b->idle[block] &= ~bit(i);
}

/* Puts a dead slot inside of every keep box, so that it never counts as having left. */
static void park(struct bullets *b, uint32_t i)
{
    b->x[i] = b->y[i] = 0;
    b->vx[i] = b->vy[i] = 0;
    b->motion[i] = 0;
    b->flags[i] = 0;
    if (b->stands)
        b->stands[i] = 0;
    set_busy(b, i, false);
}

/* The block from slot `first` on comes into use. */
static void open_block(struct bullets *b, uint32_t first)
{
    b->busy[first / SLOTS_BLOCK] = b->idle[first / SLOTS_BLOCK] = 0;
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        park(b, i);
}

/* Bullet i does nothing until the clock is `end`. */
static void wait_until(struct bullets *b, uint32_t i, uint32_t end)
{
    b->end[i] = end;
    b->due[i] = (uint8_t)end;
    b->idle[i / SLOTS_BLOCK] |= bit(i);
}

bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t thing, uint32_t clock)
{
    if (!b->pierce || !b->pierce[i])
        return false;
    const int32_t every = kinds->every[b->kind[i]];
    int64_t *known = b->pierced + (size_t)i * PIERCED;
    int k = 0;
    while (k < PIERCED - 1 && known[k] && known[k] != thing)
        k++;
    known[k] = thing;
    b->again[(size_t)i * PIERCED + (size_t)k] = every == PIERCE_FOREVER ? UINT32_MAX : clock + (uint32_t)every;
    b->pierce[i] -= b->pierce[i] > 0;
    return true;
}

/* One more live bullet of a kind (by: 1), or one less (-1). */
static inline void count_kind(struct bullets *b, uint16_t kind, int by)
{
    if (b->of_kind)
        b->of_kind[kind] += (uint32_t)by;
}

/* Gives live bullet i another row of the kinds. */
static void change_kind(struct bullets *b, uint32_t i, unsigned kind)
{
    count_kind(b, b->kind[i], -1);
    b->kind[i] = (uint16_t)kind;
    count_kind(b, b->kind[i], 1);
}

int32_t bullets_fire(struct bullets *b, const struct bullet_shape *shape, uint32_t clock)
{
    uint32_t top = b->s.top;
    int32_t i = slots_take(&b->s);

    if (i == NO_SLOT)
        return i;
    if (top < b->s.top)
        open_block(b, top);
    b->x[i] = shape->x;
    b->y[i] = shape->y;
    b->dir[i] = shape->dir;
    b->vx[i] = b->vy[i] = 0;
    b->speed[i] = shape->speed;
    const uint16_t kind = (uint16_t)(shape->kind + (shape->clouded ? ROW_CLOUD : ROW_KIND));
    b->kind[i] = kind;
    count_kind(b, kind, 1);
    b->bank[i] = shape->bank;
    b->tag[i] = shape->tag;
    b->flags[i] = shape->delay ? BULLET_DELAYED : 0;
    b->born[i] = clock;
    b->by[i] = shape->by;
    b->player[i] = shape->player;
    b->pace[i] = b->way[i] = 0;
    b->x_more[i] = b->y_more[i] = 0;
    for (int k = 0; k < MAX_VALUES && bullets_value(b, k); k++) {
        bullets_value(b, k)[i] = b->value_start[k];
        bullets_begun(b, k)[i] = 0;
    }
    if (b->hp)
        b->hp[i] = shape->hp;
    if (b->pierce) {
        b->pierce[i] = shape->pierce;
        memset(b->pierced + (size_t)i * PIERCED, 0, PIERCED * sizeof *b->pierced);
        memset(b->again + (size_t)i * PIERCED, 0, PIERCED * sizeof *b->again);
    }
    if (b->frozen)
        b->frozen[i] = b->kept_vx[i] = b->kept_vy[i] = b->stands[i] = 0;
    if (b->around)
        b->around[i] = shape->around;
    bullets_program(b, (uint32_t)i, shape->motion, shape->fine);
    if (shape->delay)
        wait_until(b, (uint32_t)i, clock + shape->delay);
    bullets_steer(b, (uint32_t)i);
    return i;
}

static bool stands(const struct bullets *b, uint32_t i)
{
    return b->stands && b->stands[i];
}

void bullets_drop(struct bullets *b, uint32_t i)
{
    b->standing -= stands(b, i);
    count_kind(b, b->kind[i], -1);
    slots_drop(&b->s, i);
    park(b, i);
}

void bullets_hold(struct bullets *b, uint32_t i)
{
    count_kind(b, b->kind[i], -1);
    slots_hold(&b->s, b->leaving, i);
}

void bullets_release(struct bullets *b, uint32_t i)
{
    b->standing -= stands(b, i);
    slots_release(&b->s, i);
    park(b, i);
    slots_trim(&b->s);
}

void bullets_release_all(struct bullets *b)
{
    EACH_HELD (i, &b->s)
        bullets_release(b, i);
}

static inline void set_velocity(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    fx a = fx_max(fx_abs(vx), fx_abs(vy));

    if (stands(b, i)) {
        b->kept_vx[i] = vx;
        b->kept_vy[i] = vy;
        return;
    }
    b->vx[i] = vx;
    b->vy[i] = vy;
    if (a > b->fastest)
        b->fastest = a;
}

static inline void steer(struct bullets *b, uint32_t i)
{
    fx vx, vy;

    if (b->flags[i] & (BULLET_FINE | BULLET_DELAYED)) /* `fly` and `is_over` steer those */
        return;
    trig_polar(b->speed[i], b->dir[i], &vx, &vy);
    set_velocity(b, i, vx, vy);
}

void bullets_steer(struct bullets *b, uint32_t i)
{
    steer(b, i);
}

void bullets_set_flight(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    set_velocity(b, i, vx, vy);
}

static int64_t clamp_pace(int64_t v)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;

    return int64_clamp(v, -most, most);
}

/* The fx nearest to a clamped pace, ties to even. */
static fx pace_fx(int64_t pace)
{
    return (fx)((pace + 0x7fff + (pace >> PACE_BITS & 1)) >> PACE_BITS);
}

int64_t bullets_speed(const struct bullets *b, uint32_t i)
{
    return b->flags[i] & BULLET_FINE ? b->pace[i] : (int64_t)b->speed[i] * (1 << PACE_BITS);
}

void bullets_set_speed(struct bullets *b, uint32_t i, int64_t speed)
{
    b->speed[i] = pace_fx(speed);
    if (b->flags[i] & BULLET_FINE)
        b->pace[i] = speed;
    bullets_steer(b, i);
}

void bullets_velocity(const struct bullets *b, uint32_t i, int64_t *vx, int64_t *vy)
{
    fx x = (stands(b, i) ? b->kept_vx : b->vx)[i], y = (stands(b, i) ? b->kept_vy : b->vy)[i];

    if (b->flags[i] & BULLET_FINE) {
        trig_stride(0, b->pace[i], b->dir[i], vx, vy);
        return;
    }
    if (b->flags[i] & BULLET_DELAYED) /* as it will fly */
        trig_polar(b->speed[i], b->dir[i], &x, &y);
    *vx = (int64_t)x * (1 << PACE_BITS);
    *vy = (int64_t)y * (1 << PACE_BITS);
}

/* The direction comes from the leading 31 bits of (vx, vy), and the speed is their component along it. That is right to
 * the last bit, for the component across it is less than 2^-29 of the speed. */
static void set_fine_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy)
{
    int64_t ax = int64_abs(vx), ay = int64_abs(vy), along[2], across;
    int shift = 0;

    while ((ax | ay) >> shift > FX_MAX)
        shift++;
    if (ax | ay)
        b->dir[i] = trig_atan2((fx)(vy >> shift), (fx)(vx >> shift));
    trig_stride(0, vx, b->dir[i], &along[0], &across);
    trig_stride(0, vy, b->dir[i], &across, &along[1]);
    bullets_set_speed(b, i, clamp_pace(along[0] + along[1]));
}

void bullets_set_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy)
{
    const fx most = (fx)MAX_SPEED << 16, x = (fx)(vx >> PACE_BITS), y = (fx)(vy >> PACE_BITS);

    if (b->flags[i] & BULLET_FINE) {
        set_fine_velocity(b, i, vx, vy);
        return;
    }
    b->speed[i] = fx_hypot(x, y);
    if (x || y)
        b->dir[i] = trig_atan2(y, x);
    if (b->speed[i] > most) {
        b->speed[i] = most;
        bullets_steer(b, i);
    } else if (!(b->flags[i] & BULLET_DELAYED))
        set_velocity(b, i, x, y);
}

void bullets_place(const struct bullets *b, uint32_t i, int64_t *x, int64_t *y)
{
    *x = (int64_t)b->x[i] * (1 << PACE_BITS) + b->x_more[i];
    *y = (int64_t)b->y[i] * (1 << PACE_BITS) + b->y_more[i];
}

/* A place as the nearest fx and what is more. */
static fx split(int64_t v, int16_t *more)
{
    *more = (int16_t)v;
    return (fx)((v - *more) >> PACE_BITS);
}

void bullets_set_place(struct bullets *b, uint32_t i, int64_t x, int64_t y)
{
    b->x[i] = split(x, &b->x_more[i]);
    b->y[i] = split(y, &b->y_more[i]);
}

void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind)
{
    bool cloud = b->flags[i] & BULLET_DELAYED && kinds->flags[kind] & KIND_CLOUDED;

    change_kind(b, i, kind + (cloud ? (unsigned)ROW_CLOUD : ROW_KIND));
    b->bank[i] = kinds->bank[kind];
    if (b->hp)
        b->hp[i] = kinds->hp[kind];
}

void bullets_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine)
{
    if (fine && !(b->flags[i] & BULLET_FINE)) {
        b->pace[i] = bullets_speed(b, i);
        b->flags[i] |= BULLET_FINE;
        b->way[i] = 0;
    } else if (!fine && b->flags[i] & BULLET_FINE) {
        b->flags[i] &= (uint8_t)~BULLET_FINE;
        b->pace[i] = b->way[i] = 0;
        b->x_more[i] = b->y_more[i] = 0;
        bullets_steer(b, i);
    } else if (!fine)
        b->pace[i] = b->way[i] = 0;
    b->motion[i] = motion;
    b->pc[i] = 0;
    b->from[i] = 0;
    b->mute[i] = 0;
    if (!(b->flags[i] & BULLET_DELAYED)) { /* else it begins when that is over */
        b->end[i] = 0;
        set_busy(b, i, (motion || fine) && !stands(b, i));
    }
    memset(&b->rounds[i * MOTION_DEPTH], 0, MOTION_DEPTH * sizeof *b->rounds);
}

void bullets_freeze(struct bullets *b, uint32_t i, int32_t frames)
{
    b->frozen[i] = frames;
    if (!frames || b->stands[i])
        return;
    b->stands[i] = STANDS;
    b->standing++;
    b->kept_vx[i] = b->vx[i];
    b->kept_vy[i] = b->vy[i];
    b->vx[i] = b->vy[i] = 0;
    set_busy(b, i, false);
}

/* Its program runs in this move; one that only waits is found to be idle then. */
static void resume(struct bullets *b, uint32_t i)
{
    b->stands[i] = 0;
    b->standing--;
    set_velocity(b, i, b->kept_vx[i], b->kept_vy[i]);
    b->kept_vx[i] = b->kept_vy[i] = 0;
    if (b->flags[i] & BULLET_DELAYED)
        wait_until(b, i, b->end[i]);
    else
        set_busy(b, i, b->motion[i] || b->flags[i] & BULLET_FINE);
}

/* At the start of a move, of a block: who stands in it? out[k] = 1 for those that have stood as long as they were to;
 * returns 1 if there are some. */
static int32_t stand_block(uint8_t *restrict stands, int32_t *restrict frozen, uint8_t *restrict out)
{
    int32_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++) {
        const int32_t stand = stands[k] != 0, left = frozen[k] != 0, over = stand & (left ^ 1);
        frozen[k] -= stand & left & (frozen[k] != FROZEN_FOREVER);
        stands[k] |= (uint8_t)((stand & left) * STOOD);
        out[k] = (uint8_t)over;
        any |= over;
    }
    return any;
}

static bool any_stands(const uint8_t *restrict stands)
{
    uint8_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        any |= stands[k];
    return any;
}

static void stand(struct bullets *b)
{
    uint8_t out[SLOTS_BLOCK];

    for (uint32_t first = 0; first < b->s.top; first += SLOTS_BLOCK)
        if (any_stands(b->stands + first) && stand_block(b->stands + first, b->frozen + first, out))
            for (uint64_t m = slots_gather(out); m; m &= m - 1)
                resume(b, first + bits_lowest(m));
}

/* At the end of a frame, of a block. */
static void stay_block(const uint8_t *restrict stands, const uint8_t *restrict mute, const uint8_t *restrict flags,
                       uint32_t *restrict born, uint32_t *restrict end)
{
    for (int k = 0; k < SLOTS_BLOCK; k++) {
        const uint32_t stood = (stands[k] & STOOD) != 0, begun = (mute[k] & STEP_BEGUN) != 0;
        born[k] += stood;
        end[k] += stood & (begun | ((flags[k] & BULLET_DELAYED) != 0));
    }
}

/* When it bounced stands in `pace`. */
static void stay_bounced(struct bullets *b, uint32_t first)
{
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        if (b->stands[i] & STOOD && b->pace[i] && !(b->flags[i] & BULLET_FINE))
            b->pace[i]++;
}

static bool any_paces(const int64_t *restrict pace)
{
    int64_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        any |= pace[k];
    return any;
}

void bullets_stay(struct bullets *b)
{
    for (uint32_t i = 0; b->standing && i < b->s.top; i += SLOTS_BLOCK) {
        if (!any_stands(b->stands + i))
            continue;
        stay_block(b->stands + i, b->mute + i, b->flags + i, b->born + i, b->end + i);
        if (any_paces(b->pace + i))
            stay_bounced(b, i);
    }
}

/* Squared distance; positions are within the world: below 2^63. */
static uint64_t distance_squared(const struct targets *t, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)t->x[i] - x, dy = (int64_t)t->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

int32_t targets_nearest(const struct targets *t, fx x, fx y)
{
    uint32_t end = t->s->used ? t->s->top : t->s->live;
    uint64_t best = UINT64_MAX;
    int32_t found = NO_SLOT;

    for (uint32_t i = 0; i < end; i++) {
        if (t->s->used && !(t->s->used[i / SLOTS_BLOCK] & bit(i))) {
            if (!t->s->used[i / SLOTS_BLOCK])
                i |= SLOTS_BLOCK - 1;
            continue;
        }
        if (t->in && !t->in[i])
            continue;
        uint64_t d = distance_squared(t, i, x, y);
        if (d < best) {
            best = d;
            found = (int32_t)i;
        }
    }
    return found;
}

ang targets_aim(const struct targets *t, fx x, fx y, ang none)
{
    int32_t i = targets_nearest(t, x, y);

    if (i == NO_SLOT || (t->x[i] == x && t->y[i] == y))
        return none;
    return trig_atan2(fx_sub(t->y[i], y), fx_sub(t->x[i], x));
}

/* Looking for the nearest of them takes as long as so many steps more. */
static inline uint64_t steps_of_aim(const struct targets *t)
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

static void restyle(struct bullets *b, const struct motion_world *w, uint32_t i, uint32_t st)
{
    const struct steps *s = w->steps;

    if (s->does[st] & DOES_KIND && w->kinds)
        bullets_set_kind(b, w->kinds, i, s->kind[st]);
    if (s->does[st] & DOES_BANK)
        b->bank[i] = s->bank[st];
}

enum { DOES_STEER = DOES_DIR | DOES_AIM | DOES_TURN | DOES_HOME, DOES_DRIVE = DOES_STEER | DOES_SPEED | DOES_ACCEL };

/* What a step does to direction and speed in one of its frames: the k-th of n. True: the velocity is to follow. */
static inline __attribute__((always_inline)) bool turn_and_speed(struct bullets *b, const struct motion_world *w,
                                                                 uint32_t i, unsigned mute, uint32_t st, uint32_t k,
                                                                 uint32_t n)
{
    const struct steps *s = w->steps;
    const unsigned does = s->does[st];

    if (!(mute & OVERRIDE_DIR)) {
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
    if (!(does & (DOES_SPEED | DOES_ACCEL)) || mute & OVERRIDE_SPEED)
        return does & DOES_STEER;
    const bool fine = b->flags[i] & BULLET_FINE;
    const int shift = fine ? 0 : PACE_BITS; /* rounded to the unit this bullet keeps: Q32 if fine, else fx */
    int64_t v = bullets_speed(b, i) >> shift;
    if (does & DOES_SPEED)
        v = motion_part_way(b->from[i] >> shift, s->speed[st] >> shift, k, n);
    if (does & DOES_ACCEL)
        v += s->accel[st] >> shift;
    v = clamp_pace(v * ((int64_t)1 << shift));
    b->speed[i] = pace_fx(v);
    if (fine)
        b->pace[i] = v;
    return true;
}

static void drive(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t st, uint32_t k,
                  uint32_t n)
{
    if (turn_and_speed(b, w, i, mute, st, k, n))
        steer(b, i);
}

/* Moves a fine bullet on to `way`, that far. vx, vy become what that is in whole units. */
static void fly_by(struct bullets *b, uint32_t i, int64_t way, int64_t dx, int64_t dy)
{
    int64_t x, y;

    bullets_place(b, i, &x, &y);
    const fx nx = split(x + dx, &b->x_more[i]), ny = split(y + dy, &b->y_more[i]);
    set_velocity(b, i, nx - b->x[i], ny - b->y[i]);
    b->way[i] = (int64_t)((uint64_t)way << 16) >> 16;
}

/* Moves a fine bullet on by its pace. */
static void fly(struct bullets *b, uint32_t i)
{
    const int64_t to = b->way[i] + b->pace[i];
    int64_t dx, dy;

    trig_stride(b->way[i], to, b->dir[i], &dx, &dy);
    fly_by(b, i, to, dx, dy);
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

/* While a step leads a bullet, `from` and `way`, which its drive and fine motion would use, keep what it found. */
static void keep_lead(struct bullets *b, uint32_t i, const struct motion_lead *l)
{
    b->from[i] = (int64_t)((uint64_t)(uint32_t)l->x << 32 | (uint32_t)l->y);
    b->way[i] = (int64_t)((uint64_t)(uint32_t)l->radius << 32 | l->angle);
}

static struct motion_lead kept_lead(const struct bullets *b, uint32_t i)
{
    return (struct motion_lead){ .x = (fx)(b->from[i] >> 32),
                                 .y = (fx)b->from[i],
                                 .radius = (fx)(b->way[i] >> 32),
                                 .angle = (ang)b->way[i],
                                 .speed = b->speed[i] };
}

/* Where the thing is, or was a frame before, that bullet i is to go round; false: it is not there. */
static bool around(const struct bullets *b, const struct motion_world *w, uint32_t i, bool before, fx *x, fx *y)
{
    return b->around && b->around[i] && w->where(w, b->around[i], i / SLOTS_BLOCK * SLOTS_BLOCK, before, x, y);
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
    return s->how[st] & HOW_SPEED ? (uint32_t)(b->way[i] >> 32) : s->over[st];
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
    set_velocity(b, i, (fx)dx, (fx)dy);
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
    if (lead(b, w, i, st, n - (b->end[i] - w->clock) + 1, n))
        return true;
    b->way[i] = 0;
    return false;
}

/* What a step has led is let go. It flies on as it did in the last frame; a wave along its way. */
static void let_go(struct bullets *b, uint32_t i, uint32_t does)
{
    b->way[i] = 0;
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

/* Turns bullet i back where this frame's move would lead it out. It ends the frame at the reflected place; `way` keeps
 * the velocity that it has then, till the next frame. */
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
    b->way[i] = (int64_t)((uint64_t)(uint32_t)vx << 32 | (uint32_t)vy);
    set_velocity(b, i, (fx)(x - b->x[i]), (fx)(y - b->y[i]));
}

/* The frame after a bounce: it has its velocity, unless a script has given it another. */
static void bounced(struct bullets *b, uint32_t i, unsigned mute)
{
    if (!(mute & (OVERRIDE_DIR | OVERRIDE_SPEED)))
        set_velocity(b, i, (fx)(b->way[i] >> 32), (fx)b->way[i]);
    b->way[i] = 0;
}

/* A frame of bullet i on its way to a wall, since the clock before `pace`. Returns the step that it goes on with in
 * this frame; pc: none. */
static uint32_t fly_to_wall(struct bullets *b, const struct motion_world *w, uint32_t i, unsigned mute, uint32_t pc)
{
    const struct steps *s = w->steps;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + pc;

    if (b->way[i]) {
        bounced(b, i, mute);
        return pc + 1;
    }
    if (w->clock + 1 - (uint32_t)b->pace[i] >= s->over[st])
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
        return crossed((fx)(b->from[i] >> 32), b->x[i], s->x[st]);
    case HOW_Y:
        return crossed((fx)b->from[i], b->y[i], s->y[st]);
    case HOW_NEAR: {
        const int32_t t = targets_nearest(&w->targets, b->x[i], b->y[i]);
        b->ran += steps_of_aim(&w->targets);
        return t != NO_SLOT && distance_squared(&w->targets, (uint32_t)t, b->x[i], b->y[i]) <
                                   (uint64_t)((int64_t)s->size[st] * s->size[st]);
    }
    default:
        return mute & STEP_SIGNALLED;
    }
}

void bullets_signal(struct bullets *b, const struct motion_world *w, uint32_t i, uint16_t tag)
{
    if (!b->motion[i] || !(b->mute[i] & STEP_BEGUN))
        return;
    const uint32_t st = w->motions->first[b->motion[i] - 1u] + b->pc[i];
    if (!(w->steps->does[st] & DOES_AWAIT) || w->steps->how[st] != HOW_SIGNAL)
        return;
    if (tag && w->steps->count[st] != tag)
        return;
    b->mute[i] |= STEP_SIGNALLED;
    if (!stands(b, i))
        set_busy(b, i, true);
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

/* Where a bullet's program is while it runs: `pc` and `mute`, kept when it waits for the next frame. */
struct run {
    uint32_t pc;
    unsigned mute;
};

static void keep_run(struct bullets *b, uint32_t i, const struct run *r)
{
    b->pc[i] = (uint16_t)r->pc;
    b->mute[i] = (uint8_t)r->mute;
}

/* A program after a step of this frame. */
enum program_state {
    PROGRAM_NEXT,  /* the next step follows in this frame */
    PROGRAM_OVER,  /* it is over, or the bullet gone */
    PROGRAM_RUNS,  /* it runs in the next frame too */
    PROGRAM_WAITS, /* it does nothing until the clock is `end` */
};

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
            b->pace[i] = (int64_t)w->clock + 1;
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

    b->from[i] = bullets_speed(b, i);
    if (does & DOES_LEAD)
        n = begin_lead(b, w, i, st);
    else if (does & DOES_AWAIT)
        b->from[i] = (int64_t)((uint64_t)(uint32_t)b->x[i] << 32 | (uint32_t)b->y[i]);
    b->end[i] = w->clock + n;
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
    if (n && b->end[i] != w->clock) {
        r->mute |= STEP_BEGUN;
        keep_run(b, i, r);
        if (does & DOES_DRIVE)
            drive(b, w, i, r->mute, st, n - (b->end[i] - w->clock) + 1, n);
        else if (does & (DOES_LEAD | DOES_AWAIT)) {
            if (does & DOES_LEAD ? !lead_on(b, w, i, r->mute, st, n) : has_come(b, w, i, r->mute, st))
                return step_over(r);
        }
        b->due[i] = (uint8_t)b->end[i];
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
    struct run r = { b->pc[i], b->mute[i] };

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
    slots_prefetch(&b->mute[i]);
    slots_prefetch(&b->end[i]);
    slots_prefetch(&b->from[i]);
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

/* Is what bullet i waited for over? A delay: then it is what was fired, from this frame on. */
static inline bool is_over(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    if (b->end[i] != w->clock)
        return false;
    if (b->flags[i] & BULLET_DELAYED) {
        b->flags[i] &= (uint8_t)~BULLET_DELAYED;
        if (w->kinds)
            change_kind(b, i, bullets_kind(b, w->kinds, i));
        b->born[i] = w->clock;
        b->end[i] = 0;
        bullets_steer(b, i);
    }
    return true;
}

/* Runs a program, and moves what is fine. */
static enum program_state go_on(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    enum program_state state = b->flags[i] & BULLET_FINE ? PROGRAM_RUNS : PROGRAM_OVER;

    if (b->motion[i])
        state = run_program(b, w, i);
    if (b->flags[i] & BULLET_FINE)
        fly(b, i);
    return state;
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
    bool is, timed;    /* there is one; it is a step's, which ends at `end` */
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
    c->mute = b->mute[i];
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
    return b->motion[i] == c->motion && b->pc[i] == c->pc && b->mute[i] == c->mute &&
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

    course_block(b->motion + first, b->pc + first, b->mute + first, b->flags + first, c, out);
    return slots_gather(out) & (c->timed ? ~ends_block(b->end + first, w->clock) : UINT64_MAX);
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
    if (!c->is || (c->timed && b->end[i] == w->clock))
        return 0;
    if (!has_company(b, c, first, of & (of - 1), *few)) {
        *few = 1;
        return bit(i);
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
        if (t->s->used && !(t->s->used[i / SLOTS_BLOCK] & bit(i))) {
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
            if (distance_squared(t, few[other], x, y) < distance_squared(t, nearest, x, y))
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
        int64_t v = c->fine ? b->pace[i] : b->speed[i];
        if (c->does & DOES_SPEED) {
            const int64_t began = b->from[i] >> shift;
            if (b->end[i] != end || began != from) {
                from = began;
                end = b->end[i];
                reached = motion_part_way(from, goal, over - (end - w->clock) + 1, over);
            }
            v = reached;
        }
        v = int64_clamp(c->does & DOES_ACCEL ? v + accel : v, -most, most);
        if (c->fine)
            b->pace[i] = v;
        b->speed[i] = c->fine ? pace_fx(v) : (fx)v;
    }
}

/* `fly` for all of them. */
static void fly_some(struct bullets *b, const struct some *s, const ang *dir)
{
    int64_t from[SLOTS_BLOCK], to[SLOTS_BLOCK], dx[SLOTS_BLOCK], dy[SLOTS_BLOCK];

    for (int k = 0; k < s->n; k++) {
        from[k] = b->way[nth(s, k)];
        to[k] = from[k] + b->pace[nth(s, k)];
    }
    trig_strides(from, to, dir, dx, dy, s->n);
    for (int k = 0; k < s->n; k++)
        fly_by(b, nth(s, k), to[k], dx[k], dy[k]);
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
            b->ran += (uint64_t)s->n * steps_of_aim(&w->targets);
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
    if (turn_and_speed(b, w, i, c->mute, c->st, n - (b->end[i] - w->clock) + 1, n))
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
        const enum program_state state = is_over(b, w, i) ? go_on(b, w, i) : PROGRAM_WAITS;
        busy |= state == PROGRAM_RUNS ? bit(i) : 0;
        idle |= state == PROGRAM_WAITS ? bit(i) : 0;
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
        const uint64_t who = woken & bit(i) ? 0 : alike(b, w, &c, i, m & ~woken, &few);
        if (who) { /* they are busy, and stay so */
            if (who == bit(i) && !c.fine)
                keep_alone(b, w, &c, i, &later);
            else {
                take_some(&some, first, who);
                keep_course(b, w, &c, &some);
            }
            m &= ~who;
            continue;
        }
        enum program_state state = PROGRAM_WAITS;
        if (!(woken & bit(i)) || is_over(b, w, i))
            state = go_on(b, w, i);
        busy = state == PROGRAM_RUNS ? busy | bit(i) : busy & ~bit(i);
        idle |= state == PROGRAM_WAITS ? bit(i) : 0;
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

/* near: the bullets of a block, as bits, that may touch or graze player p. The narrow phase decides which do. */
static inline void set_near(struct bullets *b, const struct bullets_query *q, uint32_t block, uint32_t p, uint64_t near)
{
    uint64_t grazes = 0;

    near &= b->s.used[block];
    if (near && q->narrow)
        near = q->narrow(q, p, block, near, &grazes);
    b->near[block * PADS + p] = near;
    b->grazes[block * PADS + p] = grazes;
}

/* What the narrow phase will read of a block's bullets besides where they are. */
static void prefetch_near(const struct bullets *b, uint32_t first)
{
    slots_prefetch(&b->kind[first]);
    slots_prefetch(&b->kind[first + SLOTS_BLOCK / 2]);
    slots_prefetch(&b->flags[first]);
}

static void find_near_block(struct bullets *b, const struct bullets_query *q, uint32_t block, uint32_t p)
{
    uint32_t first = block * SLOTS_BLOCK;
    uint8_t out[SLOTS_BLOCK];

    struct range r = near_range(q, b->fastest);
    bool some = near_block(b->x + first, b->y + first, out, &r);
    set_near(b, q, block, p, some ? slots_gather(out) : 0);
}

static inline void find_near(struct bullets *b, const struct bullets_query *q, uint32_t block, uint32_t p)
{
    if (q->reach < 0)
        set_near(b, q, block, p, 0);
    else
        find_near_block(b, q, block, p);
}

void bullets_find_near(struct bullets *b, const struct bullets_query query[PADS])
{
    for (uint32_t block = 0; block < b->s.top / SLOTS_BLOCK; block++)
        for (uint32_t p = 0; p < PADS; p++)
            find_near(b, &query[p], block, p);
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
        if (hold & bit(i))
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
        stand(b);
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
        set_near(b, &query[0], block, 0, query[0].reach < 0 ? 0 : named);
        for (uint32_t p = 1; p < PADS; p++)
            find_near(b, &query[p], block, p);
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
        stand(b);
}

bool bullets_go_on(struct bullets *b, const struct motion_world *w, uint32_t i)
{
    const uint32_t block = i / SLOTS_BLOCK;

    if (b->busy[block] & bit(i) || (b->idle[block] & bit(i) && is_over(b, w, i))) {
        enum program_state state = go_on(b, w, i);
        if (!(b->s.used[block] & bit(i)))
            return false;
        set_busy(b, i, state == PROGRAM_RUNS);
        b->idle[block] |= state == PROGRAM_WAITS ? bit(i) : 0;
    }
    b->x[i] += b->vx[i];
    b->y[i] += b->vy[i];
    b->moved++;
    return true;
}
