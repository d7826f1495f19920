/*
 * text.h - bitmap fonts: 8 x 8 characters of shades, recoloured by bank like sprites.
 * floor: fb
 */
#ifndef FB_TEXT_H
#define FB_TEXT_H

#include "fb.h"

enum { TEXT_SIDE = 8 }; /* px a character, each way */

struct font {
    const uint8_t *glyphs; /* 64 bytes a character, row by row, 0 transparent */
    int first, count;      /* the codes [first, first + count) have a glyph */
};

/* One character, its top left corner at (x, y); clipped; a code without a glyph draws nothing. Any x, y. */
void text_glyph(struct fb *fb, const struct font *font, int x, int y, uint8_t c, uint8_t bank);

/* The eight places next to each of the character's pixels, in colour `rim`: to be drawn before all characters. */
void text_rim(struct fb *fb, const struct font *font, int x, int y, uint8_t c, uint8_t rim);

/* Bytes up to the NUL, TEXT_SIDE px apart; '\n' goes back to x, one line down. Any x, y. For tests. */
void text_draw(struct fb *fb, const struct font *font, int x, int y, const char *s, uint8_t bank);

#endif
