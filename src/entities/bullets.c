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
    COLUMN(bullet_kinds, draw_order),
    COLUMN(bullet_kinds, vanish_spark),
    GROUP_COLUMN(bullet_kinds, hp, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, score, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, spark, GROUP_HP),
    GROUP_COLUMN(bullet_kinds, pierce_hits, GROUP_PIERCE),
    GROUP_COLUMN(bullet_kinds, rehit_interval, GROUP_PIERCE),
    GROUP_COLUMN(bullet_kinds, scale, GROUP_TRANSFORMS),
    DERIVED_COLUMN(bullet_kinds, live_count, "counts the live bullets of each kind"),
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
    COLUMN(bullets, x_low),
    COLUMN(bullets, y_low),
    COLUMNS(bullets, rounds_left, MOTION_MAX_DEPTH),
    GROUP_COLUMN(bullets, value1, GROUP_VALUE + 0),
    GROUP_COLUMN(bullets, value2, GROUP_VALUE + 1),
    GROUP_COLUMN(bullets, value3, GROUP_VALUE + 2),
    GROUP_COLUMN(bullets, value4, GROUP_VALUE + 3),
    GROUP_COLUMN(bullets, orbit_target, GROUP_ORBIT),
    GROUP_COLUMN(bullets, step_value1, GROUP_VALUE + 0),
    GROUP_COLUMN(bullets, step_value2, GROUP_VALUE + 1),
    GROUP_COLUMN(bullets, step_value3, GROUP_VALUE + 2),
    GROUP_COLUMN(bullets, step_value4, GROUP_VALUE + 3),
    GROUP_COLUMN(bullets, hp, GROUP_HP),
    GROUP_COLUMN(bullets, frozen_left, GROUP_FROZEN),
    GROUP_COLUMN(bullets, freeze_flags, GROUP_FROZEN),
    GROUP_COLUMN(bullets, saved_vx, GROUP_FROZEN),
    GROUP_COLUMN(bullets, saved_vy, GROUP_FROZEN),
    GROUP_COLUMN(bullets, pierce_left, GROUP_PIERCE),
    GROUP_COLUMNS(bullets, pierced_targets, MAX_PIERCED_TARGETS, GROUP_PIERCE),
    GROUP_COLUMNS(bullets, rehit_clock, MAX_PIERCED_TARGETS, GROUP_PIERCE),
    DERIVED_BLOCKS(bullets, busy, 1, "computed from motion, pc, step_flags and flags"),
    DERIVED_BLOCKS(bullets, idle, 1, "computed from motion, pc, step_flags and flags"),
    DERIVED_BLOCKS(bullets, near_player, MAX_PLAYERS, "rewritten by every move before hit tests read it"),
    DERIVED_BLOCKS(bullets, leaving, 1, "empty between frames"),
    GROUP_DERIVED_BLOCKS(bullets, solid, GROUP_HP, "rewritten in every frame before hit tests read it"),
    GROUP_REGISTER(bullets, n_meet_pairs, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_first, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_second, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_spark, GROUP_MEET),
    GROUP_REGISTERS(bullets, meet_flags, GROUP_MEET),
    GROUP_DERIVED_COLUMN(bullets, meet_next, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    GROUP_DERIVED_BLOCKS(bullets, meet_collided, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    GROUP_DERIVED_BLOCKS(bullets, meet_removed, GROUP_MEET, "rewritten in every frame before hit tests read it"),
    DERIVED_COLUMN(bullets, step_end_low, "the low byte of `step_end`, only for idle bullets"),
    DERIVED_REGISTERS(bullets, initial_value, "set only while scripts load, like names"),
    DERIVED_REGISTER(bullets, speed_bound, "an upper bound for the broad phase; the narrow phase decides what is hit"),
    DERIVED_REGISTER(bullets, n_frozen, "the number of frozen bullets, counted from the column `freeze_flags`"),
    DERIVED_REGISTER(bullets, n_moved, "a count for benchmarks, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, holds_all, "rewritten by every move before hit tests read it"),
    DERIVED_REGISTER(bullets, work_done, "a counter for the work limit, rewritten by every move before it is read"),
    DERIVED_REGISTER(bullets, kind_counts,
                     "address of the kinds' column `live_count`, computed from the address of RAM"),
};

const struct chip bullets_chip = { .name = "bullets", CHIP_COLUMNS(columns) };
const struct chip shots_chip = { .name = "shots", CHIP_COLUMNS(columns) };
const struct chip laser_heads_chip = { .name = "laser_heads", CHIP_COLUMNS(columns) };
const struct chip bullet_kinds_chip = { .name = "bullet_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };
const struct chip shot_kinds_chip = { .name = "shot_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };

/* Parks a dead slot at (0, 0), which is inside every keep box, so the slot never counts as having left the field. */
static void park(struct bullets *b, uint32_t i)
{
    b->x[i] = b->y[i] = 0;
    b->vx[i] = b->vy[i] = 0;
    b->motion[i] = 0;
    b->flags[i] = 0;
    if (b->freeze_flags)
        b->freeze_flags[i] = 0;
    bullets_set_busy(b, i, false);
}

/* Initialises the block that starts at slot `first` before the block is first used. */
static void init_block(struct bullets *b, uint32_t first)
{
    b->busy[first / SLOTS_BLOCK] = b->idle[first / SLOTS_BLOCK] = 0;
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        park(b, i);
}

/* Makes bullet i idle until the clock reaches `end`. */
static void make_idle(struct bullets *b, uint32_t i, uint32_t end)
{
    b->step_end[i] = end;
    b->step_end_low[i] = (uint8_t)end;
    b->idle[i / SLOTS_BLOCK] |= bullets_bit(i);
}

bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t entity, uint32_t clock)
{
    if (!b->pierce_left || !b->pierce_left[i])
        return false;
    const int32_t rehit_interval = kinds->rehit_interval[b->kind[i]];
    int64_t *pierced = b->pierced_targets + (size_t)i * MAX_PIERCED_TARGETS;
    int k = 0;
    while (k < MAX_PIERCED_TARGETS - 1 && pierced[k] && pierced[k] != entity)
        k++;
    pierced[k] = entity;
    b->rehit_clock[(size_t)i * MAX_PIERCED_TARGETS + (size_t)k] =
        rehit_interval == PIERCE_FOREVER ? UINT32_MAX : clock + (uint32_t)rehit_interval;
    b->pierce_left[i] -= b->pierce_left[i] > 0;
    return true;
}

int32_t bullets_fire(struct bullets *b, const struct bullet_spec *spec, uint32_t clock)
{
    uint32_t top = b->s.top;
    int32_t i = slots_take(&b->s);

    if (i == NO_SLOT)
        return i;
    if (top < b->s.top)
        init_block(b, top);
    b->x[i] = spec->x;
    b->y[i] = spec->y;
    b->dir[i] = spec->dir;
    b->vx[i] = b->vy[i] = 0;
    b->speed[i] = spec->speed;
    const uint16_t kind = (uint16_t)(spec->kind + (spec->is_clouded ? ROW_CLOUD : ROW_KIND));
    b->kind[i] = kind;
    bullets_adjust_kind_count(b, kind, 1);
    b->bank[i] = spec->bank;
    b->tag[i] = spec->tag;
    b->flags[i] = spec->delay ? BULLET_DELAYED : 0;
    b->born[i] = clock;
    b->owner_task[i] = spec->owner_task;
    b->player[i] = spec->player;
    b->speed_q32[i] = b->travel_q32[i] = 0;
    b->x_low[i] = b->y_low[i] = 0;
    for (int k = 0; k < MAX_VALUES && bullets_value_column(b, k); k++) {
        bullets_value_column(b, k)[i] = b->initial_value[k];
        bullets_step_value_column(b, k)[i] = 0;
    }
    if (b->hp)
        b->hp[i] = spec->hp;
    if (b->pierce_left) {
        b->pierce_left[i] = spec->pierce_hits;
        memset(b->pierced_targets + (size_t)i * MAX_PIERCED_TARGETS, 0,
               MAX_PIERCED_TARGETS * sizeof *b->pierced_targets);
        memset(b->rehit_clock + (size_t)i * MAX_PIERCED_TARGETS, 0, MAX_PIERCED_TARGETS * sizeof *b->rehit_clock);
    }
    if (b->frozen_left)
        b->frozen_left[i] = b->saved_vx[i] = b->saved_vy[i] = b->freeze_flags[i] = 0;
    if (b->orbit_target)
        b->orbit_target[i] = spec->orbit_target;
    bullets_start_program(b, (uint32_t)i, spec->motion, spec->is_fine);
    if (spec->delay)
        make_idle(b, (uint32_t)i, clock + spec->delay);
    bullets_update_velocity(b, (uint32_t)i);
    return i;
}

void bullets_drop(struct bullets *b, uint32_t i)
{
    b->n_frozen -= bullets_is_frozen(b, i);
    bullets_adjust_kind_count(b, b->kind[i], -1);
    slots_drop(&b->s, i);
    park(b, i);
}

void bullets_hold(struct bullets *b, uint32_t i)
{
    bullets_adjust_kind_count(b, b->kind[i], -1);
    slots_hold(&b->s, b->leaving, i);
}

void bullets_release(struct bullets *b, uint32_t i)
{
    b->n_frozen -= bullets_is_frozen(b, i);
    slots_release(&b->s, i);
    park(b, i);
    slots_trim(&b->s);
}

void bullets_release_all(struct bullets *b)
{
    EACH_HELD (i, &b->s)
        bullets_release(b, i);
}

void bullets_update_velocity(struct bullets *b, uint32_t i)
{
    bullets_set_velocity_from_dir(b, i);
}

void bullets_set_velocity_only(struct bullets *b, uint32_t i, fx vx, fx vy)
{
    bullets_store_velocity(b, i, vx, vy);
}

void bullets_set_speed(struct bullets *b, uint32_t i, int64_t speed)
{
    b->speed[i] = bullets_speed_to_fx(speed);
    if (b->flags[i] & BULLET_FINE)
        b->speed_q32[i] = speed;
    bullets_update_velocity(b, i);
}

void bullets_get_velocity(const struct bullets *b, uint32_t i, int64_t *vx, int64_t *vy)
{
    fx x = (bullets_is_frozen(b, i) ? b->saved_vx : b->vx)[i], y = (bullets_is_frozen(b, i) ? b->saved_vy : b->vy)[i];

    if (b->flags[i] & BULLET_FINE) {
        trig_stride(0, b->speed_q32[i], b->dir[i], vx, vy);
        return;
    }
    if (b->flags[i] & BULLET_DELAYED) /* the velocity that the bullet will have after the delay */
        trig_polar(b->speed[i], b->dir[i], &x, &y);
    *vx = (int64_t)x * (1 << Q32_EXTRA_BITS);
    *vy = (int64_t)y * (1 << Q32_EXTRA_BITS);
}

/* Sets dir from the leading 31 bits of (vx, vy), and the speed to the component of (vx, vy) along dir. The component
 * across dir is less than 2^-29 of the speed, so the speed is right to the last bit. */
static void set_fine_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy)
{
    int64_t ax = int64_abs(vx), ay = int64_abs(vy), along_dir[2], unused;
    int shift = 0;

    while ((ax | ay) >> shift > FX_MAX)
        shift++;
    if (ax | ay)
        b->dir[i] = trig_atan2((fx)(vy >> shift), (fx)(vx >> shift));
    trig_stride(0, vx, b->dir[i], &along_dir[0], &unused);
    trig_stride(0, vy, b->dir[i], &unused, &along_dir[1]);
    bullets_set_speed(b, i, bullets_clamp_speed(along_dir[0] + along_dir[1]));
}

void bullets_set_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy)
{
    const fx limit = (fx)MAX_SPEED << 16, x = (fx)(vx >> Q32_EXTRA_BITS), y = (fx)(vy >> Q32_EXTRA_BITS);

    if (b->flags[i] & BULLET_FINE) {
        set_fine_velocity(b, i, vx, vy);
        return;
    }
    b->speed[i] = fx_hypot(x, y);
    if (x || y)
        b->dir[i] = trig_atan2(y, x);
    if (b->speed[i] > limit) {
        b->speed[i] = limit;
        bullets_update_velocity(b, i);
    } else if (!(b->flags[i] & BULLET_DELAYED))
        bullets_store_velocity(b, i, x, y);
}

void bullets_set_position(struct bullets *b, uint32_t i, int64_t x, int64_t y)
{
    b->x[i] = bullets_split_coordinate(x, &b->x_low[i]);
    b->y[i] = bullets_split_coordinate(y, &b->y_low[i]);
}

void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind)
{
    bool is_clouded = b->flags[i] & BULLET_DELAYED && kinds->flags[kind] & KIND_HAS_CLOUD;

    bullets_set_kind_row(b, i, kind + (is_clouded ? (unsigned)ROW_CLOUD : ROW_KIND));
    b->bank[i] = kinds->bank[kind];
    if (b->hp)
        b->hp[i] = kinds->hp[kind];
}

