/*
 * paint.h - draws unclipped pictures, sixteen pixels at a time; shared by blit.c, stamp.c and tiles.c. The mask of
 * opaque pixels is computed from the pixels, which is faster than loading a prepared one: most of the time is spent on
 * one store per row.
 *
 * Sixteen pixels are a compiler vector (gcc, clang), because no loop over them stays vectorised at every optimisation
 * level (see tests/lint/levels.sh). No step moves bits from one byte to another. The mix, and usually the height, is a
 * constant at the call sites; inlining is forced, as gcc would otherwise merge all calls into one loop.
 */
#ifndef FB_PAINT_H
#define FB_PAINT_H

#include "blit.h"
#include "words.h"

static inline void paint_word(uint8_t *d, uint64_t s, uint64_t add)
{
    uint64_t mask = words_opaque_mask(s);

    words_store(d, (words_load(d) & ~mask) | (words_add(s, add) & mask));
}

typedef int8_t pixels16 __attribute__((vector_size(16)));

/* Adds the bank to all pixels; bytes wrap around. */
static inline pixels16 paint_add_bank(pixels16 s, uint8_t add)
{
    typedef uint8_t bytes __attribute__((vector_size(16)));

    return (pixels16)((bytes)s + add);
}

/* Selects a where the mask has all bits set, b where it has none. */
static inline pixels16 paint_select(pixels16 mask, pixels16 a, pixels16 b)
{
    return (a & mask) | (b & ~mask);
}

/* Returns the shades, 0 to 15, that the rule computes from the shades of `under` and `over`. */
__attribute__((always_inline)) static inline pixels16 paint_mix_shades(pixels16 under, pixels16 over,
                                                                       enum blit_mix rule)
{
    const pixels16 a = under & 15, b = over & 15, sum = a + b;

    if (rule == BLIT_RAMP_ADD)
        return (sum | (sum > 15)) & 15;
    return rule == BLIT_RAMP_HALF ? (sum + 1) >> 1 : paint_select(a > b, a, b);
}

/* Returns the sixteen pixels d with the pixels s painted over them, opaque or blended by `mix`. */
__attribute__((always_inline)) static inline pixels16 paint_mix_pixels(pixels16 d, pixels16 s, uint8_t add,
                                                                       enum blit_mix mix)
{
    const pixels16 over = paint_add_bank(s, add);

    return paint_select(s != 0, mix == BLIT_OPAQUE ? over : (over & -16) | paint_mix_shades(d, over, mix), d);
}

/* Paints sixteen pixels of a row. */
__attribute__((always_inline)) static inline void paint_sixteen(uint8_t *d, const uint8_t *s, uint8_t add,
                                                                enum blit_mix mix)
{
    pixels16 to, from;

    memcpy(&to, d, sizeof to);
    memcpy(&from, s, sizeof from);
    to = paint_mix_pixels(to, from, add, mix);
    memcpy(d, &to, sizeof to);
}

static inline void paint_sixteen_opaque(uint8_t *d, const uint8_t *s, uint8_t add)
{
    paint_sixteen(d, s, add, BLIT_OPAQUE);
}

/* Paints eight pixels of a row, as half of a vector of sixteen. */
__attribute__((always_inline)) static inline void paint_eight(uint8_t *d, const uint8_t *s, uint8_t add,
                                                              enum blit_mix rule)
{
    uint8_t to[16] = { 0 }, from[16] = { 0 };

    memcpy(to, d, 8);
    memcpy(from, s, 8);
    paint_sixteen(to, from, add, rule);
    memcpy(d, to, 8);
}

/* Paints two rows of eight pixels as one vector of sixteen. */
__attribute__((always_inline)) static inline void paint_two_rows(uint8_t *d, ptrdiff_t d_stride, const uint8_t *s,
                                                                 uint8_t add, enum blit_mix mix)
{
    uint64_t rows[2] = { words_load(d), words_load(d + d_stride) };
    pixels16 to, from;

    memcpy(&to, rows, sizeof to);
    memcpy(&from, s, sizeof from);
    to = paint_mix_pixels(to, from, add, mix);
    memcpy(rows, &to, sizeof to);
    words_store(d, rows[0]);
    words_store(d + d_stride, rows[1]);
}

/* Paints h rows of a picture whose pitch is eight pixels. */
__attribute__((always_inline)) static inline void paint_narrow(uint8_t *d, ptrdiff_t d_stride, const uint8_t *s,
                                                               uint8_t add, int h, enum blit_mix mix)
{
    for (; h >= 8; h -= 8, s += 64, d += 8 * d_stride) {
        paint_two_rows(d, d_stride, s, add, mix);
        paint_two_rows(d + 2 * d_stride, d_stride, s + 16, add, mix);
        paint_two_rows(d + 4 * d_stride, d_stride, s + 32, add, mix);
        paint_two_rows(d + 6 * d_stride, d_stride, s + 48, add, mix);
    }
    for (; h > 1; h -= 2, s += 16, d += 2 * d_stride)
        paint_two_rows(d, d_stride, s, add, mix);
    if (h > 0 && mix == BLIT_OPAQUE)
        paint_word(d, words_load(s), WORDS_EACH(add));
    else if (h > 0)
        paint_eight(d, s, add, mix);
}

/* Paints h rows of a picture whose pitch is sixteen pixels. */
__attribute__((always_inline)) static inline void paint_wide(uint8_t *d, ptrdiff_t d_stride, const uint8_t *s,
                                                             uint8_t add, int h, enum blit_mix mix)
{
#pragma GCC unroll 4
    for (; h >= 4; h -= 4, s += 64, d += 4 * d_stride) {
        paint_sixteen(d, s, add, mix);
        paint_sixteen(d + d_stride, s + 16, add, mix);
        paint_sixteen(d + 2 * d_stride, s + 32, add, mix);
        paint_sixteen(d + 3 * d_stride, s + 48, add, mix);
    }
    for (; h > 0; h--, s += 16, d += d_stride)
        paint_sixteen(d, s, add, mix);
}

#endif
