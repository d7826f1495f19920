/*
 * turn.h - turned copies of pictures, for the packer.
 */
#ifndef FB_TURN_H
#define FB_TURN_H

#include <stddef.h>
#include <stdint.h>
#include "../src/base/fx.h"

/* A picture prepared for turning about the point (ox, oy), given in half pixels from the picture's top left corner; the
 * middle of the picture is (w, h). Pixel 0 is transparent. */
struct turn {
    const uint8_t *pix;
    int w, h, pitch;
    int ox, oy;
    const uint8_t *smooth, *rim; /* in scratch: the picture at four times the width and height, rows without padding; in
                                    `rim`, inner pixels are 0 */
    uint8_t colour[255];         /* the opaque colours, ascending */
    int colour_count;
};

/* Computes the size of a picture that holds all opaque pixels of an image turned by any angle about (ox, oy), if that
 * point is put in the middle of the picture. The parities of the size are chosen so that the image's pixels fall on
 * whole pixels when the turn is 0. */
void turn_size(const uint8_t *in, int w, int h, int pitch, int ox, int oy, int *out_w, int *out_h);

/* Returns the bytes of scratch that turn_init needs for an image. */
size_t turn_scratch_size(int w, int h);

/* Prepares an image for turning. in and scratch (turn_scratch_size bytes) must outlive t. w and h are at most
 * FB_MAX_SIDE; pitch is bytes per row. */
void turn_init(struct turn *t, const uint8_t *in, int w, int h, int pitch, int ox, int oy, void *scratch);

/* Paints all out_w x out_h pixels of out: the image turned clockwise about (ox, oy), with that point in the middle of
 * out. Quarter turns copy pixels; other turns choose one of the image's colours for each pixel and never mix colours.
 * out_w and out_h are at most FB_MAX_SIDE; bytes of a row beyond out_w are not written. */
void turn_paint(const struct turn *t, ang angle, uint8_t *out, int out_w, int out_h, int out_pitch);

#endif
