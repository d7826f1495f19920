/* test_trig.c - angles against Taylor's series in 160-bit fractions, which fold nothing and look nothing up. */
#include "../../src/base/trig.h"
#include "../../src/base/rng.h"
#include "big.h"

#include "../test.h"

enum { Q = 160, RUNS = 4000 };

static struct big times(struct big a, struct big b)
{
    return big_shift_right(big_mul(a, b), Q);
}

/* sin and cos of half / 2^33 turns, in Q160, right to about 150 bits. */
static void oracle(int64_t half, struct big *sine, struct big *cosine)
{
    static const uint32_t PI[] = { 0xa4093822, 0x03707344, 0x13198a2e, 0x85a308d3, 0x243f6a88, 3 };
    struct big x = { { 0 } }, sum[2] = { big_shift_left(big_int(1), Q), { { 0 } } }, term = sum[0];

    for (int i = 0; i < 6; i++)
        x.limb[i] = PI[i];
    half = (int64_t)((uint64_t)half << 31) >> 31; /* half a turn either way */
    x = big_shift_right(big_mul(x, big_int(half)), 32);
    for (int i = 1; i < 60; i++) {
        bool negative;

        term = times(term, x);
        negative = big_negative(term);
        term = big_divide_small(negative ? big_neg(term) : term, (uint32_t)i);
        term = negative ? big_neg(term) : term;
        sum[i & 1] = i & 2 ? big_sub(sum[i & 1], term) : big_add(sum[i & 1], term);
    }
    *cosine = sum[0];
    *sine = sum[1];
}

/* Is r the nearest to v, of which one unit is 2^(Q - bits)? Exact values come out of the oracle a little off. */
static bool nearest(struct big v, int64_t r, int bits)
{
    return big_rounds_to(v, big_shift_left(big_int(1), Q - bits), r, INT64_MIN, INT64_MAX);
}

static void check_angle(ang a)
{
    struct big s, c;

    oracle((int64_t)a * 2, &s, &c);
    assert_true(nearest(s, trig_sin30(a), 30));
    assert_true(nearest(c, trig_cos30(a), 30));
    assert_true(nearest(s, trig_sin(a), 16));
    assert_true(nearest(c, trig_cos(a), 16));
}

/* The angles whose sines or cosines come nearest to halfway between two results. */
static const ang HARD[] = { 0x0ae1ed8e, 0x0c54420f, 0x0c8ce016, 0x0ce62007, 0x13413982,
                            0x1c0795e3, 0x1e3e7558, 0x1e562c91, 0x214dfda9, 0x2263a98a,
                            0x228d03c9, 0x2363354b, 0x2db635ce, 0x2f776f82, 0x34c914ad };

TEST(sines)
{
    struct rng r;

    rng_seed(&r, 1);
    for (uint32_t i = 0; i < sizeof HARD / sizeof HARD[0]; i++)
        for (uint32_t k = 0; k < 4; k++) {
            check_angle(HARD[i] + (k << 30));
            check_angle((k << 30) - HARD[i]);
        }
    for (uint32_t i = 0; i < 16; i++)
        for (uint32_t k = 0; k < 7; k++)
            check_angle((i << 28) + k - 3);
    for (int i = 0; i < RUNS; i++)
        check_angle((ang)(rng_next(&r) >> 32 >> rng_next(&r) % 32));
}

/* > 0 when (x, y) lies clockwise of the ray at half / 2^33 turns. */
static int side(fx x, fx y, int64_t half)
{
    struct big s, c;

    oracle(half, &s, &c);
    return big_compare(big_mul(c, big_int(y)), big_mul(s, big_int(x)));
}

static void check_direction(fx x, fx y)
{
    ang a = trig_atan2(y, x);
    struct big s, c;

    oracle((int64_t)a * 2, &s, &c);
    assert_true(big_sign(big_add(big_mul(c, big_int(x)), big_mul(s, big_int(y)))) > 0);
    if (side(x, y, (int64_t)a * 2 - 1) <= 0 || side(x, y, (int64_t)a * 2 + 1) >= 0)
        fail_msg("atan2(%ld, %ld) = %08x", (long)y, (long)x, (unsigned)a);
}

/* In all eight positions: the first is checked, the others must mirror it. */
static void check_mirrored(fx x, fx y)
{
    ang a = trig_atan2(y, x);

    check_direction(x, y);
    if (x == FX_MIN || y == FX_MIN)
        return;
    assert_int_equal(trig_atan2(-y, -x), a + 0x80000000);
    assert_int_equal(trig_atan2(x, y), 0x40000000 - a);
    assert_int_equal(trig_atan2(x, -y), a + 0x40000000);
    assert_int_equal(trig_atan2(-x, y), a - 0x40000000);
    if (y != 0)
        assert_int_equal(trig_atan2(-y, x), 0 - a);
}

