/*
 * geom.h - do two shapes touch? Exactly, with integers only; one common point is touching.
 *
 * All lengths are in one unit, whichever. A negative radius or half extent touches nothing.
 */
#ifndef BASE_GEOM_H
#define BASE_GEOM_H

#include "fx.h"

/* |a - b| */
static inline uint32_t geom_gap(fx a, fx b)
{
    return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

/* Are two points at most r apart? For circles r is the sum of their radii. Every input; no branches. */
static inline bool geom_circles(fx x1, fx y1, fx x2, fx y2, fx r)
{
    uint64_t dx = geom_gap(x1, x2), dy = geom_gap(y1, y2), limit = (uint64_t)(int64_t)r;

    return (r >= 0) & (dx <= limit) & (dy <= limit) & (dx * dx + dy * dy <= limit * limit);
}

/* Two boxes given by their centres and half extents. Every input. */
static inline bool geom_boxes(fx x1, fx y1, fx hw1, fx hh1, fx x2, fx y2, fx hw2, fx hh2)
{
    uint32_t dx = geom_gap(x1, x2), dy = geom_gap(y1, y2);
    uint32_t w = (uint32_t)hw1 + (uint32_t)hw2, h = (uint32_t)hh1 + (uint32_t)hh2;

    return ((hw1 | hh1 | hw2 | hh2) >= 0) & (dx <= w) & (dy <= h);
}

/* A circle and a box given by its centre and half extents. Every input. */
bool geom_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh);

/*
 * A point starts at (dx, dy), seen from the centre of a circle of radius r, and moves in a straight line by (wx, wy):
 * does it touch the circle on the way, both ends included? For two moving circles: d is the difference of their starts,
 * w of their motions, r the sum of their radii. Exact for |dx|, |dy| <= 2^61, |wx|, |wy| <= 2^31, r <= 2^30.
 */
bool geom_swept_circles(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r);

/*
 * The same against a box of half extents hw and hh. For two moving boxes: hw and hh are the sums of theirs. Exact for
 * |dx|, |dy| <= 2^61, |wx|, |wy| <= 2^31, hw, hh <= 2^30.
 */
bool geom_swept_boxes(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh);

/*
 * The same against a box grown by r, its corners round: a moving circle of radius r against a box. Exact for |dx|,
 * |dy| <= 2^61, |wx|, |wy| <= 2^31, r, hw, hh <= 2^30.
 */
bool geom_swept_circle_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh);

/*
 * The same with a bar in place of the point: it reaches from its middle, which is where the point was, by h to one end
 * and by -h to the other, and does not turn. A moving capsule of radius r against a circle (hw, hh = 0) or a box. Exact
 * for |dx|, |dy| <= 2^60, |wx|, |wy| <= 2^31, |hx|, |hy| <= 2^29, r, hw, hh <= 2^30.
 */
bool geom_swept_capsule(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t r, int64_t hw,
                        int64_t hh);

/*
 * Two moving capsules, as two moving circles: h and g are half their bars, r the sum of their radii. Exact for |dx|,
 * |dy| <= 2^59, |wx|, |wy| <= 2^31, |hx|, |hy|, |gx|, |gy| <= 2^29, r <= 2^30.
 */
bool geom_swept_capsules(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t gx, int64_t gy,
                         int64_t r);

/* A bar within a frame, seen from the centre of a circle: one end runs straight from (ax, ay) by (ux, uy), the other
 * from (bx, by) by (vx, vy). */
struct geom_bar {
    int64_t ax, ay, ux, uy, bx, by, vx, vy;
};

/*
 * Does all within r of the bar touch the circle's centre on the way, both ends of the way included? What it passes is
 * the quadrilateral of its places at the beginning and at the end and of its ends' ways; of one that crosses itself,
 * both halves. That is exact for a bar that turns about no point of its own, and never more than the bar passes. One
 * that does turns about points of a short curve, and what lies between that curve and the sides, a splinter, is left
 * out. Exact, in this sense, for |ax|, |ay|, |bx|, |by| <= 2^60, |ux|, |uy|, |vx|, |vy| <= 2^30, a bar that is at the
 * beginning and at the end no longer than 2^29 on each axis, r <= 2^30.
 */
bool geom_swept_bar(const struct geom_bar *bar, int64_t r);

/*
 * A capsule, which is all within r of the way from (x1, y1) to (x2, y2), and a circle. Exact for coordinates in +-2^30
 * and radii <= 2^29: 16384 and 8192 pixels.
 */
static inline bool geom_capsule_circle(fx x1, fx y1, fx x2, fx y2, fx r, fx cx, fx cy, fx cr)
{
    return (r | cr) >= 0 &&
           geom_swept_circles((int64_t)x1 - cx, (int64_t)y1 - cy, (int64_t)x2 - x1, (int64_t)y2 - y1, (int64_t)r + cr);
}

#endif
