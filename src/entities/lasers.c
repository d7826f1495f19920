/*
 * lasers.c - lasers (lasers.h).
 *
 * A laser's state (warn, grow, on, fade) is computed from its age. So freezing a laser only freezes its age, and the
 * state in an earlier frame is known.
 */
#include "lasers.h"
#include <string.h>
#include "../base/int.h"

static const struct column kind_columns[] = {
    COLUMN(laser_kinds, strip), COLUMN(laser_kinds, head),   COLUMN(laser_kinds, tail),   COLUMN(laser_kinds, width),
    COLUMN(laser_kinds, share), COLUMN(laser_kinds, bank),   COLUMN(laser_kinds, flags),  COLUMN(laser_kinds, graze),
    COLUMN(laser_kinds, every), COLUMN(laser_kinds, damage), COLUMN(laser_kinds, vanish),
};

static const struct column columns[] = {
    COLUMN(lasers, form),
    COLUMN(lasers, flags),
    COLUMN(lasers, x0),
    COLUMN(lasers, y0),
    COLUMN(lasers, was_x),
    COLUMN(lasers, was_y),
    COLUMN(lasers, was_x0),
    COLUMN(lasers, was_y0),
    COLUMN(lasers, length),
    COLUMN(lasers, grown),
    COLUMN(lasers, width),
    COLUMN(lasers, spin),
    COLUMN(lasers, warn),
    COLUMN(lasers, grow),
    COLUMN(lasers, fade),
    COLUMN(lasers, until),
    COLUMN(lasers, follow),
    COLUMN(lasers, dx),
    COLUMN(lasers, dy),
    COLUMN(lasers, followed),
    COLUMNS(lasers, again, PADS),
    COLUMN(lasers, points),
    COLUMN(lasers, count),
    COLUMN(lasers, newest),
    COLUMNS(lasers, piece, LASER_PIECES),
};

static const struct column point_columns[] = { COLUMNS(laser_points, x, LASER_PIECE),
                                               COLUMNS(laser_points, y, LASER_PIECE) };

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip lasers_chip = { "lasers", columns, COUNT(columns), false, false };
const struct chip laser_kinds_chip = { "laser_kinds", kind_columns, COUNT(kind_columns), true, false };
const struct chip laser_points_chip = { "laser_points", point_columns, COUNT(point_columns), false, false };

static uint32_t pieces_of(uint32_t points)
{
    return (points + LASER_PIECE - 1) / LASER_PIECE;
}

static void set_point(struct lasers *l, struct laser_points *p, uint32_t i, uint32_t at, fx x, fx y)
{
    uint32_t entry = l->piece[i * LASER_PIECES + at / LASER_PIECE] * (uint32_t)LASER_PIECE + at % LASER_PIECE;

    p->x[entry] = x;
    p->y[entry] = y;
}

/* Allocates n pieces for laser i. Returns false, and allocates none, when fewer than n are free. */
static bool take_pieces(struct lasers *l, struct laser_points *p, uint32_t i, uint32_t n)
{
    uint16_t *piece = &l->piece[i * LASER_PIECES];

    memset(piece, 0, LASER_PIECES * sizeof *piece);
    for (uint32_t k = 0; k < n; k++) {
        int32_t slot = slots_take(&p->s);
        if (slot == NO_SLOT) {
            while (k-- > 0)
                slots_drop(&p->s, piece[k]);
            return false;
        }
        piece[k] = (uint16_t)slot;
        memset(&p->x[slot * LASER_PIECE], 0, LASER_PIECE * sizeof *p->x);
        memset(&p->y[slot * LASER_PIECE], 0, LASER_PIECE * sizeof *p->y);
    }
    return true;
}

int32_t lasers_add(struct lasers *l, struct laser_points *p, const struct laser_shape *shape, fx x, fx y,
                   struct slots **full)
{
    int32_t slot = slots_take(&l->s);
    uint32_t i = (uint32_t)slot;

    *full = &l->s;
    if (slot == NO_SLOT)
        return slot;
    if (!take_pieces(l, p, i, pieces_of(shape->points))) {
        slots_drop(&l->s, i);
        *full = &p->s;
        return NO_SLOT;
    }
    l->form[i] = (uint8_t)shape->form;
    l->flags[i] = shape->flags;
    l->x0[i] = l->was_x[i] = l->was_x0[i] = x;
    l->y0[i] = l->was_y[i] = l->was_y0[i] = y;
    l->length[i] = shape->length;
    l->grown[i] = 0;
    l->width[i] = shape->width;
    l->spin[i] = shape->spin;
    l->warn[i] = shape->warn;
    l->grow[i] = shape->grow;
    l->fade[i] = shape->fade;
    l->until[i] = shape->hold == LASER_FOREVER ? LASER_FOREVER : shape->warn + shape->grow + shape->hold;
    l->follow[i] = shape->follow;
    l->dx[i] = shape->dx;
    l->dy[i] = shape->dy;
    l->followed[i] = 0;
    memset(&l->again[i * PADS], 0, PADS * sizeof *l->again);
    l->points[i] = shape->points;
    l->count[i] = shape->points > 0;
    l->newest[i] = 0;
    if (shape->points)
        set_point(l, p, i, 0, x, y);
    return slot;
}

