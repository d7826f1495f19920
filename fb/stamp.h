/*
 * stamp.h - one picture drawn at very many places, in any of the 16 banks: over what is there, or, front to back, only
 * where nothing is yet, so that what nobody would see costs next to nothing.
 * floor: fb    used by: board/
 */
#ifndef FB_STAMP_H
#define FB_STAMP_H

#include <stdbool.h>
#include "../src/base/fx.h"
#include "blit.h"

enum {
    STAMP_BYTES = 2048,   /* a picture with more, its rows filled up to multiples of 8, is no stamp */
    STAMP_OTHER = 1 << 27 /* in a list of places: this is none, but a number of the caller's, below 2^27 */
};

/* A picture made ready: of each byte what to keep of the surface, and, in each bank, what to put there. */
struct stamp {
    int w, h;
    int row, bytes; /* of a row, a multiple of 8; of all rows */
    uint8_t keep[STAMP_BYTES];
    uint8_t colour[16 * STAMP_BYTES]; /* `bytes` a bank */
};

/* Makes a stamp. banks: a bit for each bank that will be drawn. False: too many bytes. */
bool stamp_make(struct stamp *stamp, const struct image *image, unsigned banks);

/* The corners of a w x h picture, its top left pixels, that need no clipping on fb: so far to the right of and below
 * (x0, y0), which is the same for all pictures. */
struct stamp_corners {
    int x0, y0;
    uint32_t wide, high;
};
struct stamp_corners stamp_corners(const struct fb *fb, int w, int h);

/* A place to draw at: such a corner, x < wide and y < high counted from (x0, y0), and a bank, 0 to 15. */
static inline uint32_t stamp_place(const struct fb *fb, uint32_t x, uint32_t y, uint8_t bank)
{
    return (uint32_t)bank << 28 | (y * (uint32_t)fb->pitch + x);
}

/* Draws places in order up to the first STAMP_OTHER; returns how many. The same picture as so many calls of blit_sprite,
 * but that pixels of the band may change. */
size_t stamp_over(struct fb *fb, const struct stamp *stamp, const uint32_t *places, size_t n);

/*
 * Front to back. A layer is a surface that begins all 0, with its clip the whole picture; no pixel that is drawn is 0.
 * What is drawn later shows only where the layer is 0 still, and a map says where that is nowhere.
 */
struct layer {
    struct fb fb;
    uint8_t *full;   /* of each word of the surface: so many words from it downwards are not 0; 255: or more */
    size_t room;     /* opaque pixels that may be drawn until the map is drawn up again */
    size_t step;     /* what room is then */
    bool covered;    /* nothing is 0 any more */
    uint64_t hidden; /* pictures skipped */
};

/* Draws up the map now. */
void layer_map(struct layer *l);

/* Bytes of memory a layer of w x h takes, as fb_size; and makes an empty one of it. */
size_t layer_size(int w, int h);
void layer_init(struct layer *l, void *mem, int w, int h);

/* Draws places from the last to the first; there is no STAMP_OTHER among them. pixels: the picture's opaque ones. */
void layer_stamp(struct layer *l, const struct stamp *stamp, const uint32_t *places, size_t n, size_t pixels);

/* Is all covered where a w x h picture would go? Of a place, the bank is left out. */
static inline bool layer_hides(const struct layer *l, uint32_t place, uint32_t w, uint32_t h)
{
    uint32_t first = place >> 3, last = (place + w - 1) >> 3;

    if (l->full[first] < h || l->full[last] < h)
        return false;
    while (++first < last)
        if (l->full[first] < h)
            return false;
    return true;
}

/*
 * Which bullets are worth a look: of each 8 x 8 px cell whether anything of a picture may be seen that lies within
 * [x0, x1) x [y0, y1) of some pixel in it. Pixels outside of the layer and its band have no cell: there, anything may.
 */
struct layer_cells {
    uint32_t across, down;
    uint8_t *seen; /* 1: something may; across * down cells, row by row, and a last one for all that have none */
};
size_t layer_cells_size(int w, int h);

/* From the map as it is. `seen` has layer_cells_size bytes. */
void layer_find_cells(const struct layer *l, struct layer_cells *cells, uint8_t *seen, int x0, int y0, int x1, int y1);

/* The cells of 64 places of the layer. */
void layer_cells_at(const struct layer_cells *cells, const fx *restrict x, const fx *restrict y, uint32_t *restrict at);

/* Draws one picture at a place. */
void layer_sprite(struct layer *l, const struct image *image, uint32_t place, size_t pixels);

/* Puts the layer on fb at (x, y); all of it is inside fb's picture. */
void layer_show(const struct layer *l, struct fb *fb, int x, int y);

#endif
