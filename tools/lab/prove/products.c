/*
 * products.c - proves fx_mul, fx_div, fx_lerp, fx_add, fx_sub, conversions from and to double, and degrees.
 *
 * The exact results are fractions of whole numbers below 2^127, so the oracle is exact: r is right for a/b when
 * |a - rb| < b/2, or = b/2 and r is even, or when r is the end of the range and a/b lies beyond it.
 */
#include <string.h>
#include "../../../src/base/trig.h"
#include "oracle.h"

enum { F, G, H, CHUNK = 1 << 12 };

/* r for num/den, den > 0; clamped to the range of an fx. */
static inline void check_ratio(struct tally *t, i128 num, u128 den, int64_t r, int64_t a, int64_t b)
{
    i128 over = 2 * (num - (i128)den * r);
    u128 twice = (u128)(over < 0 ? -over : over);
    bool beyond = (r == FX_MAX && over >= 0) || (r == FX_MIN && over <= 0);

    if (twice < den || (twice == den && (r % 2 == 0 || beyond)))
        tally_right(t, over == 0 ? 0.5 : (double)(int64_t)(den - twice) / (double)(int64_t)den / 2, a, b);
    else if (beyond)
        tally_right(t, 0.5, a, b);
    else
        tally_wrong(t, (double)twice / (double)den / 2, a, b, r, (int64_t)((double)num / (double)den + 0.5));
}

/* ---- products ---- */

static void check_mul(struct tally *t, int64_t a, int64_t b)
{
    check_ratio(t, (i128)a * b, FX_ONE, fx_mul((fx)a, (fx)b), a, b);
}

/* All pairs of lower halves, under upper halves of which most let the product fit. */
static void residues_mul(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (int64_t low = 0; low < FX_ONE; low++) {
        uint64_t z = numbers_random(random);
        int shift = (int)(z & 15);
        int64_t a = (int32_t)(z >> 32) >> shift, b = (int16_t)(z >> 16) >> (16 - shift) << 16 >> (z >> 4 & 3);

        check_mul(&t[F], (int64_t)((uint64_t)a & ~(uint64_t)0xffff) + (int64_t)chunk,
                  (int64_t)((uint64_t)b & ~(uint64_t)0xffff) + low);
    }
}

static void any_mul(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t a = prove_scaled(random);

        check_mul(&t[F], a, prove_scaled(random));
        check_mul(&t[F], (int32_t)numbers_random(random), a);
    }
}

/* Products around the ends of the range, 2^31 * 2^16 and half a unit more or less. */
static void clamped_mul(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int64_t a = prove_scaled(random) | 1, b = ((int64_t)1 << 47) / a;

        for (int64_t k = b - 2; k <= b + 2; k++)
            if (k >= FX_MIN && k <= FX_MAX) {
                check_mul(&t[F], a, k);
                check_mul(&t[F], k, a);
                if (k > FX_MIN)
                    check_mul(&t[F], a, -k);
            }
    }
}

static const int64_t EDGES[] = { FX_MIN, FX_MIN + 1, -FX_ONE - 1, -FX_ONE, -0x8000,    -2,         -1,
                                 0,      1,          2,           3,       0x7fff,     0x8000,     0x8001,
                                 0xffff, FX_ONE,     FX_ONE + 1,  0x18000, 0x7fff0000, FX_MAX - 1, FX_MAX };

static void mul_edges(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint64_t i = 0; i < COUNT(EDGES); i++)
        check_mul(&t[F], EDGES[chunk], EDGES[i]);
}

/* MPFR's word for any of the functions of two numbers. */
static void compare(struct tally *t, int64_t got, int64_t want, int64_t a, int64_t b)
{
    want = want > FX_MAX ? FX_MAX : want < FX_MIN ? FX_MIN : want;
    t->by_mpfr++;
    if (got == want)
        tally_right(t, 0.5, a, b);
    else
        tally_wrong(t, fabs((double)(got - want)), a, b, got, want);
}

