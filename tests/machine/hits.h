/*
 * hits.h - every collision of a frame by a plain reference in 128 bits: which events, and in which order.
 */
#ifndef TESTS_HITS_H
#define TESTS_HITS_H

#include "../../src/machine/collision/hit.h"
#include "rig.h"

__extension__ typedef __int128 wide;

/* ---- scenes by chance ---- */

static struct rng rng;
static const fx edge = (fx)WORLD_EDGE << 16, fastest = (fx)MAX_SPEED << 16;

static inline bool one_in(uint64_t n)
{
    return rng_below(&rng, n) == 0;
}

static inline fx within(fx most)
{
    return (fx)((int64_t)rng_below(&rng, 2 * (uint64_t)most + 1) - most);
}

static inline fx clamped(int64_t v, fx most)
{
    return (fx)(v > most ? most : v < -most ? -most : v);
}

/* A board of a game that does nothing, with pools so large; hp: bullets have it. */
static inline void open_pools(struct rig *r, struct rig_game *game, int bullets, int shots, int enemies, bool hp)
{
    struct manifest m = rig_manifest();

    m.bullets = bullets;
    m.shots = shots;
    m.enemies = enemies;
    m.has_hp = hp;
    m.has_transforms = 1;
    rig_script(game, &m, "");
    rig_power(r, game, NULL);
    rig_reserve_kinds(r->b);
}

/* Makes row k of some kinds a shape that is not plain, `most` far at most; several circles: and the rows after it, up
 * to `last`, which are for no other kind. A capsule as of enemies has a bar of its own. */
static inline void draw_pieces(const struct shape_columns *c, uint32_t k, uint32_t last, bool bar, fx most)
{
    uint32_t n = last - k + 1 < SHAPE_MAX_CIRCLES ? last - k + 1 : SHAPE_MAX_CIRCLES;
    int32_t left = (int32_t)rng_below(&rng, n);

    if (!left) {
        c->shape[k] = SHAPE_CAPSULE;
        c->a[k] = (fx)rng_below(&rng, (uint64_t)most + 1);
        c->b[k] = (fx)rng_below(&rng, (uint64_t)(most - c->a[k]) + 1);
        c->x[k] = c->y[k] = 0;
        if (bar) {
            trig_polar(c->b[k], (ang)rng_next(&rng) << (rng_below(&rng, 3) ? 0 : 30), &c->x[k], &c->y[k]);
            c->b[k] = 0;
        }
        return;
    }
    for (; left >= 0; left--, k++) {
        int64_t a = (int64_t)rng_below(&rng, (uint64_t)most + 1), rest = most - a > 2 ? most - a - 2 : 0;
        int64_t x = (int64_t)rng_below(&rng, (uint64_t)rest + 1),
                y = (int64_t)rng_below(&rng, (uint64_t)(rest - x) + 1);
        c->shape[k] = SHAPE_CIRCLES;
        c->a[k] = (fx)a;
        c->b[k] = left;
        c->x[k] = (fx)(rng_below(&rng, 2) ? x : -x);
        c->y[k] = (fx)(rng_below(&rng, 2) ? y : -y);
    }
}

/* What the reference has come across. */
static struct {
    long hits, grazes, bullet_misses, box_hits, standing, touches, touch_misses, shots, shot_misses, ties, solids,
        solid_ties;
    long capsule_hits, capsule_shots, circles_hits, circles_shots, blocks, long_foes, long_touches, scaled_foes,
        scaled_touches;
} seen;

static wide square(wide v)
{
    return v * v;
}

static wide magnitude(wide v)
{
    return v < 0 ? -v : v;
}

/* Is the point (px, py) within r of the segment from (x, y) to (x + wx, y + wy)? */
static bool near_segment(wide px, wide py, wide x, wide y, wide wx, wide wy, wide r)
{
    wide dx = px - x, dy = py - y, along = dx * wx + dy * wy, ww = square(wx) + square(wy);

    if (along <= 0)
        return square(dx) + square(dy) <= square(r);
    if (along >= ww)
        return square(dx - wx) + square(dy - wy) <= square(r);
    wide cross = magnitude(dx * wy - dy * wx);
    return cross < (wide)1 << 63 && square(cross) <= square(r) * ww;
}

/* How far v is outside of [-half, half]. */
static wide outside(wide v, wide half)
{
    return magnitude(v) > half ? magnitude(v) - half : 0;
}

