/* test_geom.c - contact tests against 384-bit integers, on lattices, at random, at the ends, and around contact. */
#include "../../src/base/geom.h"
#include "../../src/base/rng.h"
#include "big.h"

#include <math.h>
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

static void check_circles(fx x1, fx y1, fx x2, fx y2, fx r)
{
    bool hit = geom_circles(x1, y1, x2, y2, r);

    assert_int_equal(hit, r >= 0 && near_box((int64_t)x1 - x2, (int64_t)y1 - y2, r, 0, 0));
    seen[hit]++;
}

static void check_boxes(fx x1, fx y1, fx hw1, fx hh1, fx x2, fx y2, fx hw2, fx hh2)
{
    bool hit = geom_boxes(x1, y1, hw1, hh1, x2, y2, hw2, hh2);
    int64_t l1 = (int64_t)x1 - hw1, r1 = (int64_t)x1 + hw1, t1 = (int64_t)y1 - hh1, b1 = (int64_t)y1 + hh1;
    int64_t l2 = (int64_t)x2 - hw2, r2 = (int64_t)x2 + hw2, t2 = (int64_t)y2 - hh2, b2 = (int64_t)y2 + hh2;

    assert_int_equal(hit, l1 <= r2 && l2 <= r1 && t1 <= b2 && t2 <= b1);
    seen[hit]++;
}

static void check_circle_box(fx cx, fx cy, fx r, fx bx, fx by, fx hw, fx hh)
{
    bool hit = geom_circle_box(cx, cy, r, bx, by, hw, hh);

    assert_int_equal(hit, near_box((int64_t)cx - bx, (int64_t)cy - by, r, hw, hh));
    seen[hit]++;
}

static void check_swept(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r, int64_t hw, int64_t hh)
{
    bool hit = geom_swept_circle_box(dx, dy, wx, wy, r, hw, hh);

    assert_int_equal(hit, swept_circle_box(dx, dy, wx, wy, r, hw, hh));
    seen[hit]++;
    hit = geom_swept_circles(dx, dy, wx, wy, r);
    assert_int_equal(hit, swept_circles(dx, dy, wx, wy, r));
    seen[hit]++;
    hit = geom_swept_boxes(dx, dy, wx, wy, hw, hh);
    assert_int_equal(hit, path_meets_box(dx, dy, wx, wy, hw, hh));
    seen[hit]++;
}

