/*
 * scale.h - pictures enlarged and reduced without mixing colours: Scale2x, and scaling fast enough for drawing.
 */
#ifndef FB_SCALE_H
#define FB_SCALE_H

#include "blit.h"

/* Paints an image at twice its size with Scale2x (Andrea Mazzoleni, 2001), which keeps diagonal edges smooth.
 * Everything outside the image counts as transparent. */
void scale_double(uint8_t *out, int out_pitch, const uint8_t *pix, int w, int h, int pitch);

/* Returns the bytes of scratch that scale_paint needs for an image. */
size_t scale_scratch_size(int w, int h);

/* Paints an image, scaled to w x h px, into out, and zeros from w to pitch in each row. Each pixel has one of the
 * image's colours. w and h are at least 1 and at least a fifth of the image's. scratch: scale_scratch_size bytes. */
void scale_paint(const struct image *in, uint8_t *out, int w, int h, int pitch, void *scratch);

#endif
