/*
 * geom.c - exact contact tests.
 *
 * Boxes around the shapes are compared first, as most pairs are far apart. For the remaining pairs squares fit in 64
 * bits, except that a point moving past a circle needs two products of 128 bits. There are no divisions or roots. No
 * signed integer overflows for the inputs that geom.h allows.
 */
#include "geom.h"
#include "int.h"

static uint64_t abs_difference(int64_t a, int64_t b)
{
    return a > b ? (uint64_t)a - (uint64_t)b : (uint64_t)b - (uint64_t)a;
}

/* Returns whether (x, y) is within r of the box with half extents hw and hh around the origin. Requires 0 <= r < 2^31,
 * so that the sum of two squares is below 2^63. */
static bool is_near_box(int64_t x, int64_t y, int64_t r, int64_t hw, int64_t hh)
{
    int64_t ex = int64_abs(x) - hw, ey = int64_abs(y) - hh;

    if (ex > r || ey > r)
        return false;
    ex = ex < 0 ? 0 : ex;
    ey = ey < 0 ? 0 : ey;
    return ex * ex + ey * ey <= r * r;
}

/* Returns whether (x, y) is in the circle of radius r around the origin. */
static bool is_in_circle(int64_t x, int64_t y, int64_t r)
{
    return is_near_box(x, y, r, 0, 0);
}

/* Returns whether the segment from d to d + w, on one axis, comes within r of 0. The segment's middle is d + w/2. */
static bool comes_within(int64_t d, int64_t w, int64_t r)
{
    return int64_abs(2 * d + w) <= int64_abs(w) + 2 * r;
}

/* Returns whether a^2 <= b * c. */
static bool is_square_at_most(uint64_t a, uint64_t b, uint64_t c)
{
    uint64_t left = fx_mul_high(a, a), right = fx_mul_high(b, c);

    return left < right || (left == right && a * a <= b * c);
}

bool geom_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh)
{
    return (r | hw | hh) >= 0 && is_near_box((int64_t)cx - bx, (int64_t)cy - by, r, hw, hh);
}

/*
 * The nearest point of the path is its start when d.w >= 0, its end when -d.w >= w.w, and otherwise the foot of the
 * perpendicular from the centre, |d x w| / |w| away.
 *
 * After the box test, |d| <= |w| + r < 2^31.6 on each axis, so each product is below 2^62.6. A sum of two products that
 * is known to be positive is therefore correct as a uint64_t.
 */
bool geom_swept_circles(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    if (!comes_within(dx, wx, r) || !comes_within(dy, wy, r) || r < 0)
        return false;

    int64_t px = -dx * wx, py = -dy * wy;
    uint64_t dot = (uint64_t)px + (uint64_t)py, ww = (uint64_t)(wx * wx) + (uint64_t)(wy * wy);

    if (px <= -py)
        return is_in_circle(dx, dy, r);
    if (dot >= ww)
        return is_in_circle(dx + wx, dy + wy, r);
    return is_square_at_most(abs_difference(dx * wy, dy * wx), (uint64_t)(r * r), ww);
}

/*
 * Two convex shapes are apart if and only if they are separated by a line parallel to a side of one of them: here to a
 * side of the box, or to the path. Perpendicular to the path, the box extends from its centre as far as its outermost
 * corner. The products are below 2^62.6, as in geom_swept_circles.
 */
bool geom_swept_boxes(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh)
{
    if (!comes_within(dx, wx, hw) || !comes_within(dy, wy, hh) || (hw | hh) < 0)
        return false;
    return abs_difference(dx * wy, dy * wx) <= (uint64_t)(hw * int64_abs(wy) + hh * int64_abs(wx));
}

/*
 * If the path and the box do not meet, the nearest point is an end of the path or one of the two corners of the box
 * that are outermost perpendicular to the path. If w points to the lower right, these are the upper right and the lower
 * left corner.
 */
bool geom_swept_circle_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    if (!comes_within(dx, wx, hw + r) || !comes_within(dy, wy, hh + r) || (r | hw | hh) < 0)
        return false;
    if (is_near_box(dx, dy, r, hw, hh) || is_near_box(dx + wx, dy + wy, r, hw, hh) ||
        geom_swept_boxes(dx, dy, wx, wy, hw, hh))
        return true;

    int64_t cy = (wx ^ wy) < 0 ? hh : -hh;

    return geom_swept_circles(dx - hw, dy - cy, wx, wy, r) || geom_swept_circles(dx + hw, dy + cy, wx, wy, r);
}

/*
 * Returns whether the origin is inside the parallelogram that a moving bar sweeps. If the origin is outside, a line
 * parallel to one of the sides separates the two (see geom_swept_boxes). 2d + w is twice the vector to the
 * parallelogram's centre. If the sides are parallel or one has length 0, the lines do not suffice, and the box test
 * decides.
 *
 * After the box test, |d| < 2^31.4 and |2d + w| < 2^31.6 on each axis, so the products are below 2^62.4.
 */