static void check_capsule(fx x1, fx y1, fx x2, fx y2, fx r, fx cx, fx cy, fx cr)
{
    bool hit = geom_capsule_circle(x1, y1, x2, y2, r, cx, cy, cr);

    assert_int_equal(
        hit, swept_circles((int64_t)x1 - cx, (int64_t)y1 - cy, (int64_t)x2 - x1, (int64_t)y2 - y1, (int64_t)r + cr));
    seen[hit]++;
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
    check_circles(FX_MIN, FX_MIN, FX_MAX, FX_MAX, FX_MAX);
    check_boxes(FX_MIN, FX_MIN, FX_MAX, FX_MAX, FX_MAX, FX_MAX, FX_MAX, FX_MAX);
    check_circle_box(FX_MIN, FX_MIN, FX_MAX, FX_MAX, FX_MAX, FX_MAX, FX_MAX);
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

/* The rim: y as the square root gives it, and two units either way. */
TEST(still_contact)
{
    struct rng r;

    start(&r, 3);
    for (int i = 0; i < RUNS; i++) {
        fx radius = length(&r), x = (fx)between(&r, 0, radius), hw = length(&r) >> 2, hh = length(&r) >> 2;
        int64_t y = (int64_t)sqrt(((double)radius - x) * ((double)radius + x)) + between(&r, -2, 2);
        bool left = i & 1, up = i & 2;

        if (y > FX_MAX)
            continue;
        check_circles(left ? x : 0, up ? (fx)y : 0, left ? 0 : x, up ? 0 : (fx)y, radius);
        if ((int64_t)x + hw <= FX_MAX && y + hh <= FX_MAX)
            check_circle_box(left ? -x - hw : x + hw, up ? (fx)-y - hh : (fx)y + hh, radius, 0, 0, hw, hh);
    }
    both_seen();
}

TEST(negative_sizes)
{
    assert_true(geom_circles(3, 4, 3, 4, 0));
    assert_true(geom_circles(FX_MIN, 0, -1, 0, FX_MAX));
    assert_false(geom_circles(FX_MIN, 0, 0, 0, FX_MAX));
    assert_false(geom_circles(3, 4, 3, 4, -1));
    assert_false(geom_boxes(0, 0, -1, 5, 0, 0, 5, 5));
    assert_false(geom_boxes(0, 0, 5, 5, 0, 0, 5, -1));
    assert_false(geom_circle_box(0, 0, -1, 0, 0, 5, 5));
    assert_false(geom_circle_box(0, 0, 5, 0, 0, -1, 5));
    assert_false(geom_circle_box(0, 0, 5, 0, 0, 5, -1));
    assert_false(geom_swept_circles(0, 0, 1, 1, -1));
    assert_false(geom_swept_circles(-5, -5, 10, 10, -1));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, -1, 5, 5));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, 5, -1, 5));
    assert_false(geom_swept_circle_box(0, 0, 1, 1, 5, 5, -1));
    assert_true(geom_swept_boxes(0, 0, 0, 0, 0, 0));
    assert_false(geom_swept_boxes(0, 0, 9, 9, -1, 5));
    assert_false(geom_swept_boxes(-5, -5, 10, 10, 5, -1));
    assert_true(geom_capsule_circle(3, 4, 3, 4, 0, 3, 4, 0));
    assert_false(geom_capsule_circle(0, 0, 9, 9, -1, 5, 5, 5));
    assert_false(geom_capsule_circle(0, 0, 9, 9, 5, 5, 5, -1));
    assert_false(geom_circles(0, 0, 0, 0, FX_MIN));
    assert_false(geom_boxes(0, 0, FX_MIN, FX_MAX, 0, 0, FX_MAX, FX_MAX));
    assert_false(geom_circle_box(0, 0, FX_MIN, 0, 0, FX_MAX, FX_MAX));
    assert_false(geom_circle_box(0, 0, FX_MAX, 0, 0, FX_MIN, FX_MAX));
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
    assert_true(geom_swept_circles(-2 * UNIT, 0, 2 * UNIT, 0, 0));
    assert_false(geom_swept_circles(-2 * UNIT, 1, 2 * UNIT, 0, 0));
    assert_false(geom_swept_circles(8 * UNIT + 5, 0, -2 * UNIT, 0, UNIT)); /* products that pass 2^63 */
    assert_false(geom_swept_circles(0, 8 * UNIT + 5, 0, -2 * UNIT, UNIT));
    assert_false(geom_swept_circles((int64_t)1 << 61, (int64_t)1 << 61, -2 * UNIT, -2 * UNIT, UNIT));
    assert_false(geom_swept_circle_box(-((int64_t)1 << 61), (int64_t)1 << 61, 2 * UNIT, -2 * UNIT, UNIT, UNIT, UNIT));
    assert_false(geom_swept_boxes((int64_t)1 << 61, -((int64_t)1 << 61), -2 * UNIT, 2 * UNIT, UNIT, UNIT));
}

/*
 * A path laid along a tangent of the circle around a corner (cx, cy), touching it somewhere on the way, and moved up to
 * two units off. Tangents of length 0 touch with an end.
 */
static void check_tangent(struct rng *r, int bits, int64_t hw, int64_t hh, int64_t cx, int64_t cy)
{
    int64_t size = (int64_t)1 << bits, radius = between(r, 0, size / 2);
    int64_t wx = between(r, -size, size), wy = between(r, -size, size);
    double w = sqrt((double)wx * (double)wx + (double)wy * (double)wy), s = (double)between(r, 0, 8) / 8;
    double nx = w > 0 ? (double)wy / w : 1, ny = w > 0 ? -(double)wx / w : 0, side = rng_next(r) & 1 ? 1 : -1;
    int64_t dx = (int64_t)rint(side * nx * (double)radius - s * (double)wx) + between(r, -2, 2);
    int64_t dy = (int64_t)rint(side * ny * (double)radius - s * (double)wy) + between(r, -2, 2);

    check_swept(dx + cx, dy + cy, wx, wy, radius, hw, hh);
    check_swept(dx, dy, wx, wy, radius, 0, 0);
}

TEST(swept_contact)
{
    struct rng r;

    start(&r, 7);
    for (int i = 0; i < RUNS; i++) {
        int bits = (int)between(&r, 2, 31);
        int64_t hw = between(&r, 0, (int64_t)1 << (bits - 1)), hh = between(&r, 0, (int64_t)1 << (bits - 1));

        check_tangent(&r, bits, hw, hh, i & 1 ? hw : -hw, i & 2 ? hh : -hh);
    }
    both_seen();
}

