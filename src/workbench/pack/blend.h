/*
 * blend.h - tables of blended drawing: the palette entry for each pair of colours.
 */
#ifndef WORKBENCH_BLEND_H
#define WORKBENCH_BLEND_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/blit.h"
#include "../../rom/cart.h"

enum {
    BLEND_ADD = 0,
    BLEND_RULE = -1 /* and below: the rule BLEND_RULE + BLIT_RAMP_ADD - mix of blit.h, which ignores colours */
};

/* Fills table[under * 256 + over], for all pairs of palette entries. The wanted colour is the sum of the two, at most
 * 255 per channel, if mix is BLEND_ADD; otherwise mix percent (1 to 99) of `over` and the rest of `under`, each channel
 * to the nearest, halves up. The entry is the nearest of those that games show, entry 0 and columns 1 to 15 of all
 * banks: the least sum of the channels' squared differences, the lowest of equals. False: out of memory. */
bool blend_make(const uint8_t *rgb, int mix, uint8_t table[CART_BLEND_SIZE]);

#endif
