/*
 * blit.h - sprites: masked, flipped and recoloured by bank; and turned copies for the packer.
 * floor: fb    used by: board/ cab/
 */
#ifndef FB_BLIT_H
#define FB_BLIT_H

#include "fb.h"
#include "../src/base/fx.h"

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

/* The same, but a pixel becomes table[under * 256 + over]: `under` is what was there, `over` what blit_sprite would
 * have put there. */
void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536]);

/* The size of a picture that holds all opaque pixels of an image turned any way about its point (ox, oy), in half
 * pixels from its top left corner (w, h is its middle), when that point is put in the picture's middle. The parities
 * are such that the image's pixels fall on pixels when the turn is 0. */
void blit_rotated_size(const uint8_t *in, int w, int h, int pitch, int ox, int oy, int *out_w, int *out_h);

/* Paints into out all of out_w x out_h pixels: the image turned clockwise about (ox, oy), in half pixels, which comes
 * to lie in the middle of out. Quarter turns copy pixels; other turns choose for each pixel one of the image's colours,
 * none is mixed. out_w and out_h up to FB_MAX, w and h too; pitches are bytes a row; bytes of out beyond out_w are left
 * alone. */
void blit_rotate(uint8_t *out, int out_w, int out_h, int out_pitch, const uint8_t *in, int w, int h, int pitch,
                 ang turn, int ox, int oy);

#endif
