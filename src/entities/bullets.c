/*
 * bullets.c - the pools of bullets and shots: spawning, despawning, properties, freezing, targets.
 */
#include "bullets_parts.h"
#include <string.h>

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
    COLUMN(bullets, owner_task),
    COLUMN(bullets, player),
    COLUMN(bullets, motion),
    COLUMN(bullets, pc),
    COLUMN(bullets, step_end),
    COLUMN(bullets, step_start),
    COLUMN(bullets, step_flags),
    COLUMN(bullets, speed_q32),
    COLUMN(bullets, travel_q32),
    COLUMN(bullets, x_more),
    COLUMN(bullets, y_more),
    COLUMNS(bullets, rounds, MOTION_DEPTH),
    GROUP_COLUMN(bullets, value1, GROUP_VALUE + 0),
    GROUP_COLUMN(bullets, value2, GROUP_VALUE + 1),
    GROUP_COLUMN(bullets, value3, GROUP_VALUE + 2),
    GROUP_COLUMN(bullets, value4, GROUP_VALUE + 3),
    GROUP_COLUMN(bullets, orbit_target, GROUP_AROUND),
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
    GROUP_COLUMNS(bullets, rehit_clock, PIERCED, GROUP_PIERCE),
    DERIVED_BLOCKS(bullets, busy, 1, "computed from motion, pc, step_flags and flags"),
    DERIVED_BLOCKS(bullets, idle, 1, "computed from motion, pc, step_flags and flags"),
    DERIVED_BLOCKS(bullets, near, PADS, "rewritten by every move before hit tests read it"),
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
    DERIVED(bullets, due, "the low byte of `step_end`, only for idle bullets"),
    DERIVED_REGISTERS(bullets, value_start, "set only while scripts load, like names"),
    DERIVED_REGISTER(bullets, fastest, "an upper bound for the broad phase; the narrow phase decides what is hit"),
    DERIVED_REGISTER(bullets, standing, "the number of standing bullets, counted from the column `stands`"),
    DERIVED_REGISTER(bullets, moved, "a count for benchmarks, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, holds_all, "rewritten by every move before hit tests read it"),
    DERIVED_REGISTER(bullets, ran, "a counter for the work limit, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, of_kind, "the address of the kinds' column `live`, computed from the address of RAM"),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip bullets_chip = { "bullets", columns, COUNT(columns), false, false };
const struct chip shots_chip = { "shots", columns, COUNT(columns), false, false };
const struct chip laser_heads_chip = { "laser_heads", columns, COUNT(columns), false, false };
const struct chip bullet_kinds_chip = { "bullet_kinds", kind_columns, COUNT(kind_columns), true, false };
const struct chip shot_kinds_chip = { "shot_kinds", kind_columns, COUNT(kind_columns), true, false };

/* Parks a dead slot at (0, 0), which is inside every keep box, so the slot never counts as having left the field. */
static void park(struct bullets *b, uint32_t i)
{
    b->x[i] = b->y[i] = 0;
    b->vx[i] = b->vy[i] = 0;
    b->motion[i] = 0;
    b->flags[i] = 0;
    if (b->stands)
        b->stands[i] = 0;
    bullets_set_busy(b, i, false);
}

/* Initialises the block that starts at slot `first` before the block is first used. */
static void open_block(struct bullets *b, uint32_t first)
{
    b->busy[first / SLOTS_BLOCK] = b->idle[first / SLOTS_BLOCK] = 0;
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        park(b, i);
}

/* Makes bullet i idle until the clock reaches `end`. */
static void wait_until(struct bullets *b, uint32_t i, uint32_t end)
{
    b->step_end[i] = end;
    b->due[i] = (uint8_t)end;
    b->idle[i / SLOTS_BLOCK] |= bullets_bit(i);
}

bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t entity, uint32_t clock)
{
    if (!b->pierce || !b->pierce[i])
        return false;
    const int32_t every = kinds->every[b->kind[i]];
    int64_t *known = b->pierced + (size_t)i * PIERCED;
    int k = 0;
    while (k < PIERCED - 1 && known[k] && known[k] != entity)
        k++;
    known[k] = entity;
    b->rehit_clock[(size_t)i * PIERCED + (size_t)k] = every == PIERCE_FOREVER ? UINT32_MAX : clock + (uint32_t)every;
    b->pierce[i] -= b->pierce[i] > 0;
    return true;
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
    bullets_count_kind(b, kind, 1);
    b->bank[i] = shape->bank;
    b->tag[i] = shape->tag;
    b->flags[i] = shape->delay ? BULLET_DELAYED : 0;
    b->born[i] = clock;
    b->owner_task[i] = shape->by;
    b->player[i] = shape->player;
    b->speed_q32[i] = b->travel_q32[i] = 0;
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
        memset(b->rehit_clock + (size_t)i * PIERCED, 0, PIERCED * sizeof *b->rehit_clock);
    }
    if (b->frozen)
        b->frozen[i] = b->kept_vx[i] = b->kept_vy[i] = b->stands[i] = 0;
    if (b->orbit_target)
        b->orbit_target[i] = shape->around;
    bullets_program(b, (uint32_t)i, shape->motion, shape->fine);
    if (shape->delay)
        wait_until(b, (uint32_t)i, clock + shape->delay);
    bullets_steer(b, (uint32_t)i);
    return i;
}

