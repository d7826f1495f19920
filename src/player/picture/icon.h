/*
 * icon.h - the icon of a game, for its window and menu entry.
 *
 * A ROM stores it in the lump "icon": a PNG file, or the name of a sprite whose first frame is the icon. It is not part
 * of the game's hash.
 */
#ifndef PLAYER_ICON_H
#define PLAYER_ICON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

#define ICON_LUMP "icon"

enum {
    ICON_MAX_BYTES = 4 << 20, /* most bytes of the file */
    ICON_MIN_SIDE = 16,       /* px, the longer side of the picture in the file */
    ICON_MAX_SIDE = 1024,
    ICON_WINDOW_SIDE = 64, /* px, at least, for a window */
    ICON_FILE_SIDE = 128   /* px, at least, in a file */
};

/* Checks a PNG file. If it cannot be an icon, returns false and sets err. */
bool icon_check(const uint8_t *png, size_t size, char *err, size_t err_size);

/* Returns a game's icon as a square of *side pixels, R G B A (free it): the picture is centred and scaled by the least
 * integer that makes it at least min_side pixels. Returns NULL if there is no icon, or when out of memory. */
uint8_t *icon_make(const struct cart *cart, int min_side, int *side);

/* The same with exactly `side` pixels: shrinks the next larger size by averaging. */
uint8_t *icon_fit(const struct cart *cart, int side);

/* Sets the icon of the open window. */
void icon_show(const struct cart *cart);

#endif
