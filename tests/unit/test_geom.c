/*
 * test_geom.c - contact tests against 384-bit integers, on lattices, at random and at the ends. tests/machine/shapes.sh
 * tries many more cases around contact.
 */
#include "../../src/base/geom.h"
#include "../../src/base/rng.h"
#include "big.h"

#include "../test.h"

enum { RUNS = 20000 };

/* a * b - c * d */
static struct big minors(struct big a, struct big b, struct big c, struct big d)
{
    return big_sub(big_mul(a, b), big_mul(c, d));
}

static struct big squares(struct big x, struct big y)
{
    return big_add(big_mul(x, x), big_mul(y, y));
}

/* How far v lies outside -h..h. */
static struct big outside(int64_t v, int64_t h)
{
    return big_int(v < -h ? -h - v : v > h ? v - h : 0);
}

/* Is the point (x, y) within r of the box, or, without extents, of the origin? */
static bool near_box(int64_t x, int64_t y, int64_t r, int64_t hw, int64_t hh)
{
    return big_compare(squares(outside(x, hw), outside(y, hh)), squares(big_int(r), big_int(0))) <= 0;
}

/*
 * |d + s w|^2 - r^2 = a s^2 + 2 b s + c is <= 0 somewhere in 0 <= s <= 1: at an end, or at its lowest point, if that is
 * inside, where it is c - b^2 / a.
 */
static bool swept_circles(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    struct big DX = big_int(dx), DY = big_int(dy), WX = big_int(wx), WY = big_int(wy);
    struct big a = squares(WX, WY), b = big_add(big_mul(DX, WX), big_mul(DY, WY));
    struct big c = big_sub(squares(DX, DY), squares(big_int(r), big_int(0)));
    struct big end = big_add(big_add(a, b), big_add(b, c));

    if (big_sign(c) <= 0 || big_sign(end) <= 0)
        return true;
    return big_sign(b) < 0 && big_compare(big_neg(b), a) < 0 && big_sign(minors(b, b, a, c)) >= 0;
}

/* No axis separates the path from the box: not x, not y, and not the path's normal. */
static bool path_meets_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t hw, int64_t hh)
{
    int below = 0, above = 0;

    if ((dx < -hw && dx + wx < -hw) || (dx > hw && dx + wx > hw))
        return false;
    if ((dy < -hh && dy + wy < -hh) || (dy > hh && dy + wy > hh))
        return false;
    for (int k = 0; k < 4; k++) {
        struct big x = big_int((k & 1 ? hw : -hw) - dx), y = big_int((k & 2 ? hh : -hh) - dy);
        int sign = big_sign(minors(x, big_int(wy), y, big_int(wx)));

        below += sign < 0;
        above += sign > 0;
    }
    return below < 4 && above < 4;
}

/* Two convex shapes meet, or they are nearest at a corner of one: an end of the path or a corner of the box. */
static bool swept_circle_box(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    if (near_box(dx, dy, r, hw, hh) || near_box(dx + wx, dy + wy, r, hw, hh))
        return true;
    for (int k = 0; k < 4; k++)
        if (swept_circles(dx + (k & 1 ? hw : -hw), dy + (k & 2 ? hh : -hh), wx, wy, r))
            return true;
    return path_meets_box(dx, dy, wx, wy, hw, hh);
}

/* Counts both answers: a test of which one never comes up tests nothing. */
static int seen[2];

static void check(bool hit, bool want)
{
    assert_int_equal(hit, want);
    seen[hit]++;
}

static void check_circles(fx x1, fx y1, fx x2, fx y2, fx r)
{
    check(geom_circles(x1, y1, x2, y2, r), near_box((int64_t)x1 - x2, (int64_t)y1 - y2, r, 0, 0));
}

static void check_boxes(fx x1, fx y1, fx hw1, fx hh1, fx x2, fx y2, fx hw2, fx hh2)
{
    int64_t l1 = (int64_t)x1 - hw1, r1 = (int64_t)x1 + hw1, t1 = (int64_t)y1 - hh1, b1 = (int64_t)y1 + hh1;
    int64_t l2 = (int64_t)x2 - hw2, r2 = (int64_t)x2 + hw2, t2 = (int64_t)y2 - hh2, b2 = (int64_t)y2 + hh2;

    check(geom_boxes(x1, y1, hw1, hh1, x2, y2, hw2, hh2), l1 <= r2 && l2 <= r1 && t1 <= b2 && t2 <= b1);
}

