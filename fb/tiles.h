/*
 * tiles.h - square tiles side by side onto the surface: what the layers of a background are drawn with.
 */
#ifndef FB_TILES_H
#define FB_TILES_H

#include <stddef.h>
#include <stdint.h>

enum tile {
    TILE_EMPTY, /* nothing is drawn */
    TILE_HOLES, /* the pixels that are not 0 */
    TILE_SOLID  /* all pixels, none of which is 0 */
};

/* So many rows of n tiles, one beside the other from d on, on a surface of that pitch. Of tile k the first of these
 * rows is at pix + at[k], side px long, and the others follow it; side: 8, 16 or 32. add is added to every pixel that
 * is drawn, modulo 256. Nothing is clipped. */
void tiles_draw(uint8_t *d, ptrdiff_t pitch, const uint8_t *pix, const uint32_t *at, const uint8_t *tile, int n,
                int side, int rows, uint8_t add);

#endif
