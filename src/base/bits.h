/*
 * bits.h - the lowest and highest set bits of a word, and the number of set bits.
 */
#ifndef BASE_BITS_H
#define BASE_BITS_H

#include <stdint.h>

/* Returns the index of the lowest set bit; v != 0. */
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

/* Returns the index of the highest set bit; v != 0. */
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

/* Returns the number of set bits. Uses shifts and adds, because the baseline processors of the build have no
 * instruction that counts bits. */
static inline int bits_count(uint64_t v)
{
    v -= v >> 1 & 0x5555555555555555;
    v = (v & 0x3333333333333333) + (v >> 2 & 0x3333333333333333);
    return (int)(((v + (v >> 4)) & 0x0f0f0f0f0f0f0f0f) * 0x0101010101010101 >> 56);
}

#endif
