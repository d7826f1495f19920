/*
 * fx.h - Q15.16 fixed point: 65536 is one.
 *
 * The rounding rule: a result is the exact value rounded once to the nearest representable value, ties to even, and
 * clamped to FX_MIN..FX_MAX. So functions that are odd in mathematics are odd here (a mirrored pattern stays mirrored),
 * and every compiler and processor gives the same bits: a first guess may be computed in doubles, but integers decide.
 *
 * FX_MIN is an ordinary value. Its negation is one unit beyond FX_MAX, so FX_MIN / -FX_ONE, FX_MIN * -FX_ONE, 0 -
 * FX_MIN and the length of (FX_MIN, 0) are FX_MAX.
 *
 * Each guess in doubles has an integer-only equivalent. Defining FX_INTEGER selects the integer versions throughout,
 * for targets that emulate doubles in software; the results are the same. Values passed to or from Lua are doubles in
 * any case.
 *
 * Assumes IEEE 754 doubles in the default rounding mode, arithmetic right shifts, and conversions to signed types that
 * wrap (gcc and clang guarantee both).
 */
#ifndef BASE_FX_H
#define BASE_FX_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "int.h"

/* ieee.h detects at run time the flags for which compilers define no macro. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    defined(__NO_SIGNED_ZEROS__) || defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "build without -ffast-math and the flags it sets: results must be the same everywhere"
#endif
_Static_assert(sizeof 0.1 == sizeof(double),
               "build without -fsingle-precision-constant: results must be the same everywhere");
/* FLT_EVAL_METHOD 1 (s390x) evaluates float as double; doubles are unaffected and float is not used. 16 affects only
 * _Float16. */
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || !(FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 16)
#error "doubles must be IEEE 754 binary64, evaluated without excess precision (on i386: -msse2 -mfpmath=sse)"
#endif

typedef int32_t fx;   /* Q15.16 */
typedef uint32_t ang; /* a binary angle: 2^32 is a full turn, see trig.h */

#define FX_ONE 65536
#define FX_MAX INT32_MAX
#define FX_MIN INT32_MIN

/*
 * Rare cases are handled in a branch: a predicted branch costs nothing, while a select between two values (which
 * compilers prefer) makes the result wait for both values. FX_KEEP_BRANCH(v) inside such a branch, where v is the
 * variable that the branch changes, keeps the compiler from turning the branch into a select. FX_LIKELY(x) is x,
 * predicted to be true.
 */
#if defined(__GNUC__)
#define FX_KEEP_BRANCH(v) __asm__("" : "+r"(v))
#define FX_LIKELY(x)      __builtin_expect(!!(x), 1)
#define FX_COLD           __attribute__((noinline, cold, unused))
#else
#define FX_KEEP_BRANCH(v) ((void)0)
#define FX_LIKELY(x)      (x)
#define FX_COLD
#endif

/* Returns v clamped to the range of fx. */
static inline fx fx_sat(int64_t v)
{
    if (!FX_LIKELY((fx)v == v)) {
        FX_KEEP_BRANCH(v);
        return (fx)(v >> 63 ^ FX_MAX);
    }
    return (fx)v;
}

INT_FUNCTIONS(fx, fx)

/* Returns the high half of the 128-bit product; the low half is a * b. */
static inline uint64_t fx_mul_high(uint64_t a, uint64_t b)
{
#if defined(__SIZEOF_INT128__) && !defined(FX_NO_INT128)
    return (uint64_t)(__extension__(unsigned __int128) a * b >> 64);
#else
    uint64_t al = a & 0xffffffffu, ah = a >> 32, bl = b & 0xffffffffu, bh = b >> 32;
    uint64_t mid = ah * bl + (al * bl >> 32), mid2 = al * bh + (mid & 0xffffffffu);

    return ah * bh + (mid >> 32) + (mid2 >> 32);
#endif
}

/* Returns the whole number nearest to v, ties to even; |v| < 2^51. A double near 1.5 * 2^52 has no bits below one, so
 * the addition does the rounding. */
static inline int64_t fx_nearest(double v)
{
    double sum = v + 6755399441055744.0;
    int64_t bits;

    memcpy(&bits, &sum, sizeof bits);
    return bits - 0x4338000000000000;
}

/* Returns sqrt(n) to about 52 bits, n <= 2^63. Callers correct the result by exact tests. */
static inline double fx_root_guess(uint64_t n)
{
    return sqrt((double)(int64_t)(n - (n >> 63)));
}

/* Returns floor(sqrt(n)), computed one bit per step. Replaces fx_root_guess in builds with FX_INTEGER. */
static inline uint64_t fx_root_bits(uint64_t n)
{
    uint64_t r = 0;

    for (uint64_t bit = (uint64_t)1 << 62; bit; bit >>= 2) {
        uint64_t candidate = r + bit;

        r >>= 1;
        if (n >= candidate) {
            n -= candidate;
            r += bit;
        }
    }
    return r;
}

/*
 * Returns the whole number nearest to sqrt(n), n <= 2^63. (r + 1/2)^2 is never whole, so there are no ties: r is right
 * when r*r - r < n <= r*r + r. The guess is off by less than 2^-20; truncated, it is r or r - 1.
 */
static inline uint64_t fx_root(uint64_t n)
{
#ifdef FX_INTEGER
    uint64_t r = fx_root_bits(n);
#else
    uint64_t r = (uint64_t)(int64_t)fx_root_guess(n);
#endif

    return r + (n > r * r + r);
}

