/*
 * border.h - the art around the picture, which a ROM can contain: any size, any colours, and a hole for the picture.
 *
 * The hole is the bounding box of all fully transparent pixels. The art is scaled so that the hole has the size of the
 * picture. Where the art then doesn't reach the window's edge, its margin is stretched. Partly transparent pixels are
 * blended with black.
 */
#ifndef PLAYER_BORDER_H
#define PLAYER_BORDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "rotation.h"

#define BORDER_LUMP "border" /* a lump that contains a PNG file */

enum { BORDER_MAX_BYTES = 16 << 20 /* most bytes of that file */ };

struct border {
    const uint8_t *rgba; /* 4 bytes per pixel, rows without padding; NULL: black */
    int w, h;
    struct area hole;
};

/* Finds the hole. If there is none, returns false and sets err. */
bool border_open(struct border *b, const uint8_t *rgba, int w, int h, char *err, size_t err_size);

/* Fills a whole window of w x h pixels, 0xRRGGBB. picture: the area of the hole, after rotation. */
void border_paint(const struct border *b, uint32_t *out, int w, int h, struct area picture, enum rotation rotation);

#endif
