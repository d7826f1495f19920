/*
 * int.h - the smaller, the larger and the absolute value of whole numbers, values clamped to a range, set bits.
 * floor: base
 */
#ifndef BASE_INT_H
#define BASE_INT_H

#include <stdint.h>

/*
 * For a type: NAME_min(a, b), NAME_max(a, b); NAME_abs(v), v not the least there is; NAME_clamp(v, lo, hi), which is v
 * clamped to lo..hi, lo <= hi.
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

/* The number of the lowest set bit, v != 0. */
static inline uint32_t bits_lowest(uint64_t v)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctzll(v);
#else
    uint32_t n = 0;
    for (; !(v & 1); v >>= 1)
        n++;
    return n;
#endif
}

/* The number of the highest set bit, v != 0. */
static inline uint32_t bits_highest(uint32_t v)
{
#ifdef __GNUC__
    return 31u - (uint32_t)__builtin_clz(v);
#else
    uint32_t n = 0;
    while (v >>= 1)
        n++;
    return n;
#endif
}

/* How many bits are set, counted in bytes: the processors that are compiled for have no instruction for it. */
static inline int bits_count(uint64_t v)
{
    v -= v >> 1 & 0x5555555555555555;
    v = (v & 0x3333333333333333) + (v >> 2 & 0x3333333333333333);
    return (int)(((v + (v >> 4)) & 0x0f0f0f0f0f0f0f0f) * 0x0101010101010101 >> 56);
}

#endif