void bullets_start_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine)
{
    if (fine && !(b->flags[i] & BULLET_FINE)) {
        b->speed_q32[i] = bullets_speed(b, i);
        b->flags[i] |= BULLET_FINE;
        b->travel_q32[i] = 0;
    } else if (!fine && b->flags[i] & BULLET_FINE) {
        b->flags[i] &= (uint8_t)~BULLET_FINE;
        b->speed_q32[i] = b->travel_q32[i] = 0;
        b->x_low[i] = b->y_low[i] = 0;
        bullets_update_velocity(b, i);
    } else if (!fine)
        b->speed_q32[i] = b->travel_q32[i] = 0;
    b->motion[i] = motion;
    b->pc[i] = 0;
    b->step_start[i] = 0;
    b->step_flags[i] = 0;
    if (!(b->flags[i] & BULLET_DELAYED)) { /* a delayed bullet starts its program after the delay */
        b->step_end[i] = 0;
        bullets_set_busy(b, i, (motion || fine) && !bullets_is_frozen(b, i));
    }
    memset(&b->rounds_left[i * MOTION_MAX_DEPTH], 0, MOTION_MAX_DEPTH * sizeof *b->rounds_left);
}

void bullets_freeze(struct bullets *b, uint32_t i, int32_t frames)
{
    b->frozen_left[i] = frames;
    if (!frames || b->freeze_flags[i])
        return;
    b->freeze_flags[i] = FREEZE_ACTIVE;
    b->n_frozen++;
    b->saved_vx[i] = b->vx[i];
    b->saved_vy[i] = b->vy[i];
    b->vx[i] = b->vy[i] = 0;
    bullets_set_busy(b, i, false);
}

