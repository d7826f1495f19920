/*
 * test_fx.c - fixed point against 384-bit integers; the portable 64 x 64 product too. tests/machine/prove.sh tries many
 * more ties and roots.
 */
#ifndef FX_NO_INT128
#define FX_NO_INT128
#endif
#include "../../src/base/fx.h"
#include "../../src/base/rng.h"
#include "big.h"

#include "../test.h"

enum { RUNS = 30000 };

static const fx EDGE[] = {
    FX_MIN, FX_MIN + 1, -FX_ONE * 181, -FX_ONE - 1, -FX_ONE, -FX_ONE / 2, -3,           -2,         -1,    0, 1, 2, 3,
    255,    256,        FX_ONE / 2,    FX_ONE - 1,  FX_ONE,  FX_ONE + 1,  FX_ONE * 181, FX_MAX - 1, FX_MAX
};
enum { EDGES = sizeof EDGE / sizeof EDGE[0] };

/* Numbers of every size, extremes often. */
static fx any(struct rng *r)
{
    uint64_t v = rng_next(r);

    if (v % 16 == 0)
        return EDGE[(v >> 8) % EDGES];
    return (fx)((int64_t)v >> 32 >> (v >> 8) % 32);
}

static bool fits(struct big n, struct big d, fx r)
{
    return big_rounds_to(n, d, r, FX_MIN, FX_MAX);
}

static void check_pair(fx a, fx b, fx t)
{
    struct big A = big_int(a), B = big_int(b), one = big_int(1), unit = big_int(FX_ONE);

    assert_true(fits(big_add(A, B), one, fx_add(a, b)));
    assert_true(fits(big_sub(A, B), one, fx_sub(a, b)));
    assert_true(fits(big_mul(A, B), unit, fx_mul(a, b)));
    if (b)
        assert_true(fits(big_mul(b < 0 ? big_neg(A) : A, unit), b < 0 ? big_neg(B) : B, fx_div(a, b)));
    assert_true(fits(big_add(big_mul(A, unit), big_mul(big_sub(B, A), big_int(t))), unit, fx_lerp(a, b, t)));
}

/* Is r the whole number nearest to sqrt(n), or clamped below it? */
static void check_root(struct big n, int64_t r, int64_t high)
{
    struct big four = big_mul(n, big_int(4)), below = big_int(2 * r - 1), above = big_int(2 * r + 1);

    assert_in_range(r, 0, high);
    if (r > 0)
        assert_true(big_compare(big_mul(below, below), four) < 0);
    if (r < high)
        assert_true(big_compare(four, big_mul(above, above)) < 0);
}

static void check_roots(fx a, fx b)
{
    struct big A = big_int(a), B = big_int(b), zero = big_int(0);

    check_root(a < 0 ? zero : big_shift_left(A, 16), fx_sqrt(a), FX_MAX);
    check_root(big_add(big_mul(A, A), big_mul(B, B)), fx_hypot(a, b), FX_MAX);
    if (a <= 0) {
        assert_int_equal(fx_rsqrt(a), a ? 0 : FX_MAX);
        return;
    }

    fx r = fx_rsqrt(a);
    struct big below = big_int(2 * (int64_t)r - 1), above = big_int(2 * (int64_t)r + 1),
               n = big_shift_left(big_int(1), 50);

    assert_true(big_compare(big_mul(A, big_mul(below, below)), n) < 0);
    assert_true(big_compare(big_mul(A, big_mul(above, above)), n) > 0);
}

TEST(edges)
{
    for (int i = 0; i < EDGES; i++)
        for (int j = 0; j < EDGES; j++) {
            check_roots(EDGE[i], EDGE[j]);
            for (int k = 0; k < EDGES; k++)
                check_pair(EDGE[i], EDGE[j], EDGE[k]);
        }
}

TEST(random_numbers)
{
    struct rng r;

    rng_seed(&r, 1);
    for (int i = 0; i < RUNS; i++) {
        fx a = any(&r), b = any(&r), t = any(&r);

        check_pair(a, b, t);
        check_roots(a, b);
    }
    for (fx a = 0; a < 70000; a++)
        check_roots(a, 1);
}

