/*
 * compose.h - the whole window, pixel by pixel: the picture turned, made larger and with the look of a tube if that is
 * asked for, what stands beside it, and the border round it.
 *
 * It is done here and not by ports, so it looks the same everywhere and can be tested. A window of more than
 * COMPOSE_MOST pixels is composed at half its size, or less; the port stretches it.
 */
#ifndef PLAYER_COMPOSE_H
#define PLAYER_COMPOSE_H

#include <stdbool.h>
#include <stdint.h>
#include "border.h"
#include "crt.h"
#include "place.h"
#include "scale.h"

enum { COMPOSE_MOST = 1 << 22 };

struct compose_want {
    struct place_want place; /* window_w, window_h: of the window itself */
    bool crt;
    const struct border *border; /* NULL: black */
};

struct compose {
    struct compose_want want; /* the one that all of this was made for */
    int shrunk;               /* the window's size is so many times that of `pixels` */
    struct placed placed;
    int w, h;
    uint32_t *pixels;               /* w x h, 0xRRGGBB; malloc */
    uint32_t *back;                 /* border, without picture; malloc */
    struct scale_axis across, down; /* of the turned picture */
    uint32_t *mask;                 /* malloc */
    uint32_t *small, *rows[2];      /* a row of the picture, two that have been made larger; malloc */
    int of[2];                      /* which */
    uint8_t *turned;                /* the picture, or what stands beside it; malloc */
    bool beside;                    /* something stands beside the picture in `pixels` */
};

/* Makes it ready; cheap when nothing has changed. False: there is no memory, and it is closed. Zeroes before the first
 * call. */
bool compose_fit(struct compose *c, const struct compose_want *want);

/* Puts the picture in, w x h as want->place says. */
void compose_picture(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256]);

/* Puts what stands beside it in, placed.side_w x placed.side_h; pix NULL: nothing stands there. */
void compose_side(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256]);

/* The picture's pixel under a pixel of the composed window; false: none is. */
bool compose_point(const struct compose *c, int *x, int *y);

/* Harmless on zeroes. */
void compose_close(struct compose *c);

#endif
