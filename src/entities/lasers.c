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
    COLUMN(laser_kinds, strip),  COLUMN(laser_kinds, head_sprite),    COLUMN(laser_kinds, tail_sprite),
    COLUMN(laser_kinds, width),  COLUMN(laser_kinds, hit_share),      COLUMN(laser_kinds, bank),
    COLUMN(laser_kinds, flags),  COLUMN(laser_kinds, graze_interval), COLUMN(laser_kinds, hit_interval),
    COLUMN(laser_kinds, damage), COLUMN(laser_kinds, vanish_spark),
};

static const struct column columns[] = {
    COLUMN(lasers, form),
    COLUMN(lasers, flags),
    COLUMN(lasers, x0),
    COLUMN(lasers, y0),
    COLUMN(lasers, prev_x),
    COLUMN(lasers, prev_y),
    COLUMN(lasers, prev_x0),
    COLUMN(lasers, prev_y0),
    COLUMN(lasers, length),
    COLUMN(lasers, grown_length),
    COLUMN(lasers, width),
    COLUMN(lasers, spin),
    COLUMN(lasers, warn_frames),
    COLUMN(lasers, grow_frames),
    COLUMN(lasers, fade_frames),
    COLUMN(lasers, fade_age),
    COLUMN(lasers, follow_target),
    COLUMN(lasers, dx),
    COLUMN(lasers, dy),
    COLUMN(lasers, target_dir),
    COLUMNS(lasers, rehit_clock, MAX_PLAYERS),
    COLUMN(lasers, max_points),
    COLUMN(lasers, n_points),
    COLUMN(lasers, newest_point),
    COLUMNS(lasers, chunk, LASER_MAX_CHUNKS),
};

static const struct column point_columns[] = { COLUMNS(laser_points, x, LASER_CHUNK_POINTS),
                                               COLUMNS(laser_points, y, LASER_CHUNK_POINTS) };

