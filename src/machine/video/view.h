/*
 * view.h - what a player wants to see.
 */
#ifndef MACHINE_VIEW_H
#define MACHINE_VIEW_H

#include <stdbool.h>
#include <stdint.h>

/* How a player wants to see the picture. It is given to draw beside RAM and reaches no tick: neither RAM nor a hash or
 * demo knows of it. */

/* How much darker backgrounds and back sprites are: not at all, by a quarter, a half, three quarters. */
enum view_dim { VIEW_DIM_NONE, VIEW_DIM_QUARTER, VIEW_DIM_HALF, VIEW_DIM_MOST, VIEW_DIMS };

/* Whom the colours are for: those who see all, or lack the cones for long (protanopia), middle (deuteranopia) or short
 * waves (tritanopia). */
enum view_colours { VIEW_ALL, VIEW_PROTAN, VIEW_DEUTAN, VIEW_TRITAN, VIEW_COLOURS };

enum { VIEW_SOFT = 4 /* a soft flash has a VIEW_SOFTth of its share */ };

/* All zero: the picture as it is. */
struct view {
    enum view_dim dim;
    bool soft_flashes; /* of `screen.flash`; and whoever is hurt blinks softly */
    enum view_colours colours;
    const uint8_t *shades; /* CART_SHADES bytes (cart.h), for a ROM that has none of its own; NULL: such a ROM's
                              backgrounds are not dimmed */
};

/* The colour (0xRRGGBB) shown for one. Greys stay as they are. */
uint32_t view_colour(enum view_colours colours, uint32_t rgb);

#endif
