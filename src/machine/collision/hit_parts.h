/*
 * hit_parts.h - shared by the hit tests: bodies, and tests whether two bodies touch.
 */
#ifndef MACHINE_HIT_PARTS_H
#define MACHINE_HIT_PARTS_H

#include "../../base/geom.h"
#include "hit.h"

/* Returns whether two circles or boxes touch: at any time during this frame's movement if `swept` is set, otherwise at
 * their final positions. */
static inline bool hit_touches(const struct body *p, const struct body *q, bool swept)
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

/* Returns the hitbox of player p, a circle. */
static inline struct body hit_player_body(const struct board *b, uint32_t p)
{
    const struct player *pl = &b->player;

    return (struct body){ .shape = SHAPE_CIRCLE,
                          .a = b->player_kinds.radius[pl->kind[p]],
                          .x = pl->x[p],
                          .y = pl->y[p],
                          .mx = pl->x[p] - pl->prev_x[p],
                          .my = pl->y[p] - pl->prev_y[p] };
}

/* hit_bullet_body returns the body of bullet or shot i, not split into pieces; hit_enemy_body that of enemy i. */
static inline struct body hit_bullet_body(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    uint16_t kind = s->kind[i];

    return (struct body){ k->shape[kind], k->a[kind], k->b[kind], s->x[i], s->y[i], s->vx[i], s->vy[i], 0 };
}

static inline struct body hit_enemy_body(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint16_t kind = e->kind[i];

    return (struct body){ k->shape[kind],         k->a[kind], k->b[kind], e->x[i], e->y[i], e->x[i] - e->prev_x[i],
                          e->y[i] - e->prev_y[i], 0 };
}

/* Returns whether any of the n pieces p touches any of the m pieces q. swept: as in hit_touches. */
bool hit_any_bodies_touch(const struct body *p, uint32_t n, const struct body *q, uint32_t m, bool swept);

/* Returns whether bullet i, of any shape, touches a circle; like hit_touches. */
static inline bool hit_bullet_touches(const struct bullets *s, const struct bullet_kinds *k, uint32_t i,
                                      const struct body *bullet, const struct body *circle, bool swept)
{
    struct body piece[SHAPE_MAX_CIRCLES];

    if (bullet->shape <= SHAPE_MAX_SIMPLE)
        return hit_touches(bullet, circle, swept);
    return hit_any_bodies_touch(piece, hit_split_bullet(s, k, i, piece), circle, 1, swept);
}

/* Returns whether enemy i, of any shape, touches a circle; like hit_touches. */
static inline bool hit_enemy_touches(const struct board *b, uint32_t i, const struct body *enemy,
                                     const struct body *circle, bool swept)
{
    struct body piece[SHAPE_MAX_CIRCLES];

    if (enemy->shape <= SHAPE_MAX_SIMPLE)
        return hit_touches(enemy, circle, swept);
    return hit_any_bodies_touch(piece, hit_split_enemy(b, i, piece), circle, 1, swept);
}

/* Returns whether bullet or shot i touches enemy `enemy_slot`, both of any shape; like hit_touches. */
static inline bool hit_shot_touches(const struct board *b, const struct bullets *pool, const struct bullet_kinds *kinds,
                                    uint32_t i, const struct body *shot, uint32_t enemy_slot, const struct body *enemy,
                                    bool swept)
{
    struct body p[SHAPE_MAX_CIRCLES], q[SHAPE_MAX_CIRCLES];

    if ((shot->shape | enemy->shape) <= SHAPE_MAX_SIMPLE)
        return hit_touches(shot, enemy, swept);
    return hit_any_bodies_touch(p, hit_split_bullet(pool, kinds, i, p), q, hit_split_enemy(b, enemy_slot, q), swept);
}

/* The farthest that a shape extends from its position on each axis, in any rotation. */
struct extent {
    fx x, y;
};
struct extent hit_compute_extent(const struct shape_columns *k, uint32_t kind);

static inline struct extent hit_extent(const struct shape_columns *k, uint32_t kind)
{
    fx a = k->a[kind], h = k->shape[kind] == SHAPE_BOX ? k->b[kind] : a;

    if (k->shape[kind] > SHAPE_MAX_SIMPLE)
        return hit_compute_extent(k, kind);
    return (struct extent){ a, h };
}

