/*
 * bits.h - the lowest and the highest set bit of a word.
 * floor: base
 */
#ifndef BASE_BITS_H
#define BASE_BITS_H

#include <stdint.h>

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

#endif
