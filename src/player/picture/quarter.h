/*
 * quarter.h - pictures, points and areas turned by quarters, for monitors that stand upright.
 *
 * A turn is what happens to the picture: left for a monitor that was turned to the right. A point is a pixel.
 */
#ifndef PLAYER_QUARTER_H
#define PLAYER_QUARTER_H

#include <stdint.h>

enum quarter { QUARTER_NONE, QUARTER_LEFT, QUARTER_RIGHT, QUARTER_OVER, QUARTERS };

struct area {
    int x, y, w, h;
};

/* The turn that undoes it. */
enum quarter quarter_back(enum quarter turn);

/* Width and height of what was w x h. */
void quarter_size(enum quarter turn, int *w, int *h);

/* Where a pixel of what is w x h comes to stand; any values. */
void quarter_point(enum quarter turn, int w, int h, int *x, int *y);

/* The same of an area. */
struct area quarter_area(enum quarter turn, int w, int h, struct area a);

/* out, which is as large as quarter_size says, becomes the turned pix. The two do not overlap. */
void quarter_picture(enum quarter turn, const uint8_t *pix, int pitch, int w, int h, uint8_t *out, int out_pitch);

#endif
