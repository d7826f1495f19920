/*
 * resize.h - resized copies of pictures, for the packer.
 */
#ifndef FB_RESIZE_H
#define FB_RESIZE_H

#include "turn.h"

/* Paints t's image, resized to w x h pixels, into out; the rows of out have no padding. Each pixel is one of the
 * image's colours; colours are never mixed. w and h are 1 to FB_MAX_SIDE. */
void resize_paint(const struct turn *t, uint8_t *out, int w, int h);

#endif
