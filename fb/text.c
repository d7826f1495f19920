/*
 * text.c - see text.h. A character is an ordinary image; its rows are one word each, the fastest case of the blit.
 */
#include "text.h"
#include <string.h>
#include "blit.h"
#include "words.h"

/* Returns whether the glyph draws a pixel. */
static bool any_ink(const uint8_t *glyph)
{
    uint64_t all = 0, row;

    for (int y = 0; y < TEXT_SIDE; y++) {
        memcpy(&row, glyph + y * TEXT_SIDE, sizeof row);
        all |= row;
    }
    return all != 0;
}

static const uint8_t *glyph_of(const struct font *font, uint32_t code)
{
    uint32_t i = code - (uint32_t)font->first;

    if (code < (uint32_t)font->first || i >= (uint32_t)font->count)
        return NULL;
    const uint8_t *glyph = font->glyphs + (size_t)i * TEXT_SIDE * TEXT_SIDE;
    return any_ink(glyph) ? glyph : NULL;
}

bool text_has(const struct font *font, uint32_t code)
{
    return glyph_of(font, code) != NULL;
}

bool text_closes(uint32_t code)
{
    static const uint32_t signs[] = { 0x3001, 0x3002, 0x300d, 0x300f, 0x3011, 0x30fc, 0xff01, 0xff09, 0xff0c,
                                      0xff0e, 0xff1f, 0x2026, '!',    '?',    ',',    '.',    ')' };

    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (signs[i] == code)
            return true;
    return false;
}

void text_glyph(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t bank)
{
    if (text_blank(code))
        return;
    const uint8_t *glyph = glyph_of(font, code);
    struct image image = { glyph, TEXT_SIDE, TEXT_SIDE, TEXT_SIDE };

    if (glyph)
        blit_sprite(fb, &image, x, y, bank, 0);
    else
        text_box(fb, x, y, TEXT_SIDE - 1, TEXT_SIDE, bank);
}

/* Returns v + 1, or v if v + 1 would overflow; nothing is visible at such coordinates. */
static int beside(int v)
{
    return v < INT32_MAX ? v + 1 : v;
}

void text_box(struct fb *fb, int x, int y, int w, int h, uint8_t bank)
{
    fb_frame(fb, beside(x), beside(y), w - 1, h - 1, (uint8_t)(bank * 16 + 1));
    fb_frame(fb, x, y, w - 1, h - 1, (uint8_t)(bank * 16 + 15));
}

/* Draws one row of a rim, ten pixels starting at d: the mask's eight pixels, drawn three times, one pixel apart. */
static void rim_row(uint8_t *d, uint64_t mask, uint8_t rim)
{
    const uint64_t once = words_moved(mask), eight = mask | once | words_moved(once);
    uint8_t one[8];

    words_store(d, (words_load(d) & ~eight) | (WORDS_EACH(rim) & eight));
    words_store(one, mask);
    if (one[6] | one[7])
        d[8] = rim;
    if (one[7])
        d[9] = rim;
}

/* Draws an unclipped rim, starting at d. Each row of the rim is the union of three of the glyph's rows. */
static void whole_rim(uint8_t *d, int pitch, const uint8_t *glyph, uint8_t rim)
{
    uint64_t above = 0, on = 0;

    for (int row = -1; row <= TEXT_SIDE; row++, d += pitch) {
        uint64_t below = row + 1 < TEXT_SIDE ? words_opaque(words_load(glyph + (row + 1) * TEXT_SIDE)) : 0;
        if (above | on | below)
            rim_row(d, above | on | below, rim);
        above = on;
        on = below;
    }
}

void text_rim(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t rim)
{
    const uint8_t *glyph = text_blank(code) ? NULL : glyph_of(font, code);
    struct image image = { glyph, TEXT_SIDE, TEXT_SIDE, TEXT_SIDE };

    if (!glyph)
        return;
    if (x > fb->x0 && y > fb->y0 && x < fb->x1 - TEXT_SIDE && y < fb->y1 - TEXT_SIDE)
        whole_rim(fb->pix + (y - 1) * fb->pitch + x - 1, fb->pitch, glyph, rim);
    else
        blit_rim(fb, &image, x, y, rim);
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
