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

/* Draws `rows` rows of pixels of n tiles, side by side starting at d, on a surface with pitch `pitch`. Rows of a tile
 * are `side` px long; side is 8, 16 or 32. Tile k is of kind tile[k] (enum tile); its first drawn row is at pix +
 * at[k], and the others follow. `add` is added to every drawn pixel, modulo 256. Nothing is clipped. */
void tiles_draw(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix, const uint32_t *at, const uint8_t *tile, int n,
                int side, int rows, uint8_t add);

#endif
