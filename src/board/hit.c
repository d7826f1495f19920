/*
 * hit.c - see hit.h.
 *
 * Things move within the frame, so the tests are swept: relative to the one, the other travels from d to d + w, and the
 * exact shape test (geom.h) looks at that whole way. A kind with swept = false is tested where it stands.
 *
 * Of bullets only those are tested that the move found near a player (`near` in bullets.h). `reach` covers the largest
 * radius, the graze ring and the player's movement. Enemies are sieved for a shot in 32-bit modular arithmetic over
 * blocks of 64: (u32)(x - (px - reach)) > 2 * reach never drops a near one for reach <= 2^30, because such a distance
 * cannot wrap.
 */
#include "hit.h"
#include <string.h>
#include "../base/geom.h"

enum { MOST_REACH = 1 << 30 };

/* A thing this frame: its shape, where it is now, and its move of the frame. */
struct body {
    uint8_t shape;
    fx a, b;
    fx x, y, mx, my;
};

/* Do they touch on their ways or, not swept, where they are now? Growing a circle is its caller's part. */
static bool touch(const struct body *p, const struct body *q, bool swept)
{
    int64_t wx = swept ? (int64_t)p->mx - q->mx : 0, wy = swept ? (int64_t)p->my - q->my : 0;
    int64_t dx = (int64_t)p->x - q->x - wx, dy = (int64_t)p->y - q->y - wy;

    if (p->shape == SHAPE_NONE || q->shape == SHAPE_NONE)
        return false;
    if (p->shape == SHAPE_BOX && q->shape == SHAPE_BOX)
        return geom_swept_boxes(dx, dy, wx, wy, (int64_t)p->a + q->a, (int64_t)p->b + q->b);
    if (p->shape == SHAPE_BOX)
        return geom_swept_circle_box(dx, dy, wx, wy, q->a, p->a, p->b);
    if (q->shape == SHAPE_BOX)
        return geom_swept_circle_box(dx, dy, wx, wy, p->a, q->a, q->b);
    return geom_swept_circles(dx, dy, wx, wy, (int64_t)p->a + q->a);
}

static struct body flying(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    uint16_t kind = s->kind[i];

    return (struct body){ k->shape[kind], k->a[kind], k->b[kind], s->x[i], s->y[i], s->vx[i], s->vy[i] };
}

static struct body enemy(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint16_t kind = e->kind[i];

    return (struct body){ k->shape[kind],        k->a[kind],           k->b[kind], e->x[i], e->y[i],
                          e->x[i] - e->was_x[i], e->y[i] - e->was_y[i] };
}

static fx larger(fx a, fx b)
{
    return a > b ? a : b;
}

static fx size(fx v)
{
    return v < 0 ? -v : v;
}

/* How far from the player the end of a bullet's way can be that touches it, but for the bullet's own movement. */
static int64_t reach_of(const struct board *b, const struct body *c, fx graze)
{
    const struct bullet_kinds *k = &b->bullet_kinds;
    fx most = 0;

    for (uint32_t i = 0; i < k->s.live; i++)
        most = larger(most, k->shape[i] == SHAPE_BOX ? larger(k->a[i], k->b[i]) : k->a[i]);
    return (int64_t)most + larger(c->a, graze) + larger(size(c->mx), size(c->my));
}

/* May the bullet's way of this frame come within reach of the player, on both axes? */
static bool within(const struct body *bullet, const struct body *c, int64_t reach)
{
    int64_t dx = (int64_t)bullet->x - c->x, dy = (int64_t)bullet->y - c->y;

    return (dx < 0 ? -dx : dx) <= reach + size(bullet->mx) && (dy < 0 ? -dy : dy) <= reach + size(bullet->my);
}

static void bullet_against(struct board *b, uint32_t p, const struct body *c, const struct body *ring, int64_t reach,
                           uint32_t i)
{
    struct body bullet = flying(&b->bullets, &b->bullet_kinds, i);
    uint8_t flags = b->bullet_kinds.flags[b->bullets.kind[i]];

    if (!within(&bullet, c, reach))
        return;
    b->counts.tested++;
    if (touch(&bullet, c, flags & KIND_SWEPT)) {
        b->counts.hit++;
        board_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_BULLET, (int32_t)i));
    } else if (flags & KIND_GRAZE && !(b->bullets.flags[i] >> p & BULLET_GRAZED) &&
               touch(&bullet, ring, flags & KIND_SWEPT)) {
        b->counts.grazed++;
        board_event(b, EV_GRAZE, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_BULLET, (int32_t)i));
    }
}

static void bullets_against(struct board *b, uint32_t p, const struct body *c, fx graze)
{
    const struct bullets *s = &b->bullets;
    int64_t reach = reach_of(b, c, graze);
    struct body ring = *c;

    ring.a = graze;
    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++)
        for (uint64_t m = s->near[block * PADS + p] & s->s.used[block]; m; m &= m - 1)
            bullet_against(b, p, c, &ring, reach, block * SLOTS_BLOCK + lowest_bit(m));
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

