/*
 * icon.h - the picture of a game: of its window, of an entry in a menu.
 *
 * In a ROM it is the lump "icon": a PNG file as it is, or the name of a sprite, whose first picture it is. It is no
 * part of the game's hash.
 */
#ifndef PLAYER_ICON_H
#define PLAYER_ICON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

#define ICON_LUMP "icon"

enum {
    ICON_BYTES = 4 << 20, /* of the file */
    ICON_LEAST = 16,      /* px, the longer side of the picture in the file */
    ICON_MOST = 1024,
    ICON_SHOWN = 64, /* px, at least, of a window's */
    ICON_SAVED = 128 /* and of one that is saved */
};

/* Can a PNG file be one? False and one sentence. */
bool icon_check(const uint8_t *png, size_t size, char *err, size_t err_size);

/* The icon of a game, a square of *side px, R G B A (free it): the picture in its middle, as many whole times its size
 * as are needed for `least`. NULL: it has none, or there is no memory. */
uint8_t *icon_make(const struct cart *cart, int least, int *side);

/* The same of exactly that side: the next larger one shrunk, each pixel the mean of those it covers. */
uint8_t *icon_fit(const struct cart *cart, int side);

/* Gives it to the open window. */
void icon_show(const struct cart *cart);

#endif