TEST(directions)
{
    static const fx V[] = { 0, 1, 2, 3, 0xffff, FX_ONE, FX_MAX - 1, FX_MAX, FX_MIN, FX_MIN + 1, -1, -FX_ONE };
    enum { N = sizeof V / sizeof V[0] };
    struct rng r;

    rng_seed(&r, 4);
    for (int i = 1; i < N * N; i++)
        check_mirrored(V[i / N], V[i % N]);
    for (int i = 0; i < RUNS; i++) {
        uint64_t v = rng_next(&r);
        fx x = (fx)((int64_t)rng_next(&r) >> 32 >> v % 32), y = (fx)((int64_t)rng_next(&r) >> 32 >> (v >> 8) % 32);

        if (x | y)
            check_mirrored(x, y);
    }
    assert_int_equal(trig_atan2(0, 0), 0);
}

/*
 * The hardest vectors: the convergents of the continued fraction of a slope y / x are nearer to its ray than any other
 * vector as short. Euclid's algorithm on (y, x) makes them.
 */
static void convergents(struct big y, struct big x, void (*check)(fx, fx))
{
    int64_t n0 = 0, d0 = 1, n1 = 1, d1 = 0;

    while (big_sign(x) > 0) {
        struct big rest, q = big_divide(y, x, &rest);
        int64_t n = big_low(q) * n1 + n0, d = big_low(q) * d1 + d0;

        if (big_compare(q, big_int(FX_MAX)) > 0 || d > FX_MAX || n > FX_MAX)
            return;
        check((fx)d, (fx)n);
        n0 = n1, d0 = d1, n1 = n, d1 = d;
        y = x, x = rest;
    }
}

/* Around the ray k + 1/2, a boundary between two results. */
static void check_convergents(uint32_t k)
{
    struct big s, c;

    oracle((int64_t)k * 2 + 1, &s, &c);
    convergents(s, c, check_mirrored);
}

TEST(hardest_directions)
{
    struct rng r;

    rng_seed(&r, 5);
    for (int i = 0; i < 300; i++)
        check_convergents((uint32_t)(rng_next(&r) >> 35));
    check_convergents(0);
    check_convergents(1);
    check_convergents(0x1fffffff);
}

TEST(polar)
{
    static const fx SPEED[] = { 0, 1, -1, FX_ONE, -FX_ONE, FX_MAX, FX_MIN };
    struct rng r;

    rng_seed(&r, 6);
    for (int i = 0; i < RUNS; i++) {
        uint64_t v = rng_next(&r);
        ang a = i % 5 ? (ang)rng_next(&r) : (ang)i << 26;
        fx speed = v % 8 == 7 ? (fx)(v >> 32) : v % 8 == 6 ? SPEED[(v >> 8) % 7] : (fx)(v >> 42), out[2];
        struct big part[2];

        trig_polar(speed, a, &out[0], &out[1]);
        oracle((int64_t)a * 2, &part[1], &part[0]);
        for (int k = 0; k < 2; k++) {
            struct big off = big_sub(big_mul(part[k], big_int(speed)), big_shift_left(big_int(out[k]), Q));
            struct big half = big_add(big_shift_left(big_int(1), Q - 1), big_shift_left(big_int(1), Q - 110));

            off = big_negative(off) ? big_neg(off) : off;
            if (speed == FX_MIN && out[k] == FX_MAX)
                half = big_shift_left(half, 1);
            assert_true(big_compare(off, half) < 0);
        }
    }
}

TEST(strides)
{
    struct rng r;

    rng_seed(&r, 12);
    for (int i = 0; i < RUNS; i++) {
        ang a = i % 5 ? (ang)rng_next(&r) : (ang)i << 26;
        int64_t most = (int64_t)1 << (i % 49), way[2], at[2], end[2], step[2];
        struct big part[2];

        for (int k = 0; k < 2; k++)
            way[k] = i % 7 ? (int64_t)rng_below(&r, (uint64_t)most * 2 + 1) - most : k ? most : -most;
        trig_stride(0, way[0], a, &at[0], &at[1]);
        trig_stride(0, way[1], a, &end[0], &end[1]);
        trig_stride(way[0], way[1], a, &step[0], &step[1]);
        oracle((int64_t)a * 2, &part[1], &part[0]);
        for (int k = 0; k < 2; k++) {
            assert_true(step[k] == end[k] - at[k]);
            assert_true(nearest(big_mul(part[k], big_int(way[0])), at[k], 0));
        }
    }
}

