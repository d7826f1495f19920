/*
 * turn.h - turned copies of pictures, for the packer.
 */
#ifndef FB_TURN_H
#define FB_TURN_H

#include <stddef.h>
#include <stdint.h>
#include "../src/base/fx.h"

/* A picture made ready to be turned about the point (ox, oy), in half pixels from its top left corner: w, h is its
 * middle. Pixel 0 is transparent. */
struct turn {
    const uint8_t *in;
    int w, h, pitch;
    int ox, oy;
    const uint8_t *smooth, *rim; /* in scratch: four times as large, rows on end; rim without what is inside */
    uint8_t colour[255];         /* the opaque colours, ascending */
    int colours;
};

/* The size of a picture that holds all opaque pixels of an image turned any way about its point, when that point is put
 * in the picture's middle. The parities are such that the image's pixels fall on pixels when the turn is 0. */
void turn_size(const uint8_t *in, int w, int h, int pitch, int ox, int oy, int *out_w, int *out_h);

/* Bytes of scratch that turn_open needs for an image. */
size_t turn_scratch(int w, int h);

/* in and scratch (turn_scratch bytes) must stay while t is used. w and h up to FB_MAX; pitch is bytes a row. */
void turn_open(struct turn *t, const uint8_t *in, int w, int h, int pitch, int ox, int oy, void *scratch);

/* Paints into out all of out_w x out_h pixels: the image turned clockwise about its point, which comes to lie in the
 * middle of out. Quarter turns copy pixels; other turns choose for each pixel one of the image's colours, none is
 * mixed. out_w and out_h up to FB_MAX; bytes of out beyond out_w are left alone. */
void turn_paint(const struct turn *t, ang turn, uint8_t *out, int out_w, int out_h, int out_pitch);

#endif
