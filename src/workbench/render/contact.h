/*
 * contact.h - frames of a run on one picture, in reading order, each with its number above it.
 */
#ifndef WORKBENCH_CONTACT_H
#define WORKBENCH_CONTACT_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/fb.h"

struct contact {
    uint8_t *rgb; /* malloc; NULL: none is wanted */
    int w, h;     /* px */
    int columns;
    int label; /* px of the row above a picture */
    int scale; /* of the digits in it */
    int count; /* pictures on it */
};

/* A contact sheet for n pictures of w x h px, about as wide as high. False: too large, or no memory. */
bool contact_open(struct contact *s, int64_t n, int w, int h);

/* Adds the picture of that frame. At most n are added. */
void contact_add(struct contact *s, const struct fb *fb, const uint32_t rgb[256], uint32_t frame);

/* Gives it back; harmless on one of zeroes. */
void contact_close(struct contact *s);

#endif
