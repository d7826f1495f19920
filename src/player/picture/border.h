/*
 * border.h - the art round a picture that a ROM may bring: any size, its own colours, and a hole.
 *
 * The hole is the box round all pixels that are wholly transparent. It is put where the picture is, and the rest is as
 * much larger or smaller as the hole; where that does not reach the window's edge, the margin is stretched. What is
 * partly transparent is on black.
 */
#ifndef PLAYER_BORDER_H
#define PLAYER_BORDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "quarter.h"

#define BORDER_LUMP "border" /* of a ROM: the PNG file as it is */

enum { BORDER_BYTES = 16 << 20 /* of that file */ };

struct border {
    const uint8_t *rgba; /* 4 bytes a pixel, rows on end; NULL: black */
    int w, h;
    struct area hole;
};

/* Finds the hole. False and one sentence: there is none. */
bool border_open(struct border *b, const uint8_t *rgba, int w, int h, char *err, size_t err_size);

/* Fills a window of w x h, 0xRRGGBB, all of it. picture: where the hole is to be, as seen in the window: turned. */
void border_paint(const struct border *b, uint32_t *out, int w, int h, struct area picture, enum quarter turn);

#endif
