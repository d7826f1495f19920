/*
 * screen_picture.h - pictures on a screen: portraits and thumbnails.
 */
#ifndef PLAYER_SCREEN_PICTURE_H
#define PLAYER_SCREEN_PICTURE_H

#include "screen.h"
#include "../../rom/cart.h"

struct screen_picture {
    int w, h, pitch;
    const uint8_t *pix;
    uint32_t rgb[256]; /* of each value of a pixel, 0xRRGGBB */
    bool has_holes;    /* pixels of value 0 are transparent */
};

/* Describes the first frame of a sprite in the colours of its sheet. Returns false if the game has no such sprite. */
bool screen_picture_of_sprite(struct screen_picture *p, const struct cart *cart, const char *name);

/* Draws a picture at the left edge of an area, in the middle of its height, reduced by a whole factor if it is larger.
 * Returns its width on the screen. A colour for which the palette has no entry left gets the nearest one. */
int screen_picture_draw(const struct screen_picture *p, const struct canvas *canvas, struct screen_area to);

#endif