/* Converts a whole number to fx; clamped. */
static inline fx fx_int(int n)
{
    fx v = (fx)((uint32_t)n << 16);

    if (!FX_LIKELY(v >> 16 == n)) {
        FX_KEEP_BRANCH(n);
        return n >> 31 ^ FX_MAX;
    }
    return v;
}

/* Returns the greatest whole number not above v. */
static inline int fx_floor(fx v)
{
    return v >> 16;
}

static inline fx fx_add(fx a, fx b)
{
    fx sum = (fx)((uint32_t)a + (uint32_t)b);

    if (!FX_LIKELY(((a ^ sum) & (b ^ sum)) >= 0)) {
        FX_KEEP_BRANCH(a);
        return a >> 31 ^ FX_MAX;
    }
    return sum;
}

static inline fx fx_sub(fx a, fx b)
{
    fx diff = (fx)((uint32_t)a - (uint32_t)b);

    if (!FX_LIKELY(((a ^ diff) & (a ^ b)) >= 0)) {
        FX_KEEP_BRANCH(a);
        return a >> 31 ^ FX_MAX;
    }
    return diff;
}

/* Returns p / 2^16 rounded, ties to even, where up is p + 2^15; not clamped. The shift rounds halves up, so a tie whose
 * result is odd is one too high. */
static inline int64_t fx_round_half_even(int64_t biased)
{
    int64_t q = biased >> 16;

    if (!FX_LIKELY((uint16_t)biased != 0)) {
        q -= q & 1;
        FX_KEEP_BRANCH(q);
    }
    return q;
}

static inline fx fx_mul(fx a, fx b)
{
    return fx_sat(fx_round_half_even((int64_t)a * b + 0x8000));
}

/*
 * Returns a/b; a/0 is FX_MAX or FX_MIN depending on the sign of a, 0/0 is 0. A quotient that is a tie is exact as a
 * double. Any other quotient is at least 1 / 2|b| away from a tie, which is at least 2^-48 of the quotient; rounding to
 * a double changes the quotient by at most 2^-53 of it.
 */
static inline fx fx_div(fx a, fx b)
{
    if (b == 0)
        return a > 0 ? FX_MAX : a < 0 ? FX_MIN : 0;
#ifdef FX_INTEGER
    int64_t wa = a, wb = b;
    uint64_t n = (uint64_t)(a < 0 ? -wa : wa) << 16, d = (uint64_t)(b < 0 ? -wb : wb);
    uint64_t q = n / d, twice = (n - q * d) * 2;

    q += (twice > d) | ((twice == d) & (q & 1));
    return fx_sat((a ^ b) < 0 ? -(int64_t)q : (int64_t)q);
#else
    return fx_sat(fx_nearest(a * 65536.0 / b));
#endif
}

/* Returns the square root; 0 for x < 0. */
static inline fx fx_sqrt(fx x)
{
    return x > 0 ? (fx)fx_root((uint64_t)x << 16) : 0;
}

/*
 * Returns 1/sqrt(x); FX_MAX for x = 0, and 0 for x < 0. In units the result is 2^24/sqrt(x), and r is right when (2r -
 * 1)^2 x < 2^50 < (2r + 1)^2 x; an odd square times x < 2^31 is never 2^50, so there are no ties.
 */
static inline fx fx_rsqrt(fx x)
{
    if (x <= 0)
        return x < 0 ? 0 : FX_MAX;

#ifdef FX_INTEGER
    uint64_t r = fx_root_bits(((uint64_t)1 << 48) / (uint32_t)x); /* floor(sqrt(floor(v))) is floor(sqrt(v)) */
#else
    uint64_t r = (uint64_t)(int64_t)(16777216.0 / sqrt((double)x));
#endif
    uint64_t m = 2 * r + 1;

    return (fx)(r + (m * m * (uint64_t)x < (uint64_t)1 << 50));
}

/* Returns x*x + y*y in square units, exact: at most 2^63. */
static inline uint64_t fx_length_squared(fx x, fx y)
{
    return (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y);
}

/* Returns the length of (x, y); clamped, as it can reach 46341, above the range of fx. */
static inline fx fx_hypot(fx x, fx y)
{
    return fx_sat((int64_t)fx_root(fx_length_squared(x, y)));
}

/* Computes fx_lerp for t outside 0..1. */
FX_COLD static fx fx_lerp_beyond(fx a, fx b, fx t)
{
    int64_t p = ((int64_t)b - a) * t; /* |p| < 2^63 */
    int64_t q = (p >> 16) + a, fraction = p & 0xffff;

    return fx_sat(q + ((fraction > 0x8000) | ((fraction == 0x8000) & (q & 1))));
}

/* Returns a + (b - a) * t for any t: a at t = 0, b at t = FX_ONE, extrapolated outside 0..1. Monotone in each
 * argument. */
static inline fx fx_lerp(fx a, fx b, fx t)
{
    uint32_t u = (uint32_t)t;

    if (!FX_LIKELY(u <= FX_ONE))
        return fx_lerp_beyond(a, b, t);
    return (fx)fx_round_half_even((int64_t)a * (FX_ONE - u) + ((int64_t)b * u + 0x8000));
}

/* Stores the fx nearest to v in *out. Returns false, leaving *out untouched, for NaN and for v that rounds outside
 * FX_MIN..FX_MAX. */
static inline bool fx_from_double(double v, fx *out)
{
    double units = v * FX_ONE; /* exact, or infinite */

    if (!FX_LIKELY(units >= -2147483648.5 && units < 2147483647.5))
        return false;
    *out = (fx)fx_nearest(units);
    return true;
}

/* Converts v to a double; exact. */
static inline double fx_to_double(fx v)
{
    return v / 65536.0;
}

#endif
