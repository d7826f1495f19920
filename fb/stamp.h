/*
 * stamp.h - draws one picture at very many destinations, in any of the 16 banks.
 */
#ifndef FB_STAMP_H
#define FB_STAMP_H

#include <stdbool.h>
#include "../src/base/fx.h"
#include "blit.h"

enum {
    STAMP_CALLER_ENTRY = 1 << 27 /* in a list of destinations: marks a number of the caller, below 2^27,
                             instead of a destination */
};

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

/* Returns which of n_copies turned copies of a picture is nearest to dir. */
static inline uint32_t stamp_turn_index(ang dir, uint32_t n_copies)
{
    const uint32_t turn = (uint32_t)(((uint64_t)dir * n_copies + (1u << 31)) >> 32);

    return turn < n_copies ? turn : 0;
}

#endif