static void mul_by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t a = prove_scaled(random), b = prove_scaled(random);

    (void)chunk;
    compare(&t[F], fx_mul((fx)a, (fx)b), oracle_ratio(a, b, 0, FX_ONE), a, b);
}

static void prove_mul(void)
{
    prove_phase(mul_edges, COUNT(EDGES), COUNT(EDGES));
    prove_phase(residues_mul, FX_ONE, 12);
    prove_phase(any_mul, 1 << 15, 20);
    prove_phase(clamped_mul, 1 << 12, 4);
    prove_phase(mul_by_mpfr, 200000, 2000);
    prove_line(F, "fx_mul",
               "every pair of lower halves with random upper halves, that is every value of the rounded bits; random, "
               "around the clamp; a sample with MPFR");
}

/* ---- quotients ---- */

static void check_div(struct tally *t, int64_t a, int64_t b)
{
    int64_t r = fx_div((fx)a, (fx)b);

    if (b == 0)
        check_ratio(t, a > 0 ? FX_MAX : a < 0 ? FX_MIN : 0, 1, r, a, b);
    else
        check_ratio(t, (i128)(b < 0 ? -a : a) * FX_ONE, (u128)(b < 0 ? -b : b), r, a, b);
}

static void check_div_signed(struct tally *t, int64_t a, int64_t b, uint64_t signs)
{
    check_div(t, signs & 1 ? -a : a, signs & 2 ? -b : b);
}

/* Ties: 2^17 a is an odd multiple of b only for b = 2^17 j and a an odd multiple of j. */
static void tied_div(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t j = (int64_t)chunk + 1;

    for (int64_t a = j; a <= FX_MAX; a += 2 * j)
        check_div_signed(&t[F], a, j << 17, (uint64_t)a / 2 + prove_sampled() * (numbers_random(random) & 3));
}

/* Some of them for the sampled form: all of a divisor are too many. */
static void few_tied_div(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);
        int64_t j = (int64_t)(z >> 18 & 0x3fff) + 1 - (int64_t)((z >> 18 & 0x3fff) == 0x3fff);
        int64_t a = j * (int64_t)((z >> 32) % (uint64_t)(FX_MAX / j) | 1);

        if (a <= FX_MAX)
            check_div_signed(&t[F], a, j << 17, z);
    }
}

/*
 * The hardest that are no ties: b = 2^e b' with b' odd; with e < 17 the distance of 2^17 a from an odd multiple of b is
 * an odd multiple of 2^e, and least where 2^(17-e) a = +-1 modulo b'.
 */
static void hard_div_by(struct tally *t, int64_t b, uint64_t *random)
{
    int64_t odd = b, a = 1;
    int halvings = 17;

    while (odd % 2 == 0)
        odd /= 2, halvings--;
    if (halvings <= 0)
        return;
    for (; halvings; halvings--)
        a = (a % 2 ? a + odd : a) / 2;
    for (int k = 0; k < 2; k++, a = odd - a) {
        uint64_t z = numbers_random(random);
        int64_t most = (FX_MAX - a) / odd, more = most ? a + (int64_t)((z >> 8) % (uint64_t)(most + 1)) * odd : a;

        check_div_signed(t, a, b, z);
        check_div_signed(t, more, b, z >> 2);
    }
}

static void hard_div(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (int64_t i = 0; i < CHUNK; i++)
        if (chunk || i)
            hard_div_by(&t[F], (int64_t)chunk * CHUNK + i, random);
}

static void small_div(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t b = (int64_t)chunk + 1;

    for (int64_t i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);

        check_div_signed(&t[F], i, b, z);
        check_div_signed(&t[F], (int64_t)(z >> 33), b, z >> 2);
        check_div_signed(&t[F], b * 32768 - 8 + (i & 15) <= FX_MAX ? b * 32768 - 8 + (i & 15) : FX_MAX, b, z >> 4);
    }
}

