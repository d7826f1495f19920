/*
 * roots.c - proves fx_sqrt, fx_rsqrt and fx_hypot.
 *
 * Oracle: a root is checked by squares of whole numbers, which is exact: r is the nearest to sqrt(n) when (2r - 1)^2 <
 * 4n < (2r + 1)^2, and to 2^24/sqrt(x) when (2r - 1)^2 x < 2^50 < (2r + 1)^2 x. None of these can be equal, so there
 * are no ties. A sample is compared with what MPFR makes of it, too.
 *
 * fx_hypot depends on x and y only through n = x*x + y*y <= 2^63, of which it takes fx_root. That is a guess which
 * never falls as n grows (conversion, sqrt and cutting are monotone, and so is the twin), plus one if n > g*g + g for
 * the guess g. If it is right for the first and for the last n of those that round to r, then g is r or r - 1 for both,
 * therefore for all between, and the correction is right for all of them. So both sides of every boundary are every n.
 */
#include "../../../src/base/fx.h"
#include "oracle.h"

enum { ROOT, CHUNK = 1 << 12 };

/* The distance of sqrt(n) from the nearer boundary around r: |n - (r^2 +- r + 1/4)| over the sum of the roots. */
static double off_boundary(uint64_t n, uint64_t r)
{
    i128 square = (i128)r * r, over = (i128)n - square;
    double edge = over > 0 ? 0.5 : -0.5, twice = 2 * (double)r + edge;

    return over > 0 ? (double)(int64_t)(4 * (square + (i128)r - n) + 1) / 4 / twice
                    : (double)(int64_t)(4 * ((i128)n - square + (i128)r) - 1) / 4 / twice;
}

/* Is r the nearest to sqrt(n)? */
static bool is_root(uint64_t n, uint64_t r)
{
    u128 low = 2 * (u128)r - (r > 0), high = 2 * (u128)r + 1;

    return low * low < 4 * (u128)n + (r == 0) && 4 * (u128)n < high * high;
}

static void check_sqrt(struct tally *t, int64_t a, int64_t unused)
{
    int64_t r = fx_sqrt((fx)a);
    uint64_t n = (uint64_t)a << 16;

    (void)unused;
    if (a <= 0 ? r == 0 : r >= 0 && is_root(n, (uint64_t)r))
        tally_right(t, a > 0 ? off_boundary(n, (uint64_t)r) : 0.5, a, 0);
    else
        tally_wrong(t, fabs((double)r - (a > 0 ? sqrt((double)n) : 0)), a, 0, r, a > 0 ? oracle_sqrt(a) : 0);
}

static void all_sqrt(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t i = 0; i < CHUNK; i++)
        check_sqrt(&t[ROOT], (int64_t)(chunk * CHUNK) + i - 0x80000000, 0);
}

static void mpfr_sqrt_too(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t a = prove_scaled(random) & FX_MAX, r = fx_sqrt((fx)a), want = oracle_sqrt(a);

    (void)chunk;
    t[ROOT].by_mpfr++;
    if (r == want)
        tally_right(&t[ROOT], 0.5, a, 0);
    else
        tally_wrong(&t[ROOT], fabs((double)(r - want)), a, 0, r, want);
}

static void prove_sqrt(void)
{
    prove_hard(ROOT, "fx_sqrt", check_sqrt);
    prove_phase(all_sqrt, (uint64_t)1 << 32 >> 12, 300);
    prove_phase(mpfr_sqrt_too, 100000, 2000);
    prove_line(ROOT, "fx_sqrt",
               "all inputs, negatives give 0; checked with (2r-1)^2 < 4n < (2r+1)^2, a sample with MPFR");
}

/* 2^24/sqrt(x) from r + 1/2, or r - 1/2: |odd^2 x - 2^50| over x and the sum of the roots, halved. */
static double off_reciprocal(int64_t x, int64_t r)
{
    const i128 one = (i128)1 << 50;
    double v = 0x1p25 / sqrt((double)x);
    double above = (double)(int64_t)((i128)(2 * r + 1) * (2 * r + 1) * x - one) / (double)x / (v + (double)(2 * r + 1));
    double below = (double)(int64_t)(one - (i128)(2 * r - 1) * (2 * r - 1) * x) / (double)x / (v + (double)(2 * r - 1));

    return (above < below ? above : below) / 2;
}

static void check_rsqrt(struct tally *t, int64_t a, int64_t unused)
{
    const i128 one = (i128)1 << 50;
    int64_t r = fx_rsqrt((fx)a);

    (void)unused;
    if (a <= 0 ? r == (a ? 0 : FX_MAX)
               : r > 0 && (i128)(2 * r - 1) * (2 * r - 1) * a < one && one < (i128)(2 * r + 1) * (2 * r + 1) * a)
        tally_right(t, a > 0 ? off_reciprocal(a, r) : 0.5, a, 0);
    else if (a <= 0)
        tally_wrong(t, 1, a, 0, r, a ? 0 : FX_MAX);
    else
        tally_wrong(t, fabs((double)r - 0x1p24 / sqrt((double)a)), a, 0, r, oracle_rsqrt(a));
}

