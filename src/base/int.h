/*
 * int.h - minimum, maximum, absolute value and clamping of integers; the length of arrays.
 */
#ifndef BASE_INT_H
#define BASE_INT_H

#include <stdint.h>

/*
 * Defines for a type: NAME_min(a, b), NAME_max(a, b); NAME_abs(v), where v must not be the type's minimum;
 * NAME_clamp(v, lo, hi), which clamps v to lo..hi, lo <= hi.
 */
#define INT_FUNCTIONS(name, type)                                                                                      \
    static inline type name##_min(type a, type b)                                                                      \
    {                                                                                                                  \
        return a < b ? a : b;                                                                                          \
    }                                                                                                                  \
    static inline type name##_max(type a, type b)                                                                      \
    {                                                                                                                  \
        return a > b ? a : b;                                                                                          \
    }                                                                                                                  \
    static inline type name##_abs(type v)                                                                              \
    {                                                                                                                  \
        return v < 0 ? -v : v;                                                                                         \
    }                                                                                                                  \
    static inline type name##_clamp(type v, type lo, type hi)                                                          \
    {                                                                                                                  \
        return v < lo ? lo : v > hi ? hi : v;                                                                          \
    }

INT_FUNCTIONS(int, int)
INT_FUNCTIONS(int64, int64_t)

/* Returns a modulo n, never negative; n > 0. */
static inline int64_t int64_modulo(int64_t a, int64_t n)
{
    int64_t r = a % n;

    return r < 0 ? r + n : r;
}

/* The number of items of an array. */
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* Returns n rounded up to a multiple of 64 bytes, a cache line. */
static inline uint64_t int_align_cache_line(uint64_t n)
{
    return (n + 63) / 64 * 64;
}

#endif