static void any_div(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t a = prove_scaled(random);

        check_div(&t[F], a, prove_scaled(random));
        check_div(&t[F], (int32_t)numbers_random(random), a);
        check_div(&t[F], a, 0);
    }
}

static void div_edges(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint64_t i = 0; i < COUNT(EDGES); i++)
        check_div(&t[F], EDGES[chunk], EDGES[i]);
}

static void div_by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t a = prove_scaled(random), b = prove_scaled(random) | 1;

    (void)chunk;
    compare(&t[F], fx_div((fx)a, (fx)b), oracle_ratio(a, FX_ONE, 0, b), a, b);
}

static void prove_div(void)
{
    prove_hard(F, "fx_div", check_div);
    prove_phase(div_edges, COUNT(EDGES), COUNT(EDGES));
    prove_phase(few_tied_div, 64, 8);
    if (!prove_sampled())
        prove_phase(tied_div, (1 << 14) - 1, 1);
    prove_phase(hard_div, (uint64_t)1 << 31 >> 12, 16);
    prove_phase(small_div, 1 << 15, 8);
    prove_phase(any_div, 1 << 15, 10);
    prove_phase(div_by_mpfr, 200000, 2000);
    prove_line(F, "fx_div",
               "all ties, b = 2^17 j and a an odd multiple of j; for every divisor the dividends next to a tie, from "
               "inverses modulo b; small divisors, around the clamp, by 0, random; a sample with MPFR");
}

/* ---- sums and lerp ---- */

static void check_sums(struct tally *t, int64_t a, int64_t b)
{
    check_ratio(&t[F], (i128)a + b, 1, fx_add((fx)a, (fx)b), a, b);
    check_ratio(&t[G], (i128)a - b, 1, fx_sub((fx)a, (fx)b), a, b);
}

static void any_sum(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);

        check_sums(t, (int32_t)z, (int32_t)(z >> 32));
        check_sums(t, (int32_t)z,
                   FX_MAX - (int32_t)z + (int64_t)(z >> 60) - 8 <= FX_MAX && (int32_t)z > 8
                       ? FX_MAX - (int32_t)z + (int64_t)(z >> 60) - 8
                       : 0);
        check_sums(t, EDGES[z % COUNT(EDGES)], EDGES[(z >> 32) % COUNT(EDGES)]);
    }
}

static void prove_sums(void)
{
    prove_phase(any_sum, 1 << 15, 20);
    prove_line(F, "fx_add", "random, sums around the clamp, extremes; exact or clamped");
    prove_line(G, "fx_sub", "the same pairs");
}

/* b and t in one number, for the printed inputs. */
static void check_lerp(struct tally *t, int64_t a, int64_t b, int64_t at)
{
    check_ratio(t, (i128)a * FX_ONE + ((i128)b - a) * at, FX_ONE, fx_lerp((fx)a, (fx)b, (fx)at), a,
                (int64_t)((uint64_t)b << 32 | (uint32_t)at));
}

/* All pairs of lower halves of b - a and t; half of the t within 0..1. */
static void residues_lerp(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (int64_t low = 0; low < FX_ONE; low++) {
        uint64_t z = numbers_random(random);
        int64_t a = prove_scaled(random), at = z & 1 ? (int64_t)chunk : (int32_t)(z >> 32) >> (z >> 8 & 15);
        int64_t b = prove_scaled(random);

        at = (int64_t)((uint64_t)at & ~(uint64_t)0xffff) + (int64_t)chunk;
        b = (int64_t)(((uint64_t)b & ~(uint64_t)0xffff) | ((uint64_t)(a + low) & 0xffff));
        check_lerp(&t[F], a, b, at);
    }
}

