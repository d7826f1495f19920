/*
 * faces.h - packs fonts: the characters that a game shows, and their pictures.
 */
#ifndef WORKBENCH_FACES_H
#define WORKBENCH_FACES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../fb/utf8.h"
#include "../../rom/cart.h"
#include "art.h"

/* A set of code points. */
struct faces_set {
    uint8_t bits[UTF8_MAX_CODE / 8 + 1];
};

static inline bool faces_has(const struct faces_set *s, uint32_t code)
{
    return code <= UTF8_MAX_CODE && (s->bits[code / 8] >> (code % 8) & 1);
}

static inline void faces_add(struct faces_set *s, uint32_t code)
{
    if (code <= UTF8_MAX_CODE)
        s->bits[code / 8] = (uint8_t)(s->bits[code / 8] | 1u << code % 8);
}

/* All characters of a text; those of a script's literals, as written or as \u{...}, but not of its comments. */
void faces_add_text(struct faces_set *s, const char *text, size_t n);
void faces_add_script(struct faces_set *s, const char *text, size_t n);

struct faces_glyph {
    uint32_t code;
    int w, h, x, y, advance;
    uint8_t *pix; /* w * h shades; malloc */
};

struct faces {
    struct faces_glyph *list; /* malloc */
    int n, height;
};

/* Adds a glyph, and takes pix, also on failure. False: out of memory. */
bool faces_put(struct faces *f, struct faces_glyph g);
void faces_close(struct faces *f);

/* Sorts the glyphs. False: two have the code *code. */
bool faces_sort(struct faces *f, uint32_t *code);

/* Adds a shadow of shade 1 to the right and below. False: out of memory. */
bool faces_shadow(struct faces *f);

/* The lump of face.h; *out is malloc. 0: out of memory. */
size_t faces_make(const struct faces *f, uint8_t **out);

/* The wanted characters of a picture with a grid of cells, in the order of font->chars; f is empty before. False and
 * one sentence, without the file's name. */
bool faces_cut(struct faces *f, const struct art_picture *picture, const struct art_font *font,
               const struct faces_set *wanted, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, char *err,
               size_t err_size);

#endif
