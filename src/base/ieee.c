/*
 * ieee.c - see ieee.h.
 *
 * Each expression is one that some flag allows the compiler to compute differently. Operands are volatile, so that the
 * compiler cannot know their values. Results are compared bit for bit, because a flag may also change constants.
 */
#include "ieee.h"
#include "fx.h"

static bool is(double v, uint64_t bits)
{
    uint64_t has;

    memcpy(&has, &v, sizeof has);
    return has == bits;
}

/* Returns whether divisions are computed as divisions: multiplying by a precomputed 1 / 3 or 1 / 49 gives other
 * results. */
static bool divides(void)
{
    volatile double five = 5, forty_nine = 49;
    double n = five, by = forty_nine, a = n / by, b = (n + 1) / by, c = (n + 2) / by;

    return is(n / 49.0, 0x3fba1f58d0fac688) && is(a, 0x3fba1f58d0fac688) && is(b, 0x3fbf58d0fac687d6) &&
           is(c, 0x3fc2492492492492) && is(n / 3.0, 0x3ffaaaaaaaaaaaab);
}

/* Returns whether sums are evaluated from left to right, and the part of a sum that is rounded off is lost.
 * 9007199254740992 is 2^53. */
static bool adds(void)
{
    volatile double small = 0.25, wide = 9007199254740992.0;
    double v = small, w = wide;

    return is((v + 6755399441055744.0) - 6755399441055744.0, 0) && is((v + w) - w, 0) &&
           is((w + 1.0) + 1.0, 0x4340000000000000) && is((w + (v + v)) + (v + v), 0x4340000000000000);
}

/* Returns whether a product is rounded before it is added: (1 + 2^-27)^2 is 1 + 2^-26 + 2^-54. Each product is used
 * only once, because the compiler might not fuse a product that is used twice. */
static bool multiplies(void)
{
    volatile double odd = 1 + 1.0 / 134217728, square = 1 + 1.0 / 67108864;
    double a = odd, s = square, left = a * a - s;
    double b = odd, c = odd, t = square, right = t - b * c;

    return is(left, 0) && is(right, 0);
}

/* Returns whether sums are rounded only once: 1 + 2^-53 + 2^-78 is more than halfway to the next double. */
static bool rounds_once(void)
{
    volatile double one = 1, half = (1 + 1.0 / 33554432) / 9007199254740992.0;
    double v = one + half;

    return is(v, 0x3ff0000000000001);
}

/* Returns whether 0 has a sign, NaN equals nothing, and infinity is greater than all numbers. */
static bool knows_zero_and_beyond(void)
{
    volatile double zero = 0, none = -zero;
    double z = zero, minus = none, endless = 1 / z, nan = z / z;

    return is(minus + 0.0, 0) && is(0.0 - z, 0) && is(minus, 0x8000000000000000) && !(nan == nan) && nan != nan &&
           isnan(nan) && !isfinite(nan) && !(z < nan || z >= nan) && endless > DBL_MAX && endless == endless + 1 &&
           endless == (double)INFINITY && !isfinite(endless);
}

/* Returns whether numbers smaller than DBL_MIN are kept rather than flushed to 0, both at run time and in constants
 * that the compiler computes. */
static bool keeps_small(void)
{
    volatile double smallest = DBL_MIN;
    double v = smallest, known = DBL_MIN;

    for (int i = 0; i < 52; i++)
        known *= 0.5;
    return is(v / 4503599627370496.0, 1) && is(known, 1) && v / 2 > 0;
}

static bool takes_roots(void)
{
    volatile double two = 2, three = 3;

    return is(sqrt(two), 0x3ff6a09e667f3bcd) && is(sqrt(three), 0x3ffbb67ae8584caa) &&
           is(1 / sqrt(two), 0x3fe6a09e667f3bcc);
}

#define BUILT "built with flags that change results: "

const char *ieee_fault(void)
{
    if (!divides())
        return BUILT "divisions become multiplications by reciprocals (-freciprocal-math, -funsafe-math-optimizations, "
                     "-ffast-math)";
    if (!adds())
        return BUILT "sums are reordered (-fassociative-math, -funsafe-math-optimizations, -ffast-math)";
    if (!multiplies())
        return BUILT "multiplications and additions are fused (-ffp-contract=off is missing)";
    if (!rounds_once())
        return BUILT "sums are rounded twice (on i386: -msse2 -mfpmath=sse is missing)";
    if (!knows_zero_and_beyond())
        return BUILT "-0, NaN or infinity is ignored (-fno-signed-zeros, -ffinite-math-only, -fno-honor-nans)";
    if (!keeps_small())
        return BUILT "small numbers are flushed to 0 (-fdenormal-fp-math, -ffast-math)";
    return takes_roots() ? NULL : BUILT "square roots are estimated (-mrecip, -ffast-math)";
}
