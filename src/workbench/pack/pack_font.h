/*
 * pack_font.h - packs a font: collects the characters that a game shows, and makes the lump of face.h from their
 * glyphs.
 */
#ifndef WORKBENCH_PACK_FONT_H
#define WORKBENCH_PACK_FONT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../fb/utf8.h"
#include "../../rom/cart.h"
#include "art.h"

/* A set of code points. */
struct pack_font_chars {
    uint8_t bits[UTF8_MAX_CODE / 8 + 1];
};

static inline bool pack_font_has(const struct pack_font_chars *s, uint32_t code)
{
    return code <= UTF8_MAX_CODE && (s->bits[code / 8] >> (code % 8) & 1);
}

static inline void pack_font_add(struct pack_font_chars *s, uint32_t code)
{
    if (code <= UTF8_MAX_CODE)
        s->bits[code / 8] = (uint8_t)(s->bits[code / 8] | 1u << code % 8);
}

/* Adds all characters of a text. add_script adds those outside comments, and those written as \u{...} in strings. */
void pack_font_add_text(struct pack_font_chars *s, const char *text, size_t n);
void pack_font_add_script(struct pack_font_chars *s, const char *text, size_t n);

struct pack_font_glyph {
    uint32_t code;
    int w, h, x, y, advance;
    uint8_t *pix; /* w * h shades, 0: transparent; malloc */
};

struct pack_font {
    struct pack_font_glyph *list; /* malloc */
    int n, height;
};

/* Adds a glyph. Owns g.pix from then on, and frees it on failure. False: out of memory. */
bool pack_font_add_glyph(struct pack_font *f, struct pack_font_glyph g);
void pack_font_free(struct pack_font *f);

/* Sorts the glyphs by code. False: two glyphs have the code *code. */
bool pack_font_sort(struct pack_font *f, uint32_t *code);

/* Makes `ink` the brightest shade, 2 to 15, and the others as much darker. */
void pack_font_darken(struct pack_font *f, int ink);

/* Adds a shadow of shade 1, to the right and below each glyph. False: out of memory. */
bool pack_font_add_shadow(struct pack_font *f);

/* Makes the lump of face.h (malloc). Returns its size; 0: out of memory. */
size_t pack_font_make(const struct pack_font *f, uint8_t **out);

/* Cuts the wanted characters from a picture that is a grid of cells, in the order of font->chars. f must be empty.
 * err doesn't name the file. */
bool pack_font_cut(struct pack_font *f, const struct art_picture *picture, const struct art_font *font,
                   const struct pack_font_chars *wanted, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, char *err,
                   size_t err_size);

#endif
