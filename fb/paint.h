/*
 * paint.h - pictures of which nothing is cut off, sixteen pixels at a time: what blit.c and stamp.c share. The mask is
 * made of the pixels as they go, which takes less time than to fetch it: a store to each row is what the time goes to.
 * floor: fb
 *
 * `unroll 1` keeps the loops over sixteen bytes loops: gcc's -O3 would unroll them first and then find no vectors in
 * what is left. tests/house/levels.sh reads the compilers' output for it. The rule, and mostly the height, is a
 * constant where these are called; forced, for gcc would make one loop of all calls.
 */
#ifndef FB_PAINT_H
#define FB_PAINT_H

#include "blit.h"
#include "words.h"

static inline void cover(uint8_t *d, uint64_t s, uint64_t add)
{
    uint64_t mask = words_opaque(s);

    words_store(d, (words_load(d) & ~mask) | (words_add(s, add) & mask));
}

/* Sixteen pixels at once, in a form that compilers turn into vector instructions of the plainest kind: a select by
 * mask, no branch, a constant count. */
static inline void cover_pair(uint8_t *restrict d, const uint8_t *restrict s, uint8_t add)
{
#pragma GCC unroll 1
    for (int k = 0; k < 16; k++) {
        uint8_t mask = (uint8_t)(0 - (s[k] != 0)), colour = (uint8_t)(s[k] + add);
        d[k] = (uint8_t)(d[k] ^ ((d[k] ^ colour) & mask));
    }
}

/* The same, each mixed by a rule; rule is a constant in the calls. */
static inline void mix_pair(uint8_t *restrict d, const uint8_t *restrict s, uint8_t add, enum blit_mix rule)
{
#pragma GCC unroll 1
    for (int k = 0; k < 16; k++) {
        uint8_t mask = (uint8_t)(0 - (s[k] != 0)), over = (uint8_t)(s[k] + add);
        uint8_t a = d[k] & 15, b = over & 15, sum = (uint8_t)(a + b), most = a > b ? a : b;
        uint8_t half = (uint8_t)((uint8_t)(sum + 1) >> 1), added = sum < 15 ? sum : 15;
        uint8_t shade = rule == BLIT_RAMP_ADD ? added : rule == BLIT_RAMP_HALF ? half : most;
        d[k] = (uint8_t)(d[k] ^ ((d[k] ^ ((over & 0xf0) | shade)) & mask));
    }
}

/* Eight pixels: half of sixteen. */
static inline void mix_eight(uint8_t *d, const uint8_t *s, uint8_t add, enum blit_mix rule)
{
    uint8_t pair[16] = { 0 }, from[16] = { 0 };

    memcpy(pair, d, 8);
    memcpy(from, s, 8);
    mix_pair(pair, from, add, rule);
    memcpy(d, pair, 8);
}

/* Sixteen pixels, opaque or by a rule. */
__attribute__((always_inline)) static inline void paint_pair(uint8_t *d, const uint8_t *s, uint8_t add,
                                                             enum blit_mix mix)
{
    if (mix == BLIT_OPAQUE)
        cover_pair(d, s, add);
    else
        mix_pair(d, s, add, mix);
}

/* Two rows of eight as one of sixteen. */
__attribute__((always_inline)) static inline void paint_two(uint8_t *d, ptrdiff_t d_row, const uint8_t *s, uint8_t add,
                                                            enum blit_mix mix)
{
    uint8_t two[16];

    memcpy(two, d, 8);
    memcpy(two + 8, d + d_row, 8);
    paint_pair(two, s, add, mix);
    memcpy(d, two, 8);
    memcpy(d + d_row, two + 8, 8);
}

/* Eight pixels wide, and no more from a row to the next. */
__attribute__((always_inline)) static inline void paint_narrow(uint8_t *d, ptrdiff_t d_row, const uint8_t *s,
                                                               uint8_t add, int h, enum blit_mix mix)
{
    for (; h >= 8; h -= 8, s += 64, d += 8 * d_row) {
        paint_two(d, d_row, s, add, mix);
        paint_two(d + 2 * d_row, d_row, s + 16, add, mix);
        paint_two(d + 4 * d_row, d_row, s + 32, add, mix);
        paint_two(d + 6 * d_row, d_row, s + 48, add, mix);
    }
    for (; h > 1; h -= 2, s += 16, d += 2 * d_row)
        paint_two(d, d_row, s, add, mix);
    if (h > 0 && mix == BLIT_OPAQUE)
        cover(d, words_load(s), WORDS_EACH(add));
    else if (h > 0)
        mix_eight(d, s, add, mix);
}

/* The same of sixteen. */
__attribute__((always_inline)) static inline void paint_wide(uint8_t *d, ptrdiff_t d_row, const uint8_t *s, uint8_t add,
                                                             int h, enum blit_mix mix)
{
    for (; h >= 4; h -= 4, s += 64, d += 4 * d_row) {
        paint_pair(d, s, add, mix);
        paint_pair(d + d_row, s + 16, add, mix);
        paint_pair(d + 2 * d_row, s + 32, add, mix);
        paint_pair(d + 3 * d_row, s + 48, add, mix);
    }
    for (; h > 0; h--, s += 16, d += d_row)
        paint_pair(d, s, add, mix);
}

#endif
