/*
 * item.c - spawning items on the board, and how players attract them.
 */
#include "machine.h"
#include "../base/trig.h"

static int32_t put(struct board *b, uint16_t kind, fx x, fx y)
{
    int32_t i = items_put(&b->items, kind, x, y, b->core.clock);

    if (i == NO_SLOT)
        board_full(b, &b->items.s);
    return i;
}

void board_drop(struct board *b, const struct item_drop *d, const uint16_t *kind, const uint16_t *n, int kinds)
{
    uint32_t all = 0, k = 0;

    for (int j = 0; j < kinds; j++)
        all += n[j];
    for (int j = 0; j < kinds; j++)
        for (uint32_t left = n[j]; left > 0; left--, k++) {
            int32_t i = put(b, kind[j], d->x, d->y);
            if (i == NO_SLOT)
                continue;
            b->items.tag[i] = d->tag;
            trig_polar(d->speed, items_direction(d->dir, d->spread, k, all), &b->items.vx[i], &b->items.vy[i]);
        }
}

void board_turn_into(struct board *b, uint16_t kind, fx x, fx y)
{
    put(b, kind, x, y);
}

/* Returns whether player i attracts all items because of a full register: the kind of the ship may name a register
 * that, at its maximum, has this effect. */
static bool draws_all(const struct board *b, uint32_t i)
{
    const uint8_t full = b->player_kinds.full[b->player.kind[i]];

    if (full >= PLAYER_FULL_RUN)
        return board_run_full(b, full - (uint32_t)PLAYER_FULL_RUN);
    return full && registers_full(&b->registers, board_register_row(b, i, full - 1u), i);
}

void board_pulls(const struct board *b, struct item_pull pull[PADS])
{
    const struct player *p = &b->player;
    const struct player_kinds *k = &b->player_kinds;

    for (uint32_t i = 0; i < PADS; i++) {
        const uint16_t kind = p->kind[i];
        pull[i] = (struct item_pull){ .in = p->in[i] };
        if (!p->in[i])
            continue;
        pull[i].x = p->x[i];
        pull[i].y = p->y[i];
        pull[i].radius = k->magnet[kind];
        pull[i].speed = k->pull[kind];
        pull[i].all = p->y[i] <= k->line[kind] || draws_all(b, i);
    }
}
