/*
 * thumb.h - thumbnails of replays. All share one palette, so a screen can show any number of them.
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
    int w, h; /* 0: no thumbnail */
    uint8_t pix[THUMB_PIXELS];
};

/* Returns colour i of the palette, 0xRRGGBB. */
uint32_t thumb_colour(int i);

/* Shrinks a picture to fit THUMB_SIDE, averaging pixels and dithering. A picture that fits is not enlarged. */
void thumb_make(struct thumb *t, const struct fb *fb, const uint32_t rgb[256]);

#endif
