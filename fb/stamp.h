/*
 * stamp.h - one picture drawn at very many destinations, in any of the 16 banks: back to front over the surface, or
 * front to back on a layer, only where nothing is drawn yet, so that hidden pictures cost next to nothing.
 */
#ifndef FB_STAMP_H
#define FB_STAMP_H

#include <stdbool.h>
#include "../src/base/fx.h"
#include "blit.h"

enum {
    STAMP_BYTES = 2048,   /* a picture with more bytes, its rows padded to multiples of 8, cannot be a stamp */
    STAMP_OTHER = 1 << 27 /* in a list of destinations: not a destination, but a number of the caller's, below 2^27 */
};

/* A picture prepared for a layer: its pixels in each bank. */
struct stamp {
    int w, h;
    int row, bytes;                   /* of a row, a multiple of 8; of all rows */
    uint8_t colour[16 * STAMP_BYTES]; /* `bytes` per bank */
};

/* Makes a stamp. banks: a bit for each bank that will be drawn. Returns false if the picture has too many bytes. */
bool stamp_make(struct stamp *stamp, const struct image *image, unsigned banks);

/* The top left positions at which a w x h picture needs no clipping on fb: a range of offsets to the right of and below
 * (x0, y0), which is the same for all pictures. */
struct stamp_corners {
    int x0, y0;
    uint32_t wide, high;
};
static inline struct stamp_corners stamp_corners(const struct fb *fb, int w, int h)
{
    int wide = fb->sx1 - fb->sx0 - w + 1, high = fb->sy1 - fb->sy0 - h + 1;
    bool some = wide > 0 && high > 0;

    return (struct stamp_corners){ fb->sx0, fb->sy0, some ? (uint32_t)wide : 0, some ? (uint32_t)high : 0 };
}

/* Returns a destination: a top left position, x < wide and y < high counted from (x0, y0), as an offset in bytes, and a
 * bank, 0 to 15, in the top four bits. */
static inline uint32_t stamp_dest(const struct fb *fb, uint32_t x, uint32_t y, uint8_t bank)
{
    return (uint32_t)bank << 28 | (y * (uint32_t)fb->pitch + x);
}

/* Destinations in drawing order, each too large by `less`, so that a bullet's entry need not depend on its picture.
 * Including `less` they are still below STAMP_OTHER, apart from their banks. */
struct stamp_list {
    const uint32_t *dests;
    size_t n;
    uint32_t less;
};

/* Draws an image at destinations up to the first STAMP_OTHER, opaque or by a rule; returns how many. The result is that
 * of as many calls of blit_sprite or blit_ramped, except that pixels of the band may change. */
size_t stamp_over(struct fb *fb, const struct image *image, enum blit_mix mix, const struct stamp_list *list);

/* Like stamp_over, but with a picture for each destination, all of the image's size: the pixels of destination i's
 * picture are at[i] bytes after the image's. */
size_t stamp_each(struct fb *fb, const struct image *image, const uint32_t *at, enum blit_mix mix,
                  const struct stamp_list *list);

/* Turned copies of a picture, stored one after another: destination i shows the copy nearest to dir[which[i]]. */
struct stamp_turns {
    const ang *dir;
    const uint32_t *which;
    uint32_t size, rotations; /* bytes per copy; number of copies */
};

/* Returns the index of the copy nearest to dir. */
static inline uint32_t stamp_turn(ang dir, uint32_t rotations)
{
    const uint32_t turn = (uint32_t)(((uint64_t)dir * rotations + (1u << 31)) >> 32);

    return turn < rotations ? turn : 0;
}

/* Like stamp_over, but with turned copies, the first of which is the image. */
size_t stamp_turned(struct fb *fb, const struct image *image, const struct stamp_turns *turns, enum blit_mix mix,
                    const struct stamp_list *list);

/*
 * Front to back. A layer is a surface that starts all 0, with its clip the whole picture; no drawn pixel is 0. Pictures
 * drawn later show only where the layer is still 0; a map records the areas that have no 0 left.
 */
struct stamp_layer {
    struct fb fb;
    uint8_t *full;   /* the map: for each word of the surface, how many words from it downwards have no 0; at most
                        255 */
    size_t budget;   /* opaque pixels that may be drawn before the next update of the map */
    size_t step;     /* the budget after an update */
    bool covered;    /* no pixel is 0 any more */
    uint64_t hidden; /* pictures skipped */
};

/* Updates the map and resets the budget. */
void stamp_layer_map(struct stamp_layer *l);

/* Return the bytes of memory that a layer of w x h takes, as fb_size does; and make an empty layer in mem. */
size_t stamp_layer_size(int w, int h);
void stamp_layer_init(struct stamp_layer *l, void *mem, int w, int h);

/* Draws at destinations from the last to the first; none of them is a STAMP_OTHER. pixels: the number of opaque pixels
 * in the picture. */
void stamp_layer_draw(struct stamp_layer *l, const struct stamp *stamp, const struct stamp_list *list, size_t pixels);

/* Returns whether all is covered where a w x h picture would be drawn. dest: without its bank. */
static inline bool stamp_layer_hides(const struct stamp_layer *l, uint32_t dest, uint32_t w, uint32_t h)
{
    uint32_t first = dest >> 3, last = (dest + w - 1) >> 3;

    if (l->full[first] < h || l->full[last] < h)
        return false;
    while (++first < last)
        if (l->full[first] < h)
            return false;
    return true;
}

/*
 * Visibility in 8 x 8 px cells: for a pixel in the cell, whether any part of a picture within [x0, x1) x [y0, y1) of
 * that pixel may be visible. Pixels outside of the layer and its band have no cell and count as visible.
 */
struct stamp_cells {
    uint32_t across, down;
    uint8_t *seen; /* 1: may be visible; across * down cells, row by row, and a last one for all pixels without a
                      cell */
};
size_t stamp_cells_size(int w, int h);

/* Computes the cells from the current map. `seen` has stamp_cells_size bytes. */
void stamp_cells_find(const struct stamp_layer *l, struct stamp_cells *cells, uint8_t *seen, int x0, int y0, int x1,
                      int y1);

/* Stores the cell indices of 64 positions on the layer. */
void stamp_cells_at(const struct stamp_cells *cells, const fx *restrict x, const fx *restrict y, uint32_t *restrict at);

/* Draws one picture at a destination. */
void stamp_layer_sprite(struct stamp_layer *l, const struct image *image, uint32_t dest, size_t pixels);

/* Draws the layer on fb at (x, y); all of it must be inside fb's picture. */
void stamp_layer_show(const struct stamp_layer *l, struct fb *fb, int x, int y);

#endif
