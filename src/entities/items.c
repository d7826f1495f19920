/*
 * items.c - items (items.h).
 *
 * Uses no random numbers. While an item flies to a player, vx and vy hold the velocity of its last move, so scripts can
 * read it.
 */
#include "items.h"
#include "../base/geom.h"

static const struct column kind_columns[] = {
    COLUMN(item_kinds, sprite),
    COLUMN(item_kinds, bank),
    COLUMN(item_kinds, flags),
    COLUMN(item_kinds, radius),
    COLUMN(item_kinds, gravity),
    COLUMN(item_kinds, max_fall_speed),
    COLUMN(item_kinds, low_points),
    COLUMN(item_kinds, high_points),
    COLUMN(item_kinds, lives),
    COLUMN(item_kinds, full_register),
    COLUMNS(item_kinds, register_amounts, ITEM_MAX_REGISTERS),
};

static const struct column columns[] = {
    COLUMN(items, x),
    COLUMN(items, y),
    COLUMN(items, vx),
    COLUMN(items, vy),
    DERIVED_COLUMN(items, prev_x, "written by every move before hit tests read it"),
    DERIVED_COLUMN(items, prev_y, "written by every move before hit tests read it"),
    COLUMN(items, kind),
    COLUMN(items, tag),
    COLUMN(items, born),
    COLUMN(items, pulled_by),
    GROUP_COLUMN(items, frozen_left, GROUP_FROZEN),
    GROUP_COLUMN(items, freeze_flags, GROUP_FROZEN),
    DERIVED_BLOCKS(items, collected, 1, "empty between frames"),
    DERIVED_REGISTER(items, n_frozen, "the number of frozen items, counted from the column `freeze_flags`"),
};

const struct chip items_chip = { .name = "items", CHIP_COLUMNS(columns) };
const struct chip item_kinds_chip = { .name = "item_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };

int32_t items_spawn(struct items *s, uint16_t kind, fx x, fx y, uint32_t clock)
{
    int32_t i = slots_take(&s->s);

    if (i == NO_SLOT)
        return i;
    s->x[i] = s->prev_x[i] = x;
    s->y[i] = s->prev_y[i] = y;
    s->vx[i] = s->vy[i] = 0;
    s->kind[i] = kind;
    s->tag[i] = 0;
    s->born[i] = clock;
    s->pulled_by[i] = 0;
    if (s->frozen_left)
        s->frozen_left[i] = s->freeze_flags[i] = 0;
    return i;
}

ang items_spread_direction(ang dir, uint64_t spread, uint32_t k, uint32_t n)
{
    return dir - (ang)(spread / 2) + (ang)(spread * (2 * (uint64_t)k + 1) / (2 * (uint64_t)n));
}

void items_pull(struct items *s, uint32_t i, uint32_t p)
{
    s->pulled_by[i] = (uint8_t)(p + 1);
}

static void resume_fall(struct items *s, uint32_t i)
{
    s->pulled_by[i] = 0;
    s->vx[i] = s->vy[i] = 0;
}

void items_release(struct items *s, uint32_t p)
{
    EACH_LIVE (i, &s->s)
        if (s->pulled_by[i] == p + 1)
            resume_fall(s, i);
}

void items_postpone_frozen(struct items *s)
{
    if (!s->n_frozen)
        return;
    EACH_LIVE (i, &s->s)
        s->born[i] += s->freeze_flags[i] != 0;
}

static uint64_t distance_squared(const struct items *s, uint32_t i, const struct item_pull *p)
{
    uint64_t dx = geom_gap(s->x[i], p->x), dy = geom_gap(s->y[i], p->y);

    return dx * dx + dy * dy;
}

/* Returns the index + 1 of the nearest player that attracts the item, or 0 when none does. Of equally near players,
 * returns the first. */
static uint8_t find_attractor(const struct items *s, uint32_t i, const struct item_pull pull[MAX_PLAYERS])
{
    uint64_t nearest = UINT64_MAX;
    uint8_t found = 0;

    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        const struct item_pull *q = &pull[p];
        if (!q->active || !(q->pulls_all || geom_circles(s->x[i], s->y[i], q->x, q->y, q->radius)))
            continue;
        uint64_t d = distance_squared(s, i, q);
        if (d < nearest) {
            nearest = d;
            found = (uint8_t)(p + 1);
        }
    }
    return found;
}

/* Sets the velocity towards the player. Invariant: if the distance is greater than the speed, the offset is divided by
 * at least the distance, so the step is at most `speed` long and overshoots the player on neither axis. */
static void fly_to_player(struct items *s, uint32_t i, const struct item_pull *p)
{
    int64_t dx = (int64_t)p->x - s->x[i], dy = (int64_t)p->y - s->y[i];
    uint64_t squared = distance_squared(s, i, p);

    if (squared > (uint64_t)p->speed * (uint64_t)p->speed) {
        uint64_t length = fx_root(squared);
        length += length * length < squared;
        dx = dx * p->speed / (int64_t)length;
        dy = dy * p->speed / (int64_t)length;
    }
    s->vx[i] = (fx)dx;
    s->vy[i] = (fx)dy;
}

/* Returns v moved towards `to` by at most `max_step`. */
static fx approach(fx v, fx to, fx max_step)
{
    return fx_clamp(to, fx_sub(v, max_step), fx_add(v, max_step));
}

static void fall(struct items *s, uint32_t i, const struct item_kinds *kinds)
{
    const fx gravity = kinds->gravity[s->kind[i]];

    s->vy[i] = approach(s->vy[i], kinds->max_fall_speed[s->kind[i]], gravity);
    if (s->vy[i] >= 0)
        s->vx[i] = approach(s->vx[i], 0, gravity);
}

static void step_item(struct items *s, uint32_t i, const struct item_kinds *kinds,
                      const struct item_pull pull[MAX_PLAYERS])
{
    s->prev_x[i] = s->x[i];
    s->prev_y[i] = s->y[i];
    if (s->pulled_by[i] && !pull[s->pulled_by[i] - 1].active)
        resume_fall(s, i);
    if (motion_step_freeze(s->frozen_left, s->freeze_flags, i, &s->n_frozen))
        return;
    if (!s->pulled_by[i] && kinds->flags[s->kind[i]] & ITEM_MAGNET)
        s->pulled_by[i] = find_attractor(s, i, pull);
    if (s->pulled_by[i])
        fly_to_player(s, i, &pull[s->pulled_by[i] - 1]);
    else
        fall(s, i, kinds);
    s->x[i] = fx_add(s->x[i], s->vx[i]);
    s->y[i] = fx_add(s->y[i], s->vy[i]);
}

void items_move(struct items *s, const struct item_kinds *kinds, const struct item_pull pull[MAX_PLAYERS])
{
    s->n_frozen = 0;
    EACH_LIVE (i, &s->s)
        step_item(s, i, kinds, pull);
    slots_trim(&s->s);
}

int64_t items_points(const struct item_kinds *kinds, uint16_t kind, fx y, fx line, fx bottom)
{
    const int64_t low = kinds->low_points[kind], high = kinds->high_points[kind];

    if (y <= line)
        return high;
    if (y >= bottom)
        return low;
    return low + (high - low) * ((int64_t)bottom - y) / ((int64_t)bottom - line);
}
