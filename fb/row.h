/*
 * row.h - rows of pixels onto rows of the surface: what backgrounds are drawn with.
 *
 * n pixels of s; add is added to every pixel but 0, modulo 256.
 */
#ifndef FB_ROW_H
#define FB_ROW_H

#include <stdint.h>

/* All of n pixels; none of them is 0 if add is not. */
void row_copy(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add);

/* Those that are not 0. */
void row_cover(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add);

/* Those that are not 0, shown as `to` says (256 entries; NULL: as they are) and mixed by `table` as blit_blended does
 * (NULL: not). */
void row_mix(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add, const uint8_t *to,
             const uint8_t *table);

#endif