TEST(written_results)
{
    assert_int_equal(fx_sat(INT64_MAX), FX_MAX);
    assert_int_equal(fx_sat(INT64_MIN), FX_MIN);
    assert_int_equal(fx_div(1, 0), FX_MAX);
    assert_int_equal(fx_div(-1, 0), FX_MIN);
    assert_int_equal(fx_div(0, 0), 0);
    assert_int_equal(fx_sqrt(4 * FX_ONE), 2 * FX_ONE);
    assert_int_equal(fx_rsqrt(4 * FX_ONE), FX_ONE / 2);
    assert_int_equal(fx_hypot(3 * FX_ONE, -4 * FX_ONE), 5 * FX_ONE);
    assert_int_equal(fx_int(3), 3 * FX_ONE);
    assert_int_equal(fx_int(-32768), FX_MIN);
    assert_int_equal(fx_int(INT32_MAX), FX_MAX);
    assert_int_equal(fx_int(INT32_MIN), FX_MIN);
    assert_int_equal(fx_floor(-1), -1);
    assert_int_equal(fx_floor(FX_ONE - 1), 0);
    assert_int_equal(fx_floor(FX_MIN), -32768);
}

/* v in 2^-1074 would need more bits than there are; 2^-200 reaches below every case that matters. */
static void check_double(double v)
{
    int e;
    int64_t m = (int64_t)ldexp(frexp(v, &e), 53);
    fx out = 12345;
    bool ok = fx_from_double(v, &out);

    if (e < -140) {
        assert_true(ok);
        assert_int_equal(out, 0);
        return;
    }

    struct big n = big_shift_left(big_int(m), e + 163), d = big_shift_left(big_int(1), 200), r, q;

    q = big_divide(big_negative(n) ? big_neg(n) : n, d, &r); /* |v| in units, cut */
    if (big_compare(q, big_int((int64_t)1 << 32)) > 0) {
        assert_false(ok);
    } else if (ok) {
        assert_true(big_rounds_to(n, d, out, INT64_MIN, INT64_MAX));
    } else {
        assert_false(big_rounds_to(n, d, FX_MAX, INT64_MIN, INT64_MAX));
        assert_false(big_rounds_to(n, d, FX_MIN, INT64_MIN, INT64_MAX));
        assert_true(big_low(q) >= FX_MAX);
    }
    if (!ok)
        assert_int_equal(out, 12345);
}

TEST(doubles)
{
    static const double UNITS[] = { 0, 0.5, 1.5, 2147483646.5, 2147483647.5, 2147483648, 2147483648.5, 4294967296 };
    struct rng r;
    fx out = 7;

    rng_seed(&r, 4);
    for (size_t i = 0; i < sizeof UNITS / sizeof UNITS[0]; i++) {
        check_double(UNITS[i] / 65536);
        check_double(-UNITS[i] / 65536);
        check_double(nextafter(UNITS[i], 0) / 65536);
        check_double(nextafter(-UNITS[i], -1e10) / 65536);
    }
    for (int i = 0; i < RUNS / 10; i++) {
        double v = ldexp((double)(int64_t)rng_next(&r), (int)(rng_next(&r) % 120) - 140);
        fx a = any(&r);

        check_double(v);
        check_double(nextafter(fx_to_double(a) + 0.5 / 65536, (double)(rng_next(&r) % 3) - 1));
        check_double(fx_to_double(a) + 0.5 / 65536);
        assert_true(fx_to_double(a) * 65536 == a);
        assert_true(fx_from_double(fx_to_double(a), &out) && out == a);
    }
    out = 7;
    assert_false(fx_from_double(NAN, &out));
    assert_false(fx_from_double(INFINITY, &out));
    assert_int_equal(out, 7);
}

TEST(wide_product)
{
    static const uint64_t V[] = { 0, 1, 0xffffffff, 0x100000000, UINT64_MAX, (uint64_t)1 << 63, 0xffffffff00000000 };
    struct rng r;

    rng_seed(&r, 5);
    for (int i = 0; i < RUNS; i++) {
        uint64_t a = i < 49 ? V[i / 7] : rng_next(&r) >> rng_next(&r) % 64;
        uint64_t b = i < 49 ? V[i % 7] : rng_next(&r) >> rng_next(&r) % 64;
        struct big A = big_int((int64_t)a), B = big_int((int64_t)b), p;

        for (int k = 2; k < BIG_LIMBS; k++) /* unsigned */
            A.limb[k] = B.limb[k] = 0;
        p = big_mul(A, B);
        assert_true(fx_mul_high(a, b) == (uint64_t)big_low(big_shift_right(p, 64)));
        assert_true(a * b == (uint64_t)big_low(p));
    }
}

RUN_TESTS(NULL, NULL)
