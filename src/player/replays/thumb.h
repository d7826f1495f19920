/*
 * thumb.h - the small picture of a replay: the board's picture reduced, in a palette that all of them share, so that
 * any number stand side by side.
 */
#ifndef PLAYER_THUMB_H
#define PLAYER_THUMB_H

#include "../../../fb/fb.h"

enum {
    THUMB_SIDE = 96,     /* px at most */
    THUMB_COLOURS = 240, /* 6 levels of red, 8 of green, 5 of blue */
    THUMB_PIXELS = THUMB_SIDE * THUMB_SIDE
};

struct thumb {
    int w, h; /* 0: there is none */
    uint8_t pix[THUMB_PIXELS];
};

/* The i-th colour of the palette, 0xRRGGBB. */
uint32_t thumb_colour(int i);

/* Reduces a picture to what fits, by means of boxes, dithered; a smaller one stays as large as it is. */
void thumb_make(struct thumb *t, const struct fb *fb, const uint32_t rgb[256]);

#endif
