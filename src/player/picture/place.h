/*
 * place.h - where in a window the picture stands, and what is to stand beside it.
 */
#ifndef PLAYER_PLACE_H
#define PLAYER_PLACE_H

#include <stdbool.h>
#include "quarter.h"

enum { PLACE_SIDE = 156 /* px of the cabinet's writing that are enough to put something beside the picture */ };

struct place_want {
    int window_w, window_h; /* pixels, at least 1 */
    int w, h;               /* of the picture, not turned */
    enum quarter turn;
    bool smooth; /* as large as the window allows; else by a whole number, and by 1 even if the window is too small */
    bool beside; /* something may stand beside the picture */
};

/* Areas are in window pixels, as they are seen there: turned. An area may reach beyond the window, with whole numbers.
 * */
struct placed {
    struct area picture;
    struct area side;   /* to the right of the picture, for who looks at it; w 0: there is no room for it */
    int side_scale;     /* window pixels a pixel of it */
    int side_w, side_h; /* pixels of what stands there, not turned */
};

struct placed place(const struct place_want *want);

/* The pixel of the picture, not turned, that is under a pixel of the window; false: none is. */
bool place_point(const struct place_want *want, const struct placed *placed, int *x, int *y);

#endif
