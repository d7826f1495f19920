/*
 * rotation.h - rotates pictures, points and areas by multiples of 90 degrees, for rotated monitors.
 *
 * A rotation is that of the picture: left for a monitor that was rotated to the right. A point is a pixel.
 */
#ifndef PLAYER_ROTATION_H
#define PLAYER_ROTATION_H

#include <stdint.h>

enum rotation { ROTATION_NONE, ROTATION_LEFT, ROTATION_RIGHT, ROTATION_180, ROTATIONS };

struct area {
    int x, y, w, h;
};

/* Returns the rotation that undoes this one. */
enum rotation rotation_inverse(enum rotation rotation);

/* Converts the width and height of a picture to those of the rotated picture. */
void rotation_size(enum rotation rotation, int *w, int *h);

/* Converts a pixel of a picture of w x h, which may be outside, to that of the rotated picture. */
void rotation_point(enum rotation rotation, int w, int h, int *x, int *y);

/* The same for an area. */
struct area rotation_area(enum rotation rotation, int w, int h, struct area a);

/* Stores the rotated picture in out, whose size is that of rotation_size. They must not overlap. */
void rotation_picture(enum rotation rotation, const uint8_t *pix, int pitch, int w, int h, uint8_t *out, int out_pitch);

#endif
