/*
 * compose.h - composes the whole window: the picture, rotated, scaled and with the CRT filter if requested, the panel
 * next to it, and the border around it.
 *
 * Ports don't compose, so the window looks the same everywhere and can be tested. A window of more than
 * COMPOSE_MAX_PIXELS pixels is composed at half its size or less, and stretched by the port.
 */
#ifndef PLAYER_COMPOSE_H
#define PLAYER_COMPOSE_H

#include <stdbool.h>
#include <stdint.h>
#include "border.h"
#include "crt.h"
#include "place.h"
#include "scale.h"

enum { COMPOSE_MAX_PIXELS = 1 << 22 };

struct compose_options {
    struct place_options place; /* window_w, window_h: the window's own size */
    bool crt;
    const struct border *border; /* NULL: black */
};

struct compose {
    struct compose_options options; /* that the fields below were made for */
    int shrink;                     /* the window's size divided by that of `pixels` */
    struct placed placed;
    int w, h;
    uint32_t *pixels;               /* w x h, 0xRRGGBB; malloc */
    uint32_t *background;           /* the border without the picture; malloc */
    struct scale_axis across, down; /* for the rotated picture */
    uint32_t *mask;                 /* malloc */
    uint32_t *small, *rows[2];      /* a row of the picture, and two scaled rows; malloc */
    int row_numbers[2];             /* of the scaled rows */
    uint8_t *rotated;               /* the rotated picture or side panel; malloc */
    bool side_panel;                /* `pixels` contains a side panel */
};

/* Prepares *c for these options; fast if nothing has changed. Zero *c before the first call. When out of memory, closes
 * it and returns false. */
bool compose_prepare(struct compose *c, const struct compose_options *options);

/* Draws the picture, whose size is that in options->place. */
void compose_picture(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256]);

/* Draws the side panel of placed.side_w x placed.side_h pixels; pix NULL: none. */
void compose_side(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256]);

/* Converts a pixel of the composed window to a pixel of the picture. Returns false outside the picture. */
bool compose_to_picture(const struct compose *c, int *x, int *y);

/* Frees the memory. Does nothing if *c is zeroed. */
void compose_close(struct compose *c);

#endif