static bool near_box(wide x, wide y, wide hw, wide hh, wide r)
{
    return square(outside(x, hw)) + square(outside(y, hh)) <= square(r);
}

/* Do the segment and the box around the origin share a point? Separating axes. */
static bool crosses(wide x, wide y, wide wx, wide wy, wide hw, wide hh)
{
    bool left = false, right = false;

    if ((x > hw && x + wx > hw) || (x < -hw && x + wx < -hw) || (y > hh && y + wy > hh) || (y < -hh && y + wy < -hh))
        return false;
    for (int i = 0; i < 4; i++) {
        wide side = ((i & 1 ? hw : -hw) - x) * wy - ((i & 2 ? hh : -hh) - y) * wx;
        left |= side <= 0;
        right |= side >= 0;
    }
    return left && right;
}

/* Two convex shapes that do not meet are nearest at a corner of one of them. */
static bool segment_near_box(wide x, wide y, wide wx, wide wy, wide hw, wide hh, wide r)
{
    if (crosses(x, y, wx, wy, hw, hh) || near_box(x, y, hw, hh, r) || near_box(x + wx, y + wy, hw, hh, r))
        return true;
    for (int i = 0; i < 4; i++)
        if (near_segment(i & 1 ? hw : -hw, i & 2 ? hh : -hh, x, y, wx, wy, r))
            return true;
    return false;
}

/* A thing: its shape, where it is and where it was. */
struct thing {
    int shape;
    wide a, b, x, y, was_x, was_y;
    wide bar_x, bar_y; /* half of a capsule's */
};

/* A thing in pieces. */
struct whole {
    int n;
    struct thing piece[SHAPE_MAX_CIRCLES];
};

static struct whole whole_of(struct thing t, const struct shape_columns *k, uint16_t kind, bool turns, ang dir)
{
    struct whole w = { .n = 1, .piece = { t } };

    if (t.shape != SHAPE_CIRCLES)
        return w;
    for (w.n = 0; w.n == 0 || k->b[kind + w.n - 1]; w.n++) {
        fx x = k->x[kind + w.n], y = k->y[kind + w.n], cx = x, cy = 0, sx = 0, sy = y;
        if (turns) {
            trig_polar(x, dir, &cx, &cy);
            trig_polar(y, dir + (1u << 30), &sx, &sy);
        }
        struct thing *p = &w.piece[w.n];
        *p = t;
        p->shape = SHAPE_CIRCLE;
        p->a = k->a[kind + w.n];
        p->x += (wide)cx + sx;
        p->was_x += (wide)cx + sx;
        p->y += (wide)cy + sy;
        p->was_y += (wide)cy + sy;
    }
    return w;
}

static struct whole flier(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    const struct shape_columns shapes = { k->shape, k->a, k->b, k->x, k->y };
    uint16_t kind = s->kind[i];
    wide x = s->x[i], y = s->y[i];
    fx bar_x = 0, bar_y = 0;

    if (k->shape[kind] == SHAPE_CAPSULE)
        trig_polar(k->b[kind], s->dir[i], &bar_x, &bar_y);
    struct thing t = { k->shape[kind], k->a[kind], k->b[kind], x, y, x - s->vx[i], y - s->vy[i], bar_x, bar_y };
    return whole_of(t, &shapes, kind, k->flags[kind] & KIND_TURNS, s->dir[i]);
}

/* A length in eighths, to the nearest whole number; of two as near, the even one. */
static wide scaled(wide length, int eighths)
{
    wide twice = 2 * length * eighths + 8, n = twice / 16 - (twice % 16 < 0);

    return n - (twice % 16 == 0 && n % 2 != 0);
}

static void scale_whole(struct whole *w, int eighths, wide dx, wide dy)
{
    for (int i = 0; i < w->n; i++) {
        struct thing *p = &w->piece[i];
        const wide x = p->x, y = p->y;
        p->a = scaled(p->a, eighths);
        p->b = scaled(p->b, eighths);
        p->bar_x = scaled(p->bar_x, eighths);
        p->bar_y = scaled(p->bar_y, eighths);
        p->x = dx + scaled(x - dx, eighths);
        p->y = dy + scaled(y - dy, eighths);
        p->was_x += p->x - x;
        p->was_y += p->y - y;
    }
}

