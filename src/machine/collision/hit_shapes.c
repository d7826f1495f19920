/*
 * hit_shapes.c - see hit_parts.h: capsules, and shapes made of several circles.
 */
#include "hit_parts.h"
#include "../../base/trig.h"

/* Rotates (x, y) by dir: adds the rotated vectors (x, 0) and (0, y), each rounded once. */
static void rotate(fx x, fx y, ang dir, fx *tx, fx *ty)
{
    fx across_x, across_y;

    trig_polar(x, dir, tx, ty);
    trig_polar(y, dir + ANG_QUARTER, &across_x, &across_y);
    *tx += across_x;
    *ty += across_y;
}

/* Replaces the body in piece[0] by its circles; returns their number. is_rotated: rotate them by dir. */
static uint32_t split_circles(const struct shape_columns *k, uint32_t kind, bool is_rotated, ang dir,
                              struct body piece[SHAPE_MAX_CIRCLES])
{
    const struct body whole = piece[0];
    uint32_t n = (uint32_t)whole.b + 1;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t row = kind + i; /* the first circle is in ROW_KIND, the others from ROW_CIRCLES on */
        fx x = k->x[row], y = k->y[row];
        if (is_rotated)
            rotate(x, y, dir, &x, &y);
        piece[i] = whole;
        piece[i].shape = SHAPE_CIRCLE;
        piece[i].a = k->a[row];
        piece[i].x += x;
        piece[i].y += y;
    }
    return n;
}

uint32_t hit_split_bullet(const struct bullets *s, const struct bullet_kinds *k, uint32_t i,
                          struct body piece[SHAPE_MAX_CIRCLES])
{
    const struct shape_columns shapes = hit_bullet_shapes(k);

    piece[0] = hit_bullet_body(s, k, i);
    if (piece[0].shape == SHAPE_CIRCLES)
        return split_circles(&shapes, s->kind[i], k->flags[s->kind[i]] & KIND_TURNS, s->dir[i], piece);
    if (piece[0].shape == SHAPE_CAPSULE)
        trig_polar(piece[0].b, s->dir[i], &piece[0].b, &piece[0].c);
    return 1;
}

/* Applies enemy i's scale to the lengths of its n pieces, and to their offsets from its position. */
static void scale_pieces(const struct enemies *e, uint32_t i, struct body *piece, uint32_t n)
{
    const int32_t scale = e->scale[i];

    for (uint32_t k = 0; k < n; k++) {
        piece[k].a = motion_scale_length(piece[k].a, scale);
        piece[k].b = motion_scale_length(piece[k].b, scale);
        piece[k].c = motion_scale_length(piece[k].c, scale);
        piece[k].x = e->x[i] + motion_scale_length(piece[k].x - e->x[i], scale);
        piece[k].y = e->y[i] + motion_scale_length(piece[k].y - e->y[i], scale);
    }
}

uint32_t hit_split_enemy(const struct board *b, uint32_t i, struct body piece[SHAPE_MAX_CIRCLES])
{
    const struct shape_columns shapes = hit_enemy_shapes(&b->enemy_kinds);
    uint16_t kind = b->enemies.kind[i];
    uint32_t n = 1;

    piece[0] = hit_enemy_body(b, i);
    const bool is_scaled = piece[0].shape & SHAPE_SCALED;
    piece[0].shape &= (uint8_t)~SHAPE_SCALED;
    if (piece[0].shape == SHAPE_CIRCLES)
        n = split_circles(&shapes, kind, false, 0, piece);
    if (piece[0].shape == SHAPE_CAPSULE) {
        piece[0].b = shapes.x[kind];
        piece[0].c = shapes.y[kind];
    }
    if (is_scaled)
        scale_pieces(&b->enemies, i, piece, n);
    return n;
}

struct extent hit_compute_extent(const struct shape_columns *k, uint32_t kind)
{
    const fx slack = 2; /* most rounding error of a rotated position */
    const uint8_t shape = k->shape[kind] & (uint8_t)~SHAPE_SCALED;
    struct extent e = { 0, 0 };

    if (shape == SHAPE_BOX)
        return (struct extent){ k->a[kind], k->b[kind] };
    if (shape == SHAPE_CAPSULE) {
        fx x = fx_abs(k->x[kind]), y = fx_abs(k->y[kind]), a = k->a[kind];
        return (struct extent){ a + k->b[kind] + x, a + k->b[kind] + y };
    }
    for (uint32_t i = kind, end = kind + (shape == SHAPE_CIRCLES ? (uint32_t)k->b[kind] : 0) + 1; i < end; i++) {
        fx distance = fx_abs(k->x[i]) + fx_abs(k->y[i]) + slack;
        e.x = e.y = fx_max(e.x, distance + k->a[i]);
    }
    return e;
}

struct extent hit_scale_extent(struct extent e, int32_t scale)
{
    const fx slack = 2; /* most rounding error of the sum of an offset and a length */

    return (struct extent){ motion_scale_length(e.x, scale) + slack, motion_scale_length(e.y, scale) + slack };
}

static bool bodies_touch(const struct body *p, const struct body *q, bool swept)
{
    const struct body *capsule = p->shape == SHAPE_CAPSULE ? p : q, *other = capsule == p ? q : p;
    int64_t wx = swept ? (int64_t)capsule->mx - other->mx : 0, wy = swept ? (int64_t)capsule->my - other->my : 0;
    int64_t dx = (int64_t)capsule->x - other->x - wx, dy = (int64_t)capsule->y - other->y - wy;

    if (capsule->shape != SHAPE_CAPSULE)
        return hit_touches(p, q, swept);
    switch (other->shape) {
    case SHAPE_NONE:
        return false;
    case SHAPE_CIRCLE:
        return geom_swept_capsule(dx, dy, wx, wy, capsule->b, capsule->c, (int64_t)capsule->a + other->a, 0, 0);
    case SHAPE_BOX:
        return geom_swept_capsule(dx, dy, wx, wy, capsule->b, capsule->c, capsule->a, other->a, other->b);
    default:
        return geom_swept_capsules(dx, dy, wx, wy, capsule->b, capsule->c, other->b, other->c,
                                   (int64_t)capsule->a + other->a);
    }
}

bool hit_any_bodies_touch(const struct body *p, uint32_t n, const struct body *q, uint32_t m, bool swept)
{
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = 0; k < m; k++)
            if (bodies_touch(&p[i], &q[k], swept))
                return true;
    return false;
}
