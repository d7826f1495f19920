/*
 * tiles.h - draws square tiles side by side onto the surface, for the layers of a background.
 */
#ifndef FB_TILES_H
#define FB_TILES_H

#include <stddef.h>
#include <stdint.h>

enum tile_kind {
    TILE_EMPTY,  /* draws nothing */
    TILE_MASKED, /* draws the pixels that are not 0 */
    TILE_SOLID   /* draws all pixels, none of which is 0 */
};

/* Draws `rows` rows of pixels of n tiles, side by side starting at d, on a surface with pitch `pitch`. Rows of a tile
 * are `side` px long; side is 8, 16 or 32. Tile k is of kind kinds[k] (enum tile_kind); its first drawn row is at
 * pix + offsets[k], and the others follow. `add` is added to every drawn pixel, modulo 256. Nothing is clipped. */
void tiles_draw(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix, const uint32_t *offsets, const uint8_t *kinds, int n,
                int side, int rows, uint8_t add);

#endif
