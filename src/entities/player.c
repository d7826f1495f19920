/*
 * player.c - the two players (player.h).
 */
#include "player.h"
#include "../base/int.h"

static const struct column kind_columns[] = {
    COLUMN(player_kinds, sprite),
    COLUMN(player_kinds, radius),
    COLUMN(player_kinds, graze_radius),
    COLUMN(player_kinds, speed),
    COLUMN(player_kinds, focus_speed),
    COLUMN(player_kinds, lives),
    COLUMN(player_kinds, safe_frames),
    DERIVED_COLUMN(player_kinds, first_register, "set only while scripts load, like names"),
    DERIVED_COLUMN(player_kinds, n_registers, "set while scripts load"),
    DERIVED_COLUMN(player_kinds, deathbomb_frames, "set while scripts load"),
    DERIVED_COLUMN(player_kinds, bomb, "set while scripts load"),
    DERIVED_COLUMN(player_kinds, bomb_focus, "set while scripts load"),
    GROUP_COLUMN(player_kinds, magnet_radius, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, collect_line, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, pull_speed, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, full_register, GROUP_ITEMS),
};

static const struct column columns[] = {
    COLUMN(player, in_game),
    COLUMN(player, gen),
    COLUMN(player, kind),
    COLUMN(player, x),
    COLUMN(player, y),
    DERIVED_COLUMN(player, prev_x, "written by every move before hit tests read it"),
    DERIVED_COLUMN(player, prev_y, "written by every move before hit tests read it"),
    COLUMN(player, lives),
    COLUMN(player, safe_left),
    COLUMN(player, grazes),
    COLUMN(player, score),
    COLUMN(player, flags),
    COLUMN(player, deathbomb_left),
    COLUMN(player, bomb_left),
    COLUMN(player, bomb_scope),
    COLUMN(player, push_x),
    COLUMN(player, push_y),
    COLUMN(player, speed_scale),
    COLUMN(player, focus_forced),
    COLUMN(player, scale_task),
    COLUMN(player, focus_task),
};