static struct whole foe(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    const struct shape_columns shapes = { k->shape, k->a, k->b, k->x, k->y };
    uint16_t kind = e->kind[i];
    uint8_t shape = k->shape[kind] & (uint8_t)~SHAPE_SCALED;
    bool bar = shape == SHAPE_CAPSULE;
    struct thing t = { shape,        k->a[kind],           k->b[kind],          e->x[i], e->y[i], e->prev_x[i],
                       e->prev_y[i], bar ? k->x[kind] : 0, bar ? k->y[kind] : 0 };
    struct whole w = whole_of(t, &shapes, kind, false, 0);

    if (k->shape[kind] & SHAPE_SCALED)
        scale_whole(&w, e->scale[i], e->x[i], e->y[i]);
    return w;
}

static struct whole pilot(const struct board *b, uint32_t p, wide r)
{
    const struct player *pl = &b->player;

    return (struct whole){ 1, { { SHAPE_CIRCLE, r, 0, pl->x[p], pl->y[p], pl->prev_x[p], pl->prev_y[p], 0, 0 } } };
}

/* On one axis: is the way from v to e more than half away from 0? */
static bool passes_by(wide v, wide e, wide half)
{
    return (v > half && e > half) || (v < -half && e < -half);
}

/* A side or a way, as a vector. */
struct stretch {
    wide x, y;
};

static wide cross_size(struct stretch a, struct stretch b)
{
    return magnitude(a.x * b.y - a.y * b.x);
}

/*
 * All that lies on n stretches, added up from (x, y) on: does any of it come within r of the box? It does if one of its
 * sides does, which is among the 2^(n-1) copies of each stretch, or if the box's middle is inside: as twice the vector
 * to the sum's own middle shows, on each side's normal.
 */
static bool sum_near_box(wide x, wide y, const struct stretch *s, int n, wide hw, wide hh, wide r)
{
    struct stretch middle = { 2 * x, 2 * y };
    bool inside = true, flat = true;

    for (int i = 0; i < n; i++) {
        middle.x += s[i].x;
        middle.y += s[i].y;
        for (int ends = 0; ends < 1 << n; ends++) {
            wide sx = x, sy = y;
            for (int k = 0; k < n; k++) {
                sx += ends >> k & 1 ? s[k].x : 0;
                sy += ends >> k & 1 ? s[k].y : 0;
            }
            if (!(ends >> i & 1) && !passes_by(sx, sx + s[i].x, hw + r) && !passes_by(sy, sy + s[i].y, hh + r) &&
                segment_near_box(sx, sy, s[i].x, s[i].y, hw, hh, r))
                return true;
        }
    }
    for (int i = 0; i < n; i++) {
        wide reach = 0;
        for (int k = 0; k < n; k++) {
            flat = flat && cross_size(s[i], s[k]) == 0;
            reach += cross_size(s[i], s[k]);
        }
        inside = inside && cross_size(s[i], middle) <= reach;
    }
    return inside && !flat;
}

/* The sum of the two shapes as a box with round corners, around the origin; the difference of their places moves. */
static bool pieces_meet(struct thing p, struct thing q, bool swept)
{
    wide hw = (p.shape == SHAPE_BOX ? p.a : 0) + (q.shape == SHAPE_BOX ? q.a : 0);
    wide hh = (p.shape == SHAPE_BOX ? p.b : 0) + (q.shape == SHAPE_BOX ? q.b : 0);
    wide r = (p.shape != SHAPE_BOX ? p.a : 0) + (q.shape != SHAPE_BOX ? q.a : 0);
    wide x = p.was_x - q.was_x, y = p.was_y - q.was_y, ex = p.x - q.x, ey = p.y - q.y;

    if (p.shape == SHAPE_NONE || q.shape == SHAPE_NONE)
        return false;
    if (p.shape == SHAPE_CAPSULE || q.shape == SHAPE_CAPSULE) {
        struct stretch s[3] = { { swept ? ex - x : 0, swept ? ey - y : 0 },
                                { 2 * p.bar_x, 2 * p.bar_y },
                                { 2 * q.bar_x, 2 * q.bar_y } };
        wide sx = (swept ? x : ex) - p.bar_x - q.bar_x, sy = (swept ? y : ey) - p.bar_y - q.bar_y;
        return sum_near_box(sx, sy, s, 3, hw, hh, r);
    }
    if (!swept)
        return near_box(ex, ey, hw, hh, r);
    if (passes_by(x, ex, hw + r) || passes_by(y, ey, hh + r))
        return false;
    return segment_near_box(x, y, ex - x, ey - y, hw, hh, r);
}