/* Unfreezes bullet i. Its program runs in this move; if the program only waits, bullet i then becomes idle. */
static void unfreeze(struct bullets *b, uint32_t i)
{
    b->freeze_flags[i] = 0;
    b->n_frozen--;
    bullets_store_velocity(b, i, b->saved_vx[i], b->saved_vy[i]);
    b->saved_vx[i] = b->saved_vy[i] = 0;
    if (b->flags[i] & BULLET_DELAYED)
        make_idle(b, i, b->step_end[i]);
    else
        bullets_set_busy(b, i, b->motion[i] || b->flags[i] & BULLET_FINE);
}

/* Counts down the frames left of a block's frozen bullets at the start of a move. Sets thawed[k] to 1 if bullet k is
 * frozen with none left, otherwise to 0. Returns 1 if any thawed[k] is 1, otherwise 0. */
static int32_t step_freeze_block(uint8_t *restrict freeze_flags, int32_t *restrict frozen_left,
                                 uint8_t *restrict thawed)
{
    int32_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++) {
        const int32_t is_frozen = freeze_flags[k] != 0, has_frames = frozen_left[k] != 0,
                      is_done = is_frozen & (has_frames ^ 1);
        frozen_left[k] -= is_frozen & has_frames & (frozen_left[k] != FROZEN_FOREVER);
        freeze_flags[k] |= (uint8_t)((is_frozen & has_frames) * FREEZE_LAST_MOVE);
        thawed[k] = (uint8_t)is_done;
        any |= is_done;
    }
    return any;
}

