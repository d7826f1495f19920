/*
 * shade.h - the tables by which a view dims backgrounds: which palette entry stands for a darker one.
 */
#ifndef PLAYER_SHADE_H
#define PLAYER_SHADE_H

#include "../../board/board.h"
#include "../../rom/cart.h"

/* Fills tables[(dim - 1) * 256 + entry], for dims from VIEW_DIM_QUARTER on. The colour looked for has dim quarters of
 * each channel less. The entry is the nearest of those that games show (entry 0 and columns 1 to 15 of all banks) that
 * are no brighter than what the dim before shows, or than the entry itself: the least sum of the channels' squared
 * differences, the lowest of equals. Brightness is 2 red + 3 green + blue. Where none is, it is what the dim before
 * shows. So nothing that is dimmed is ever brighter. */
void shade_make(const uint8_t rgb[CART_PALETTE_SIZE], uint8_t tables[CART_SHADES_SIZE]);

/* Tables that are made when a game is shown; all zero: none yet. */
struct shade_kept {
    bool made;
    uint8_t of[CART_PALETTE_SIZE], tables[CART_SHADES_SIZE];
};

/* For a view: tables of a ROM that has none of its own, an older one; NULL for one that has. They are made anew only
 * where the palette is another. */
const uint8_t *shade_for(struct shade_kept *k, const struct cart *cart);

#endif