static bool meets(struct whole p, struct whole q, bool swept)
{
    for (int i = 0; i < p.n * q.n; i++)
        if (pieces_meet(p.piece[i / q.n], q.piece[i % q.n], swept))
            return true;
    return false;
}

/* hit_run after things were put in places by hand, without a move that found who is near: all are asked. */
static inline void hit_now(struct board *b)
{
    struct bullets_query query[MAX_PLAYERS];

    b->events.n = 0;
    hit_get_queries(b, query);
    for (uint32_t k = 0; k < b->bullets.s.top / SLOTS_BLOCK * MAX_PLAYERS; k++)
        b->bullets.near_player[k] = query[k % MAX_PLAYERS].reach < 0 ? 0 : b->bullets.s.live_bits[k / MAX_PLAYERS];
    b->bullets.holds_all = true;
    hit_run(b);
}

static int expected_n;
static struct event expected[4096];

static inline void expect(const struct board *b, enum event_kind kind, enum handle_kind hx, uint32_t x,
                          enum handle_kind hy, uint32_t y)
{
    assert_true(expected_n < 4096);
    expected[expected_n++] =
        (struct event){ .kind = kind, .a = board_handle(b, hx, (int32_t)x), .b = board_handle(b, hy, (int32_t)y) };
}

static inline void player_reference(const struct board *b, uint32_t p)
{
    uint16_t kind = b->player.kind[p], k;

    for (uint32_t i = 0; i < b->bullets.s.cap; i++) {
        if (i >= b->bullets.s.top || !(b->bullets.s.live_bits[i / 64] >> (i & 63) & 1))
            continue;
        k = b->bullets.kind[i];
        if (b->bullet_kinds.shape[k] == SHAPE_NONE)
            continue;
        bool swept = b->bullet_kinds.flags[k] & KIND_SWEPT;
        struct whole bullet = flier(&b->bullets, &b->bullet_kinds, i);
        if (meets(bullet, pilot(b, p, b->player_kinds.radius[kind]), swept)) {
            expect(b, EV_HIT, H_PLAYER, p, H_BULLET, i);
            seen.hits++;
            seen.box_hits += b->bullet_kinds.shape[k] == SHAPE_BOX;
            seen.capsule_hits += b->bullet_kinds.shape[k] == SHAPE_CAPSULE;
            seen.circles_hits += b->bullet_kinds.shape[k] == SHAPE_CIRCLES;
            seen.standing += !swept;
        } else if (b->bullet_kinds.flags[k] & KIND_GRAZE && !(b->bullets.flags[i] & BULLET_GRAZED << p) &&
                   meets(bullet, pilot(b, p, b->player_kinds.graze_radius[kind]), swept)) {
            expect(b, EV_GRAZE, H_PLAYER, p, H_BULLET, i);
            seen.grazes++;
        } else
            seen.bullet_misses++;
    }
    for (uint32_t e = 0; e < b->enemies.s.top; e++) {
        if (!(b->enemies.s.live_bits[e / 64] >> (e & 63) & 1) ||
            !(b->enemy_kinds.flags[b->enemies.kind[e]] & ENEMY_TOUCH))
            continue;
        k = b->enemies.kind[e];
        if (meets(foe(b, e), pilot(b, p, b->player_kinds.radius[kind]), b->enemy_kinds.flags[k] & ENEMY_SWEPT)) {
            expect(b, EV_HIT, H_PLAYER, p, H_ENEMY, e);
            seen.touches++;
            seen.long_touches += b->enemy_kinds.shape[k] > SHAPE_MAX_SIMPLE;
            seen.scaled_touches += (b->enemy_kinds.shape[k] & SHAPE_SCALED) != 0;
        } else
            seen.touch_misses++;
    }
}

/* The bullets that a shot could hit: those with hp, and for one that cancels, those that are clearable. */
static inline bool is_solid(const struct board *b, uint32_t i, bool cancels)
{
    const struct bullets *s = &b->bullets;

    if (s->flags[i] & BULLET_DELAYED)
        return false;
    return (s->hp && s->hp[i] != 0) || (cancels && !(b->bullet_kinds.flags[s->kind[i]] & KIND_FIXED));
}