static bool bar_covers_origin(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy)
{
    int64_t mx = 2 * dx + wx, my = 2 * dy + wy;
    uint64_t area = abs_difference(hx * wy, hy * wx);

    return comes_within(dx, wx, int64_abs(hx)) && comes_within(dy, wy, int64_abs(hy)) &&
           abs_difference(dx * wy, dy * wx) <= area && abs_difference(mx * hy, my * hx) <= area;
}

/* Returns whether a circle of radius r that moves along one side of the parallelogram touches the box with half extents
 * hw and hh around the origin, or the origin itself if hw = hh = 0. */
static bool side_touches(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    return hw | hh ? geom_swept_circle_box(dx, dy, wx, wy, r, hw, hh) : geom_swept_circles(dx, dy, wx, wy, r);
}

/*
 * If the parallelogram and the box do not meet, one of the parallelogram's four sides is nearest to the box. If they
 * meet but none of the sides meets the box, the box is inside the parallelogram, and so is the box's middle.
 */
bool geom_swept_capsule(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t r, int64_t hw,
                        int64_t hh)
{
    if ((r | hw | hh) < 0 || !comes_within(dx, wx, int64_abs(hx) + hw + r) ||
        !comes_within(dy, wy, int64_abs(hy) + hh + r))
        return false;
    return side_touches(dx - hx, dy - hy, wx, wy, r, hw, hh) || side_touches(dx + hx, dy + hy, wx, wy, r, hw, hh) ||
           side_touches(dx - hx, dy - hy, 2 * hx, 2 * hy, r, hw, hh) ||
           side_touches(dx + wx - hx, dy + wy - hy, 2 * hx, 2 * hy, r, hw, hh) ||
           bar_covers_origin(dx, dy, wx, wy, hx, hy);
}

/*
 * The Minkowski sum of two bars and a path is a hexagon. It is tiled by three parallelograms, each spanned by two of
 * these three segments. So the hexagon is the union of six parallelograms: for each two of the segments, one at either
 * end of the third segment.
 */
bool geom_swept_capsules(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t gx, int64_t gy,
                         int64_t r)
{
    return geom_swept_capsule(dx - gx, dy - gy, wx, wy, hx, hy, r, 0, 0) ||
           geom_swept_capsule(dx + gx, dy + gy, wx, wy, hx, hy, r, 0, 0) ||
           geom_swept_capsule(dx - hx, dy - hy, wx, wy, gx, gy, r, 0, 0) ||
           geom_swept_capsule(dx + hx, dy + hy, wx, wy, gx, gy, r, 0, 0) ||
           geom_swept_capsule(dx - gx, dy - gy, 2 * gx, 2 * gy, hx, hy, r, 0, 0) ||
           geom_swept_capsule(dx + wx - gx, dy + wy - gy, 2 * gx, 2 * gy, hx, hy, r, 0, 0);
}

static bool are_all_beyond(int64_t a, int64_t b, int64_t c, int64_t d, int64_t r)
{
    return (a > r && b > r && c > r && d > r) || (a < -r && b < -r && c < -r && d < -r);
}

/* Returns what the segment from p to q adds to the winding number about the origin: 1 if the segment crosses,
 * downwards, the ray that extends from the origin to the right; -1 if it crosses the ray upwards; otherwise 0. A
 * comparison of two products determines on which side of the segment the origin is; the callers' products are below
 * 2^63. */
static int winding_step(int64_t px, int64_t py, int64_t qx, int64_t qy)
{
    if ((py <= 0) == (qy <= 0))
        return 0;
    if (py <= 0)
        return px * qy > qx * py;
    return -(px * qy < qx * py);
}

/*
 * Tests the four sides of the quadrilateral, and whether the origin is inside. After the box test a corner is no
 * further than 2^31.4 from the origin on each axis, so the products are below 2^62.8.
 */
bool geom_swept_bar(const struct geom_bar *b, int64_t r)
{
    const int64_t cx = b->ax + b->ux, cy = b->ay + b->uy, dx = b->bx + b->vx, dy = b->by + b->vy;

    if (r < 0 || are_all_beyond(b->ax, b->bx, cx, dx, r) || are_all_beyond(b->ay, b->by, cy, dy, r))
        return false;
    return geom_swept_circles(b->ax, b->ay, b->bx - b->ax, b->by - b->ay, r) ||
           geom_swept_circles(cx, cy, dx - cx, dy - cy, r) || geom_swept_circles(b->ax, b->ay, b->ux, b->uy, r) ||
           geom_swept_circles(b->bx, b->by, b->vx, b->vy, r) ||
           winding_step(b->ax, b->ay, b->bx, b->by) + winding_step(b->bx, b->by, dx, dy) +
               winding_step(dx, dy, cx, cy) + winding_step(cx, cy, b->ax, b->ay);
}
