/*
 * geom.c - exact contact tests.
 * floor: base
 *
 * Boxes around the shapes are compared first, as most pairs are far apart; what is left is small enough for squares in
 * 64 bits, or, for a moving point that passes a circle, two products in 128. Nothing is divided and no root is taken.
 */
#include "geom.h"

/* Is (x, y) in the circle around the origin? */
static bool inside(int64_t x, int64_t y, int64_t r)
{
    if (x > r || x < -r || y > r || y < -r)
        return false;
    return x * x + y * y <= r * r;
}

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

/* Does what runs from d to d + w, on one axis, come within r of 0? Its middle is d + w/2. */
static bool passes(int64_t d, int64_t w, int64_t r)
{
    return magnitude(2 * d + w) <= magnitude(w) + 2 * r;
}

bool geom_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh)
{
    int64_t ex = (int64_t)geom_gap(cx, bx) - hw, ey = (int64_t)geom_gap(cy, by) - hh;

    if (ex > r || ey > r || (r | hw | hh) < 0)
        return false;
    ex = ex < 0 ? 0 : ex;
    ey = ey < 0 ? 0 : ey;
    return (uint64_t)(ex * ex) + (uint64_t)(ey * ey) <= (uint64_t)((int64_t)r * r);
}

/* a^2 <= b * c */
static bool square_at_most(uint64_t a, uint64_t b, uint64_t c)
{
    uint64_t left = fx_mul_high(a, a), right = fx_mul_high(b, c);

    return left < right || (left == right && a * a <= b * c);
}

/*
 * The nearest point of the path is its start when d.w >= 0, its end when -d.w >= w.w, and otherwise the foot of the
 * perpendicular from the centre, |d x w| / |w| away.
 *
 * Past the box test |d| <= |w| + r < 2^31.6 on each axis, so each product is below 2^62.6; a sum of two, known to be
 * positive, is right modulo 2^64.
 */
bool geom_swept_circles(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    if (!passes(dx, wx, r) || !passes(dy, wy, r) || r < 0)
        return false;

    int64_t px = -dx * wx, py = -dy * wy, cx = dx * wy, cy = dy * wx;
    uint64_t along = (uint64_t)px + (uint64_t)py, ww = (uint64_t)(wx * wx) + (uint64_t)(wy * wy);

    if (px <= -py)
        return inside(dx, dy, r);
    if (along >= ww)
        return inside(dx + wx, dy + wy, r);
    return square_at_most(cx > cy ? (uint64_t)cx - (uint64_t)cy : (uint64_t)cy - (uint64_t)cx, (uint64_t)(r * r), ww);
}

/*
 * The same point and a plain box, when wx, wy >= 0 and `passes` holds on both axes. The path misses the box only if it
 * passes a corner on the outside: if it leaves the columns of the box before it enters the rows, or the rows before the
 * columns. The times compared are (W - dx) / wx and such, each over its own speed, so they are multiplied crosswise:
 * below 2^32.6 * 2^31.
 */
static bool swept_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh)
{
    if (!passes(dx, wx, hw) || !passes(dy, wy, hh))
        return false;
    if (dy < -hh && (uint64_t)(hw - dx) * (uint64_t)wy < (uint64_t)(-hh - dy) * (uint64_t)wx)
        return false;
    if (dx < -hw && (uint64_t)(hh - dy) * (uint64_t)wx < (uint64_t)(-hw - dx) * (uint64_t)wy)
        return false;
    return true;
}

/* The grown box is the union of a wider box, a higher box and four discs at the corners. */
bool geom_swept_circle_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    if (!passes(dx, wx, hw + r) || !passes(dy, wy, hh + r) || (r | hw | hh) < 0)
        return false;
    dx = wx < 0 ? -dx : dx; /* in a mirror */
    dy = wy < 0 ? -dy : dy;
    wx = magnitude(wx);
    wy = magnitude(wy);
    return swept_box(dx, dy, wx, wy, hw + r, hh) || swept_box(dx, dy, wx, wy, hw, hh + r) ||
           geom_swept_circles(dx + hw, dy + hh, wx, wy, r) || geom_swept_circles(dx - hw, dy + hh, wx, wy, r) ||
           geom_swept_circles(dx + hw, dy - hh, wx, wy, r) || geom_swept_circles(dx - hw, dy - hh, wx, wy, r);
}
