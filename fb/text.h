/*
 * text.h - bitmap fonts: 8 x 8 characters of shades, recoloured by bank like sprites.
 */
#ifndef FB_TEXT_H
#define FB_TEXT_H

#include <stdbool.h>
#include "fb.h"

enum { TEXT_SIDE = 8 }; /* px a character, each way */

struct font {
    const uint8_t *glyphs; /* 64 bytes a character, row by row, 0 transparent */
    int first, count;      /* the codes [first, first + count) have a glyph */
};

/* One character, its top left corner at (x, y); clipped. A blank (text_blank) draws nothing, any other code without a
 * glyph, or whose glyph is empty, a box. Any x, y. */
void text_glyph(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t bank);

/* The box that stands for a character without a glyph, in the shades 15 and 1 of the bank, w x h px with its shadow. */
void text_box(struct fb *fb, int x, int y, int w, int h, uint8_t bank);

/* Has the code a glyph that draws a pixel? */
bool text_has(const struct font *font, uint32_t code);

/* Is it a sign that never begins a row, for it closes what is before it? */
bool text_closes(uint32_t code);

/* Does it stand for room between words? */
static inline bool text_blank(uint32_t code)
{
    return code == 32 || code == 160 || code == 0x3000;
}

/* The character's pixels and the eight places next to each, in colour `rim`: to be drawn before all characters. */
void text_rim(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t rim);

/* Bytes up to the NUL, TEXT_SIDE px apart; '\n' goes back to x, one line down. Any x, y. For tests. */
void text_draw(struct fb *fb, const struct font *font, int x, int y, const char *s, uint8_t bank);

#endif
