/*
 * item.c - spawning items on the board, and how players attract them.
 */
#include "machine.h"
#include "../base/trig.h"

static int32_t spawn_item(struct board *b, uint16_t kind, fx x, fx y)
{
    int32_t i = items_spawn(&b->items, kind, x, y, b->core.clock);

    if (i == NO_SLOT)
        board_report_full(b, &b->items.s);
    return i;
}

void board_drop_items(struct board *b, const struct item_drop *d, const uint16_t *kind, const uint16_t *n,
                      int kind_count)
{
    uint32_t total = 0, k = 0;

    for (int j = 0; j < kind_count; j++)
        total += n[j];
    for (int j = 0; j < kind_count; j++)
        for (uint32_t left = n[j]; left > 0; left--, k++) {
            int32_t i = spawn_item(b, kind[j], d->x, d->y);
            if (i == NO_SLOT)
                continue;
            b->items.tag[i] = d->tag;
            trig_polar(d->speed, items_spread_direction(d->dir, d->spread, k, total), &b->items.vx[i], &b->items.vy[i]);
        }
}

void board_replace_with_item(struct board *b, uint16_t kind, fx x, fx y)
{
    spawn_item(b, kind, x, y);
}

/* Returns whether player i attracts all items because of a full register: the kind of the ship may name a register
 * that, at its maximum, has this effect. */
static bool attracts_all(const struct board *b, uint32_t i)
{
    const uint8_t full_register = b->player_kinds.full_register[b->player.kind[i]];

    if (full_register >= PLAYER_RUN_REGISTER_OFFSET)
        return board_run_register_is_full(b, full_register - (uint32_t)PLAYER_RUN_REGISTER_OFFSET);
    return full_register && registers_is_full(&b->registers, board_register_row(b, i, full_register - 1u), i);
}

void board_get_pulls(const struct board *b, struct item_pull pull[MAX_PLAYERS])
{
    const struct player *p = &b->player;
    const struct player_kinds *k = &b->player_kinds;

    for (uint32_t i = 0; i < MAX_PLAYERS; i++) {
        const uint16_t kind = p->kind[i];
        pull[i] = (struct item_pull){ .active = p->in_game[i] };
        if (!p->in_game[i])
            continue;
        pull[i].x = p->x[i];
        pull[i].y = p->y[i];
        pull[i].radius = k->magnet_radius[kind];
        pull[i].speed = k->pull_speed[kind];
        pull[i].pulls_all = p->y[i] <= k->collect_line[kind] || attracts_all(b, i);
    }
}
