/*
 * resize.h - pictures at another size, for the packer.
 */
#ifndef FB_RESIZE_H
#define FB_RESIZE_H

#include "turn.h"

/* Paints the image of t into out: w x h pixels, rows on end. Each is one of the image's colours, none is mixed. w and h
 * from 1 to FB_MAX. */
void resize_paint(const struct turn *t, uint8_t *out, int w, int h);

#endif
