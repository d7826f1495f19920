/*
 * view.h - the player's display settings for the picture.
 */
#ifndef MACHINE_VIEW_H
#define MACHINE_VIEW_H

#include <stdbool.h>
#include <stdint.h>

/* A view is passed to board_draw together with RAM. No tick reads it, and it is not part of RAM, hashes or demos. */

/* How much backgrounds and back sprites are darkened: not at all, by a quarter, a half or three quarters. */
enum view_dim { VIEW_DIM_NONE, VIEW_DIM_QUARTER, VIEW_DIM_HALF, VIEW_DIM_MOST, VIEW_DIMS };

/* Colour-blind mode: off, or for players without the cones for long (protanopia), medium (deuteranopia) or short
 * wavelengths (tritanopia). */
enum colour_blind_mode {
    COLOUR_BLIND_OFF,
    COLOUR_BLIND_PROTAN,
    COLOUR_BLIND_DEUTAN,
    COLOUR_BLIND_TRITAN,
    COLOUR_BLIND_MODES
};

enum { VIEW_SOFT_DIVISOR = 4 /* divisor of a flash's opacity with softens_flashes */ };

/* All zero: the picture is not changed. */
struct view {
    enum view_dim dim;
    bool softens_flashes; /* weakens `screen.flash` and the white blinking of hurt enemies */
    enum colour_blind_mode colour_blind_mode;
    bool hides_hud; /* leaves out text, plates and sprites above a dim, and sprites placed on the screen in front */
    const uint8_t *shades; /* CART_SHADES_SIZE bytes (cart.h) for a ROM without its own; NULL: the backgrounds of such a
                              ROM are not dimmed */
};

/* Returns the colour (0xRRGGBB) shown for rgb. Greys do not change. */
uint32_t view_adjust_colour(enum colour_blind_mode colours, uint32_t rgb);

#endif