void bullets_drop(struct bullets *b, uint32_t i)
{
    b->standing -= bullets_stands(b, i);
    bullets_count_kind(b, b->kind[i], -1);
    slots_drop(&b->s, i);
    park(b, i);
}

void bullets_hold(struct bullets *b, uint32_t i)
{
    bullets_count_kind(b, b->kind[i], -1);
    slots_hold(&b->s, b->leaving, i);
}

void bullets_release(struct bullets *b, uint32_t i)
{
    b->standing -= bullets_stands(b, i);
    slots_release(&b->s, i);
    park(b, i);
    slots_trim(&b->s);
}

void bullets_release_all(struct bullets *b)
{
    EACH_HELD (i, &b->s)
        bullets_release(b, i);
}

void bullets_steer(struct bullets *b, uint32_t i)
{
    bullets_velocity_from_dir(b, i);
}

void bullets_set_flight(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    bullets_store_velocity(b, i, vx, vy);
}

void bullets_set_speed(struct bullets *b, uint32_t i, int64_t speed)
{
    b->speed[i] = bullets_pace_fx(speed);
    if (b->flags[i] & BULLET_FINE)
        b->speed_q32[i] = speed;
    bullets_steer(b, i);
}

void bullets_velocity(const struct bullets *b, uint32_t i, int64_t *vx, int64_t *vy)
{
    fx x = (bullets_stands(b, i) ? b->kept_vx : b->vx)[i], y = (bullets_stands(b, i) ? b->kept_vy : b->vy)[i];

    if (b->flags[i] & BULLET_FINE) {
        trig_stride(0, b->speed_q32[i], b->dir[i], vx, vy);
        return;
    }
    if (b->flags[i] & BULLET_DELAYED) /* the velocity that the bullet will have after the delay */
        trig_polar(b->speed[i], b->dir[i], &x, &y);
    *vx = (int64_t)x * (1 << PACE_BITS);
    *vy = (int64_t)y * (1 << PACE_BITS);
}

/* Sets dir from the leading 31 bits of (vx, vy), and the speed to the component of (vx, vy) along dir. The component
 * across dir is less than 2^-29 of the speed, so the speed is right to the last bit. */
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
    bullets_set_speed(b, i, bullets_clamp_pace(along[0] + along[1]));
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
        bullets_store_velocity(b, i, x, y);
}

void bullets_set_place(struct bullets *b, uint32_t i, int64_t x, int64_t y)
{
    b->x[i] = bullets_split(x, &b->x_more[i]);
    b->y[i] = bullets_split(y, &b->y_more[i]);
}

void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind)
{
    bool cloud = b->flags[i] & BULLET_DELAYED && kinds->flags[kind] & KIND_CLOUDED;

    bullets_change_kind(b, i, kind + (cloud ? (unsigned)ROW_CLOUD : ROW_KIND));
    b->bank[i] = kinds->bank[kind];
    if (b->hp)
        b->hp[i] = kinds->hp[kind];
}