static void any_lerp(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);
        int32_t a = prove_scaled(random), b = (int32_t)z;

        check_lerp(&t[F], a, b, prove_scaled(random));
        check_lerp(&t[F], b, a, (int64_t)(z >> 32 & 0x1ffff));
        check_lerp(&t[F], a, b, 0);
        check_lerp(&t[F], a, b, FX_ONE);
        check_lerp(&t[F], EDGES[z % COUNT(EDGES)], EDGES[(z >> 20) % COUNT(EDGES)], EDGES[(z >> 40) % COUNT(EDGES)]);
    }
}

static void lerp_by_mpfr(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t a = prove_scaled(random) >> 8, b = prove_scaled(random), at = prove_scaled(random);

    (void)chunk;
    compare(&t[F], fx_lerp((fx)a, (fx)b, (fx)at), oracle_ratio(b - a, at, a * FX_ONE, FX_ONE), a, b);
}

static void prove_lerp(void)
{
    prove_phase(residues_lerp, FX_ONE, 12);
    prove_phase(any_lerp, 1 << 14, 20);
    prove_phase(lerp_by_mpfr, 200000, 2000);
    prove_line(F, "fx_lerp",
               "every pair of lower halves of b - a and t with random upper halves; random, t = 0 and 1, extremes; a "
               "sample with MPFR");
}

/* ---- differences ---- */

static void check_difference(struct tally *t, int64_t from, int64_t to)
{
    int64_t r = trig_difference((ang)from, (ang)to), want = (to - from) & 0xffffffff;

    want = want >= 0x80000000 ? want - 0x100000000 : want;
    if (r == want)
        tally_right(t, 0.5, from, to);
    else
        tally_wrong(t, fabs((double)(r - want)), from, to, r, want);
}

static void any_difference(uint64_t chunk, struct tally *t, uint64_t *random)
{
    for (int64_t i = 0; i < CHUNK; i++) {
        uint64_t z = numbers_random(random);

        check_difference(&t[F], (int64_t)(z & 0xffffffff), (int64_t)(z >> 32));
        check_difference(&t[F], (int64_t)(z & 0xffffffff), (int64_t)((z + 0x80000000) & 0xffffffff) & ~(int64_t)1);
        check_difference(&t[F], 0, ((int64_t)chunk * CHUNK + i) & 0xffffffff);
    }
}

static void prove_difference(void)
{
    prove_phase(any_difference, 1 << 20, 20);
    prove_line(F, "trig_difference", "from 0 to every angle, and random pairs, some of them opposite");
}

/* ---- doubles ---- */

/* A finite v as m * 2^-k, m an odd number of up to 53 bits or 0. */
struct exact {
    int64_t m;
    int k;
};

static struct exact exact_of(double v)
{
    struct exact x;
    int e;

    x.m = (int64_t)ldexp(frexp(v, &e), 53);
    x.k = 53 - e;
    while (x.m && x.m % 2 == 0)
        x.m /= 2, x.k--;
    return x;
}

/* The nearest to num / (den 2^k), ties to even; num >= 0 and all that matters below 2^127. */
static int64_t nearest(u128 num, u128 den, int k, double *off)
{
    u128 unit = den << k, q = num / unit, rest = num % unit, half = unit >> 1;

    *off = (double)(rest < half ? half - rest : rest - half) / (double)unit;
    if (unit % 2)
        *off = fabs((double)rest / (double)unit - 0.5);
    return (int64_t)q + (2 * rest > unit || (2 * rest == unit && q % 2));
}

/* The input counts as the bits of its double. */
static void double_result(struct tally *t, bool right, double off, double v, int64_t got, int64_t want)
{
    int64_t bits;

    memcpy(&bits, &v, sizeof bits);
    if (right)
        tally_right(t, off, bits, 0);
    else
        tally_wrong(t, fabs((double)(got - want)), bits, 0, got, want);
}

