/*
 * text.h - bitmap fonts: characters of 8 x 8 px whose pixels are shades, recoloured by bank like sprites.
 */
#ifndef FB_TEXT_H
#define FB_TEXT_H

#include <stdbool.h>
#include "fb.h"

enum { TEXT_SIDE = 8 }; /* px, width and height of a character */

struct font {
    const uint8_t *glyphs; /* 64 bytes per character, row by row, 0 transparent */
    int first, count;      /* codes [first, first + count) have a glyph */
};

/* Draws a character with its top left corner at (x, y); clipped. A blank (text_is_blank) draws nothing; any other code
 * without a glyph, or with an empty one, draws a box. Any x, y. */
void text_draw_glyph(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t bank);

/* Draws the box that stands for a character without a glyph, in shades 15 and 1 of the bank, w x h px including its
 * shadow. */
void text_draw_box(struct fb *fb, int x, int y, int w, int h, uint8_t bank);

/* Returns the pixels of the code's glyph, TEXT_SIDE * TEXT_SIDE bytes; NULL if it has none that draws a pixel. */
const uint8_t *text_find_glyph(const struct font *font, uint32_t code);

static inline bool text_has_glyph(const struct font *font, uint32_t code)
{
    return text_find_glyph(font, code) != NULL;
}

/* Returns whether the code is closing punctuation, which never starts a row. */
bool text_is_closing_punctuation(uint32_t code);

/* Returns whether the code is opening punctuation, which never ends a row. */
bool text_is_opening_punctuation(uint32_t code);

/* Returns whether the code is a space between words. */
static inline bool text_is_blank(uint32_t code)
{
    return code == 32 || code == 160 || code == 0x3000;
}

/* Draws the character's pixels, and the eight pixels around each, in colour `rim`. Draw all rims before the first
 * character, as rims cover neighbouring characters. */
void text_draw_rim(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t rim);

/* Draws the bytes up to the NUL, TEXT_SIDE px apart; '\n' returns to x, one line down. Any x, y. For tests. */
void text_draw(struct fb *fb, const struct font *font, int x, int y, const char *s, uint8_t bank);

#endif