static bool any_frozen(const uint8_t *restrict freeze_flags)
{
    uint8_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        any |= freeze_flags[k];
    return any;
}

void bullets_step_freeze(struct bullets *b)
{
    uint8_t thawed[SLOTS_BLOCK];

    for (uint32_t first = 0; first < b->s.top; first += SLOTS_BLOCK)
        if (any_frozen(b->freeze_flags + first) &&
            step_freeze_block(b->freeze_flags + first, b->frozen_left + first, thawed))
            for (uint64_t m = slots_pack_flags(thawed); m; m &= m - 1)
                unfreeze(b, first + bits_lowest(m));
}

/* For the bullets of a block that were frozen in this frame, postpones `born`, and the end of a delay or of a step in
 * progress, by a frame. */
static void postpone_frozen_block(const uint8_t *restrict freeze_flags, const uint8_t *restrict step_flags,
                                  const uint8_t *restrict flags, uint32_t *restrict born, uint32_t *restrict step_end)
{
    for (int k = 0; k < SLOTS_BLOCK; k++) {
        const uint32_t was_frozen = (freeze_flags[k] & FREEZE_LAST_MOVE) != 0,
                       has_begun = (step_flags[k] & STEP_BEGUN) != 0;
        born[k] += was_frozen;
        step_end[k] += was_frozen & (has_begun | ((flags[k] & BULLET_DELAYED) != 0));
    }
}

