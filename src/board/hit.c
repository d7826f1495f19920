/*
 * hit.c - see hit.h.
 *
 * Bullets and player move within the frame, so the test is swept: relative to the player a bullet travels from d to d +
 * w, and the exact shape test (geom.h) looks at that whole way. Before it stands a reject in 32-bit modular arithmetic
 * over blocks of 64: (u32)(x - (px - reach)) > 2 * reach never drops a bullet that is near for reach <= 2^30, because
 * such a distance cannot wrap. `reach` covers the largest radius, the graze ring, and both movements.
 */
#include "hit.h"
#include <string.h>
#include "../base/geom.h"

enum { MOST_REACH = 1 << 30 };

/* One player's circle this frame. */
struct circle {
    fx x, y;   /* now */
    fx mx, my; /* its move of this frame */
    fx r, graze;
};

static fx larger(fx a, fx b)
{
    return a > b ? a : b;
}

static fx size(fx v)
{
    return v < 0 ? -v : v;
}

/* The largest half extent and the fastest bullet bound how far from the player a bullet can matter. */
static fx reach_of(const struct board *b, const struct circle *c)
{
    const struct bullet_kinds *k = &b->bullet_kinds;
    fx most = 0;

    for (uint32_t i = 0; i < k->s.live; i++)
        most = larger(most, k->shape[i] == SHAPE_BOX ? larger(k->a[i], k->b[i]) : k->a[i]);
    return fx_add(fx_add(most, larger(c->r, c->graze)), larger(size(c->mx), size(c->my)));
}

/* near[i] is 1 where bullet i's way of this frame may come within reach of (px, py). */
static int32_t near_block(const fx *restrict x, const fx *restrict y, const fx *restrict vx, const fx *restrict vy,
                          uint8_t *restrict near, fx px, fx py, fx reach)
{
    int32_t any = 0;
    const uint32_t left = (uint32_t)px - (uint32_t)reach, top = (uint32_t)py - (uint32_t)reach;
    const uint32_t wide = 2u * (uint32_t)reach;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        uint32_t ax = (uint32_t)(vx[i] < 0 ? -vx[i] : vx[i]), ay = (uint32_t)(vy[i] < 0 ? -vy[i] : vy[i]);
        uint32_t dx = (uint32_t)x[i] - left + ax, dy = (uint32_t)y[i] - top + ay;
        int32_t n = (dx <= wide + 2 * ax) & (dy <= wide + 2 * ay);
        near[i] = (uint8_t)n;
        any |= n;
    }
    return any;
}

/* Does the circle, grown by `grow`, touch bullet i on its way? */
static bool touches(const struct board *b, const struct circle *c, uint32_t i, fx grow)
{
    const struct bullets *s = &b->bullets;
    uint16_t kind = s->kind[i];
    fx a = b->bullet_kinds.a[kind], h = b->bullet_kinds.b[kind];
    int64_t ex = (int64_t)s->x[i] - c->x, ey = (int64_t)s->y[i] - c->y;
    int64_t wx = (int64_t)s->vx[i] - c->mx, wy = (int64_t)s->vy[i] - c->my;

    if (b->bullet_kinds.shape[kind] == SHAPE_CIRCLE)
        return geom_swept_circles(ex - wx, ey - wy, wx, wy, (int64_t)a + grow);
    return geom_swept_circle_box(ex - wx, ey - wy, wx, wy, grow, a, h);
}

static void bullet_against(struct board *b, uint32_t p, const struct circle *c, uint32_t i)
{
    struct bullets *s = &b->bullets;
    uint16_t kind = s->kind[i];
    int64_t who = board_handle(b, H_PLAYER, (int32_t)p);

    b->counts.tested++;
    if (b->bullet_kinds.shape[kind] == SHAPE_NONE)
        return;
    if (touches(b, c, i, c->r)) {
        b->counts.hit++;
        board_event(b, EV_HIT, who, board_handle(b, H_BULLET, (int32_t)i));
    } else if (b->bullet_kinds.flags[kind] & KIND_GRAZE && !(s->flags[i] >> p & BULLET_GRAZED) &&
               touches(b, c, i, c->graze)) {
        b->counts.grazed++;
        board_event(b, EV_GRAZE, who, board_handle(b, H_BULLET, (int32_t)i));
    }
}

static void bullets_against(struct board *b, uint32_t p, const struct circle *c)
{
    const struct bullets *s = &b->bullets;
    fx reach = reach_of(b, c);
    uint8_t near[SLOTS_BLOCK];

    for (uint32_t i = 0; i < s->s.top; i += SLOTS_BLOCK) {
        if (reach > MOST_REACH)
            memset(near, 1, sizeof near);
        else if (!near_block(s->x + i, s->y + i, s->vx + i, s->vy + i, near, c->x, c->y, reach))
            continue;
        for (uint32_t k = 0; k < SLOTS_BLOCK; k++)
            if (near[k] && s->s.used[i / 64] >> k & 1)
                bullet_against(b, p, c, i + k);
    }
}

static void enemies_against(struct board *b, uint32_t p, const struct circle *c)
{
    const struct enemies *e = &b->enemies;

    EACH_LIVE (i, &e->s) {
        uint16_t kind = e->kind[i];
        if (b->enemy_kinds.flags[kind] & ENEMY_TOUCH && !(e->flags[i] & ENEMY_DYING) &&
            geom_circle_box(c->x, c->y, c->r, e->x[i], e->y[i], b->enemy_kinds.half_w[kind],
                            b->enemy_kinds.half_h[kind]))
            board_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_ENEMY, (int32_t)i));
    }
}

static bool shot_touches(const struct board *b, uint32_t shot, uint32_t enemy)
{
    const struct bullet_kinds *k = &b->shot_kinds;
    const struct enemy_kinds *ek = &b->enemy_kinds;
    uint16_t sk = b->shots.kind[shot], kind = b->enemies.kind[enemy];
    fx x = b->shots.x[shot], y = b->shots.y[shot], ex = b->enemies.x[enemy], ey = b->enemies.y[enemy];

    if (k->shape[sk] == SHAPE_CIRCLE)
        return geom_circle_box(x, y, k->a[sk], ex, ey, ek->half_w[kind], ek->half_h[kind]);
    return geom_boxes(x, y, k->a[sk], k->b[sk], ex, ey, ek->half_w[kind], ek->half_h[kind]);
}

static void shots_against_enemies(struct board *b)
{
    EACH_LIVE (i, &b->shots.s) {
        if (b->shot_kinds.shape[b->shots.kind[i]] == SHAPE_NONE)
            continue;
        EACH_LIVE (k, &b->enemies.s) {
            if (b->enemies.flags[k] & ENEMY_DYING || !shot_touches(b, i, k))
                continue;
            board_event(b, EV_SHOT, board_handle(b, H_SHOT, (int32_t)i), board_handle(b, H_ENEMY, (int32_t)k));
            break;
        }
    }
}

void hit_run(struct board *b)
{
    for (uint32_t p = 0; p < PADS; p++) {
        uint16_t kind = b->player.kind[p];
        if (!b->player.in[p])
            continue;
        fx x = b->player.x[p], y = b->player.y[p];
        struct circle c = { x,
                            y,
                            x - b->player.was_x[p],
                            y - b->player.was_y[p],
                            b->player_kinds.radius[kind],
                            b->player_kinds.graze[kind] };
        bullets_against(b, p, &c);
        enemies_against(b, p, &c);
    }
    shots_against_enemies(b);
}
