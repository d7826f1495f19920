/*
 * stamp.h - draws one picture at very many destinations, in any of the 16 banks: back to front on the surface, or front
 * to back in a layer. In a layer, a picture is drawn only where nothing is drawn yet, so that hidden pictures cost next
 * to nothing.
 */
#ifndef FB_STAMP_H
#define FB_STAMP_H

#include <stdbool.h>
#include "../src/base/fx.h"
#include "blit.h"

enum {
    STAMP_MAX_BYTES = 2048,      /* a picture with more bytes, its rows padded to multiples of 8, cannot be a stamp */
    STAMP_CALLER_ENTRY = 1 << 27 /* in a list of destinations: marks a number of the caller, below 2^27,
                             instead of a destination */
};

/* A picture prepared for a layer: its pixels in each bank. */
struct stamp {
    int w, h;
    int pitch, bytes;                     /* bytes of a row, a multiple of 8; bytes of all rows */
    uint8_t colour[16 * STAMP_MAX_BYTES]; /* the pixels in each bank, `bytes` per bank */
};

/* Makes a stamp. banks: a bit for each bank that will be drawn. Returns false if the picture has too many bytes. */
bool stamp_make(struct stamp *stamp, const struct image *image, unsigned banks);

/* The top left positions at which a w x h picture needs no clipping on fb: from (x0, y0), `width` positions to the
 * right and `height` positions down. (x0, y0) is the same for all pictures. */
struct stamp_unclipped_area {
    int x0, y0;
    uint32_t width, height;
};
static inline struct stamp_unclipped_area stamp_find_unclipped_area(const struct fb *fb, int w, int h)
{
    int width = fb->sx1 - fb->sx0 - w + 1, height = fb->sy1 - fb->sy0 - h + 1;
    bool fits = width > 0 && height > 0;

    return (struct stamp_unclipped_area){ fb->sx0, fb->sy0, fits ? (uint32_t)width : 0, fits ? (uint32_t)height : 0 };
}

/* Returns a destination: the offset in bytes of the top left position (x, y), with the bank, 0 to 15, in the top four
 * bits. x < width and y < height are relative to (x0, y0) of struct stamp_unclipped_area. */
static inline uint32_t stamp_dest(const struct fb *fb, uint32_t x, uint32_t y, uint8_t bank)
{
    return (uint32_t)bank << 28 | (y * (uint32_t)fb->pitch + x);
}

/* Destinations in drawing order. `bias` is subtracted from each, so that a bullet's entry need not depend on its
 * picture. Before the subtraction, an entry without its bank is below STAMP_CALLER_ENTRY. */
struct stamp_list {
    const uint32_t *dests;
    size_t n;
    uint32_t bias;
};

/* Draws the image, opaque or blended by a rule, at each destination before the first STAMP_CALLER_ENTRY. Returns the
 * number drawn. The result equals one call of blit_sprite or blit_ramped per destination, except that pixels of the
 * band may change. */
size_t stamp_draw(struct fb *fb, const struct image *image, enum blit_mix mix, const struct stamp_list *list);

/* Like stamp_draw, but each destination has its own picture, of the same size as the image: the pixels of destination
 * i's picture start at[i] bytes after the image's. */
size_t stamp_draw_each(struct fb *fb, const struct image *image, const uint32_t *at, enum blit_mix mix,
                       const struct stamp_list *list);

/* Turned copies of a picture, stored one after another: destination i shows the copy nearest to dir[dir_index[i]]. */
struct stamp_turns {
    const ang *dir;
    const uint32_t *dir_index;
    uint32_t size, n_copies; /* bytes per copy; number of copies */
};

/* Returns the index of the copy nearest to dir. */
static inline uint32_t stamp_turn_index(ang dir, uint32_t n_copies)
{
    const uint32_t turn = (uint32_t)(((uint64_t)dir * n_copies + (1u << 31)) >> 32);

    return turn < n_copies ? turn : 0;
}

/* Like stamp_draw, but draws rotated copies of a picture; `image` is the first of the copies in `turns`. */
size_t stamp_draw_turned(struct fb *fb, const struct image *image, const struct stamp_turns *turns, enum blit_mix mix,
                         const struct stamp_list *list);

/*
 * Drawing front to back. A layer is a surface whose pixels are all 0 at first and whose clip is the whole picture; no
 * drawn pixel is 0. A picture drawn later shows only where the layer is still 0. A map records the areas in which no
 * pixel is 0.
 */
struct stamp_layer {
    struct fb fb;
    uint8_t *map;          /* the map: for each word (8 px) of the surface, the number of consecutive words without a
                        0 pixel, from that word downwards; at most 255 */
    size_t budget;         /* opaque pixels that may be drawn before the next update of the map */
    size_t next_budget;    /* the budget after an update */
    bool covered;          /* no pixel is 0 any more */
    uint64_t hidden_count; /* pictures skipped as hidden */
};

/* Updates the map and resets the budget. */
void stamp_layer_update_map(struct stamp_layer *l);

/* stamp_layer_size returns the bytes of memory that a w x h layer takes; stamp_layer_init makes an empty layer in mem,
 * which has that size. */
size_t stamp_layer_size(int w, int h);
void stamp_layer_init(struct stamp_layer *l, void *mem, int w, int h);

/* Draws the stamp at the destinations from the last to the first; the list contains no STAMP_CALLER_ENTRY. pixels: the
 * number of opaque pixels in the picture. */
void stamp_layer_draw(struct stamp_layer *l, const struct stamp *stamp, const struct stamp_list *list, size_t pixels);

/* Returns whether a w x h picture at dest would be hidden completely, according to the map. dest: without its bank. */
static inline bool stamp_layer_hides(const struct stamp_layer *l, uint32_t dest, uint32_t w, uint32_t h)
{
    uint32_t first = dest >> 3, last = (dest + w - 1) >> 3;

    if (l->map[first] < h || l->map[last] < h)
        return false;
    while (++first < last)
        if (l->map[first] < h)
            return false;
    return true;
}

/*
 * Visibility by cells of 8 x 8 px. A cell is marked if a picture may be visible when it is placed at a pixel of the
 * cell and extends over [x0, x1) x [y0, y1) relative to that pixel. Pixels outside the layer and its band have no cell;
 * pictures placed there count as visible.
 */
struct stamp_cells {
    uint32_t columns, rows;
    uint8_t *visible; /* 1: may be visible; columns * rows cells, row by row, then one entry for all pixels without
                      a cell */
};
size_t stamp_cells_size(int w, int h);

/* Computes the cells from the current map. `visible` has stamp_cells_size bytes. */
void stamp_cells_compute(const struct stamp_layer *l, struct stamp_cells *cells, uint8_t *visible, int x0, int y0,
                         int x1, int y1);

/* Stores in `at` the cell indices of 64 positions on the layer. */
void stamp_cells_index(const struct stamp_cells *cells, const fx *restrict x, const fx *restrict y,
                       uint32_t *restrict at);

/* Draws one picture in the layer at dest, a destination including its bank. pixels: as in stamp_layer_draw. */
void stamp_layer_draw_sprite(struct stamp_layer *l, const struct image *image, uint32_t dest, size_t pixels);

/* Draws the layer on fb at (x, y); the whole layer must be inside fb's picture. */
void stamp_layer_show(const struct stamp_layer *l, struct fb *fb, int x, int y);

#endif
