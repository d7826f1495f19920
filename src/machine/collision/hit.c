/*
 * hit.c - see hit.h.
 *
 * The tests are swept, because entities move during the frame: relative to one entity, the other travels from d to
 * d + w, and the exact shape test (geom.h) covers that whole path. Bullets and enemies of a kind with swept = false are
 * tested at their final positions.
 *
 * The broad phase for bullets is in bullets_move, which finds the bullets near a player; players have already moved.
 * raise_bullet_hits is the narrow phase. The search distance, `reach`, covers the largest shape of a bullet, the hitbox
 * or graze ring, and the player's movement. Shots against enemies are in hit_shots.c.
 *
 * Entities that leave the field are tested too, because they may touch something on the way out. bullets_move holds the
 * bullets that leave near a player (all that leave, if shots or bullets can hit them), and all shots that leave while
 * there is anything to hit. If only bullets near a player are held, hit_run releases those that touch no player.
 * hit_test_shots releases the held shots that hit nothing, and events_run all others.
 */
#include "../../base/int.h"
#include "hit.h"
#include "hit_parts.h"

/* Returns how far from the player, on either axis, a bullet that hits or grazes may be after its move, not counting the
 * length of that move. */
static int64_t reach_of(const struct board *b, const struct body *c, fx graze)
{
    const struct shape_columns shapes = hit_bullet_shapes(&b->bullet_kinds);
    fx max_extent = 0;

    for (uint32_t i = 0; i < b->bullet_kinds.s.live; i++) {
        struct extent e = hit_extent(&shapes, i);
        max_extent = fx_max(max_extent, fx_max(e.x, e.y));
    }
    return (int64_t)max_extent + fx_max(c->a, graze) + fx_max(fx_abs(c->mx), fx_abs(c->my));
}

enum verdict { MISS, HIT, GRAZE };

/* Returns whether the path of bullet i in this frame may come within reach of the player on both axes. */
static inline bool is_within_reach(const struct bullets *s, uint32_t i, const struct body *c, int64_t reach)
{
    const int64_t dx = (int64_t)s->x[i] - c->x, dy = (int64_t)s->y[i] - c->y;

    return int64_abs(dx) <= reach + fx_abs(s->vx[i]) && int64_abs(dy) <= reach + fx_abs(s->vy[i]);
}

/* Tests a circular bullet, the usual case, against the hitbox c and the graze ring. radius: the bullet's; graze: the
 * ring's, below 0: no graze test. */
static inline enum verdict test_circle(const struct bullets *s, uint32_t i, const struct body *c, fx radius, fx graze,
                                       bool swept)
{
    const int64_t wx = swept ? (int64_t)s->vx[i] - c->mx : 0, wy = swept ? (int64_t)s->vy[i] - c->my : 0;
    const int64_t dx = (int64_t)s->x[i] - c->x - wx, dy = (int64_t)s->y[i] - c->y - wy;

    if (geom_swept_circles(dx, dy, wx, wy, (int64_t)radius + c->a))
        return HIT;
    return graze >= 0 && geom_swept_circles(dx, dy, wx, wy, (int64_t)radius + graze) ? GRAZE : MISS;
}

/* Tests a bullet of any shape; graze as in test_circle. */
static enum verdict test_shape(const struct board *b, const struct body *c, uint32_t i, fx graze, bool swept)
{
    const struct body bullet = hit_bullet_body(&b->bullets, &b->bullet_kinds, i);
    struct body ring;

    if (hit_bullet_touches(&b->bullets, &b->bullet_kinds, i, &bullet, c, swept))
        return HIT;
    if (graze < 0)
        return MISS;
    ring = *c;
    ring.a = graze;
    return hit_bullet_touches(&b->bullets, &b->bullet_kinds, i, &bullet, &ring, swept) ? GRAZE : MISS;
}

static inline enum verdict test_bullet(struct board *b, uint32_t p, const struct body *c, int64_t reach, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    const struct bullet_kinds *k = &b->bullet_kinds;
    const uint16_t kind = s->kind[i];
    const unsigned flags = k->flags[kind];

    if (!is_within_reach(s, i, c, reach) || s->flags[i] & BULLET_DELAYED || flags & KIND_HARMLESS)
        return MISS;
    b->counts.tested++;
    const bool can_graze = flags & KIND_GRAZE && !(s->flags[i] >> p & BULLET_GRAZED), swept = flags & KIND_SWEPT;
    const fx graze = can_graze ? b->player_kinds.graze_radius[b->player.kind[p]] : -1;
    if (k->shape[kind] == SHAPE_CIRCLE)
        return test_circle(s, i, c, k->a[kind], graze, swept);
    return test_shape(b, c, i, graze, swept);
}

