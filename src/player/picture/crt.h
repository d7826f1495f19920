/*
 * crt.h - the look of a tube: its lines, brighter ones wider, and a slight mask of red, green and blue.
 *
 * It works on rows of a picture that has been made larger, in integers. Lines are seen from twice the size on, the mask
 * too; below that only the colours are brighter, as they are made in advance for what lines and mask take away.
 */
#ifndef PLAYER_CRT_H
#define PLAYER_CRT_H

#include <stdint.h>

/* What a row does: a byte of colour c becomes c * (dark + c * bright / 256) / 256, and then its part of the mask. */
struct crt_line {
    uint16_t dark, bright; /* together 256 at most */
};

/* The colours as they have to be. */
void crt_colours(uint32_t out[256], const uint32_t rgb[256]);

/* Row y of `large` that a picture of `small` rows has become. */
struct crt_line crt_line(int y, int small, int large);

/* The mask of columns that were `small`: for each, what is left of its colours, 0xRRGGBB. */
void crt_mask(uint32_t *mask, int small, int large);

/* n pixels of a row. */
void crt_row(uint32_t *row, const uint32_t *mask, struct crt_line line, int n);

#endif
