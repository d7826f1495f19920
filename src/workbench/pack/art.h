/*
 * art.h - converts pictures to palette indices.
 *
 * A pixel of less than half opacity is transparent (0). Any other pixel must have one of the bank's 15 colours, or is
 * converted to the nearest on request. In a picture that is matched by index, colours are ignored: index n is shade
 * n % 16, and must be below 16 or in the bank. Errors don't name the file; the caller adds it.
 */
#ifndef WORKBENCH_ART_H
#define WORKBENCH_ART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

struct art_picture {
    uint8_t *rgba; /* malloc; rows without padding */
    int w, h;
    uint8_t *index;         /* malloc; palette indices. NULL: the picture is not indexed */
    bool by_index;          /* match by index instead of by colour (index is not NULL) */
    int cell;               /* px; the picture is a strip of frames of this width; 0: a sheet */
    const uint16_t *frames; /* the frames' numbers in the file, from 1; NULL: in order */
};
void art_picture_free(struct art_picture *picture);

/* Writes the position of a pixel for messages: "pixel 3,4", and in a strip "frame 2, pixel 3,4". */
enum { ART_PLACE = 48 };
void art_place(const struct art_picture *p, int x, int y, char out[ART_PLACE]);

/* Fills in the colours of a game without a palette: bank 0 from black to white, each other bank a hue of the colour
 * wheel from dark to light. */
void art_default_palette(uint8_t rgb[CART_PALETTE_SIZE]);

/* Reads a palette from a picture of 16x16 pixels: rows are banks, columns are shades. */
bool art_make_palette(const struct art_picture *picture, uint8_t rgb[CART_PALETTE_SIZE], char *err, size_t err_size);

/* Returns the shade of a pixel: 1 to 15, or 0 for a transparent one. -1: its colour or index is not in the bank. */
int art_shade(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
              size_t err_size);

/* Makes the font lump from a picture 128 px wide: 8x8 cells, 16 per row, in the colours of bank 0. *out is malloc. */
bool art_make_font(const struct art_picture *picture, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out,
                   size_t *size, char *err, size_t err_size);

/* The opaque pixels whose colour or index is not in the bank. marked: a byte per pixel, 0 for pixels to ignore; NULL:
 * ignore none. */
struct art_strays {
    long n;
    int x, y;         /* of the first, in reading order */
    int bank;         /* a bank with its colour, or -1 */
    uint8_t c[3];     /* its colour */
    int index;        /* its index if the picture is matched by index; otherwise -1 */
    bool indices_fit; /* all indices are in the bank although colours are not: the palette was changed */
};
struct art_strays art_find_strays(const struct art_picture *picture, const uint8_t *marked, int bank,
                                  const uint8_t rgb[CART_PALETTE_SIZE]);

/* Pixels that are not shown because they are less than half opaque. */
struct art_faint {
    long n;
    int x, y, percent; /* of the first, in reading order */
};
struct art_faint art_find_faint(const struct art_picture *picture, const uint8_t *marked);

/* Describes them in a sentence, without the file; n is not 0. */
void art_faint_describe(const struct art_picture *picture, const struct art_faint *f, char *out, size_t size);

/* Returns a side of a sprite in px after scaling: rounded, at least 1. */
int art_resized(int side, int percent);

/* Makes the gfx lump of a sprite on its sheet. Rotated copies have the smallest size that fits all of them. *out is
 * malloc. *pixel (may be NULL): the error is about a pixel's colour, and err starts with its position. */
bool art_make_sprite(const struct art_picture *sheet, const struct art_sprite *sprite, int bank,
                     const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out, size_t *size, bool *pixel,
                     char *err, size_t err_size);

#endif
