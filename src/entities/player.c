/*
 * player.c - the two players (player.h).
 */
#include "player.h"

static const struct column kind_columns[] = {
    COLUMN(player_kinds, sprite),
    COLUMN(player_kinds, radius),
    COLUMN(player_kinds, graze_radius),
    COLUMN(player_kinds, speed),
    COLUMN(player_kinds, focus),
    COLUMN(player_kinds, lives),
    COLUMN(player_kinds, safe),
    DERIVED(player_kinds, first, "set only while scripts load, like names"),
    DERIVED(player_kinds, registers, "set while scripts load"),
    DERIVED(player_kinds, deathbomb, "set while scripts load"),
    DERIVED(player_kinds, bomb, "set while scripts load"),
    DERIVED(player_kinds, bomb_focus, "set while scripts load"),
    GROUP_COLUMN(player_kinds, magnet, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, line, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, pull, GROUP_ITEMS),
    GROUP_COLUMN(player_kinds, full, GROUP_ITEMS),
};

static const struct column columns[] = {
    COLUMN(player, in),
    COLUMN(player, gen),
    COLUMN(player, kind),
    COLUMN(player, x),
    COLUMN(player, y),
    DERIVED(player, was_x, "written by every move before hit tests read it"),
    DERIVED(player, was_y, "written by every move before hit tests read it"),
    COLUMN(player, lives),
    COLUMN(player, safe),
    COLUMN(player, grazes),
    COLUMN(player, score),
    COLUMN(player, flags),
    COLUMN(player, deathbomb_left),
    COLUMN(player, bombing),
    COLUMN(player, bomb),
};

#define COUNT(table) (int)(sizeof table / sizeof *table)
const struct chip player_chip = { "player", columns, COUNT(columns), true, false };
const struct chip player_kinds_chip = { "player_kinds", kind_columns, COUNT(kind_columns), true, false };

void player_place(struct player *p, uint32_t i, fx x, fx y)
{
    p->x[i] = p->was_x[i] = x;
    p->y[i] = p->was_y[i] = y;
}

void player_join(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t kind, fx x, fx y)
{
    p->in[i] = PLAYER_IN;
    p->kind[i] = kind;
    player_place(p, i, x, y);
    p->lives[i] = kinds->lives[kind] - 1;
    p->safe[i] = kinds->safe[kind];
    p->grazes[i] = 0;
    p->score[i] = 0;
    p->flags[i] = 0;
    p->deathbomb_left[i] = 0;
    p->bombing[i] = 0;
    p->bomb[i] = 0;
}

unsigned player_withheld(const struct player *p, uint32_t i)
{
    return (p->in[i] & PLAYER_NO_FIRE ? PAD_FIRE | PAD_BOMB | PAD_SPECIAL : 0u) |
           (p->in[i] & PLAYER_STANDS ? PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT | PAD_FOCUS : 0u);
}

bool player_retired(const struct player *p, uint32_t i)
{
    return p->gen[i] == GENERATIONS;
}

void player_leave(struct player *p, uint32_t i)
{
    p->in[i] = 0;
    p->gen[i] += p->gen[i] < GENERATIONS;
    player_place(p, i, PARK, PARK);
}

/* Selects the picture for the horizontal direction, if the kind has pictures and no script has chosen one. */
static void bank(struct player *p, const struct player_kinds *kinds, uint32_t i, int dx)
{
    uint16_t kind = p->kind[i];
    int picture = dx < 0 ? PICTURE_LEFT : dx > 0 ? PICTURE_RIGHT : 0;

    if (p->flags[i] & PLAYER_POSED || kind == 0 || kinds->radius[kind - 1] != PICTURE_ROW)
        return;
    p->flags[i] = (uint8_t)((p->flags[i] & ~PLAYER_PICTURE) | picture * PLAYER_PICTURE_ONE);
}

uint16_t player_picture(const struct player *p, const struct player_kinds *kinds, uint32_t i)
{
    return kinds->sprite[p->kind[i] - p->flags[i] / PLAYER_PICTURE_ONE];
}

static void move_one(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t held,
                     const struct box *area)
{
    uint16_t kind = p->kind[i];
    int dx = !!(held & PAD_RIGHT) - !!(held & PAD_LEFT), dy = !!(held & PAD_DOWN) - !!(held & PAD_UP);

    p->flags[i] = (uint8_t)((p->flags[i] & ~PLAYER_FOCUS) | (held & PAD_FOCUS ? PLAYER_FOCUS : 0));
    bank(p, kinds, i, dx);
    fx speed = p->flags[i] & PLAYER_FOCUS ? kinds->focus[kind] : kinds->speed[kind];
    if (dx && dy)
        speed = fx_mul(speed, PLAYER_DIAGONAL);
    p->was_x[i] = fx_clamp(p->x[i], area->x0, area->x1); /* clamping moves the ship without a sweep */
    p->was_y[i] = fx_clamp(p->y[i], area->y0, area->y1);
    p->x[i] = fx_clamp(p->was_x[i] + dx * speed, area->x0, area->x1);
    p->y[i] = fx_clamp(p->was_y[i] + dy * speed, area->y0, area->y1);
}

void player_count_down(struct player *p)
{
    for (uint32_t i = 0; i < PADS; i++)
        if (p->safe[i])
            p->safe[i]--;
}

void player_move(struct player *p, const struct player_kinds *kinds, const uint16_t held[PADS], const struct box *area)
{
    for (uint32_t i = 0; i < PADS; i++)
        if (p->in[i] && p->deathbomb_left[i])
            player_place(p, i, p->x[i], p->y[i]);
        else if (p->in[i])
            move_one(p, kinds, i, held[i], area);
}