/* The narrow phase: tests the bullets that bullets_move found near player p, raises an event for each that hits or
 * grazes, and clears the `near_player` bits of the others. */
static void raise_bullet_hits(struct board *b, uint32_t p, const struct body *c)
{
    struct bullets *s = &b->bullets;
    int64_t reach = -1;

    for (uint32_t block = 0; block < s->s.top / SLOTS_BLOCK; block++) {
        uint64_t *near = &s->near_player[block * MAX_PLAYERS + p];
        if (*near && reach < 0)
            reach = reach_of(b, c, b->player_kinds.graze_radius[b->player.kind[p]]);
        for (uint64_t m = *near; m; m &= m - 1) {
            const uint32_t i = block * SLOTS_BLOCK + bits_lowest(m);
            const enum verdict v = test_bullet(b, p, c, reach, i);
            if (v == MISS) {
                *near &= ~(m & -m);
                continue;
            }
            b->counts.hit += v == HIT;
            b->counts.grazed += v == GRAZE;
            board_raise_event(b, v == GRAZE ? EV_GRAZE : EV_HIT, board_handle(b, H_PLAYER, (int32_t)p),
                              board_handle(b, H_BULLET, (int32_t)i));
        }
    }
}

/* Releases the held bullets, which left the field near a player, if they touched no player. */
static void release_missed(struct bullets *s)
{
    for (uint32_t block = 0; block < s->s.held_top / SLOTS_BLOCK; block++) {
        uint64_t missed = s->s.held[block];
        for (uint32_t p = 0; p < MAX_PLAYERS; p++)
            missed &= ~s->near_player[block * MAX_PLAYERS + p];
        for (; missed; missed &= missed - 1)
            bullets_release(s, block * SLOTS_BLOCK + bits_lowest(missed));
    }
}

static void raise_enemy_hits(struct board *b, uint32_t p, const struct body *c)
{
    EACH_LIVE (i, &b->enemies.s) {
        const uint8_t flags = b->enemy_kinds.flags[b->enemies.kind[i]];

        if (!(flags & ENEMY_TOUCH) || b->enemies.flags[i] & ENEMY_DYING)
            continue;
        const struct body e = hit_enemy_body(b, i);
        if (hit_enemy_touches(b, i, &e, c, flags & ENEMY_SWEPT))
            board_raise_event(b, EV_HIT, board_handle(b, H_PLAYER, (int32_t)p), board_handle(b, H_ENEMY, (int32_t)i));
    }
}

void hit_get_queries(struct board *b, struct bullets_query query[MAX_PLAYERS])
{
    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        struct body c = hit_player_body(b, p);
        fx graze = b->player_kinds.graze_radius[b->player.kind[p]];
        query[p] = (struct bullets_query){ c.x, c.y, b->player.in_game[p] ? reach_of(b, &c, graze) : -1 };
    }
}

/* Raises an event for each enemy that left the field. Call after the events of all entities that touched it. */
static void raise_enemy_leaves(struct board *b)
{
    EACH_LIVE (i, &b->enemies.s)
        if (b->enemies.flags[i] & ENEMY_LEAVING)
            board_raise_event(b, EV_LEAVE, board_handle(b, H_ENEMY, (int32_t)i), 0);
}

void hit_run(struct board *b)
{
    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        struct body c = hit_player_body(b, p);
        if (!b->player.in_game[p])
            continue;
        raise_bullet_hits(b, p, &c);
        if (b->lasers.s.live)
            hit_test_lasers(b, p, &c);
        raise_enemy_hits(b, p, &c);
    }
    if (!b->bullets.holds_all)
        release_missed(&b->bullets);
    hit_test_shots(b);
    if (b->lasers.s.live)
        hit_test_player_lasers(b);
    hit_test_blocks(b);
    if (b->bullets.n_meet_pairs)
        hit_test_meets(b);
    if (b->enemies.n_leaving)
        raise_enemy_leaves(b);
    if (b->items.s.top)
        hit_test_items(b);
}