static void check_from_double(struct tally *t, double v)
{
    static const fx UNTOUCHED = 1234567;
    fx got = UNTOUCHED;
    bool took = fx_from_double(v, &got), takes = false;
    int64_t want = UNTOUCHED;
    double off = 0.5;

    if (fabs(v) < 40000) {
        struct exact x = exact_of(v);
        int64_t r =
            x.k > 110 ? 0
                      : nearest((u128)(x.m < 0 ? -x.m : x.m) << (x.k < 0 ? -x.k : 0) << 16, 1, x.k < 0 ? 0 : x.k, &off);

        r = v < 0 ? -r : r;
        takes = r >= FX_MIN && r <= FX_MAX;
        want = takes ? r : want;
    }
    double_result(t, took == takes && got == want, off, v, got, want);
}

/* v and what is next to it on either side. */
static void check_around(struct tally *t, double v)
{
    check_from_double(t, v);
    check_from_double(t, nextafter(v, -INFINITY));
    check_from_double(t, nextafter(v, INFINITY));
}

static void doubles(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t i = 0; i < CHUNK; i++) {
        int64_t a = (int64_t)chunk * CHUNK + i - 0x80000000;
        double v = fx_to_double((fx)a);
        fx back = 0;
        bool exact = v * 65536 == (double)a;

        double_result(&t[G], exact, 0.5, v, exact ? a : a + 1, a);
        double_result(&t[F], fx_from_double(v, &back) && back == a, 0.5, v, back, a);
        check_around(&t[F], ((double)a + 0.5) / 65536);
    }
}

static void other_doubles(uint64_t chunk, struct tally *t, uint64_t *random)
{
    static const double ENDS[] = { 0,        -0.0,      INFINITY, -INFINITY, NAN,  DBL_MAX, -DBL_MAX, DBL_MIN,
                                   -DBL_MIN, 0x1p-1074, 32768,    -32768,    1e18, -1e18,   0x1p47,   -0x1p47 };

    if (chunk == 0)
        for (uint64_t i = 0; i < COUNT(ENDS); i++)
            check_around(&t[F], ENDS[i]);
    for (int i = 0; i < CHUNK; i++) {
        double v = ldexp((double)(int64_t)numbers_random(random), -(int)(numbers_random(random) % 100) - 40);

        check_from_double(&t[F], v);
        check_around(&t[F], ldexp(floor(ldexp(v, 17)), -17));
    }
}

static double double_of(int64_t bits)
{
    double v;

    memcpy(&v, &bits, sizeof v);
    return v;
}

static void hard_double(struct tally *t, int64_t bits, int64_t unused)
{
    (void)unused;
    check_from_double(t, double_of(bits));
}

static void prove_doubles(void)
{
    prove_hard(F, "fx_from_double", hard_double);
    prove_phase(other_doubles, 1 << 12, 8);
    prove_phase(doubles, (uint64_t)1 << 32 >> 12, 60);
    prove_line(F, "fx_from_double",
               "round trip of every fx; all 2^32 ties and the doubles next to them; infinities, NaN, random");
    prove_line(G, "fx_to_double", "every fx, exact");
}

/* ---- degrees ---- */

/* 2^32 deg / 360 modulo 2^32, ties to even: m 2^-k modulo 360, times 2^32 / 360. */
static ang ang_of(double deg, double *off)
{
    struct exact x = exact_of(deg);
    u128 m = (u128)(x.m < 0 ? -x.m : x.m), turn = 360;
    ang a;

    *off = 0.5;
    if (x.k > 85) /* below 2^-32 degrees; half an ang is 2^-24.6 */
        return 0;
    for (; x.k < 0; x.k++)
        m = 2 * (m % turn);
    a = (ang)nearest(m % (turn << x.k) << 32, turn, x.k, off);
    return deg < 0 ? 0 - a : a;
}

