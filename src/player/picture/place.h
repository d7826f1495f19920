/*
 * place.h - the positions of the picture and of the side panel in a window.
 */
#ifndef PLAYER_PLACE_H
#define PLAYER_PLACE_H

#include <stdbool.h>
#include "quarter.h"

enum { PLACE_SIDE = 156 /* px: the least width of a side panel */ };

struct place_want {
    int window_w, window_h; /* pixels, at least 1 */
    int w, h;               /* of the picture, before rotation */
    enum quarter turn;
    bool smooth; /* fill the window; otherwise scale by an integer, by 1 even if the window is too small */
    bool beside; /* a side panel is allowed */
};

/* Areas are in window pixels, after rotation. With integer scaling, an area may extend beyond the window. */
struct placed {
    struct area picture;
    struct area side;   /* of the side panel, to the right of the picture as the player sees it; w 0: it doesn't fit */
    int side_scale;     /* window pixels per pixel of the panel */
    int side_w, side_h; /* pixels of the panel, before rotation */
};

struct placed place(const struct place_want *want);

/* Converts a window pixel to a pixel of the picture before rotation. Returns false outside the picture. */
bool place_point(const struct place_want *want, const struct placed *placed, int *x, int *y);

#endif
