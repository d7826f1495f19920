/*
 * hit_shapes.c - see hit_parts.h: the shapes that are not circles or boxes.
 */
#include "hit_parts.h"
#include "../../base/trig.h"

void hit_capsule(struct body *p, ang dir)
{
    trig_polar(p->b, dir, &p->b, &p->c);
}

bool hit_any_touch(const struct body *p, const struct body *q, bool swept)
{
    const struct body *bar = p->shape == SHAPE_CAPSULE ? p : q, *other = bar == p ? q : p;
    int64_t wx = swept ? (int64_t)bar->mx - other->mx : 0, wy = swept ? (int64_t)bar->my - other->my : 0;
    int64_t dx = (int64_t)bar->x - other->x - wx, dy = (int64_t)bar->y - other->y - wy;

    if (bar->shape != SHAPE_CAPSULE)
        return hit_touches(p, q, swept);
    switch (other->shape) {
    case SHAPE_NONE:
        return false;
    case SHAPE_CIRCLE:
        return geom_swept_capsule(dx, dy, wx, wy, bar->b, bar->c, (int64_t)bar->a + other->a, 0, 0);
    case SHAPE_BOX:
        return geom_swept_capsule(dx, dy, wx, wy, bar->b, bar->c, bar->a, other->a, other->b);
    default:
        return geom_swept_capsules(dx, dy, wx, wy, bar->b, bar->c, other->b, other->c, (int64_t)bar->a + other->a);
    }
}