static void check_degrees(struct tally *t, double deg)
{
    static const ang UNTOUCHED = 0x12345678;
    ang a = UNTOUCHED, want = UNTOUCHED;
    int32_t turn = (int32_t)UNTOUCHED;
    double off = 0.5;
    bool takes = isfinite(deg), took = trig_from_degrees(deg, &a), took_turn = trig_turn_from_degrees(deg, &turn);

    if (takes)
        want = ang_of(deg, &off);
    double_result(&t[F], took == takes && a == want, off, deg, a, want);
    double_result(&t[G], took_turn == takes && turn == (int32_t)want, off, deg, turn, (int32_t)want);
}

static void check_degrees_hard(struct tally *t, int64_t bits, int64_t unused)
{
    (void)unused;
    check_degrees(t, double_of(bits));
}

static void check_degrees_around(struct tally *t, double deg)
{
    check_degrees(t, deg);
    check_degrees(t, nextafter(deg, -INFINITY));
    check_degrees(t, nextafter(deg, INFINITY));
}

/* There and back; and the ties after each angle, with their neighbours. */
static void all_degrees(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint64_t i = 0; i < CHUNK; i++) {
        uint64_t a = chunk * CHUNK + i;
        double deg = trig_to_degrees((ang)a);
        ang back = ~(ang)a;
        int32_t turn = 0;
        bool exact = deg * 536870912 == (double)(a * 45);

        double_result(&t[H], exact, 0.5, deg, exact ? (int64_t)a : (int64_t)a + 1, (int64_t)a);
        double_result(&t[F], trig_from_degrees(deg, &back) && back == a, 0.5, deg, back, (int64_t)a);
        double_result(&t[G], trig_turn_from_degrees(deg, &turn) && (ang)turn == a, 0.5, deg, turn, (int32_t)a);
        if (chunk % 8 == 0 || prove_sampled())
            check_degrees_around(t, (double)(2 * a + 1) * 45 / 1073741824);
    }
}

/* Ties after whole turns forwards and backwards, as near as doubles come; any double. */
static void other_degrees(uint64_t chunk, struct tally *t, uint64_t *random)
{
    static const double ENDS[] = { 0,   -0.0, INFINITY, -INFINITY, NAN,   DBL_MAX, -DBL_MAX, DBL_MIN, 0x1p-1074,
                                   180, -180, 360,      -360,      359.5, 720,     1e15,     0x1p60,  -0x1p80 };

    if (chunk == 0)
        for (uint64_t i = 0; i < COUNT(ENDS); i++)
            check_degrees_around(t, ENDS[i]);
    for (int i = 0; i < CHUNK / 4; i++) {
        uint64_t z = numbers_random(random);
        double tie = (double)((z >> 32) * 2 + 1) * 45 / 1073741824, turns = (double)(prove_scaled(random) >> 12);

        check_degrees_around(t, tie + 360 * turns);
        check_degrees_around(t, -tie);
        check_degrees(t, (double)(int64_t)(z % 7200) / 10);
        check_degrees(t, ldexp((double)(int64_t)numbers_random(random), (int)(z % 200) - 120));
        check_degrees(t, ldexp((double)(int64_t)z, (int)(numbers_random(random) % 900)));
    }
}

static void prove_degrees(void)
{
    prove_hard(F, "trig_from_degrees", check_degrees_hard);
    prove_phase(other_degrees, 1 << 12, 20);
    prove_phase(all_degrees, (uint64_t)1 << 32 >> 12, 60);
    prove_line(F, "trig_from_degrees",
               "round trip of every angle; the ties after every eighth block of 4096, more after whole turns, and the "
               "doubles next to them; any double");
    prove_line(G, "trig_turn_from_degrees", "the same");
    prove_line(H, "trig_to_degrees", "every angle, exact");
}

int main(int argc, char **argv)
{
    static const struct proof PROOFS[] = {
        { "fx_mul", prove_mul },      { "fx_div", prove_div },      { "fx_lerp", prove_lerp },
        { "sums", prove_sums },       { "doubles", prove_doubles }, { "trig_difference", prove_difference },
        { "degrees", prove_degrees },
    };

    return prove_main(argc, argv, PROOFS, COUNT(PROOFS));
}