void lasers_drop(struct lasers *l, struct laser_points *p, uint32_t i)
{
    for (uint32_t k = 0; k < pieces_of(l->points[i]); k++)
        slots_drop(&p->s, l->piece[i * LASER_PIECES + k]);
    slots_drop(&l->s, i);
    slots_trim(&p->s);
    slots_trim(&l->s);
}

/* While a ring is not full, its points are in the first `count` entries. */
void lasers_box(const struct lasers *l, const struct laser_points *p, uint32_t i, struct box *box)
{
    fx x0 = l->x0[i], x1 = x0, y0 = l->y0[i], y1 = y0;

    for (uint32_t at = 0; at < l->count[i]; at += LASER_PIECE) {
        const uint32_t first = l->piece[i * LASER_PIECES + at / LASER_PIECE] * (uint32_t)LASER_PIECE;
        const uint32_t n = l->count[i] - at < LASER_PIECE ? l->count[i] - at : LASER_PIECE;
        for (uint32_t k = first; k < first + n; k++) {
            x0 = fx_min(x0, p->x[k]);
            x1 = fx_max(x1, p->x[k]);
            y0 = fx_min(y0, p->y[k]);
            y1 = fx_max(y1, p->y[k]);
        }
    }
    *box = (struct box){ x0, y0, x1, y1 };
}

void lasers_advance(struct lasers *l, struct laser_points *p, uint32_t i, fx x, fx y)
{
    lasers_point(l, p, i, l->count[i] - 1u, &l->x0[i], &l->y0[i]);
    l->newest[i] = (uint16_t)(l->newest[i] + 1u == l->points[i] ? 0 : l->newest[i] + 1u);
    l->count[i] = (uint16_t)(l->count[i] < l->points[i] ? l->count[i] + 1u : l->points[i]);
    set_point(l, p, i, l->newest[i], x, y);
}

static fx within(int64_t v)
{
    return (fx)int64_clamp(v, -(int64_t)WORLD * 65536, (int64_t)WORLD * 65536);
}

void lasers_shift(struct lasers *l, struct laser_points *p, uint32_t i, fx dx, fx dy)
{
    for (uint32_t k = 0; k < l->points[i]; k++) {
        uint32_t entry = l->piece[i * LASER_PIECES + k / LASER_PIECE] * (uint32_t)LASER_PIECE + k % LASER_PIECE;
        p->x[entry] = within((int64_t)p->x[entry] + dx);
        p->y[entry] = within((int64_t)p->y[entry] + dy);
    }
    l->x0[i] = within((int64_t)l->x0[i] + dx);
    l->y0[i] = within((int64_t)l->y0[i] + dy);
}

static bool fades(const struct lasers *l, uint32_t i, int64_t age)
{
    return l->until[i] != LASER_FOREVER && age >= l->until[i];
}

enum laser_state lasers_state(const struct lasers *l, uint32_t i, uint32_t age)
{
    if (fades(l, i, age))
        return LASER_FADE;
    if (age < (uint32_t)l->warn[i])
        return LASER_WARN;
    return age - (uint32_t)l->warn[i] < (uint32_t)l->grow[i] ? LASER_GROW : LASER_ON;
}

/* Returns k / n of a width, 0 <= k <= n. */
static fx share(fx width, int64_t k, int64_t n)
{
    return (fx)(width * k / n);
}

fx lasers_width(const struct lasers *l, uint32_t i, uint32_t age)
{
    switch (lasers_state(l, i, age)) {
    case LASER_GROW:
        return share(l->width[i], (int64_t)age - l->warn[i] + 1, (int64_t)l->grow[i] + 1);
    case LASER_FADE:
        return lasers_over(l, i, age)
                   ? 0
                   : share(l->width[i], (int64_t)l->until[i] + l->fade[i] - age, (int64_t)l->fade[i] + 1);
    default:
        return l->width[i];
    }
}

bool lasers_over(const struct lasers *l, uint32_t i, uint32_t age)
{
    return fades(l, i, age) && (int64_t)age - l->until[i] >= l->fade[i];
}

/* A laser that is still warning disappears at once; one that is growing fades from its current width. */
void lasers_fade(struct lasers *l, uint32_t i, uint32_t age)
{
    if (fades(l, i, age))
        return;
    if (lasers_state(l, i, age) == LASER_WARN)
        l->fade[i] = 0;
    l->width[i] = lasers_width(l, i, age);
    l->until[i] = (int32_t)age;
}
