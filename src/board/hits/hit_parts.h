/*
 * hit_parts.h - what the hit tests share: bodies, and whether two of them touch.
 * floor: board
 */
#ifndef BOARD_HIT_PARTS_H
#define BOARD_HIT_PARTS_H

#include "../../base/geom.h"
#include "../machine.h"

/* A thing this frame: its shape, where it is now, and its move of the frame. */
struct body {
    uint8_t shape;
    fx a, b; /* as of its kind; a capsule's bar, as hit_capsule turned it: (b, c) to one end */
    fx x, y, mx, my;
    fx c;
};

/* Do two circles or boxes touch on their paths of the frame or, not swept, where they are now? */
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

/* A capsule's bar comes to lie along dir: its ends are the points that trig_polar gives. */
void hit_capsule(struct body *p, ang dir);

/* hit_touches for any shapes; of bodies of bullets, hit_capsule has turned the capsules. */
bool hit_any_touch(const struct body *p, const struct body *q, bool swept);

/* The same, by dir, of the body of bullet or shot i. */
static inline bool hit_bullet_touches(const struct bullets *s, uint32_t i, const struct body *bullet,
                                      const struct body *q, bool swept)
{
    struct body turned;

    if (bullet->shape < SHAPE_CAPSULE)
        return hit_touches(bullet, q, swept);
    turned = *bullet;
    hit_capsule(&turned, s->dir[i]);
    return hit_any_touch(&turned, q, swept);
}

/* How far a shape reaches from its place at most, on either axis, whatever its dir. */
static inline fx hit_half_width(uint8_t shape, fx a, fx b)
{
    return shape < SHAPE_CAPSULE ? a : a + b;
}

static inline fx hit_half_height(uint8_t shape, fx a, fx b)
{
    return shape == SHAPE_BOX ? b : hit_half_width(shape, a, b);
}

/* The body of bullet, shot or enemy i. */
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

    return (struct body){ k->shape[kind],        k->a[kind], k->b[kind], e->x[i], e->y[i], e->x[i] - e->was_x[i],
                          e->y[i] - e->was_y[i], 0 };
}

/* Shots against enemies: raises an event for each shot that hits. */
void hit_shots(struct board *b);

#endif
