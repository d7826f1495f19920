/*
 * blend.h - blend tables: the palette entry for each pair of palette entries.
 */
#ifndef WORKBENCH_BLEND_H
#define WORKBENCH_BLEND_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../fb/blit.h"
#include "../../rom/cart.h"

enum {
    BLEND_ADD = 0,
    BLEND_RULE = -1 /* -1 and below: enum blit_mix BLEND_RULE + BLIT_RAMP_ADD - mix (blit.h), which ignores colours */
};

/* Fills table[under * 256 + over] for all pairs of palette entries. If mix is BLEND_ADD, the blended colour is the sum
 * of the two, at most 255 per channel; otherwise it is mix percent (1 to 99) of `over` and the rest of `under`, each
 * channel rounded, halves up. The result is the nearest palette entry, the lowest of equals, by squared distance. Only
 * entries that games show are used: entry 0 and columns 1 to 15 of each bank. False: out of memory. */
bool blend_make(const uint8_t *rgb, int mix, uint8_t table[CART_BLEND_SIZE]);

#endif
