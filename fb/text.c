/*
 * text.c - see text.h. A character is an image as any other; its rows are one word each, the blit's quickest case.
 */
#include "text.h"
#include "blit.h"

void text_glyph(struct fb *fb, const struct font *font, int x, int y, uint8_t c, uint8_t bank)
{
    if (c < font->first || c - font->first >= font->count)
        return;
    struct image glyph = { font->glyphs + (c - font->first) * (TEXT_SIDE * TEXT_SIDE), TEXT_SIDE, TEXT_SIDE,
                           TEXT_SIDE };
    blit_sprite(fb, &glyph, x, y, bank, 0);
}

void text_draw(struct fb *fb, const struct font *font, int x, int y, const char *s, uint8_t bank)
{
    int64_t at = x, row = y;

    for (; *s && row < fb->y1; s++) {
        if (*s == '\n') {
            at = x;
            row += TEXT_SIDE;
            continue;
        }
        if (at < fb->x1)
            text_glyph(fb, font, (int)at, (int)row, (uint8_t)*s, bank);
        at += TEXT_SIDE;
    }
}
