/*
 * turn.h - turned copies of pictures, for the packer.
 * floor: fb    used by: cab/
 */
#ifndef FB_TURN_H
#define FB_TURN_H

#include <stdint.h>
#include "../src/base/fx.h"

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
