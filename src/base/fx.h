/*
 * fx.h - Q15.16 fixed point: 65536 is one.
 *
 * The rounding law: a result is the exact value rounded once to the nearest representable one, ties to the even one,
 * and clamped to FX_MIN..FX_MAX. So the functions are odd where mathematics is (a mirrored pattern stays mirrored), and
 * their bits depend on no compiler and no processor: where a double makes the first guess, integers decide.
 *
 * FX_MIN is a number like any other. Its negative is one unit beyond FX_MAX, so FX_MIN / -FX_ONE, FX_MIN * -FX_ONE,
 * 0 - FX_MIN and the length of (FX_MIN, 0) are FX_MAX.
 *
 * Each such guess has a twin made of integers alone. With FX_INTEGER defined the twins are used throughout, for targets
 * whose doubles are made by software; results are the same. What comes from or goes to Lua is a double in any case.
 *
 * Relied upon: IEEE 754 doubles in the default rounding mode, arithmetic right shifts, conversions to signed types that
 * wrap (gcc and clang promise both).
 */
#ifndef BASE_FX_H
#define BASE_FX_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "int.h"

/* What a compiler does not tell by a macro, ieee.h finds when the program runs. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    defined(__NO_SIGNED_ZEROS__) || defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "build without -ffast-math and the flags it sets: results must be the same everywhere"
#endif
_Static_assert(sizeof 0.1 == sizeof(double),
               "build without -fsingle-precision-constant: results must be the same everywhere");
/* 1 (s390x): float in double, which changes no double, and there is no float; 16: _Float16 alone. */
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || !(FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 16)
#error "doubles must be IEEE 754 binary64, evaluated without excess precision (on i386: -msse2 -mfpmath=sse)"
#endif

typedef int32_t fx;   /* Q15.16 */
typedef uint32_t ang; /* a binary angle: 2^32 is a turn, see trig.h */

#define FX_ONE 65536
#define FX_MAX INT32_MAX
#define FX_MIN INT32_MIN

/*
 * What hardly ever happens stands in a branch: one that is predicted costs nothing, while a choice between two values
 * (which compilers prefer) makes the result wait for both. FX_RARE(v) in such a branch, v being what it changes, keeps
 * it one. FX_USUAL(x) is x.
 */
#if defined(__GNUC__)
#define FX_RARE(v)  __asm__("" : "+r"(v))
#define FX_USUAL(x) __builtin_expect(!!(x), 1)
#define FX_COLD     __attribute__((noinline, cold, unused))
#else
#define FX_RARE(v)  ((void)0)
#define FX_USUAL(x) (x)
#define FX_COLD
#endif

/* v clamped to what an fx holds. */
static inline fx fx_sat(int64_t v)
{
    if (!FX_USUAL((fx)v == v)) {
        FX_RARE(v);
        return (fx)(v >> 63 ^ FX_MAX);
    }
    return (fx)v;
}

INT_FUNCTIONS(fx, fx)

/* The high half of the 128-bit product; the low half is a * b. */
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

/* The whole number nearest to v, ties to even, |v| < 2^51: 1.5 * 2^52 has no bits below one, so the sum is rounded
 * so. */
static inline int64_t fx_nearest(double v)
{
    double sum = v + 6755399441055744.0;
    int64_t bits;

    memcpy(&bits, &sum, sizeof bits);
    return bits - 0x4338000000000000;
}

/* sqrt(n) to about 52 bits, n <= 2^63: where exact tests start from. */
static inline double fx_root_guess(uint64_t n)
{
    return sqrt((double)(int64_t)(n - (n >> 63)));
}

/* The greatest whole number that is not above sqrt(n), a bit a step: the twin. */
static inline uint64_t fx_root_bits(uint64_t n)
{
    uint64_t r = 0;

    for (uint64_t bit = (uint64_t)1 << 62; bit; bit >>= 2) {
        uint64_t with = r + bit;

        r >>= 1;
        if (n >= with) {
            n -= with;
            r += bit;
        }
    }
    return r;
}

/*
 * The whole number nearest to sqrt(n), n <= 2^63. (r + 1/2)^2 is never whole, so there are no ties: r is right when
 * r*r - r < n <= r*r + r. The guess is off by less than 2^-20; cut to a whole number it is r or r - 1.
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

/* n whole units; clamped. */
static inline fx fx_int(int n)
{
    fx v = (fx)((uint32_t)n << 16);

    if (!FX_USUAL(v >> 16 == n)) {
        FX_RARE(n);
        return n >> 31 ^ FX_MAX;
    }
    return v;
}

