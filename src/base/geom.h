/*
 * geom.h - exact contact tests between shapes, in integers only. Shapes with a single common point touch.
 *
 * All lengths are in one unit, which the caller chooses. A shape with a negative radius or half extent touches nothing.
 */
#ifndef BASE_GEOM_H
#define BASE_GEOM_H

#include "fx.h"

/* Returns |a - b|. */
static inline uint32_t geom_gap(fx a, fx b)
{
    return a > b ? (uint32_t)a - (uint32_t)b : (uint32_t)b - (uint32_t)a;
}

/* Returns whether two points are at most r apart. For circles r is the sum of the radii. Valid for every input;
 * contains no branches. */
static inline bool geom_circles(fx x1, fx y1, fx x2, fx y2, fx r)
{
    uint64_t dx = geom_gap(x1, x2), dy = geom_gap(y1, y2), limit = (uint64_t)(int64_t)r;

    return (r >= 0) & (dx <= limit) & (dy <= limit) & (dx * dx + dy * dy <= limit * limit);
}

/* Returns whether two boxes, given by their centres and half extents, touch. Valid for every input. */
static inline bool geom_boxes(fx x1, fx y1, fx hw1, fx hh1, fx x2, fx y2, fx hw2, fx hh2)
{
    uint32_t dx = geom_gap(x1, x2), dy = geom_gap(y1, y2);
    uint32_t w = (uint32_t)hw1 + (uint32_t)hw2, h = (uint32_t)hh1 + (uint32_t)hh2;

    return ((hw1 | hh1 | hw2 | hh2) >= 0) & (dx <= w) & (dy <= h);
}

/* Returns whether a circle and a box, given by its centre and half extents, touch. Valid for every input. */
bool geom_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh);

/*
 * Returns whether a point that starts at (dx, dy), relative to the centre of a circle of radius r, and moves in a
 * straight line by (wx, wy) touches the circle anywhere on its path, both ends included. For two moving circles d is
 * the difference of their starts, w the difference of their motions, r the sum of their radii. Exact for |dx|, |dy| <=
 * 2^61, |wx|, |wy| <= 2^31, r <= 2^30.
 */
bool geom_swept_circles(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r);

/*
 * Like geom_swept_circles, but against a box of half extents hw and hh. For two moving boxes hw and hh are the sums of
 * their half extents. Exact for |dx|, |dy| <= 2^61, |wx|, |wy| <= 2^31, hw, hh <= 2^30.
 */
bool geom_swept_boxes(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh);

/*
 * Like geom_swept_boxes, but against a box grown by r with round corners: a moving circle of radius r against a box.
 * Exact for |dx|, |dy| <= 2^61, |wx|, |wy| <= 2^31, r, hw, hh <= 2^30.
 */
bool geom_swept_circle_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh);

/*
 * Like geom_swept_circle_box, but with a bar in place of the point. The bar's middle is at d; it extends by h to one
 * end and by -h to the other, and does not rotate. Tests a moving capsule of radius r against a circle (hw, hh = 0) or
 * a box. Exact for |dx|, |dy| <= 2^60, |wx|, |wy| <= 2^31, |hx|, |hy| <= 2^29, r, hw, hh <= 2^30.
 */
bool geom_swept_capsule(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t r, int64_t hw,
                        int64_t hh);

/*
 * Returns whether two moving capsules touch; d, w and r are as for two moving circles, h and g are the vectors from the
 * middle of each capsule's bar to one of its ends. Exact for |dx|, |dy| <= 2^59, |wx|, |wy| <= 2^31, |hx|, |hy|, |gx|,
 * |gy| <= 2^29, r <= 2^30.
 */
bool geom_swept_capsules(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t gx, int64_t gy,
                         int64_t r);

/* A bar's motion during a frame, relative to the centre of a circle: one end moves straight from (ax, ay) by (ux, uy),
 * the other from (bx, by) by (vx, vy). */
struct geom_bar {
    int64_t ax, ay, ux, uy, bx, by, vx, vy;
};

/*
 * Returns whether the bar, thickened by r, touches the circle's centre during its motion, both ends of the motion
 * included. The area swept is taken to be the quadrilateral formed by the bar's start and end positions and the paths
 * of its two ends; if the quadrilateral crosses itself, both halves. This is the area really swept if the bar does not
 * rotate about one of its own points, and otherwise slightly less: the pivot of such a rotation moves along a short
 * curve, and the sliver between this curve and the sides of the quadrilateral is left out. Exact, in this sense, for
 * |ax|, |ay|, |bx|, |by| <= 2^60, |ux|, |uy|, |vx|, |vy| <= 2^30, a bar no longer than 2^29 on each axis at the start
 * and at the end, and r <= 2^30.
 */
bool geom_swept_bar(const struct geom_bar *bar, int64_t r);

/*
 * Returns whether a capsule, all points within r of the segment from (x1, y1) to (x2, y2), and a circle touch. Exact
 * for coordinates within +-2^30 (16384 pixels) and radii <= 2^29 (8192 pixels).
 */
static inline bool geom_capsule_circle(fx x1, fx y1, fx x2, fx y2, fx r, fx cx, fx cy, fx cr)
{
    return (r | cr) >= 0 &&
           geom_swept_circles((int64_t)x1 - cx, (int64_t)y1 - cy, (int64_t)x2 - x1, (int64_t)y2 - y1, (int64_t)r + cr);
}

#endif