enum { MANY = 97, TURNS = 30000 };

/* Any of 32 bits, or what is extreme, or what a game has. */
static fx any_fx(struct rng *r)
{
    static const fx V[] = { 0, 1, -1, 2, FX_ONE, -FX_ONE, FX_MAX, FX_MIN, FX_MIN + 1, FX_MAX - 1, 0x40000000 };
    const uint64_t v = rng_next(r);

    switch (v % 8) {
    case 0:
        return V[(v >> 8) % (sizeof V / sizeof V[0])];
    case 1:
        return (fx)(v >> 32);
    case 2:
        return (fx)((int64_t)v >> 32 >> (v >> 8) % 32);
    default:
        return (fx)((int64_t)v >> 39); /* within 256 px */
    }
}

static ang any_ang(struct rng *r)
{
    const uint64_t v = rng_next(r);

    return v % 8 ? (ang)(v >> 32) : ((ang)(v >> 8) << 29) + (ang)(v >> 11) % 3 - 1;
}

/* Up to 2^lot, and often just that. */
static int64_t any_length(struct rng *r, int lot)
{
    const int64_t most = (int64_t)1 << lot, v = (int64_t)rng_next(r);

    return v % 16 == 0 ? (v & 16 ? most : -most) : (int64_t)rng_below(r, (uint64_t)most * 2 + 1) - most;
}

/* What columns hold comes to the same as one by one, at all lengths, and nothing is written beyond. */
TEST(columns)
{
    static fx x[MANY], y[MANY], vx[MANY + 1], vy[MANY + 1];
    static ang a[MANY], out[MANY + 1];
    static int64_t from[MANY], to[MANY], dx[MANY + 1], dy[MANY + 1];
    struct rng r;

    rng_seed(&r, 13);
    for (int turn = 0; turn < TURNS; turn++) {
        const int n = turn % (MANY + 1), lot = turn % 49;
        for (int i = 0; i < n; i++) {
            x[i] = turn % 16 ? (fx)((int64_t)rng_next(&r) >> 39) : any_fx(&r);
            y[i] = turn % 16 == 1 ? x[i] + i % 3 - 1 : any_fx(&r);
            a[i] = any_ang(&r);
            from[i] = any_length(&r, lot);
            to[i] = any_length(&r, lot);
        }
        out[n] = 77;
        vx[n] = vy[n] = 78;
        dx[n] = dy[n] = 79;
        trig_atan2s(y, x, out, n);
        trig_polars(y, a, vx, vy, n);
        trig_strides(from, to, a, dx, dy, n);
        for (int i = 0; i < n; i++) {
            fx one_x, one_y;
            int64_t step_x, step_y;
            trig_polar(y[i], a[i], &one_x, &one_y);
            trig_stride(from[i], to[i], a[i], &step_x, &step_y);
            if (out[i] != trig_atan2(y[i], x[i]))
                fail_msg("trig_atan2s(%d, %d), %d of %d", y[i], x[i], i, n);
            if (vx[i] != one_x || vy[i] != one_y)
                fail_msg("trig_polars(%d, %08x), %d of %d", y[i], (unsigned)a[i], i, n);
            if (dx[i] != step_x || dy[i] != step_y)
                fail_msg("trig_strides(%lld, %lld, %08x), %d of %d", (long long)from[i], (long long)to[i],
                         (unsigned)a[i], i, n);
        }
        assert_true(out[n] == 77 && vx[n] == 78 && vy[n] == 78 && dx[n] == 79 && dy[n] == 79);
    }
}

/* |u| / 2^16 nearest to |x| / sqrt(x^2 + y^2), and of the same sign. */
static bool unit_is(fx u, fx x, fx y)
{
    struct big X = big_int(x), Y = big_int(y), square = big_add(big_mul(X, X), big_mul(Y, Y));
    struct big n = big_shift_left(big_mul(X, X), 34); /* compared with (2|u| +- 1)^2 square */
    int64_t m = u < 0 ? -(int64_t)u : u;
    struct big low = big_int(2 * m - 1), high = big_int(2 * m + 1);

    if ((u < 0 && x >= 0) || (u > 0 && x <= 0))
        return false;
    if (m && big_compare(big_mul(big_mul(low, low), square), n) >= 0)
        return false;
    return big_compare(n, big_mul(big_mul(high, high), square)) < 0;
}

