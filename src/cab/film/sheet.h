/*
 * sheet.h - frames of a run on one picture, in reading order, each with its number above it.
 * floor: cab
 */
#ifndef CAB_SHEET_H
#define CAB_SHEET_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/fb.h"

struct sheet {
    uint8_t *rgb; /* malloc; NULL: none is wanted */
    int w, h;     /* px */
    int columns;
    int label; /* px of the row above a picture */
    int scale; /* of the digits in it */
    int count; /* pictures on it */
};

/* A sheet for n pictures of w x h px, about as wide as high. False: too large, or no memory. */
bool sheet_open(struct sheet *s, int64_t n, int w, int h);

/* Adds the picture of that frame. At most n are added. */
void sheet_add(struct sheet *s, const struct fb *fb, const uint32_t rgb[256], uint32_t frame);

/* Gives it back; harmless on a sheet of zeroes. */
void sheet_close(struct sheet *s);

#endif