/* Pythagorean paths touch in one exact point, where one unit decides. */
TEST(swept_exact_touch)
{
    static const int64_t K = (1 << 30) / 5;

    for (int64_t k = 1; k <= K; k += k < 50 ? 1 : k) {
        /* The path (4, 3) passes the origin at distance 5k, at (-3k, 4k). */
        assert_true(geom_swept_circles(-3 * k - 4 * k, 4 * k - 3 * k, 8 * k, 6 * k, 5 * k));
        assert_false(geom_swept_circles(-3 * k - 4 * k, 4 * k - 3 * k + 1, 8 * k, 6 * k, 5 * k));
        assert_false(geom_swept_circles(-3 * k - 4 * k, 4 * k - 3 * k, 8 * k, 6 * k, 5 * k - 1));
        /* It ends there, and one step of it before. */
        assert_true(geom_swept_circles(-3 * k - 4 * k, 4 * k - 3 * k, 4 * k, 3 * k, 5 * k));
        assert_false(geom_swept_circles(-3 * k - 4 * k - 4, 4 * k - 3 * k - 3, 4 * k, 3 * k, 5 * k));
        /* The same at the corner (-k, k) of a box. */
        assert_true(geom_swept_circle_box(-8 * k, 2 * k, 8 * k, 6 * k, 5 * k, k, k));
        assert_false(geom_swept_circle_box(-8 * k, 2 * k + 1, 8 * k, 6 * k, 5 * k, k, k));
        /* Past the corner of a plain box, exactly through it and one unit off. */
        assert_true(geom_swept_boxes(-k - 4 * k, k - 3 * k, 8 * k, 6 * k, k, k));
        assert_false(geom_swept_boxes(-k - 4 * k, k - 3 * k + 1, 8 * k, 6 * k, k, k));
        assert_false(geom_swept_boxes(-k - 4 * k, k - 3 * k, 8 * k, 6 * k, k, k - 1));
        assert_false(geom_swept_boxes(-k - 4 * k - 1, k - 3 * k, 4 * k, 3 * k, k, k)); /* it ends before */
        /* And along its side. */
        assert_true(geom_swept_circle_box(-9 * k, 6 * k, 10 * k, 0, 5 * k, 4 * k, k));
        assert_false(geom_swept_circle_box(-9 * k, 6 * k + 1, 10 * k, 0, 5 * k, 4 * k, k));
    }
}

/* A motion seen from the other shape, or in a mirror, touches alike. */
TEST(swept_symmetry)
{
    struct rng r;

    start(&r, 8);
    for (int i = 0; i < RUNS; i++) {
        int64_t dx = between(&r, -900, 900), dy = between(&r, -900, 900), wx = between(&r, -900, 900);
        int64_t wy = between(&r, -900, 900), radius = between(&r, 0, 299), hw = between(&r, 0, 99);
        bool hit = geom_swept_circle_box(dx, dy, wx, wy, radius, hw, 50);

        assert_int_equal(hit, geom_swept_circle_box(-dx, dy, -wx, wy, radius, hw, 50));
        assert_int_equal(hit, geom_swept_circle_box(dx, -dy, wx, -wy, radius, hw, 50));
        assert_int_equal(hit, geom_swept_circle_box(dy, dx, wy, wx, radius, 50, hw));
        assert_int_equal(hit, geom_swept_circle_box(dx + wx, dy + wy, -wx, -wy, radius, hw, 50));
        hit = geom_swept_circles(dx, dy, wx, wy, radius);
        assert_int_equal(hit, geom_swept_circles(dx + wx, dy + wy, -wx, -wy, radius));
        assert_int_equal(hit, geom_swept_circle_box(dx, dy, wx, wy, radius, 0, 0));
        assert_int_equal(geom_swept_boxes(dx, dy, wx, wy, hw, 50), geom_swept_circle_box(dx, dy, wx, wy, 0, hw, 50));
        seen[hit]++;
    }
    both_seen();
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
    /* A beam from (0, 0) to (80, 60), and circles that touch its middle, its end, and neither. */
    assert_true(geom_capsule_circle(0, 0, 80, 60, 10, 40 - 9, 30 + 12, 5));
    assert_false(geom_capsule_circle(0, 0, 80, 60, 10, 40 - 9, 30 + 12, 4));
    assert_true(geom_capsule_circle(0, 0, 80, 60, 10, 80 + 12, 60 + 9, 5));
    assert_false(geom_capsule_circle(0, 0, 80, 60, 10, 80 + 12, 60 + 9, 4));
}

RUN_TESTS(NULL, NULL)