/* The bullet nearer than `best` (-1: any) that the shot hits, or NO_SLOT. */
static inline int32_t solid_reference(const struct board *b, uint32_t i, struct whole shot, wide best)
{
    const uint16_t flags = b->shot_kinds.flags[b->shots.kind[i]];
    int32_t found = NO_SLOT;

    EACH_LIVE (k, &b->bullets.s) {
        const struct bullets *s = &b->bullets, *t = &b->shots;
        struct whole bullet = flier(s, &b->bullet_kinds, k);
        wide apart = square((wide)t->x[i] - t->vx[i] - ((wide)s->x[k] - s->vx[k])) +
                     square((wide)t->y[i] - t->vy[i] - ((wide)s->y[k] - s->vy[k]));
        if (!is_solid(b, k, flags & KIND_CANCELS) || !meets(shot, bullet, flags & KIND_SWEPT))
            continue;
        seen.solid_ties += apart == best;
        if (best >= 0 && apart >= best)
            continue;
        best = apart;
        found = (int32_t)k;
    }
    return found;
}

/* Each of a pool with the enemy it meets first. */
static inline void pool_reference(const struct board *b, const struct bullets *pool, const struct bullet_kinds *kinds,
                                  enum event_kind event, enum handle_kind of)
{
    EACH_LIVE (i, &pool->s) {
        if (event == EV_BLOCK && pool->flags[i] & BULLET_DELAYED)
            continue;
        struct whole shot = flier(pool, kinds, i);
        wide best = -1, apart;
        uint32_t found = 0;
        EACH_LIVE (e, &b->enemies.s) {
            struct whole f = foe(b, e);
            apart = square((wide)pool->x[i] - pool->vx[i] - b->enemies.prev_x[e]) +
                    square((wide)pool->y[i] - pool->vy[i] - b->enemies.prev_y[e]);
            if ((best >= 0 && apart > best) || b->enemies.flags[e] & ENEMY_DYING ||
                (event == EV_BLOCK && !(b->enemy_kinds.flags[b->enemies.kind[e]] & ENEMY_BLOCKS_BULLETS)))
                continue;
            if (!meets(shot, f, kinds->flags[pool->kind[i]] & KIND_SWEPT)) {
                seen.shot_misses++;
                continue;
            }
            seen.ties += apart == best;
            if (best < 0 || apart < best) {
                best = apart;
                found = e;
            }
        }
        int32_t bullet = event == EV_SHOT ? solid_reference(b, i, shot, best) : NO_SLOT;
        if (bullet != NO_SLOT) {
            expect(b, EV_SHOT, H_SHOT, i, H_BULLET, (uint32_t)bullet);
            seen.solids++;
        } else if (best >= 0) {
            expect(b, event, of, i, H_ENEMY, found);
            *(event == EV_BLOCK ? &seen.blocks : &seen.shots) += 1;
            seen.capsule_shots += kinds->shape[pool->kind[i]] == SHAPE_CAPSULE;
            seen.circles_shots += kinds->shape[pool->kind[i]] == SHAPE_CIRCLES;
            seen.long_foes += b->enemy_kinds.shape[b->enemies.kind[found]] > SHAPE_MAX_SIMPLE;
            seen.scaled_foes += (b->enemy_kinds.shape[b->enemies.kind[found]] & SHAPE_SCALED) != 0;
        }
    }
}

static inline void reference(const struct board *b)
{
    expected_n = 0;
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        if (b->player.in_game[p])
            player_reference(b, p);
    pool_reference(b, &b->shots, &b->shot_kinds, EV_SHOT, H_SHOT);
    pool_reference(b, &b->bullets, &b->bullet_kinds, EV_BLOCK, H_BULLET);
}

static inline void compare(const struct board *b, int scene)
{
    for (int i = 0; i < expected_n && i < (int)b->events.n; i++) {
        const struct event e = events_at(&b->events, (uint32_t)i), *x = &expected[i];
        if (e.kind != x->kind || e.a != x->a || e.b != x->b)
            fail_msg("scene %d, event %d: kind %u, slots %u %u; expected kind %u, slots %u %u", scene, i, e.kind,
                     handle_slot(e.a), handle_slot(e.b), x->kind, handle_slot(x->a), handle_slot(x->b));
    }
    if ((int)b->events.n != expected_n)
        fail_msg("scene %d: %u events, expected %d", scene, b->events.n, expected_n);
}

#endif
