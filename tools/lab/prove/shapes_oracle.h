/*
 * shapes_oracle.h - what shapes.c compares with: do two shapes touch, in 256-bit integers. Slow, plain, nothing of the
 * engine in it, and by other ways than the engine's: times of entry and quadratic equations instead of normals, unions
 * of boxes and discs instead of nearest points.
 *
 * Largest number: of points that start 2^61 away and move by 2^31, the product of d.d and w.w, 2^187.
 */
#ifndef SHAPES_ORACLE_H
#define SHAPES_ORACLE_H

#include <stdbool.h>
#include <stdint.h>

enum { LIMBS = 8 };

/* Two's complement, modulo 2^256. */
struct wide {
    uint32_t limb[LIMBS]; /* the least significant first */
};

static inline struct wide wide_int(int64_t v)
{
    uint32_t fill = v < 0 ? 0xffffffffu : 0;
    struct wide n = { { (uint32_t)v, (uint32_t)((uint64_t)v >> 32), fill, fill, fill, fill, fill, fill } };

    return n;
}

static inline struct wide wide_add(struct wide a, struct wide b)
{
    uint64_t carry = 0;

    for (int i = 0; i < LIMBS; i++) {
        carry += (uint64_t)a.limb[i] + b.limb[i];
        a.limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static inline struct wide wide_sub(struct wide a, struct wide b)
{
    uint64_t carry = 1;

    for (int i = 0; i < LIMBS; i++) {
        carry += (uint64_t)a.limb[i] + (uint32_t)~b.limb[i];
        a.limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static inline struct wide wide_mul(struct wide a, struct wide b)
{
    struct wide n = { { 0 } };

    for (int i = 0; i < LIMBS; i++) {
        uint64_t carry = 0;

        for (int k = 0; i + k < LIMBS; k++) {
            carry += (uint64_t)a.limb[i] * b.limb[k] + n.limb[i + k];
            n.limb[i + k] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    return n;
}

/* -1, 0 or 1. */
static inline int wide_sign(struct wide a)
{
    uint32_t any = 0;

    for (int i = 0; i < LIMBS; i++)
        any |= a.limb[i];
    return a.limb[LIMBS - 1] >> 31 ? -1 : any != 0;
}

static inline bool wide_at_most(struct wide a, struct wide b)
{
    return wide_sign(wide_sub(a, b)) <= 0;
}

/* a * b for numbers of 64 bits: as wide_mul, with fewer steps. */
static inline struct wide wide_product(int64_t a, int64_t b)
{
    uint64_t ua = a < 0 ? 0 - (uint64_t)a : (uint64_t)a, ub = b < 0 ? 0 - (uint64_t)b : (uint64_t)b;
    uint64_t al = (uint32_t)ua, ah = ua >> 32, bl = (uint32_t)ub, bh = ub >> 32;
    uint64_t low = al * bl, mid = ah * bl + (low >> 32), mid2 = al * bh + (uint32_t)mid;
    uint64_t high = ah * bh + (mid >> 32) + (mid2 >> 32);
    struct wide n = { { (uint32_t)low, (uint32_t)mid2, (uint32_t)high, (uint32_t)(high >> 32) } };

    return (a < 0) != (b < 0) ? wide_sub(wide_int(0), n) : n;
}

/* x^2 + y^2 */
static inline struct wide wide_squares(int64_t x, int64_t y)
{
    return wide_add(wide_product(x, x), wide_product(y, y));
}

static inline bool oracle_disc(int64_t x, int64_t y, int64_t r)
{
    return r >= 0 && wide_at_most(wide_squares(x, y), wide_product(r, r));
}

/* A point and a box. */
static inline bool oracle_box(int64_t x, int64_t y, int64_t hw, int64_t hh)
{
    return -hw <= x && x <= hw && -hh <= y && y <= hh;
}

/* Two boxes, by their edges. */
static inline bool oracle_boxes(const int64_t a[4], const int64_t b[4])
{
    if (a[2] < 0 || a[3] < 0 || b[2] < 0 || b[3] < 0)
        return false;
    return a[0] - a[2] <= b[0] + b[2] && b[0] - b[2] <= a[0] + a[2] && a[1] - a[3] <= b[1] + b[3] &&
           b[1] - b[3] <= a[1] + a[3];
}

/* A box with round corners is a wider box, a higher box and four discs. */
static inline bool oracle_round_box(int64_t x, int64_t y, int64_t r, int64_t hw, int64_t hh)
{
    if (r < 0 || hw < 0 || hh < 0)
        return false;
    return oracle_box(x, y, hw + r, hh) || oracle_box(x, y, hw, hh + r) || oracle_disc(x - hw, y - hh, r) ||
           oracle_disc(x - hw, y + hh, r) || oracle_disc(x + hw, y - hh, r) || oracle_disc(x + hw, y + hh, r);
}

/*
 * |d + s w|^2 - r^2 = a s^2 + 2 b s + c is <= 0 somewhere in 0 <= s <= 1: at an end, or at its lowest point, if that is
 * inside, where it is c - b^2 / a.
 */
static inline bool oracle_swept_disc(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    if (r < 0)
        return false;

    struct wide c = wide_sub(wide_squares(dx, dy), wide_product(r, r));

    if (wide_sign(c) <= 0)
        return true;

    struct wide b = wide_add(wide_product(dx, wx), wide_product(dy, wy));

    if (wide_sign(b) >= 0)
        return false; /* it moves away */

    struct wide a = wide_squares(wx, wy), end = wide_add(wide_add(a, b), wide_add(b, c));

    if (wide_sign(end) <= 0)
        return true;
    if (wide_sign(wide_add(a, b)) <= 0)
        return false; /* it comes nearer to the last */
    return wide_at_most(wide_mul(a, c), wide_mul(b, b));
}

/* A time, n / d with d > 0. */
struct moment {
    int64_t n, d;
};

static inline bool moment_at_most(struct moment a, struct moment b)
{
    return wide_at_most(wide_product(a.n, b.d), wide_product(b.n, a.d));
}

/* When is d + s w in -h..h? False: never. */
static inline bool oracle_slab(int64_t d, int64_t w, int64_t h, struct moment *from, struct moment *to)
{
    struct moment in = { w > 0 ? -h - d : d - h, w > 0 ? w : -w }, out = { w > 0 ? h - d : d + h, in.d };

    if (w == 0)
        return -h <= d && d <= h;
    if (!moment_at_most(in, *from))
        *from = in;
    if (!moment_at_most(*to, out))
        *to = out;
    return true;
}

/* The path is in the columns of the box and in its rows at one time. */
static inline bool oracle_swept_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh)
{
    struct moment from = { 0, 1 }, to = { 1, 1 };

    if (hw < 0 || hh < 0)
        return false;
    return oracle_slab(dx, wx, hw, &from, &to) && oracle_slab(dy, wy, hh, &from, &to) && moment_at_most(from, to);
}

static inline bool oracle_swept_round_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw,
                                          int64_t hh)
{
    if (r < 0 || hw < 0 || hh < 0)
        return false;
    return oracle_swept_box(dx, dy, wx, wy, hw + r, hh) || oracle_swept_box(dx, dy, wx, wy, hw, hh + r) ||
           oracle_swept_disc(dx - hw, dy - hh, wx, wy, r) || oracle_swept_disc(dx - hw, dy + hh, wx, wy, r) ||
           oracle_swept_disc(dx + hw, dy - hh, wx, wy, r) || oracle_swept_disc(dx + hw, dy + hh, wx, wy, r);
}

/* a x b */
static inline struct wide wide_cross(int64_t ax, int64_t ay, int64_t bx, int64_t by)
{
    return wide_sub(wide_product(ax, by), wide_product(ay, bx));
}

/* 0 <= n <= d, or the same with both signs turned. */
static inline bool oracle_share(struct wide n, struct wide d)
{
    struct wide none = wide_int(0);

    return wide_sign(d) > 0 ? wide_sign(n) >= 0 && wide_at_most(n, d)
                            : wide_sign(d) < 0 && wide_at_most(n, none) && wide_at_most(d, n);
}

/* Is (x, y) = s u + t v for shares s and t, the two not being parallel? By Cramer's rule. */
static inline bool oracle_in_parallelogram(int64_t x, int64_t y, int64_t ux, int64_t uy, int64_t vx, int64_t vy)
{
    struct wide d = wide_cross(ux, uy, vx, vy);

    return oracle_share(wide_cross(x, y, vx, vy), d) && oracle_share(wide_cross(ux, uy, x, y), d);
}

/* One of the four sides of what the bar sweeps touches the box, or the box lies in its midst, a corner of it too. */
static inline bool oracle_swept_bar(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t r,
                                    int64_t hw, int64_t hh)
{
    if (r < 0 || hw < 0 || hh < 0)
        return false;
    for (int end = -1; end <= 1; end += 2)
        if (oracle_swept_round_box(dx + end * hx, dy + end * hy, wx, wy, r, hw, hh) ||
            oracle_swept_round_box(dx + (end > 0 ? wx : 0) - hx, dy + (end > 0 ? wy : 0) - hy, 2 * hx, 2 * hy, r, hw,
                                   hh))
            return true;
    return oracle_in_parallelogram(hw - (dx - hx), hh - (dy - hy), 2 * hx, 2 * hy, wx, wy);
}

/* |c x u| <= |u x v1| + |u x v2| */
static inline bool oracle_across(const int64_t c[2], const int64_t u[2], const int64_t v1[2], const int64_t v2[2])
{
    const int64_t *v[3] = { c, v1, v2 };
    struct wide size[3];

    for (int i = 0; i < 3; i++) {
        size[i] = wide_cross(u[0], u[1], v[i][0], v[i][1]);
        size[i] = wide_sign(size[i]) < 0 ? wide_sub(wide_int(0), size[i]) : size[i];
    }
    return wide_at_most(size[0], wide_add(size[1], size[2]));
}

/*
 * The hexagon that two bars and a way add up to: a side of it is the way or a bar, at one end of each of the other two.
 * Of these twelve one touches the disc, or the disc's centre is inside, which no line parallel to a side denies.
 */
static inline bool oracle_swept_bars(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hx, int64_t hy, int64_t gx,
                                     int64_t gy, int64_t r)
{
    const int64_t c[2] = { 2 * dx + wx, 2 * dy + wy }, w[2] = { wx, wy };
    const int64_t h[2] = { 2 * hx, 2 * hy }, g[2] = { 2 * gx, 2 * gy };

    if (r < 0)
        return false;
    for (int k = 0; k < 4; k++) {
        int64_t a = k & 1 ? 1 : -1, b = k & 2 ? 1 : -1, end = k & 2 ? 1 : 0;
        if (oracle_swept_disc(dx + a * hx + b * gx, dy + a * hy + b * gy, wx, wy, r) ||
            oracle_swept_disc(dx + a * gx - hx + end * wx, dy + a * gy - hy + end * wy, h[0], h[1], r) ||
            oracle_swept_disc(dx + a * hx - gx + end * wx, dy + a * hy - gy + end * wy, g[0], g[1], r))
            return true;
    }
    bool flat = wide_sign(wide_cross(w[0], w[1], h[0], h[1])) == 0 &&
                wide_sign(wide_cross(w[0], w[1], g[0], g[1])) == 0 &&
                wide_sign(wide_cross(h[0], h[1], g[0], g[1])) == 0;
    return !flat && oracle_across(c, w, h, g) && oracle_across(c, h, w, g) && oracle_across(c, g, w, h);
}

/* Which way is it round the triangle of the origin, p and q: 1, -1, or 0 where they lie on a line? */
static inline int oracle_turn(const int64_t p[2], const int64_t q[2])
{
    return wide_sign(wide_cross(p[0], p[1], q[0], q[1]));
}

/* Is the origin, which is on their line, between p and q? */
static inline bool oracle_between(const int64_t p[2], const int64_t q[2])
{
    return wide_sign(wide_add(wide_product(p[0], q[0]), wide_product(p[1], q[1]))) < 0;
}

/* Is the origin inside of the triangle, not on a side? */
static inline bool oracle_in_triangle(const int64_t p[2], const int64_t q[2], const int64_t r[2])
{
    int turn = oracle_turn(p, q);

    return turn != 0 && turn == oracle_turn(q, r) && turn == oracle_turn(r, p);
}

/*
 * A bar from p[0] to p[1] whose ends go straight to p[3] and p[2], within r of the origin: the four sides, or the
 * origin inside of a triangle of three of the four corners, and not of the one that has the fourth and the same
 * diagonal: a quadrilateral is the two, or where it has a notch or crosses itself, what is in one of them alone. A
 * point on a diagonal is in neither, but seen along the other diagonal.
 */
static inline bool oracle_turned_bar(int64_t p[4][2], int64_t r)
{
    if (r < 0)
        return false;
    for (int k = 0; k < 4; k++) {
        const int64_t *a = p[k], *b = p[(k + 1) % 4];
        if (oracle_swept_disc(a[0], a[1], b[0] - a[0], b[1] - a[1], r))
            return true;
    }
    for (int k = 0; k < 2; k++)
        if (oracle_turn(p[k], p[k + 2]) != 0)
            return oracle_in_triangle(p[k], p[k + 1], p[k + 2]) != oracle_in_triangle(p[k + 2], p[(k + 3) % 4], p[k]);
    /* where the lines of both diagonals meet: inside, if they do between their ends */
    return oracle_between(p[0], p[2]) && oracle_between(p[1], p[3]);
}

#endif
