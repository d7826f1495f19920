/*
 * options.c - options (options.h). Integer arithmetic only: each frame an option's offset moves by the remaining
 * distance divided by the frames left, so it reaches its target exactly on time. Angles wrap at 32 bits.
 */
#include "options.h"
#include "../base/trig.h"

static const struct column columns[] = {
    COLUMN(options, x),
    COLUMN(options, y),
    DERIVED_COLUMN(options, prev_x, "written by every move before it is read"),
    DERIVED_COLUMN(options, prev_y, "written by every move before it is read"),
    COLUMN(options, kind),
    COLUMN(options, player),
    COLUMN(options, index),
    COLUMN(options, bank),
    COLUMN(options, flags),
    COLUMN(options, born),
    COLUMNS(options, offset, 2),
    COLUMNS(options, target_offset, 2),
    COLUMN(options, frames_left),
    GROUP_COLUMN(options, dir, GROUP_TRANSFORMS),
};
static const struct column kind_columns[] = {
    COLUMN(option_kinds, sprite),
    COLUMN(option_kinds, bank),
    COLUMN(option_kinds, layer),
};
static const struct column path_columns[] = {
    COLUMN(option_paths, head),
    COLUMNS(option_paths, x, OPTION_PATH_LENGTH),
    COLUMNS(option_paths, y, OPTION_PATH_LENGTH),
    COLUMN(option_paths, phase),
};

const struct chip options_chip = { .name = "options", CHIP_COLUMNS(columns) };
const struct chip option_kinds_chip = { .name = "option_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };
const struct chip option_paths_chip = { .name = "option_ways", CHIP_COLUMNS(path_columns), .is_list = true };

const struct option_level *options_level(const struct option_plan *plan, int64_t value)
{
    const struct option_level *found = NULL;

    for (uint32_t i = 0; i < plan->n_levels && plan->level[i].min_value <= value; i++)
        found = &plan->level[i];
    return found;
}

int32_t options_add(struct options *o, const struct option_kinds *kinds, uint16_t kind, uint32_t p, uint32_t index,
                    fx x, fx y, uint32_t clock)
{
    const int32_t i = slots_take(&o->s);

    if (i == NO_SLOT)
        return i;
    o->x[i] = o->prev_x[i] = x;
    o->y[i] = o->prev_y[i] = y;
    o->kind[i] = kind;
    o->player[i] = (uint8_t)p;
    o->index[i] = (uint8_t)index;
    o->bank[i] = kinds->bank[kind];
    o->flags[i] = 0;
    o->born[i] = clock;
    o->offset[2 * i] = o->offset[2 * i + 1] = o->target_offset[2 * i] = o->target_offset[2 * i + 1] = 0;
    o->frames_left[i] = 0;
    if (o->dir)
        o->dir[i] = 0;
    return i;
}

void options_drop_from(struct options *o, uint32_t p, uint32_t index)
{
    EACH_LIVE (i, &o->s)
        if (o->player[i] == p && o->index[i] >= index)
            slots_drop(&o->s, i);
    slots_trim(&o->s);
}

/* Appends the ship's position to its path. A ship at rest appends nothing. After a jump, every entry is the position
 * the ship jumped to. */
static void record_path(struct option_paths *paths, uint32_t p, const struct option_ship *ship)
{
    fx *x = paths->x + p * OPTION_PATH_LENGTH, *y = paths->y + p * OPTION_PATH_LENGTH;
    uint32_t head = paths->head[p];

    if (x[head] != ship->prev_x || y[head] != ship->prev_y)
        for (uint32_t k = 0; k < OPTION_PATH_LENGTH; k++) {
            x[k] = ship->prev_x;
            y[k] = ship->prev_y;
        }
    if (ship->x == ship->prev_x && ship->y == ship->prev_y)
        return;
    head = (head + 1) % OPTION_PATH_LENGTH;
    x[head] = ship->x;
    y[head] = ship->y;
    paths->head[p] = head;
}

static int32_t wrapping_subtract(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

/* Moves an option's offset towards its target. */
static void approach(struct options *o, uint32_t i, const struct option_ship *ship, int32_t a, int32_t b)
{
    int32_t *offset = o->offset + 2 * i, *target = o->target_offset + 2 * i;

    if (target[0] != a || target[1] != b) {
        target[0] = a;
        target[1] = b;
        o->frames_left[i] = ship->plan->move_duration;
    }
    const int32_t frames_left = o->frames_left[i] ? (int32_t)o->frames_left[i]-- : 1;
    for (int k = 0; k < 2; k++)
        offset[k] = (int32_t)((uint32_t)offset[k] + (uint32_t)(wrapping_subtract(target[k], offset[k]) / frames_left));
}

static void move_fixed(struct options *o, uint32_t i, const struct option_ship *ship)
{
    const fx *target = (ship->is_focused ? ship->level->focused_offset : ship->level->unfocused_offset)[o->index[i]];

    approach(o, i, ship, target[0], target[1]);
    o->x[i] = fx_add(ship->x, o->offset[2 * i]);
    o->y[i] = fx_add(ship->y, o->offset[2 * i + 1]);
}

static void move_orbit(struct options *o, uint32_t i, const struct option_ship *ship, ang phase)
{
    const ang share = (ang)(((uint64_t)o->index[i] << 32) / ship->level->n);
    fx dx, dy;

    approach(o, i, ship, ship->is_focused ? ship->plan->focused_offset : ship->plan->unfocused_offset, (int32_t)share);
    trig_polar(o->offset[2 * i], phase + (ang)o->offset[2 * i + 1], &dx, &dy);
    o->x[i] = fx_add(ship->x, dx);
    o->y[i] = fx_add(ship->y, dy);
}

static void move_trail(struct options *o, uint32_t i, const struct option_ship *ship, const struct option_paths *paths)
{
    const uint32_t p = o->player[i], lag = (o->index[i] + 1u) * ship->plan->spacing;
    const uint32_t at = p * OPTION_PATH_LENGTH + (paths->head[p] - lag) % OPTION_PATH_LENGTH;

    o->x[i] = paths->x[at];
    o->y[i] = paths->y[at];
}

void options_move(struct options *o, struct option_paths *paths, uint32_t p, const struct option_ship *ship)
{
    record_path(paths, p, ship);
    paths->phase[p] += ship->plan->spin;
    EACH_LIVE (i, &o->s) {
        if (o->player[i] != p)
            continue;
        o->prev_x[i] = o->x[i];
        o->prev_y[i] = o->y[i];
        if (ship->plan->style == OPTION_FIXED)
            move_fixed(o, i, ship);
        else if (ship->plan->style == OPTION_ORBIT)
            move_orbit(o, i, ship, paths->phase[p]);
        else
            move_trail(o, i, ship, paths);
    }
}

void options_turn(struct options *o, const struct option_kinds *kinds)
{
    EACH_LIVE (i, &o->s) {
        const fx dx = fx_sub(o->x[i], o->prev_x[i]), dy = fx_sub(o->y[i], o->prev_y[i]);
        if (kinds->layer[o->kind[i]] & OPTION_TURNS && (dx || dy))
            o->dir[i] = trig_atan2(dy, dx);
    }
}