/* near[i] is 1 where (x[i], y[i]) is within reach of (px, py) on both axes; the same arithmetic. */
static int32_t close_block(const fx *restrict x, const fx *restrict y, uint8_t *restrict near, fx px, fx py, fx reach)
{
    int32_t any = 0;
    const uint32_t left = (uint32_t)px - (uint32_t)reach, top = (uint32_t)py - (uint32_t)reach;
    const uint32_t wide = 2u * (uint32_t)reach;

    for (int i = 0; i < SLOTS_BLOCK; i++) {
        int32_t n = ((uint32_t)x[i] - left <= wide) & ((uint32_t)y[i] - top <= wide);
        near[i] = (uint8_t)n;
        any |= n;
    }
    return any;
}

/* The largest extent of an enemy's kind and the longest move of an enemy, together. */
static fx enemies_reach(const struct board *b)
{
    const struct enemies *e = &b->enemies;
    fx most = 0, move = 0;

    for (uint32_t i = 0; i < b->enemy_kinds.s.live; i++)
        most = larger(most, larger(b->enemy_kinds.a[i], b->enemy_kinds.b[i]));
    EACH_LIVE (i, &e->s)
        move = larger(move, larger(size(e->x[i] - e->was_x[i]), size(e->y[i] - e->was_y[i])));
    return fx_add(most, move);
}

/* How far apart two things were before they moved, squared. */
static uint64_t parted(const struct body *p, const struct body *q)
{
    int64_t dx = ((int64_t)p->x - p->mx) - ((int64_t)q->x - q->mx),
            dy = ((int64_t)p->y - p->my) - ((int64_t)q->y - q->my);

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* The enemy that the shot touches; of several, the one that was nearest to it before they moved, then the lowest slot. */
static int32_t target_of(const struct board *b, const struct body *shot, bool swept, fx reach)
{
    const struct enemies *e = &b->enemies;
    uint8_t near[SLOTS_BLOCK];
    uint64_t best = UINT64_MAX;
    int32_t found = NO_SLOT;

    for (uint32_t i = 0; i < e->s.top; i += SLOTS_BLOCK) {
        if (reach > MOST_REACH)
            memset(near, 1, sizeof near);
        else if (!close_block(e->x + i, e->y + i, near, shot->x, shot->y, reach))
            continue;
        for (uint32_t k = i; k < i + SLOTS_BLOCK; k++) {
            if (!near[k - i] || !(e->s.used[i / 64] >> (k - i) & 1) || e->flags[k] & ENEMY_DYING)
                continue;
            struct body foe = enemy(b, k);
            if (parted(shot, &foe) < best && touch(shot, &foe, swept)) {
                best = parted(shot, &foe);
                found = (int32_t)k;
            }
        }
    }
    return found;
}

static void shots_against_enemies(struct board *b)
{
    fx enemies = enemies_reach(b);

    EACH_LIVE (i, &b->shots.s) {
        struct body shot = flying(&b->shots, &b->shot_kinds, i);
        if (shot.shape == SHAPE_NONE)
            continue;
        fx reach = fx_add(fx_add(enemies, larger(shot.a, shot.b)), larger(size(shot.mx), size(shot.my)));
        int32_t k = target_of(b, &shot, b->shot_kinds.flags[b->shots.kind[i]] & KIND_SWEPT, reach);
        if (k != NO_SLOT)
            board_event(b, EV_SHOT, board_handle(b, H_SHOT, (int32_t)i), board_handle(b, H_ENEMY, k));
    }
}

static struct body pilot(const struct board *b, uint32_t p)
{
    const struct player *pl = &b->player;

    return (struct body){ .shape = SHAPE_CIRCLE,
                          .a = b->player_kinds.radius[pl->kind[p]],
                          .x = pl->x[p],
                          .y = pl->y[p],
                          .mx = pl->x[p] - pl->was_x[p],
                          .my = pl->y[p] - pl->was_y[p] };
}

void hit_watch(const struct board *b, struct watch watch[PADS])
{
    for (uint32_t p = 0; p < PADS; p++) {
        struct body c = pilot(b, p);
        fx graze = b->player_kinds.graze[b->player.kind[p]];
        watch[p] = (struct watch){ c.x, c.y, b->player.in[p] ? reach_of(b, &c, graze) : -1 };
    }
}

void hit_run(struct board *b)
{
    for (uint32_t p = 0; p < PADS; p++) {
        struct body c = pilot(b, p);
        if (!b->player.in[p])
            continue;
        bullets_against(b, p, &c, b->player_kinds.graze[b->player.kind[p]]);
        enemies_against(b, p, &c);
    }
    shots_against_enemies(b);
}
