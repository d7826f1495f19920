/*
 * ieee.c - see ieee.h.
 *
 * Each expression is one that some flag allows the compiler to compute differently. Operands are volatile, so that the
 * compiler cannot know their values. Results are compared bit for bit, because a flag may also change constants.
 */
#include "ieee.h"
#include "fx.h"

static bool has_bits(double v, uint64_t bits)
{
    uint64_t actual;

    memcpy(&actual, &v, sizeof actual);
    return actual == bits;
}

/* Returns whether divisions are computed as divisions: multiplying by a precomputed 1 / 3 or 1 / 49 gives other
 * results. */
static bool divides_exactly(void)
{
    volatile double five = 5, forty_nine = 49;
    double n = five, divisor = forty_nine, a = n / divisor, b = (n + 1) / divisor, c = (n + 2) / divisor;

    return has_bits(n / 49.0, 0x3fba1f58d0fac688) && has_bits(a, 0x3fba1f58d0fac688) &&
           has_bits(b, 0x3fbf58d0fac687d6) && has_bits(c, 0x3fc2492492492492) && has_bits(n / 3.0, 0x3ffaaaaaaaaaaaab);
}

/* Returns whether sums are evaluated from left to right, and the part of a sum that is rounded off is lost.
 * 9007199254740992 is 2^53. */
static bool adds_in_order(void)
{
    volatile double small = 0.25, large = 9007199254740992.0;
    double v = small, w = large;

    return has_bits((v + 6755399441055744.0) - 6755399441055744.0, 0) && has_bits((v + w) - w, 0) &&
           has_bits((w + 1.0) + 1.0, 0x4340000000000000) && has_bits((w + (v + v)) + (v + v), 0x4340000000000000);
}

/* Returns whether a product is rounded before it is added: (1 + 2^-27)^2 is 1 + 2^-26 + 2^-54. Each product is used
 * only once, because the compiler might not fuse a product that is used twice. */
static bool rounds_products(void)
{
    volatile double factor = 1 + 1.0 / 134217728, square = 1 + 1.0 / 67108864;
    double a = factor, s = square, left = a * a - s;
    double b = factor, c = factor, t = square, right = t - b * c;

    return has_bits(left, 0) && has_bits(right, 0);
}

/* Returns whether sums are rounded only once: 1 + 2^-53 + 2^-78 is more than halfway to the next double. */
static bool rounds_once(void)
{
    volatile double one = 1, half = (1 + 1.0 / 33554432) / 9007199254740992.0;
    double v = one + half;

    return has_bits(v, 0x3ff0000000000001);
}

/* Returns whether 0 has a sign, NaN equals nothing, and infinity is greater than all numbers. */
static bool honors_zero_nan_infinity(void)
{
    volatile double zero = 0, negated = -zero;
    double z = zero, minus_zero = negated, inf = 1 / z, quiet_nan = z / z;

    return has_bits(minus_zero + 0.0, 0) && has_bits(0.0 - z, 0) && has_bits(minus_zero, 0x8000000000000000) &&
           !(quiet_nan == quiet_nan) && quiet_nan != quiet_nan && isnan(quiet_nan) && !isfinite(quiet_nan) &&
           !(z < quiet_nan || z >= quiet_nan) && inf > DBL_MAX && inf == inf + 1 && inf == (double)INFINITY &&
           !isfinite(inf);
}

/* Returns whether numbers smaller than DBL_MIN are kept rather than flushed to 0, both at run time and in constants
 * that the compiler computes. */
static bool keeps_denormals(void)
{
    volatile double smallest = DBL_MIN;
    double v = smallest, folded = DBL_MIN;

    for (int i = 0; i < 52; i++)
        folded *= 0.5;
    return has_bits(v / 4503599627370496.0, 1) && has_bits(folded, 1) && v / 2 > 0;
}

static bool computes_exact_roots(void)
{
    volatile double two = 2, three = 3;

    return has_bits(sqrt(two), 0x3ff6a09e667f3bcd) && has_bits(sqrt(three), 0x3ffbb67ae8584caa) &&
           has_bits(1 / sqrt(two), 0x3fe6a09e667f3bcc);
}

#define FAULT_PREFIX "built with flags that change results: "

const char *ieee_find_fault(void)
{
    if (!divides_exactly())
        return FAULT_PREFIX
            "divisions become multiplications by reciprocals (-freciprocal-math, -funsafe-math-optimizations, "
            "-ffast-math)";
    if (!adds_in_order())
        return FAULT_PREFIX "sums are reordered (-fassociative-math, -funsafe-math-optimizations, -ffast-math)";
    if (!rounds_products())
        return FAULT_PREFIX "multiplications and additions are fused (-ffp-contract=off is missing)";
    if (!rounds_once())
        return FAULT_PREFIX "sums are rounded twice (on i386: -msse2 -mfpmath=sse is missing)";
    if (!honors_zero_nan_infinity())
        return FAULT_PREFIX "-0, NaN or infinity is ignored (-fno-signed-zeros, -ffinite-math-only, -fno-honor-nans)";
    if (!keeps_denormals())
        return FAULT_PREFIX "small numbers are flushed to 0 (-fdenormal-fp-math, -ffast-math)";
    return computes_exact_roots() ? NULL : FAULT_PREFIX "square roots are estimated (-mrecip, -ffast-math)";
}
