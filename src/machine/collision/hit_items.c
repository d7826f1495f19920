/*
 * hit_items.c - players against items, as swept circles. If both players touch an item, the one that was nearer to
 * it before the move takes it; ties go to player 1.
 */
#include "hit_parts.h"

static struct body item_body(const struct board *b, uint32_t i)
{
    const struct items *s = &b->items;

    return (struct body){ .shape = SHAPE_CIRCLE,
                          .a = b->item_kinds.radius[s->kind[i]],
                          .x = s->x[i],
                          .y = s->y[i],
                          .mx = fx_sub(s->x[i], s->prev_x[i]),
                          .my = fx_sub(s->y[i], s->prev_y[i]) };
}

/* Returns the squared distance between p and q before they moved. */
static uint64_t start_distance_sq(const struct body *p, const struct body *q)
{
    uint64_t dx = geom_gap(p->x - p->mx, q->x - q->mx), dy = geom_gap(p->y - p->my, q->y - q->my);

    return dx * dx + dy * dy;
}

/* Returns the player that takes item i, 0 or 1, or MAX_PLAYERS if none does. */
static uint32_t find_taker(const struct board *b, uint32_t i, const struct body body[MAX_PLAYERS])
{
    const struct body item = item_body(b, i);
    uint64_t nearest = UINT64_MAX;
    uint32_t found = MAX_PLAYERS;

    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        if (!b->player.in_game[p] || !hit_touches(&item, &body[p], true))
            continue;
        uint64_t d = start_distance_sq(&item, &body[p]);
        if (d < nearest) {
            nearest = d;
            found = p;
        }
    }
    return found;
}

void hit_test_items(struct board *b)
{
    const struct body body[MAX_PLAYERS] = { hit_player_body(b, 0), hit_player_body(b, 1) };
    const struct items *s = &b->items;

    EACH_LIVE (i, &s->s) {
        uint32_t p = find_taker(b, i, body);
        if (p < MAX_PLAYERS)
            board_raise_event(b, EV_TAKE, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_ITEM, (int32_t)i));
        else if (s->x[i] < b->keep_box.x0 || s->x[i] > b->keep_box.x1 || s->y[i] < b->keep_box.y0 ||
                 s->y[i] > b->keep_box.y1)
            slots_drop(&b->items.s, i);
    }
}