void bullets_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine)
{
    if (fine && !(b->flags[i] & BULLET_FINE)) {
        b->speed_q32[i] = bullets_speed(b, i);
        b->flags[i] |= BULLET_FINE;
        b->travel_q32[i] = 0;
    } else if (!fine && b->flags[i] & BULLET_FINE) {
        b->flags[i] &= (uint8_t)~BULLET_FINE;
        b->speed_q32[i] = b->travel_q32[i] = 0;
        b->x_more[i] = b->y_more[i] = 0;
        bullets_steer(b, i);
    } else if (!fine)
        b->speed_q32[i] = b->travel_q32[i] = 0;
    b->motion[i] = motion;
    b->pc[i] = 0;
    b->step_start[i] = 0;
    b->step_flags[i] = 0;
    if (!(b->flags[i] & BULLET_DELAYED)) { /* a delayed bullet starts its program after the delay */
        b->step_end[i] = 0;
        bullets_set_busy(b, i, (motion || fine) && !bullets_stands(b, i));
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
    bullets_set_busy(b, i, false);
}

/* Unfreezes bullet i. Its program runs in this move; if the program only waits, bullet i then becomes idle. */
static void resume(struct bullets *b, uint32_t i)
{
    b->stands[i] = 0;
    b->standing--;
    bullets_store_velocity(b, i, b->kept_vx[i], b->kept_vy[i]);
    b->kept_vx[i] = b->kept_vy[i] = 0;
    if (b->flags[i] & BULLET_DELAYED)
        wait_until(b, i, b->step_end[i]);
    else
        bullets_set_busy(b, i, b->motion[i] || b->flags[i] & BULLET_FINE);
}

/* Counts down the frames left of a block's frozen bullets at the start of a move. Sets out[k] to 1 if bullet k is
 * frozen with none left, otherwise to 0. Returns 1 if any out[k] is 1, otherwise 0. */
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

void bullets_stand(struct bullets *b)
{
    uint8_t out[SLOTS_BLOCK];

    for (uint32_t first = 0; first < b->s.top; first += SLOTS_BLOCK)
        if (any_stands(b->stands + first) && stand_block(b->stands + first, b->frozen + first, out))
            for (uint64_t m = slots_gather(out); m; m &= m - 1)
                resume(b, first + bits_lowest(m));
}

/* For the bullets of a block that were frozen in this frame, postpones `born`, and the end of a delay or of a step in
 * progress, by a frame. */
static void stay_block(const uint8_t *restrict stands, const uint8_t *restrict mute, const uint8_t *restrict flags,
                       uint32_t *restrict born, uint32_t *restrict end)
{
    for (int k = 0; k < SLOTS_BLOCK; k++) {
        const uint32_t stood = (stands[k] & STOOD) != 0, begun = (mute[k] & STEP_BEGUN) != 0;
        born[k] += stood;
        end[k] += stood & (begun | ((flags[k] & BULLET_DELAYED) != 0));
    }
}

/* Like stay_block, for the start clock of a `bounce`, which bullets that are not fine store in `speed_q32`. */
static void stay_bounced(struct bullets *b, uint32_t first)
{
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        if (b->stands[i] & STOOD && b->speed_q32[i] && !(b->flags[i] & BULLET_FINE))
            b->speed_q32[i]++;
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
        stay_block(b->stands + i, b->step_flags + i, b->flags + i, b->born + i, b->step_end + i);
        if (any_paces(b->speed_q32 + i))
            stay_bounced(b, i);
    }
}

int32_t targets_nearest(const struct targets *t, fx x, fx y)
{
    uint32_t end = t->s->used ? t->s->top : t->s->live;
    uint64_t best = UINT64_MAX;
    int32_t found = NO_SLOT;

    for (uint32_t i = 0; i < end; i++) {
        if (t->s->used && !(t->s->used[i / SLOTS_BLOCK] & bullets_bit(i))) {
            if (!t->s->used[i / SLOTS_BLOCK])
                i |= SLOTS_BLOCK - 1;
            continue;
        }
        if (t->in && !t->in[i])
            continue;
        uint64_t d = bullets_target_distance(t, i, x, y);
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
