/*
 * shade.h - the tables for dimming backgrounds: the palette entries that replace entries.
 */
#ifndef PLAYER_SHADE_H
#define PLAYER_SHADE_H

#include "../../board/board.h"
#include "../../rom/cart.h"

/* Fills tables[(dim - 1) * 256 + entry] for all dims from VIEW_DIM_QUARTER. The target colour has each channel reduced
 * by `dim` quarters. Candidates are the entries that games show (entry 0 and columns 1 to 15 of all banks) and that are
 * not brighter than the result of the previous dim (or the entry itself), so dimming never brightens. The result is the
 * candidate with the least sum of squared channel differences, the lowest of equal ones, or without candidates the
 * previous result. Brightness is 2 red + 3 green + blue. */
void shade_make(const uint8_t rgb[CART_PALETTE_SIZE], uint8_t tables[CART_SHADES_SIZE]);

/* The tables of the last palette. Zero it before the first use. */
struct shade_cache {
    bool made;
    uint8_t palette[CART_PALETTE_SIZE], tables[CART_SHADES_SIZE];
};

/* Returns the tables for a view of an older ROM that contains none, or NULL if the ROM contains them. */
const uint8_t *shade_get_tables(struct shade_cache *cache, const struct cart *cart);

#endif