static void all_rsqrt(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t i = 0; i < CHUNK; i++)
        check_rsqrt(&t[ROOT], (int64_t)(chunk * CHUNK) + i - 0x80000000, 0);
}

static void small_rsqrt(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    check_rsqrt(&t[ROOT], (int64_t)chunk, 0);
}

static void mpfr_rsqrt_too(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int64_t a = (prove_scaled(random) & FX_MAX) | 1, r = fx_rsqrt((fx)a), want = oracle_rsqrt(a);

    (void)chunk;
    t[ROOT].by_mpfr++;
    if (r == want)
        tally_right(&t[ROOT], 0.5, a, 0);
    else
        tally_wrong(&t[ROOT], fabs((double)(r - want)), a, 0, r, want);
}

static void prove_rsqrt(void)
{
    prove_hard(ROOT, "fx_rsqrt", check_rsqrt);
    prove_phase(small_rsqrt, 1 << 16, 1 << 16);
    prove_phase(all_rsqrt, (uint64_t)1 << 32 >> 12, 300);
    prove_phase(mpfr_rsqrt_too, 100000, 2000);
    prove_line(
        ROOT, "fx_rsqrt",
        "all inputs, FX_MAX for 0, 0 for negatives; checked with (2r-1)^2 x < 2^50 < (2r+1)^2 x, a sample with MPFR");
}

static void check_root(struct tally *t, uint64_t n, uint64_t want)
{
    uint64_t r = fx_root(n);

    if (r == want)
        tally_right(t, off_boundary(n, r), (int64_t)want, 0);
    else
        tally_wrong(t, fabs((double)r - (double)want), (int64_t)want, 0, (int64_t)r, (int64_t)want);
}

/* The greatest r whose boundary r*r + r is within 2^63. */
static const uint64_t LAST_ROOT = 3037000499;

static void check_boundary(struct tally *t, int64_t r, int64_t unused)
{
    uint64_t n = (uint64_t)r * (uint64_t)r + (uint64_t)r;

    (void)unused;
    check_root(t, n, (uint64_t)r);
    if ((uint64_t)r < LAST_ROOT)
        check_root(t, n + 1, (uint64_t)r + 1);
}

/* From the greatest down: the hard cases come last, then, which are the first to be kept. */
static void boundaries(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (uint64_t i = 0; i < CHUNK; i++) {
        uint64_t r = LAST_ROOT - chunk * CHUNK - i;

        if (r <= LAST_ROOT) /* else the last chunk is through */
            check_boundary(&t[ROOT], (int64_t)r, 0);
    }
}

static void prove_root(void)
{
    prove_hard(ROOT, "fx_root", check_boundary);
    prove_phase(boundaries, LAST_ROOT / CHUNK + 1, 300);
    prove_line(ROOT, "fx_root",
               "both sides of every boundary r*r + r up to 2^63, which cover all n because the estimate is monotonic");
}

static void check_hypot(struct tally *t, int64_t x, int64_t y)
{
    int64_t r = fx_hypot((fx)x, (fx)y);
    uint64_t n = (uint64_t)(x * x) + (uint64_t)(y * y);
    bool beyond = n > (uint64_t)FX_MAX * FX_MAX;

    if (r == FX_MAX && beyond)
        tally_right(t, is_root(n, (uint64_t)r) ? off_boundary(n, (uint64_t)r) : 0.5, x, y);
    else if (r >= 0 && is_root(n, (uint64_t)r))
        tally_right(t, n ? off_boundary(n, (uint64_t)r) : 0.5, x, y);
    else
        tally_wrong(t, fabs((double)r - sqrt((double)n)), x, y, r, beyond ? FX_MAX : oracle_hypot(x, y));
}

/* In the eight positions; 2^31 is a magnitude that only negative numbers have. */
static void check_hypot_mirrored(struct tally *t, int64_t x, int64_t y)
{
    for (int i = 0; i < 8; i++) {
        int64_t a = i & 1 ? y : x, b = i & 1 ? x : y;

        a = i & 2 ? -a : a;
        b = i & 4 ? -b : b;
        if (a <= FX_MAX && b <= FX_MAX && a >= FX_MIN && b >= FX_MIN)
            check_hypot(t, a, b);
    }
}

static void dense_hypot(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)random;
    for (int64_t y = 0; y <= (int64_t)chunk; y++)
        check_hypot_mirrored(&t[ROOT], (int64_t)chunk, y);
}

static void random_hypot(uint64_t chunk, struct tally *t, uint64_t *random)
{
    (void)chunk;
    for (int i = 0; i < CHUNK; i++) {
        int32_t x = prove_scaled(random);

        check_hypot(&t[ROOT], x, prove_scaled(random));
        check_hypot(&t[ROOT], (int32_t)numbers_random(random), x);
    }
}

