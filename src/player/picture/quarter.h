/*
 * quarter.h - rotates pictures, points and areas by quarter turns, for rotated monitors.
 *
 * A turn is that of the picture: left for a monitor that was rotated to the right. A point is a pixel.
 */
#ifndef PLAYER_QUARTER_H
#define PLAYER_QUARTER_H

#include <stdint.h>

enum quarter { QUARTER_NONE, QUARTER_LEFT, QUARTER_RIGHT, QUARTER_OVER, QUARTERS };

struct area {
    int x, y, w, h;
};

/* Returns the opposite turn. */
enum quarter quarter_back(enum quarter turn);

/* Converts width and height. */
void quarter_size(enum quarter turn, int *w, int *h);

/* Converts a pixel of a picture of w x h; it may be outside. */
void quarter_point(enum quarter turn, int w, int h, int *x, int *y);

/* The same for an area. */
struct area quarter_area(enum quarter turn, int w, int h, struct area a);

/* Stores the rotated picture in out, whose size is that of quarter_size. They must not overlap. */
void quarter_picture(enum quarter turn, const uint8_t *pix, int pitch, int w, int h, uint8_t *out, int out_pitch);

#endif
