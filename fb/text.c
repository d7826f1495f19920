/*
 * text.c - see text.h. A character is an image as any other; its rows are one word each, the blit's quickest case.
 */
#include "text.h"
#include "blit.h"

/* w is 0: it has none. */
static struct image image_of(const struct font *font, uint8_t c)
{
    if (c < font->first || c - font->first >= font->count)
        return (struct image){ NULL, 0, 0, 0 };
    return (struct image){ font->glyphs + (c - font->first) * (TEXT_SIDE * TEXT_SIDE), TEXT_SIDE, TEXT_SIDE,
                           TEXT_SIDE };
}

void text_glyph(struct fb *fb, const struct font *font, int x, int y, uint8_t c, uint8_t bank)
{
    struct image glyph = image_of(font, c);

    if (glyph.w)
        blit_sprite(fb, &glyph, x, y, bank, 0);
}

void text_rim(struct fb *fb, const struct font *font, int x, int y, uint8_t c, uint8_t rim)
{
    struct image glyph = image_of(font, c);

    for (int k = 0; glyph.w && k < 9; k++)
        if (k != 4)
            blit_solid(fb, &glyph, x + k % 3 - 1, y + k / 3 - 1, rim, 0);
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