static void check_unit(fx x, fx y)
{
    fx ux, uy;

    trig_normalise(x, y, &ux, &uy);
    assert_true(unit_is(ux, x, y));
    assert_true(unit_is(uy, y, x));
}

TEST(unit_vectors)
{
    static const fx V[] = { 0, 1, 2, FX_ONE, FX_MAX, FX_MIN, -1, 46341 };
    struct rng r;
    fx x = 5, y = 5;

    rng_seed(&r, 7);
    for (int i = 1; i < 64; i++)
        check_unit(V[i / 8], V[i % 8]);
    for (int i = 0; i < 100000; i++) {
        uint64_t v = rng_next(&r);

        check_unit((fx)((int64_t)v >> 32 >> v % 31), (fx)((int64_t)rng_next(&r) >> 32 >> (v >> 8) % 31) | 1);
    }
    trig_normalise(0, 0, &x, &y);
    assert_int_equal(x, 0);
    assert_int_equal(y, 0);
}

TEST(differences)
{
    assert_int_equal(trig_difference(0xfffffff0, 0x10), 0x20);
    assert_int_equal(trig_difference(0x10, 0xfffffff0), -0x20);
    assert_int_equal(trig_difference(0, 0x80000000), INT32_MIN);
}

/* m * 2^e degrees, m of 53 bits, e from -190 to 100, as an ang by whole numbers. */
static ang degrees_oracle(int64_t m, int e)
{
    struct big n = big_shift_left(big_int(m < 0 ? -m : m), e + 190 + 32), d = big_shift_left(big_int(360), 190), rest,
               q;
    int c;

    q = big_divide(n, d, &rest);
    c = big_compare(big_add(rest, rest), d);
    q = big_add(q, big_int(c > 0 || (c == 0 && (q.limb[0] & 1))));
    return m < 0 ? 0 - q.limb[0] : q.limb[0];
}

static void check_degrees(double deg)
{
    int e;
    int64_t m = (int64_t)ldexp(frexp(deg, &e), 53);
    ang a = 1;
    int32_t turn = 1;

    assert_true(trig_from_degrees(deg, &a));
    assert_true(trig_turn_from_degrees(deg, &turn));
    assert_int_equal(a, degrees_oracle(m, e - 53));
    assert_int_equal((ang)turn, a);
}

TEST(degrees)
{
    static const double WRITTEN[] = { 0, 1, 45, 90, 180, 270, 359.9999999999999, 360, 720.5, 1e9, 1e15, 1e25 };
    struct rng r;

    rng_seed(&r, 8);
    for (size_t i = 0; i < sizeof WRITTEN / sizeof WRITTEN[0]; i++) {
        check_degrees(WRITTEN[i]);
        check_degrees(-WRITTEN[i]);
    }
    for (int i = 0; i < RUNS; i++) {
        double tie = (double)((rng_next(&r) >> 32) * 2 + 1) * 45 / 1073741824.0;

        check_degrees(ldexp((double)(int64_t)rng_next(&r), (int)(rng_next(&r) % 160) - 140));
        check_degrees(tie);
        check_degrees(nextafter(tie, 0));
        check_degrees(-nextafter(tie, 400));
        check_degrees((double)(rng_next(&r) % 7200) / 10);
    }
}

TEST(degrees_edges)
{
    ang a = 9;
    int32_t turn = 9;

    assert_false(trig_from_degrees(NAN, &a));
    assert_false(trig_from_degrees(INFINITY, &a));
    assert_false(trig_turn_from_degrees(-INFINITY, &turn));
    assert_true(a == 9 && turn == 9);
    assert_true(trig_turn_from_degrees(350, &turn));
    assert_int_equal(turn, -119304647); /* 10 degrees back */
    assert_true(trig_turn_from_degrees(180, &turn));
    assert_int_equal(turn, INT32_MIN);
    assert_true(trig_from_degrees(DBL_MAX, &a));
    assert_int_equal(a, 0x5b05b05b); /* 128 degrees past whole turns */
}

/* Exact: a * 45 / 2^29, and the way back ends at the start. */
TEST(degrees_back)
{
    struct rng r;
    ang b;

    rng_seed(&r, 9);
    for (int i = 0; i < 100000; i++) {
        ang a = (ang)rng_next(&r);

        assert_true(ldexp(trig_to_degrees(a), 29) == (double)((uint64_t)a * 45));
        assert_true(trig_from_degrees(trig_to_degrees(a) - 360, &b) && a == b);
    }
}

RUN_TESTS(NULL, NULL)