static void check_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh)
{
    check(geom_circle_box(cx, cy, r, bx, by, hw, hh), near_box((int64_t)cx - bx, (int64_t)cy - by, r, hw, hh));
}

static void check_swept(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    check(geom_swept_circle_box(dx, dy, wx, wy, r, hw, hh), swept_circle_box(dx, dy, wx, wy, r, hw, hh));
    check(geom_swept_circles(dx, dy, wx, wy, r), swept_circles(dx, dy, wx, wy, r));
    check(geom_swept_boxes(dx, dy, wx, wy, hw, hh), path_meets_box(dx, dy, wx, wy, hw, hh));
}

static void check_capsule(fx x1, fx y1, fx x2, fx y2, fx r, fx cx, fx cy, fx cr)
{
    check(geom_capsule_circle(x1, y1, x2, y2, r, cx, cy, cr),
          swept_circles((int64_t)x1 - cx, (int64_t)y1 - cy, (int64_t)x2 - x1, (int64_t)y2 - y1, (int64_t)r + cr));
}

/* A test that starts with this ends with both_seen. */
static void start(struct rng *r, uint64_t seed)
{
    rng_seed(r, seed);
    seen[0] = seen[1] = 0;
}

static void both_seen(void)
{
    assert_true(seen[0] > RUNS / 20 && seen[1] > RUNS / 20);
}

static int64_t between(struct rng *r, int64_t low, int64_t high)
{
    return low + (int64_t)rng_below(r, (uint64_t)(high - low) + 1);
}

/* A coordinate, often at an end. */
static fx place(struct rng *r)
{
    static const fx END[] = { FX_MIN, FX_MIN + 1, -1, 0, 1, FX_MAX - 1, FX_MAX };
    uint64_t v = rng_next(r);

    return v % 4 ? (fx)((int64_t)v >> 32 >> (v >> 8) % 31) : END[(v >> 8) % 7];
}

/* A length >= 0. */
static fx length(struct rng *r)
{
    return place(r) & FX_MAX;
}

TEST(still_shapes)
{
    struct rng r;

    start(&r, 1);
    for (int i = 0; i < RUNS; i++) {
        fx x1 = place(&r), y1 = place(&r), x2 = place(&r), y2 = place(&r), a = length(&r), b = length(&r);

        check_circles(x1, y1, x2, y2, a);
        check_boxes(x1, y1, a, b, x2, y2, length(&r), length(&r));
        check_circle_box(x1, y1, length(&r), x2, y2, a, b);
    }
    both_seen();
}

/* On all small lattices, where touching is frequent. */
TEST(still_lattice)
{
    struct rng r;

    start(&r, 2);
    for (fx x = -9; x <= 9; x++)
        for (fx y = -9; y <= 9; y++)
            for (fx a = 0; a < 5; a++)
                for (fx b = 0; b < 5; b++) {
                    check_circles(x, y, 1, -1, a + b);
                    check_boxes(x, y, a, b, 1, -1, b, 1);
                    check_circle_box(x, y, a + b, 1, -1, a, b);
                }
    both_seen();
}

TEST(negative_sizes)
{
    assert_false(geom_circles(3, 4, 3, 4, -1));
    assert_false(geom_boxes(0, 0, -1, 5, 0, 0, 5, 5));
    assert_false(geom_boxes(0, 0, 5, 5, 0, 0, 5, -1));
    assert_false(geom_circle_box(0, 0, -1, 0, 0, 5, 5));
    assert_false(geom_circle_box(0, 0, 5, 0, 0, -1, 5));
    assert_false(geom_circle_box(0, 0, 5, 0, 0, 5, -1));
    assert_false(geom_swept_circles(-5, -5, 10, 10, -1));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, -1, 5, 5));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, 5, -1, 5));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, 5, 5, -1));
    assert_false(geom_swept_boxes(-5, -5, 10, 10, -1, 5));
    assert_false(geom_swept_boxes(-5, -5, 10, 10, 5, -1));
    assert_false(geom_capsule_circle(0, 0, 9, 9, -1, 5, 5, 5));
    assert_false(geom_capsule_circle(0, 0, 9, 9, 5, 5, 5, -1));
    assert_false(geom_capsule_circle(0, 0, 0, 0, FX_MIN, 0, 0, FX_MAX));
}

