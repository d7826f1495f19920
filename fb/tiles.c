/*
 * tiles.c - see tiles.h. Draws sixteen pixels at a time, as in paint.h; side is a constant in every call.
 */
#include "tiles.h"
#include "paint.h"

static inline void copy_sixteen(uint8_t *d, const uint8_t *s, uint8_t add)
{
    pixels16 v;

    memcpy(&v, s, sizeof v);
    v = paint_add_bank(v, add);
    memcpy(d, &v, sizeof v);
}

__attribute__((always_inline)) static inline void draw_solid(uint8_t *d, ptrdiff_t pitch, const uint8_t *s, int side,
                                                             int rows, uint8_t add)
{
    for (int y = 0; y < rows; y++, d += pitch, s += side) {
        if (side == 8)
            words_store(d, words_add(words_load(s), WORDS_EACH(add)));
        for (int k = 0; k + 16 <= side; k += 16)
            copy_sixteen(d + k, s + k, add);
    }
}

__attribute__((always_inline)) static inline void draw_masked(uint8_t *d, ptrdiff_t pitch, const uint8_t *s, int side,
                                                              int rows, uint8_t add)
{
    if (side == 8)
        paint_narrow(d, pitch, s, add, rows, BLIT_OPAQUE);
    else
        for (int y = 0; y < rows; y++, d += pitch, s += side)
            for (int k = 0; k < side; k += 16)
                paint_sixteen_opaque(d + k, s + k, add);
}

__attribute__((always_inline)) static inline void draw_row(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix,
                                                           const uint32_t *offsets, const uint8_t *kinds, int n,
                                                           int side, int rows, uint8_t add)
{
    for (int k = 0; k < n; k++, d += side)
        if (kinds[k] == TILE_SOLID)
            draw_solid(d, pitch, pix + offsets[k], side, rows, add);
        else if (kinds[k] == TILE_MASKED)
            draw_masked(d, pitch, pix + offsets[k], side, rows, add);
}

void tiles_draw(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix, const uint32_t *offsets, const uint8_t *kinds, int n,
                int side, int rows, uint8_t add)
{
    if (side == 8)
        draw_row(d, pitch, pix, offsets, kinds, n, 8, rows, add);
    else if (side == 16)
        draw_row(d, pitch, pix, offsets, kinds, n, 16, rows, add);
    else
        draw_row(d, pitch, pix, offsets, kinds, n, 32, rows, add);
}
