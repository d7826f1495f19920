/*
 * hit.c - see hit.h.
 *
 * Things move within the frame, so the tests are swept: relative to the one, the other travels from d to d + w, and the
 * exact shape test (geom.h) looks at that whole way. A kind with swept = false is tested where it stands.
 *
 * Before the test of bullets stands a reject in 32-bit modular arithmetic over blocks of 64: (u32)(x - (px - reach)) > 2
 * * reach never drops a bullet that is near for reach <= 2^30, because such a distance cannot wrap. `reach` covers the
 * largest radius, the graze ring, and both movements.
 */
#include "hit.h"
#include <string.h>
#include "hit_parts.h"

enum { MOST_REACH = 1 << 30 };

static fx larger(fx a, fx b)
{
    return a > b ? a : b;
}

static fx size(fx v)
{
    return v < 0 ? -v : v;
}

/* The largest half extent and the fastest bullet bound how far from the player a bullet can matter. */
static fx reach_of(const struct board *b, const struct body *c, fx graze)
{
    const struct bullet_kinds *k = &b->bullet_kinds;
    fx most = 0;

    for (uint32_t i = 0; i < k->s.live; i++)
        most = larger(most, k->shape[i] == SHAPE_BOX ? larger(k->a[i], k->b[i]) : k->a[i]);
    return fx_add(fx_add(most, larger(c->a, graze)), larger(size(c->mx), size(c->my)));
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

static void bullet_against(struct board *b, uint32_t p, const struct body *c, const struct body *ring, uint32_t i)
{
    struct body bullet = flying(&b->bullets, &b->bullet_kinds, i);
    uint8_t flags = b->bullet_kinds.flags[b->bullets.kind[i]];
    int64_t who = board_handle(b, H_PLAYER, (int32_t)p);

    b->counts.tested++;
    if (touch(&bullet, c, flags & KIND_SWEPT)) {
        b->counts.hit++;
        board_event(b, EV_HIT, who, board_handle(b, H_BULLET, (int32_t)i));
    } else if (flags & KIND_GRAZE && !(b->bullets.flags[i] >> p & BULLET_GRAZED) &&
               touch(&bullet, ring, flags & KIND_SWEPT)) {
        b->counts.grazed++;
        board_event(b, EV_GRAZE, who, board_handle(b, H_BULLET, (int32_t)i));
    }
}

static void bullets_against(struct board *b, uint32_t p, const struct body *c, fx graze)
{
    const struct bullets *s = &b->bullets;
    struct body ring = *c;
    fx reach = reach_of(b, c, graze);
    uint8_t near[SLOTS_BLOCK];

    ring.a = graze;
    for (uint32_t i = 0; i < s->s.top; i += SLOTS_BLOCK) {
        if (reach > MOST_REACH)
            memset(near, 1, sizeof near);
        else if (!near_block(s->x + i, s->y + i, s->vx + i, s->vy + i, near, c->x, c->y, reach))
            continue;
        for (uint32_t k = 0; k < SLOTS_BLOCK; k++)
            if (near[k] && s->s.used[i / 64] >> k & 1)
                bullet_against(b, p, c, &ring, i + k);
    }
}

static void enemies_against(struct board *b, uint32_t p, const struct body *c)
{
    EACH_LIVE (i, &b->enemies.s) {
        struct body e = enemy(b, i);
        uint8_t flags = b->enemy_kinds.flags[b->enemies.kind[i]];
        if (flags & ENEMY_TOUCH && !(b->enemies.flags[i] & ENEMY_DYING) && touch(&e, c, flags & ENEMY_SWEPT))
            board_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_ENEMY, (int32_t)i));
    }
}

void hit_run(struct board *b)
{
    for (uint32_t p = 0; p < PADS; p++) {
        const struct player *pl = &b->player;
        uint16_t kind = pl->kind[p];
        if (!pl->in[p])
            continue;
        struct body c = { .shape = SHAPE_CIRCLE,
                          .a = b->player_kinds.radius[kind],
                          .x = pl->x[p],
                          .y = pl->y[p],
                          .mx = pl->x[p] - pl->was_x[p],
                          .my = pl->y[p] - pl->was_y[p] };
        bullets_against(b, p, &c, b->player_kinds.graze[kind]);
        enemies_against(b, p, &c);
    }
    hit_shots(b);
}
