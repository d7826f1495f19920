/*
 * contact.h - draws a contact sheet: frames of a run in one picture, in reading order, each with its number above it.
 */
#ifndef WORKBENCH_CONTACT_H
#define WORKBENCH_CONTACT_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/fb.h"

struct contact {
    uint8_t *rgb; /* malloc; NULL: no sheet */
    int w, h;     /* px */
    int columns;
    int label; /* height of a frame's label, px */
    int scale; /* of the digits */
    int count; /* pictures so far */
};

/* Creates a sheet for n pictures of w x h px, about as wide as high. False: too large, or out of memory. */
bool contact_open(struct contact *s, int64_t n, int w, int h);

/* Adds the picture of a frame. At most n pictures can be added. */
void contact_add(struct contact *s, const struct fb *fb, const uint32_t rgb[256], uint32_t frame);

/* Frees the sheet, which may be all zeroes. */
void contact_close(struct contact *s);

#endif
