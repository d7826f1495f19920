/*
 * crt.h - the CRT filter: scanlines, which are wider where they are brighter, and a light shadow mask.
 *
 * It works on rows of a scaled picture, in integers. Scanlines and mask are visible from a scale of two. Below that,
 * only the colours are brighter, which compensates for the darkening by scanlines and mask.
 */
#ifndef PLAYER_CRT_H
#define PLAYER_CRT_H

#include <stdint.h>

/* The brightness of a row: a colour byte c becomes c * (dark + c * bright / 256) / 256, and is then masked. */
struct crt_line {
    uint16_t dark, bright; /* together 256 at most */
};

/* Brightens the colours. */
void crt_colours(uint32_t out[256], const uint32_t rgb[256]);

/* Returns the brightness of row y of a picture that was scaled from `small` to `large` rows. */
struct crt_line crt_line(int y, int small, int large);

/* Makes the mask for a picture scaled from `small` to `large` columns: a factor per colour and column, 0xRRGGBB. */
void crt_mask(uint32_t *mask, int small, int large);

/* Applies the filter to n pixels of a row. */
void crt_row(uint32_t *row, const uint32_t *mask, struct crt_line line, int n);

#endif