/* Around the last length that is not clamped, FX_MAX + 1/2. */
static void clamped_hypot(uint64_t chunk, struct tally *t, uint64_t *random)
{
    double limit = (double)FX_MAX * FX_MAX;

    (void)chunk;
    for (int i = 0; i < CHUNK / 8; i++) {
        double x = (double)((uint32_t)numbers_random(random) >> 1), y = floor(sqrt(limit - x * x));

        for (int k = -2; k <= 2; k++)
            check_hypot_mirrored(&t[ROOT], (int64_t)x, (int64_t)y + k);
    }
    check_hypot(&t[ROOT], FX_MIN, FX_MIN);
    check_hypot(&t[ROOT], FX_MIN, 0);
    check_hypot(&t[ROOT], FX_MAX, FX_MIN);
    check_hypot(&t[ROOT], FX_MAX, FX_MAX);
}

static uint64_t power(uint64_t base, uint64_t exponent, uint64_t modulus)
{
    uint64_t v = 1;

    for (; exponent; exponent >>= 1, base = base * base % modulus)
        if (exponent & 1)
            v = v * base % modulus;
    return v;
}

/* By Miller and Rabin; these bases do below 3,215,031,751. */
static bool is_prime(uint64_t p)
{
    static const uint64_t BASES[] = { 2, 3, 5, 7 };
    int twos = 0;

    if (p < 9 || p % 2 == 0)
        return false; /* larger ones are wanted */
    while ((p - 1) >> twos << twos == p - 1)
        twos++;
    twos--;
    for (int i = 0; i < 4; i++) {
        uint64_t v = power(BASES[i] % p, (p - 1) >> twos, p);
        int k = 0;

        if (v == 1)
            continue;
        for (; k < twos && v != p - 1; k++)
            v = v * v % p;
        if (k == twos)
            return false;
    }
    return true;
}

/*
 * x*x + y*y = r*r + r + e, e = 0 or 1: with y = r - k that is x^2 + k^2 - e = r (2k + 1), so (2x)^2 = 4e - 1 modulo p =
 * 2k + 1. When p is prime, a root of -1 is g^((p-1)/4) if g has no root, and one of 3 is 3^((p+1)/4) if p = 11 modulo
 * 12. Every x of the two classes modulo p that this gives lies on the boundary with its y.
 */
static void on_boundary(struct tally *t, uint64_t p, int64_t e, uint64_t root, uint64_t *random)
{
    uint64_t k = p / 2, x = root & 1 ? (root + p) / 2 : root / 2;

    if (numbers_random(random) & 1)
        x = p - x;
    for (int i = 0; i < 4; i++, x += p * (numbers_random(random) % 8 + 1)) {
        i128 n = (i128)x * x + (i128)k * k - e, r = n / (i128)p, y = r - (i128)k;

        if (x > FX_MAX || y > FX_MAX || y < -(i128)FX_MAX)
            return;
        if (r * (i128)p != n) {
            tally_wrong(t, 0, (int64_t)x, (int64_t)y, 0, 0); /* the construction fails: not to be passed over */
            return;
        }
        check_hypot_mirrored(t, (int64_t)x, (int64_t)y);
    }
}

static void boundary_hypot(uint64_t chunk, struct tally *t, uint64_t *random)
{
    uint64_t p = (numbers_random(random) >> 33 >> chunk % 16) | 1, g = 2, root;

    while (!is_prime(p) || !(p % 4 == 1 || p % 12 == 11))
        p = (p + 2) & 0x7fffffff;
    if (p % 4 == 1) {
        while (power(g, p / 2, p) == 1)
            g++;
        root = power(g, p / 4, p);
    } else {
        root = power(3, p / 4 + 1, p);
    }
    on_boundary(&t[ROOT], p, p % 4 == 3, root, random);
}

static void mpfr_hypot_too(uint64_t chunk, struct tally *t, uint64_t *random)
{
    int32_t x = prove_scaled(random), y = prove_scaled(random);
    int64_t r = fx_hypot(x, y), want = oracle_hypot(x, y);

    (void)chunk;
    want = want > FX_MAX ? FX_MAX : want;
    t[ROOT].by_mpfr++;
    if (r == want)
        tally_right(&t[ROOT], 0.5, x, y);
    else
        tally_wrong(&t[ROOT], fabs((double)(r - want)), x, y, r, want);
}

static void prove_hypot(void)
{
    prove_hard(ROOT, "fx_hypot", check_hypot_mirrored);
    prove_phase(dense_hypot, 1 << 12, 16);
    prove_phase(random_hypot, 1 << 14, 16);
    prove_phase(clamped_hypot, 1 << 12, 8);
    prove_phase(boundary_hypot, 1 << 21, 1 << 12);
    prove_phase(mpfr_hypot_too, 100000, 2000);
    prove_line(ROOT, "fx_hypot",
               "dense, random, around the clamp; hard: x*x + y*y = r*r + r or one more, from (2x)^2 = -1 or 3 modulo a "
               "prime; a sample with MPFR");
}

int main(int argc, char **argv)
{
    static const struct proof PROOFS[] = {
        { "fx_sqrt", prove_sqrt },
        { "fx_rsqrt", prove_rsqrt },
        { "fx_root", prove_root },
        { "fx_hypot", prove_hypot },
    };

    return prove_main(argc, argv, PROOFS, COUNT(PROOFS));
}
