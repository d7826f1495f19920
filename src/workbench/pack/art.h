/*
 * art.h - converts pictures to palette indices.
 *
 * A pixel of less than half opacity is transparent (0); any other must have one of the bank's 15 colours, or gets the
 * nearest one on request. Colours of a picture that is matched by index are ignored: index n is shade n % 16, and n is
 * below 16 or in the bank. Sentences don't name the file; the caller does.
 */
#ifndef WORKBENCH_ART_H
#define WORKBENCH_ART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

struct art_picture {
    uint8_t *rgba; /* rows on end; malloc */
    int w, h;
    uint8_t *index;         /* palette indices, malloc; NULL: a picture of colours */
    bool by_index;          /* shades are the indices', not the colours' (index is not NULL) */
    int cell;               /* px: the picture is a strip of frames that wide; 0: a sheet */
    const uint16_t *frames; /* their numbers in the file, from 1; NULL: in order */
};
void art_picture_free(struct art_picture *picture);

/* The place of a pixel, for messages: "pixel 3,4", and in a strip "frame 2, pixel 3,4". */
enum { ART_PLACE = 48 };
void art_place(const struct art_picture *p, int x, int y, char out[ART_PLACE]);

/* The colours of a game without a palette: bank 0 from black to white, the others from dark to light round the colour
 * wheel. */
void art_default_palette(uint8_t rgb[CART_PALETTE_SIZE]);

/* A 16x16 picture: rows are banks, columns are shades. */
bool art_make_palette(const struct art_picture *picture, uint8_t rgb[CART_PALETTE_SIZE], char *err, size_t err_size);

/* A pixel's place in the bank: 1 to 15, 0: transparent. -1 and a sentence: its colour, or index, is not in the bank. */
int art_shade(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
              size_t err_size);

/* The font lump of a picture 128 px wide: 8x8 cells, 16 a row, in the colours of bank 0. *out is malloc. */
bool art_make_font(const struct art_picture *picture, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out,
                   size_t *size, char *err, size_t err_size);

/* The opaque pixels whose colour, or index, is not in the bank. marked: a byte per pixel, 0 for pixels to ignore; NULL:
 * none. */
struct art_strays {
    long n;
    int x, y;     /* of the first, in reading order */
    int bank;     /* one that has its colour, or -1 */
    uint8_t c[3]; /* its colour */
    int index;    /* its index, where these count; else -1 */
    bool fits;    /* its indices are in the bank, its colours are not: the palette was changed */
};
struct art_strays art_find_strays(const struct art_picture *picture, const uint8_t *marked, int bank,
                                  const uint8_t rgb[CART_PALETTE_SIZE]);

/* Pixels that are not shown because they are less than half opaque. */
struct art_faint {
    long n;
    int x, y, percent; /* of the first, in reading order */
};
struct art_faint art_find_faint(const struct art_picture *picture, const uint8_t *marked);

/* The sentence about them, without the file; n is not 0. */
void art_faint_say(const struct art_picture *picture, const struct art_faint *f, char *out, size_t size);

/* A side of a sprite in px, scaled by percent: rounded, at least 1. */
int art_resized(int side, int percent);

/* The gfx lump of a sprite on its sheet. Rotated copies have the smallest size that fits all of them. *out is malloc.
 * *pixel, which may be NULL: false was returned for the colour of a pixel, which err begins with. */
bool art_make_sprite(const struct art_picture *sheet, const struct art_sprite *sprite, int bank,
                     const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out, size_t *size, bool *pixel,
                     char *err, size_t err_size);

#endif
