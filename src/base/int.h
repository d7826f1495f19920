/*
 * int.h - the smaller, the larger and the absolute value of whole numbers, and values clamped to a range.
 * floor: base
 */
#ifndef BASE_INT_H
#define BASE_INT_H

#include <stdint.h>

static inline int int_min(int a, int b)
{
    return a < b ? a : b;
}

static inline int int_max(int a, int b)
{
    return a > b ? a : b;
}

/* v clamped to lo..hi, lo <= hi. */
static inline int int_clamp(int v, int lo, int hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static inline int64_t int64_min(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static inline int64_t int64_max(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

/* |v|, v > INT64_MIN. */
static inline int64_t int64_abs(int64_t v)
{
    return v < 0 ? -v : v;
}

static inline int64_t int64_clamp(int64_t v, int64_t lo, int64_t hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

#endif