const struct chip lasers_chip = { .name = "lasers", CHIP_COLUMNS(columns) };
const struct chip laser_kinds_chip = { .name = "laser_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };
const struct chip laser_points_chip = { .name = "laser_points", CHIP_COLUMNS(point_columns) };

static uint32_t chunk_count(uint32_t points)
{
    return (points + LASER_CHUNK_POINTS - 1) / LASER_CHUNK_POINTS;
}

static void set_point(struct lasers *l, struct laser_points *p, uint32_t i, uint32_t at, fx x, fx y)
{
    uint32_t entry = l->chunk[i * LASER_MAX_CHUNKS + at / LASER_CHUNK_POINTS] * (uint32_t)LASER_CHUNK_POINTS +
                     at % LASER_CHUNK_POINTS;

    p->x[entry] = x;
    p->y[entry] = y;
}

/* Allocates n chunks for laser i. Returns false, and allocates none, when fewer than n are free. */
static bool alloc_chunks(struct lasers *l, struct laser_points *p, uint32_t i, uint32_t n)
{
    uint16_t *chunk = &l->chunk[i * LASER_MAX_CHUNKS];

    memset(chunk, 0, LASER_MAX_CHUNKS * sizeof *chunk);
    for (uint32_t k = 0; k < n; k++) {
        int32_t slot = slots_take(&p->s);
        if (slot == NO_SLOT) {
            while (k-- > 0)
                slots_drop(&p->s, chunk[k]);
            return false;
        }
        chunk[k] = (uint16_t)slot;
        memset(&p->x[slot * LASER_CHUNK_POINTS], 0, LASER_CHUNK_POINTS * sizeof *p->x);
        memset(&p->y[slot * LASER_CHUNK_POINTS], 0, LASER_CHUNK_POINTS * sizeof *p->y);
    }
    return true;
}

int32_t lasers_add(struct lasers *l, struct laser_points *p, const struct laser_spec *spec, fx x, fx y,
                   struct slots **full_pool)
{
    int32_t slot = slots_take(&l->s);
    uint32_t i = (uint32_t)slot;

    *full_pool = &l->s;
    if (slot == NO_SLOT)
        return slot;
    if (!alloc_chunks(l, p, i, chunk_count(spec->max_points))) {
        slots_drop(&l->s, i);
        *full_pool = &p->s;
        return NO_SLOT;
    }
    l->form[i] = (uint8_t)spec->form;
    l->flags[i] = spec->flags;
    l->x0[i] = l->prev_x[i] = l->prev_x0[i] = x;
    l->y0[i] = l->prev_y[i] = l->prev_y0[i] = y;
    l->length[i] = spec->length;
    l->grown_length[i] = 0;
    l->width[i] = spec->width;
    l->spin[i] = spec->spin;
    l->warn_frames[i] = spec->warn_frames;
    l->grow_frames[i] = spec->grow_frames;
    l->fade_frames[i] = spec->fade_frames;
    l->fade_age[i] =
        spec->hold_frames == LASER_FOREVER ? LASER_FOREVER : spec->warn_frames + spec->grow_frames + spec->hold_frames;
    l->follow_target[i] = spec->follow_target;
    l->dx[i] = spec->dx;
    l->dy[i] = spec->dy;
    l->target_dir[i] = 0;
    memset(&l->rehit_clock[i * MAX_PLAYERS], 0, MAX_PLAYERS * sizeof *l->rehit_clock);
    l->max_points[i] = spec->max_points;
    l->n_points[i] = spec->max_points > 0;
    l->newest_point[i] = 0;
    if (spec->max_points)
        set_point(l, p, i, 0, x, y);
    return slot;
}

void lasers_drop(struct lasers *l, struct laser_points *p, uint32_t i)
{
    for (uint32_t k = 0; k < chunk_count(l->max_points[i]); k++)
        slots_drop(&p->s, l->chunk[i * LASER_MAX_CHUNKS + k]);
    slots_drop(&l->s, i);
    slots_trim(&p->s);
    slots_trim(&l->s);
}

/* While a ring is not full, its points are in the first `n_points` entries. */
void lasers_get_box(const struct lasers *l, const struct laser_points *p, uint32_t i, struct box *box)
{
    fx x0 = l->x0[i], x1 = x0, y0 = l->y0[i], y1 = y0;

    for (uint32_t at = 0; at < l->n_points[i]; at += LASER_CHUNK_POINTS) {
        const uint32_t first = l->chunk[i * LASER_MAX_CHUNKS + at / LASER_CHUNK_POINTS] * (uint32_t)LASER_CHUNK_POINTS;
        const uint32_t n = l->n_points[i] - at < LASER_CHUNK_POINTS ? l->n_points[i] - at : LASER_CHUNK_POINTS;
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
    lasers_get_point(l, p, i, l->n_points[i] - 1u, &l->x0[i], &l->y0[i]);
    l->newest_point[i] = (uint16_t)(l->newest_point[i] + 1u == l->max_points[i] ? 0 : l->newest_point[i] + 1u);
    l->n_points[i] = (uint16_t)(l->n_points[i] < l->max_points[i] ? l->n_points[i] + 1u : l->max_points[i]);
    set_point(l, p, i, l->newest_point[i], x, y);
}

void lasers_shift(struct lasers *l, struct laser_points *p, uint32_t i, fx dx, fx dy)
{
    for (uint32_t k = 0; k < l->max_points[i]; k++) {
        uint32_t entry = l->chunk[i * LASER_MAX_CHUNKS + k / LASER_CHUNK_POINTS] * (uint32_t)LASER_CHUNK_POINTS +
                         k % LASER_CHUNK_POINTS;
        p->x[entry] = motion_clamp_to_world((int64_t)p->x[entry] + dx);
        p->y[entry] = motion_clamp_to_world((int64_t)p->y[entry] + dy);
    }
    l->x0[i] = motion_clamp_to_world((int64_t)l->x0[i] + dx);
    l->y0[i] = motion_clamp_to_world((int64_t)l->y0[i] + dy);
}

static bool is_fading(const struct lasers *l, uint32_t i, int64_t age)
{
    return l->fade_age[i] != LASER_FOREVER && age >= l->fade_age[i];
}

enum laser_state lasers_state(const struct lasers *l, uint32_t i, uint32_t age)
{
    if (is_fading(l, i, age))
        return LASER_FADE;
    if (age < (uint32_t)l->warn_frames[i])
        return LASER_WARN;
    return age - (uint32_t)l->warn_frames[i] < (uint32_t)l->grow_frames[i] ? LASER_GROW : LASER_ON;
}

/* Returns k / n of a width, 0 <= k <= n. */
static fx scale_width(fx width, int64_t k, int64_t n)
{
    return (fx)(width * k / n);
}

fx lasers_width(const struct lasers *l, uint32_t i, uint32_t age)
{
    switch (lasers_state(l, i, age)) {
    case LASER_GROW:
        return scale_width(l->width[i], (int64_t)age - l->warn_frames[i] + 1, (int64_t)l->grow_frames[i] + 1);
    case LASER_FADE:
        return lasers_has_faded(l, i, age) ? 0
                                           : scale_width(l->width[i], (int64_t)l->fade_age[i] + l->fade_frames[i] - age,
                                                         (int64_t)l->fade_frames[i] + 1);
    default:
        return l->width[i];
    }
}

bool lasers_has_faded(const struct lasers *l, uint32_t i, uint32_t age)
{
    return is_fading(l, i, age) && (int64_t)age - l->fade_age[i] >= l->fade_frames[i];
}

/* A laser that is still warning disappears at once; one that is growing fades from its current width. */
void lasers_fade(struct lasers *l, uint32_t i, uint32_t age)
{
    if (is_fading(l, i, age))
        return;
    if (lasers_state(l, i, age) == LASER_WARN)
        l->fade_frames[i] = 0;
    l->width[i] = lasers_width(l, i, age);
    l->fade_age[i] = (int32_t)age;
}
