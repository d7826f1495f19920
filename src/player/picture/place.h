/*
 * place.h - the positions of the picture and of the side panel in a window.
 */
#ifndef PLAYER_PLACE_H
#define PLAYER_PLACE_H

#include <stdbool.h>
#include "rotation.h"

enum { PLACE_MIN_SIDE_WIDTH = 156 /* px of the side panel */ };

struct place_options {
    int window_w, window_h; /* pixels, at least 1 */
    int w, h;               /* of the picture, before rotation */
    enum rotation rotation;
    bool smooth;     /* fill the window; otherwise scale by an integer, by 1 even if the window is too small */
    bool side_panel; /* show a side panel if it fits */
};

/* Areas are in window pixels, after rotation. With integer scaling, an area may extend beyond the window. */
struct placed {
    struct area picture;
    struct area side;   /* of the side panel, to the right of the picture as the player sees it; w 0: it doesn't fit */
    int side_scale;     /* window pixels per pixel of the panel */
    int side_w, side_h; /* pixels of the panel, before rotation */
};

struct placed place(const struct place_options *options);

/* Converts a window pixel to a pixel of the picture before rotation. Returns false outside the picture. */
bool place_to_picture(const struct place_options *options, const struct placed *placed, int *x, int *y);

#endif