static inline struct shape_columns hit_bullet_shapes(const struct bullet_kinds *k)
{
    return (struct shape_columns){ k->shape, k->a, k->b, k->x, k->y };
}

static inline struct shape_columns hit_enemy_shapes(const struct enemy_kinds *k)
{
    return (struct shape_columns){ k->shape, k->a, k->b, k->x, k->y };
}

/* Returns a bound for the extent of a shape whose lengths are scaled (motion_scale_length). */
struct extent hit_scale_extent(struct extent e, int32_t scale);

static inline struct extent hit_enemy_extent(const struct board *b, uint32_t i)
{
    const struct shape_columns shapes = hit_enemy_shapes(&b->enemy_kinds);
    const struct extent e = hit_extent(&shapes, b->enemies.kind[i]);

    return shapes.shape[b->enemies.kind[i]] & SHAPE_SCALED ? hit_scale_extent(e, b->enemies.scale[i]) : e;
}

/* The bullets that shots can hit in this frame. */
struct hit_solids {
    bool any_solid; /* some bullets can be hit by any shot */
    int64_t reach;  /* the farthest that a bullet's shape extends from its position */
};

/* Finds the bullets that shots can hit. Returns false if no shot can hit any. */
bool hit_find_solids(struct board *b, struct hit_solids *f);

/* Handles of the targets that a piercing shot cannot hit again yet, because it hit them recently or in this frame. */
struct hit_pierced_targets {
    int n;
    int64_t entity[MAX_PIERCED_TARGETS];
};

/* Returns whether `pierced` contains the entity of this kind and slot. A NULL `pierced` is empty. */
static inline bool hit_pierced_contains(const struct hit_pierced_targets *pierced, enum handle_kind kind, uint32_t slot)
{
    for (int k = 0; pierced && k < pierced->n; k++)
        if (handle_kind(pierced->entity[k]) == kind && handle_slot(pierced->entity[k]) == slot)
            return true;
    return false;
}

/* Returns the bullet that shot i hits, or NO_SLOT: of the bullets it touches, the one that was nearest before both
 * moved; ties go to the lowest slot. Only bullets whose squared distance from the shot was below *distance_sq count. If
 * there is one, its squared distance is stored in *distance_sq. */
int32_t hit_find_nearest_solid(struct board *b, const struct hit_solids *f, uint32_t i,
                               const struct hit_pierced_targets *pierced, uint64_t *distance_sq);

/* Tests shots against enemies and bullets: raises an event for each shot that hits. A piercing shot raises one for each
 * target it passes through, nearest first, and one for the target that stops it. It stores at most MAX_PIERCED_TARGETS
 * targets that it cannot hit again yet; while that list is full, the shot hits nothing. Targets that no longer exist
 * are removed from the list here. */
void hit_test_shots(struct board *b);

/* Tests bullets against enemies that block: raises an event for each bullet that touches one. */
void hit_test_blocks(struct board *b);

/*
 * Tests bullets against bullets. For each pair of tags, in the order of declaration, each bullet of the first tag, by
 * slot, meets the bullet of the second tag that it touches: of several, the one that was nearest before both moved;
 * ties go to the lowest slot. In one frame a bullet meets at most one other as the first bullet of a pair. A bullet
 * that a pair removes meets no more bullets. For a pair of equal tags, each bullet meets at most one other. Delayed
 * bullets and bullets without a shape meet none.
 */
void hit_test_meets(struct board *b);

/* Tests players against items: raises an event for each item taken, and removes the others that left the field. */
void hit_test_items(struct board *b);

/* Returns whether laser i, which hits within `reach` of its line, touches circle c at any time during this frame's
 * movement. */
bool hit_laser_touches_circle(const struct board *b, uint32_t i, const struct body *c, int64_t reach);

/* hit_test_lasers tests lasers against player p, whose body is c, and raises an event for each laser that hits or
 * grazes. hit_test_player_lasers tests players' lasers against enemies, and raises an event for each laser that touches
 * one. */
void hit_test_lasers(struct board *b, uint32_t p, const struct body *c);
void hit_test_player_lasers(struct board *b);

#endif