/* The greatest whole number that is not above v. */
static inline int fx_floor(fx v)
{
    return v >> 16;
}

static inline fx fx_add(fx a, fx b)
{
    fx sum = (fx)((uint32_t)a + (uint32_t)b);

    if (!FX_USUAL(((a ^ sum) & (b ^ sum)) >= 0)) {
        FX_RARE(a);
        return a >> 31 ^ FX_MAX;
    }
    return sum;
}

static inline fx fx_sub(fx a, fx b)
{
    fx diff = (fx)((uint32_t)a - (uint32_t)b);

    if (!FX_USUAL(((a ^ diff) & (a ^ b)) >= 0)) {
        FX_RARE(a);
        return a >> 31 ^ FX_MAX;
    }
    return diff;
}

/* p / 2^16 by p + 2^15, not clamped. Shifted, that is rounded half up; a tie that came out odd is one too many. */
static inline int64_t fx_half_even(int64_t up)
{
    int64_t q = up >> 16;

    if (!FX_USUAL((uint16_t)up != 0)) {
        q -= q & 1;
        FX_RARE(q);
    }
    return q;
}

static inline fx fx_mul(fx a, fx b)
{
    return fx_sat(fx_half_even((int64_t)a * b + 0x8000));
}

/*
 * a/b; a/0 is FX_MAX or FX_MIN by the sign of a, 0/0 is 0. A quotient that is a tie is exact in a double; any other is
 * off a tie by 1 / 2|b| or more, 2^-48 of itself, which is more than the double's 2^-53.
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

/* The square root; 0 for x < 0. */
static inline fx fx_sqrt(fx x)
{
    return x > 0 ? (fx)fx_root((uint64_t)x << 16) : 0;
}

/*
 * 1/sqrt(x); FX_MAX for x = 0, and 0 for x < 0. In units: 2^24/sqrt(x), and r is right when
 * (2r - 1)^2 x < 2^50 < (2r + 1)^2 x; an odd square times x < 2^31 is never 2^50, so there are no ties.
 */
static inline fx fx_rsqrt(fx x)
{
    if (x <= 0)
        return x < 0 ? 0 : FX_MAX;

#ifdef FX_INTEGER
    uint64_t r = fx_root_bits(((uint64_t)1 << 48) / (uint32_t)x); /* the root of what is cut is the root, cut */
#else
    uint64_t r = (uint64_t)(int64_t)(16777216.0 / sqrt((double)x));
#endif
    uint64_t m = 2 * r + 1;

    return (fx)(r + (m * m * (uint64_t)x < (uint64_t)1 << 50));
}

/* x*x + y*y in square units, exact: at most 2^63. */
static inline uint64_t fx_square(fx x, fx y)
{
    return (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y);
}

/* The length of (x, y); clamped, for it can reach 46341. */
static inline fx fx_hypot(fx x, fx y)
{
    return fx_sat((int64_t)fx_root(fx_square(x, y)));
}

/* fx_lerp for t outside 0..1. */
FX_COLD static fx fx_lerp_beyond(fx a, fx b, fx t)
{
    int64_t p = ((int64_t)b - a) * t; /* |p| < 2^63 */
    int64_t q = (p >> 16) + a, rest = p & 0xffff;

    return fx_sat(q + ((rest > 0x8000) | ((rest == 0x8000) & (q & 1))));
}

/* a + (b - a) * t, for any t: a at t = 0, b at t = FX_ONE, beyond them outside 0..1. Monotone in each argument. */
static inline fx fx_lerp(fx a, fx b, fx t)
{
    uint32_t u = (uint32_t)t;

    if (!FX_USUAL(u <= FX_ONE))
        return fx_lerp_beyond(a, b, t);
    return (fx)fx_half_even((int64_t)a * (FX_ONE - u) + ((int64_t)b * u + 0x8000));
}

/* The fx nearest to v into *out. False, and *out untouched, for NaN and for v that rounds outside FX_MIN..FX_MAX. */
static inline bool fx_from_double(double v, fx *out)
{
    double units = v * FX_ONE; /* exact, or infinite */

    if (!FX_USUAL(units >= -2147483648.5 && units < 2147483647.5))
        return false;
    *out = (fx)fx_nearest(units);
    return true;
}

/* Exact. */
static inline double fx_to_double(fx v)
{
    return v / 65536.0;
}

#endif
