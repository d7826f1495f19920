/*
 * tiles.h - draws square tiles side by side onto the surface, for the layers of a background.
 */
#ifndef FB_TILES_H
#define FB_TILES_H

#include <stddef.h>
#include <stdint.h>

enum tile {
    TILE_EMPTY, /* draws nothing */
    TILE_HOLES, /* draws the pixels that are not 0 */
    TILE_SOLID  /* draws all pixels, none of which is 0 */
};

/* Draws `rows` rows of n tiles, side by side from d on, on a surface of that pitch. The first of these rows of tile k
 * is at pix + at[k], side px long, and the others follow it; side is 8, 16 or 32. Every drawn pixel has add added,
 * modulo 256. Nothing is clipped. */
void tiles_draw(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix, const uint32_t *at, const uint8_t *tile, int n,
                int side, int rows, uint8_t add);

#endif
