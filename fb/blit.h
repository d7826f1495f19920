/*
 * blit.h - draws sprites: masked, flipped and recoloured by bank.
 */
#ifndef FB_BLIT_H
#define FB_BLIT_H

#include <stdbool.h>
#include "fb.h"

/* A picture. Each row has w pixels followed by zeros up to pitch, which is a multiple of 8 and at least w. Pixel 0 is
 * transparent. */
struct image {
    const uint8_t *pix;
    int w, h, pitch;
};

enum {
    BLIT_FLIP_X = 1 << 0, /* swaps left and right */
    BLIT_FLIP_Y = 1 << 1, /* swaps top and bottom */
    BLIT_DOTS = 1 << 2,   /* draws every second pixel; for blit_solid only */
};

/* Draws an image with its top left corner at (x, y), clipped. bank * 16 is added, modulo 256, to every pixel except 0;
 * a pixel that becomes 0 is still drawn. flags: BLIT_FLIP_X, BLIT_FLIP_Y. Any x, y; an image with w or h of 0 draws
 * nothing. */
void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags);

/* How a pixel is mixed with the pixel under it: by a table, or by a rule for palettes whose banks are ramps from dark
 * to bright. A rule keeps the bank of the drawn pixel and computes its shade, the position in the bank, from both
 * shades. */
enum blit_mix {
    BLIT_OPAQUE,
    BLIT_TABLE,
    BLIT_RAMP_ADD,  /* the sum, 15 at most */
    BLIT_RAMP_HALF, /* the mean, halves rounded up */
    BLIT_RAMP_MAX,  /* the greater */
    BLIT_MIXES
};

/* Returns the palette entry that the rule computes from two entries. */
static inline uint8_t blit_ramp_entry(enum blit_mix rule, uint8_t under, uint8_t over)
{
    const unsigned u = under & 15, o = over & 15, sum = u + o;
    const unsigned shade = rule == BLIT_RAMP_ADD    ? sum < 15 ? sum : 15
                           : rule == BLIT_RAMP_HALF ? (sum + 1) / 2
                           : u > o                  ? u
                                                    : o;

    return (uint8_t)((over & 0xf0) | shade);
}

/* Draws like blit_blended with the rule's table, but much faster. Returns false and draws nothing if the image needs
 * clipping or is flipped left to right. */
bool blit_ramped(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                 enum blit_mix rule);

/* One of many pictures of the same size, all drawn without clipping or flipping (blit_batch). */
struct blit_item {
    const uint8_t *s; /* the image's first row */
    uint8_t *d;       /* destination of its first pixel */
    uint64_t bank;
};

/* Draws n items in order, opaque or by a rule. All images are w x h px with pitch s_pitch; d_pitch is the surface's
 * pitch. */
void blit_batch(const struct blit_item *items, size_t n, int d_pitch, int w, int h, int s_pitch, enum blit_mix mix);

/* Draws like blit_sprite, but a pixel becomes table[under * 256 + over]: `under` is the surface's pixel, `over` the
 * pixel that blit_sprite would have drawn. */
void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536]);

/* Draws like blit_sprite, but draws every opaque pixel in colour c or, with BLIT_DOTS, every second one, in a
 * chequerboard pattern. */
void blit_solid(struct fb *fb, const struct image *image, int x, int y, uint8_t c, unsigned flags);

/* Draws the image's opaque pixels, and the eight pixels around each, in colour c. */
void blit_rim(struct fb *fb, const struct image *image, int x, int y, uint8_t c);

#endif
