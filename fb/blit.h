/*
 * blit.h - sprites: masked, flipped and recoloured by bank.
 * floor: fb
 */
#ifndef FB_BLIT_H
#define FB_BLIT_H

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
};

/* Draws an image with its top left corner at (x, y), clipped. Every pixel but 0 has bank * 16 added, modulo 256: it may
 * become 0, and is drawn. flags: BLIT_. Any x, y; w or h of 0 draws nothing. */
void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags);

/* One of many pictures of a size, that blit_sprite would draw without clipping or flipping. */
struct blit_item {
    const uint8_t *s; /* the image's first row */
    uint8_t *d;       /* where its first pixel goes */
    uint64_t bank;
};

/* Draws n of them in order: images of that size and pitch, on a surface of that pitch. */
void blit_batch(const struct blit_item *items, size_t n, int d_pitch, int w, int h, int s_pitch);

/* As blit_sprite, but a pixel becomes table[under * 256 + over]: `under` is what was there, `over` what blit_sprite
 * would have put there. */
void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536]);

/* The same, but every pixel of it is c. */
void blit_solid(struct fb *fb, const struct image *image, int x, int y, uint8_t c, unsigned flags);

/* Its pixels and the eight places next to each, in c. */
void blit_rim(struct fb *fb, const struct image *image, int x, int y, uint8_t c);

#endif
