/*
 * row.h - draws rows of pixels onto rows of the surface, for backgrounds.
 *
 * All functions draw n pixels of s onto d, and add `add`, modulo 256, to every pixel except 0.
 */
#ifndef FB_ROW_H
#define FB_ROW_H

#include <stdint.h>

/* Draws all n pixels; none of them may be 0 unless add is 0. */
void row_copy(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add);

/* Draws the pixels that are not 0. */
void row_cover(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add);

/* Draws the pixels that are not 0, mapped by `remap` (256 entries; NULL: unchanged) and mixed by `table` as in
 * blit_blended (NULL: opaque). */
void row_mix(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add, const uint8_t *remap,
             const uint8_t *table);

#endif