TEST(swept_lattice)
{
    struct rng r;

    start(&r, 4);
    for (int dx = -6; dx <= 6; dx++)
        for (int dy = -6; dy <= 6; dy++)
            for (int wx = -5; wx <= 5; wx++)
                for (int wy = -5; wy <= 5; wy++)
                    check_swept(dx, dy, wx, wy, (dx + 2 * wy) & 3, (dy + wx) & 1, (dy + wy) % 3 ? 0 : 2);
    both_seen();
}

TEST(swept_random)
{
    struct rng r;

    start(&r, 5);
    for (int i = 0; i < RUNS; i++) {
        int bits = (int)between(&r, 1, 31);
        int64_t w = (int64_t)1 << bits, size = w / 2;
        int64_t wx = between(&r, -w, w), wy = between(&r, -w, w), dx = between(&r, -2 * w, 2 * w);
        int64_t dy = i % 3 ? dx * wy / (wx ? wx : 1) + between(&r, -size, size) : between(&r, -2 * w, 2 * w);

        dy = dy > 2 * w ? 2 * w : dy < -2 * w ? -2 * w : dy;
        check_swept(dx, dy, wx, wy, between(&r, 0, size), between(&r, 0, size), between(&r, 0, size));
    }
    both_seen();
}

/* All combinations of the ends of the domain. */
TEST(swept_extremes)
{
    static const int64_t UNIT = 1 << 30;
    struct rng r;

    start(&r, 6);
    for (int i = 0; i < RUNS; i++) {
        int64_t dx = between(&r, -4, 4) * UNIT + between(&r, -1, 1), wx = between(&r, -2, 2) * UNIT;
        int64_t dy = between(&r, -4, 4) * UNIT + between(&r, -1, 1), wy = between(&r, -2, 2) * UNIT;

        check_swept(dx, dy, wx, wy, between(&r, 0, 1) * UNIT, between(&r, 0, 1) * UNIT, between(&r, 0, 1) * UNIT);
    }
    both_seen();
    assert_false(geom_swept_circles(8 * UNIT + 5, 0, -2 * UNIT, 0, UNIT)); /* products that pass 2^63 */
    assert_false(geom_swept_circles((int64_t)1 << 61, (int64_t)1 << 61, -2 * UNIT, -2 * UNIT, UNIT));
    assert_false(geom_swept_circle_box(-((int64_t)1 << 61), (int64_t)1 << 61, 2 * UNIT, -2 * UNIT, UNIT, UNIT, UNIT));
    assert_false(geom_swept_boxes((int64_t)1 << 61, -((int64_t)1 << 61), -2 * UNIT, 2 * UNIT, UNIT, UNIT));
}

/* The world's ends and beyond: 2^30 is 16384 pixels, the largest radius half of it. */
TEST(capsules)
{
    static const fx END = 1 << 30;
    struct rng r;

    start(&r, 9);
    for (int i = 0; i < RUNS; i++) {
        int bits = (int)between(&r, 1, 30);
        int64_t size = (int64_t)1 << bits, radius = size / 2;

        check_capsule((fx)between(&r, -size, size), (fx)between(&r, -size, size), (fx)between(&r, -size, size),
                      (fx)between(&r, -size, size), (fx)between(&r, 0, radius), (fx)between(&r, -size, size),
                      (fx)between(&r, -size, size), (fx)between(&r, 0, radius));
        check_capsule((fx)between(&r, -1, 1) * END, (fx)between(&r, -1, 1) * END, (fx)between(&r, -1, 1) * END,
                      (fx)between(&r, -1, 1) * END, (fx)between(&r, 0, 1) * END / 2, (fx)between(&r, -1, 1) * END,
                      (fx)between(&r, -1, 1) * END, (fx)between(&r, 0, 1) * END / 2);
    }
    both_seen();
}

RUN_TESTS(NULL, NULL)