const struct chip player_chip = { .name = "player", CHIP_COLUMNS(columns), .is_list = true };
const struct chip player_kinds_chip = { .name = "player_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };

void player_set_position(struct player *p, uint32_t i, fx x, fx y)
{
    p->x[i] = p->prev_x[i] = x;
    p->y[i] = p->prev_y[i] = y;
}

void player_shift(struct player *p, uint32_t i, fx dx, fx dy, const struct box *area)
{
    player_set_position(p, i, (fx)int64_clamp((int64_t)p->x[i] + dx, area->x0, area->x1),
                        (fx)int64_clamp((int64_t)p->y[i] + dy, area->y0, area->y1));
}

void player_push(struct player *p, uint32_t i, fx vx, fx vy)
{
    p->push_x[i] = fx_add(p->push_x[i], vx);
    p->push_y[i] = fx_add(p->push_y[i], vy);
}

void player_scale_speed(struct player *p, uint32_t i, fx scale, uint32_t task)
{
    p->speed_scale[i] = scale;
    p->scale_task[i] = task;
}

void player_force_focus(struct player *p, uint32_t i, enum player_focus focus, uint32_t task)
{
    p->focus_forced[i] = (uint8_t)focus;
    p->focus_task[i] = task;
    if (focus != FOCUS_BY_BUTTON)
        p->flags[i] = (uint8_t)((p->flags[i] & ~PLAYER_FOCUS) | (focus == FOCUS_ON ? PLAYER_FOCUS : 0));
}

void player_end_task(struct player *p, uint32_t task)
{
    for (uint32_t i = 0; i < MAX_PLAYERS; i++) {
        if (p->scale_task[i] == task)
            player_scale_speed(p, i, FX_ONE, 0);
        if (p->focus_task[i] == task)
            player_force_focus(p, i, FOCUS_BY_BUTTON, 0);
    }
}

void player_join(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t kind, fx x, fx y)
{
    p->in_game[i] = PLAYER_IN_GAME;
    p->kind[i] = kind;
    player_set_position(p, i, x, y);
    p->lives[i] = kinds->lives[kind] - 1;
    p->safe_left[i] = kinds->safe_frames[kind];
    p->grazes[i] = 0;
    p->score[i] = 0;
    p->flags[i] = 0;
    p->deathbomb_left[i] = 0;
    p->bomb_left[i] = 0;
    p->bomb_scope[i] = 0;
    p->push_x[i] = p->push_y[i] = 0;
    player_scale_speed(p, i, FX_ONE, 0);
    player_force_focus(p, i, FOCUS_BY_BUTTON, 0);
}

unsigned player_ignored_buttons(const struct player *p, uint32_t i)
{
    return (p->in_game[i] & PLAYER_NO_FIRE ? PAD_FIRE | PAD_BOMB | PAD_SPECIAL : 0u) |
           (p->in_game[i] & PLAYER_NO_MOVE ? PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT | PAD_FOCUS : 0u);
}

bool player_is_retired(const struct player *p, uint32_t i)
{
    return p->gen[i] == RETIRED_GENERATION;
}

void player_leave(struct player *p, uint32_t i)
{
    p->in_game[i] = 0;
    p->gen[i] += p->gen[i] < RETIRED_GENERATION;
    player_set_position(p, i, PARK_COORDINATE, PARK_COORDINATE);
}

/* Selects the picture for the horizontal direction, if the kind has pictures and no script has chosen one. */
static void select_picture(struct player *p, const struct player_kinds *kinds, uint32_t i, int dx)
{
    uint16_t kind = p->kind[i];
    int picture = dx < 0 ? PICTURE_LEFT : dx > 0 ? PICTURE_RIGHT : 0;

    if (p->flags[i] & PLAYER_PICTURE_LOCKED || kind == 0 || kinds->radius[kind - 1] != PICTURE_ROW_RADIUS)
        return;
    p->flags[i] = (uint8_t)((p->flags[i] & ~PLAYER_PICTURE) | picture * PLAYER_PICTURE_ONE);
}

uint16_t player_sprite(const struct player *p, const struct player_kinds *kinds, uint32_t i)
{
    return kinds->sprite[p->kind[i] - p->flags[i] / PLAYER_PICTURE_ONE];
}

static void move_one(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t held_buttons,
                     const struct box *area)
{
    uint16_t kind = p->kind[i];
    int dx = !!(held_buttons & PAD_RIGHT) - !!(held_buttons & PAD_LEFT),
        dy = !!(held_buttons & PAD_DOWN) - !!(held_buttons & PAD_UP);

    const bool is_focused = p->focus_forced[i] ? p->focus_forced[i] == FOCUS_ON : held_buttons & PAD_FOCUS;
    p->flags[i] = (uint8_t)((p->flags[i] & ~PLAYER_FOCUS) | (is_focused ? PLAYER_FOCUS : 0));
    select_picture(p, kinds, i, dx);
    fx speed = fx_mul(is_focused ? kinds->focus_speed[kind] : kinds->speed[kind], p->speed_scale[i]);
    if (dx && dy)
        speed = fx_mul(speed, PLAYER_DIAGONAL_FACTOR);
    p->prev_x[i] = fx_clamp(p->x[i], area->x0, area->x1); /* clamping moves the ship without a sweep */
    p->prev_y[i] = fx_clamp(p->y[i], area->y0, area->y1);
    p->x[i] = (fx)int64_clamp((int64_t)p->prev_x[i] + dx * (int64_t)speed + p->push_x[i], area->x0, area->x1);
    p->y[i] = (fx)int64_clamp((int64_t)p->prev_y[i] + dy * (int64_t)speed + p->push_y[i], area->y0, area->y1);
}

void player_step_invulnerability(struct player *p)
{
    for (uint32_t i = 0; i < MAX_PLAYERS; i++)
        if (p->safe_left[i])
            p->safe_left[i]--;
}

void player_move(struct player *p, const struct player_kinds *kinds, const uint16_t held_buttons[MAX_PLAYERS],
                 const struct box *area)
{
    for (uint32_t i = 0; i < MAX_PLAYERS; i++) {
        if (p->in_game[i] && p->deathbomb_left[i])
            player_set_position(p, i, p->x[i], p->y[i]);
        else if (p->in_game[i])
            move_one(p, kinds, i, held_buttons[i], area);
        p->push_x[i] = p->push_y[i] = 0;
    }
}
