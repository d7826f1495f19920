/*
 * hit.c - see hit.h.
 *
 * Things move within the frame, so the tests are swept: relative to the one, the other travels from d to d + w, and the
 * exact shape test (geom.h) looks at that whole way. A kind with swept = false is tested where it stands.
 *
 * Of bullets only those are tested that the move found near a player (`near` in bullets.h). `reach` covers the largest
 * radius, the graze ring and the player's movement. Shots against enemies are in hit_shots.c.
 */
#include "hit.h"
#include "hit_parts.h"

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

/* What the tests will read of a block's bullets. */
static void fetch(const struct bullets *s, uint32_t block, uint32_t p)
{
    for (uint64_t m = s->near[block * PADS + p] & s->s.used[block]; m; m &= m - 1) {
        uint32_t i = block * SLOTS_BLOCK + lowest_bit(m);
        slots_fetch(&s->x[i]);
        slots_fetch(&s->y[i]);
        slots_fetch(&s->vx[i]);
        slots_fetch(&s->vy[i]);
        slots_fetch(&s->kind[i]);
        slots_fetch(&s->flags[i]);
    }
}

enum { AHEAD = 8 /* blocks */ };

static void bullets_against(struct board *b, uint32_t p, const struct body *c, fx graze)
{
    const struct bullets *s = &b->bullets;
    int64_t reach = reach_of(b, c, graze);
    struct body ring = *c;
    uint32_t blocks = s->s.top / SLOTS_BLOCK;

    ring.a = graze;
    for (uint32_t block = 0; block < blocks; block++) {
        if (block + AHEAD < blocks)
            fetch(s, block + AHEAD, p);
        for (uint64_t m = s->near[block * PADS + p] & s->s.used[block]; m; m &= m - 1)
            bullet_against(b, p, c, &ring, reach, block * SLOTS_BLOCK + lowest_bit(m));
    }
}

static void enemies_against(struct board *b, uint32_t p, const struct body *c)
{
    const struct slots *s = &b->enemies.s;

    for (uint32_t word = 0; word < s->top / SLOTS_BLOCK; word++)
        for (uint64_t m = s->used[word]; m; m &= m - 1) {
            uint32_t i = word * SLOTS_BLOCK + lowest_bit(m);
            uint8_t flags = b->enemy_kinds.flags[b->enemies.kind[i]];
            if (!(flags & ENEMY_TOUCH) || b->enemies.flags[i] & ENEMY_DYING)
                continue;
            struct body e = enemy(b, i);
            if (touch(&e, c, flags & ENEMY_SWEPT))
                board_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_ENEMY, (int32_t)i));
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
    hit_shots(b);
}
