/*
 * blit.h - sprites: masked, flipped and recoloured by bank.
 */
#ifndef FB_BLIT_H
#define FB_BLIT_H

#include <stdbool.h>
#include "fb.h"

/* A picture. A row holds w pixels, then zeros up to pitch, a multiple of 8 that is w or more. Pixel 0 is transparent.
 */
struct image {
    const uint8_t *pix;
    int w, h, pitch;
};

enum {
    BLIT_FLIP_X = 1 << 0, /* left and right change places */
    BLIT_FLIP_Y = 1 << 1, /* top and bottom */
    BLIT_DOTS = 1 << 2,   /* of blit_solid alone */
};

/* Draws an image with its top left corner at (x, y), clipped. Every pixel but 0 has bank * 16 added, modulo 256: it may
 * become 0, and is drawn. flags: BLIT_. Any x, y; w or h of 0 draws nothing. */
void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags);

/* How a pixel is mixed with what is under it: by a table, or by a rule for palettes whose banks are ramps from dark to
 * bright. A rule keeps the bank of what is drawn, and makes its shade, the place in the bank, of both shades. */
enum blit_mix {
    BLIT_OPAQUE,
    BLIT_TABLE,
    BLIT_RAMP_ADD,  /* the sum, 15 at most */
    BLIT_RAMP_HALF, /* their mean, halves up */
    BLIT_RAMP_MAX,  /* the greater */
    BLIT_MIXES
};

/* What a rule makes of two entries of the palette. */
static inline uint8_t blit_ramp(enum blit_mix rule, uint8_t under, uint8_t over)
{
    const unsigned u = under & 15, o = over & 15, sum = u + o;
    const unsigned shade = rule == BLIT_RAMP_ADD    ? sum < 15 ? sum : 15
                           : rule == BLIT_RAMP_HALF ? (sum + 1) / 2
                           : u > o                  ? u
                                                    : o;

    return (uint8_t)((over & 0xf0) | shade);
}

/* As blit_blended with the table that the rule makes, and much faster. False, and nothing is drawn: it needs clipping,
 * or is to be flipped from left to right. */
bool blit_ramped(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                 enum blit_mix rule);

/* One of many pictures of a size, that blit_sprite would draw without clipping or flipping. */
struct blit_item {
    const uint8_t *s; /* the image's first row */
    uint8_t *d;       /* where its first pixel goes */
    uint64_t bank;
};

/* Draws n of them in order: images of that size and pitch, on a surface of that pitch; opaque, or by a rule. */
void blit_batch(const struct blit_item *items, size_t n, int d_pitch, int w, int h, int s_pitch, enum blit_mix mix);

/* As blit_sprite, but a pixel becomes table[under * 256 + over]: `under` is what was there, `over` what blit_sprite
 * would have put there. */
void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536]);

/* The same, but every pixel of it is c; with BLIT_DOTS every second, as on a chess board. */
void blit_solid(struct fb *fb, const struct image *image, int x, int y, uint8_t c, unsigned flags);

/* Its pixels and the eight places next to each, in c. */
void blit_rim(struct fb *fb, const struct image *image, int x, int y, uint8_t c);

#endif
