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
    fx a, b;
    fx x, y, mx, my;
};

/* Do they touch on their paths of the frame or, not swept, where they are now? */
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

/* The body of bullet, shot or enemy i. */
static inline struct body hit_bullet_body(const struct bullets *s, const struct bullet_kinds *k, uint32_t i)
{
    uint16_t kind = s->kind[i];

    return (struct body){ k->shape[kind], k->a[kind], k->b[kind], s->x[i], s->y[i], s->vx[i], s->vy[i] };
}

static inline struct body hit_enemy_body(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint16_t kind = e->kind[i];

    return (struct body){ k->shape[kind],        k->a[kind],           k->b[kind], e->x[i], e->y[i],
                          e->x[i] - e->was_x[i], e->y[i] - e->was_y[i] };
}

/* What a shot could hit of the bullets, this frame. */
struct hit_solids {
    bool some;     /* any shot can hit some of them */
    int64_t reach; /* most that a bullet extends from where it is */
};

/* False: no shot can hit any. */
bool hit_find_solids(struct board *b, struct hit_solids *f);

/* The bullet that shot i hits, or NO_SLOT: of those it touches the nearest before both moved, then the lowest slot; nearer
 * than *apart, a squared distance, which becomes the bullet's. */
int32_t hit_solid(const struct board *b, const struct hit_solids *f, uint32_t i, uint64_t *apart);

/* Shots against enemies and bullets: raises an event for each shot that hits. */
void hit_shots(struct board *b);

#endif