/* Like postpone_frozen_block, for the start clock of a `bounce`, which bullets that are not fine store in
 * `speed_q32`. */
static void postpone_frozen_bounces(struct bullets *b, uint32_t first)
{
    for (uint32_t i = first; i < first + SLOTS_BLOCK; i++)
        if (b->freeze_flags[i] & FREEZE_LAST_MOVE && b->speed_q32[i] && !(b->flags[i] & BULLET_FINE))
            b->speed_q32[i]++;
}

static bool any_speed_q32(const int64_t *restrict speed_q32)
{
    int64_t any = 0;

    for (int k = 0; k < SLOTS_BLOCK; k++)
        any |= speed_q32[k];
    return any;
}

void bullets_postpone_frozen(struct bullets *b)
{
    for (uint32_t i = 0; b->n_frozen && i < b->s.top; i += SLOTS_BLOCK) {
        if (!any_frozen(b->freeze_flags + i))
            continue;
        postpone_frozen_block(b->freeze_flags + i, b->step_flags + i, b->flags + i, b->born + i, b->step_end + i);
        if (any_speed_q32(b->speed_q32 + i))
            postpone_frozen_bounces(b, i);
    }
}

int32_t targets_find_nearest(const struct targets *t, fx x, fx y)
{
    uint32_t end = t->s->live_bits ? t->s->top : t->s->live;
    uint64_t best = UINT64_MAX;
    int32_t found = NO_SLOT;

    for (uint32_t i = 0; i < end; i++) {
        if (t->s->live_bits && !(t->s->live_bits[i / SLOTS_BLOCK] & bullets_bit(i))) {
            if (!t->s->live_bits[i / SLOTS_BLOCK])
                i |= SLOTS_BLOCK - 1;
            continue;
        }
        if (t->included && !t->included[i])
            continue;
        uint64_t d = bullets_target_distance_squared(t, i, x, y);
        if (d < best) {
            best = d;
            found = (int32_t)i;
        }
    }
    return found;
}

ang targets_aim(const struct targets *t, fx x, fx y, ang fallback)
{
    int32_t i = targets_find_nearest(t, x, y);

    if (i == NO_SLOT || (t->x[i] == x && t->y[i] == y))
        return fallback;
    return trig_atan2(fx_sub(t->y[i], y), fx_sub(t->x[i], x));
}
