/*
 * text.c - see text.h. A character is an ordinary image; its rows are one word each, the fastest case of the blit.
 */
#include "text.h"
#include <string.h>
#include "blit.h"
#include "words.h"

/* Returns whether the glyph draws a pixel. */
static bool has_ink(const uint8_t *glyph)
{
    uint64_t pixels = 0, row;

    for (int y = 0; y < TEXT_SIDE; y++) {
        memcpy(&row, glyph + y * TEXT_SIDE, sizeof row);
        pixels |= row;
    }
    return pixels != 0;
}

const uint8_t *text_find_glyph(const struct font *font, uint32_t code)
{
    uint32_t i = code - (uint32_t)font->first;

    if (code < (uint32_t)font->first || i >= (uint32_t)font->count)
        return NULL;
    const uint8_t *glyph = font->glyphs + (size_t)i * TEXT_SIDE * TEXT_SIDE;
    return has_ink(glyph) ? glyph : NULL;
}

bool text_is_closing_punctuation(uint32_t code)
{
    static const uint32_t marks[] = {
        0x3001, 0x3002, 0x3005, 0x300d, 0x300f, 0x3011, 0x30fb, 0x30fc, 0xff01, 0xff09, 0xff0c,
        0xff0e, 0xff1a, 0xff1f, 0x2026, '!',    '?',    ',',    '.',    ')',    ':', /* then small kana */
        0x3041, 0x3043, 0x3045, 0x3047, 0x3049, 0x3063, 0x3083, 0x3085, 0x3087, 0x308e, 0x30a1,
        0x30a3, 0x30a5, 0x30a7, 0x30a9, 0x30c3, 0x30e3, 0x30e5, 0x30e7, 0x30ee,
    };

    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (marks[i] == code)
            return true;
    return false;
}

bool text_is_opening_punctuation(uint32_t code)
{
    return code == 0x300c || code == 0x300e || code == 0x3010 || code == 0xff08 || code == '(';
}

void text_draw_glyph(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t bank)
{
    if (text_is_blank(code))
        return;
    const uint8_t *glyph = text_find_glyph(font, code);
    struct image image = { glyph, TEXT_SIDE, TEXT_SIDE, TEXT_SIDE };

    if (glyph)
        blit_sprite(fb, &image, x, y, bank, 0);
    else
        text_draw_box(fb, x, y, TEXT_SIDE - 1, TEXT_SIDE, bank);
}

/* Returns v + 1, or v if v + 1 would overflow; nothing is visible at such coordinates. */
static int increment_saturated(int v)
{
    return v < INT32_MAX ? v + 1 : v;
}

void text_draw_box(struct fb *fb, int x, int y, int w, int h, uint8_t bank)
{
    fb_outline(fb, increment_saturated(x), increment_saturated(y), w - 1, h - 1, (uint8_t)(bank * 16 + 1));
    fb_outline(fb, x, y, w - 1, h - 1, (uint8_t)(bank * 16 + 15));
}

/* Draws one row of a rim, ten pixels starting at d: the mask's eight pixels, drawn three times, one pixel apart. */
static void draw_rim_row(uint8_t *d, uint64_t mask, uint8_t rim)
{
    const uint64_t moved_once = words_shift_up(mask), covered = mask | moved_once | words_shift_up(moved_once);
    uint8_t mask_bytes[8];

    words_store(d, (words_load(d) & ~covered) | (WORDS_EACH(rim) & covered));
    words_store(mask_bytes, mask);
    if (mask_bytes[6] | mask_bytes[7])
        d[8] = rim;
    if (mask_bytes[7])
        d[9] = rim;
}

/* Draws an unclipped rim, starting at d. Each row of the rim is the union of three of the glyph's rows. */
static void draw_unclipped_rim(uint8_t *d, int pitch, const uint8_t *glyph, uint8_t rim)
{
    uint64_t above = 0, current = 0;

    for (int row = -1; row <= TEXT_SIDE; row++, d += pitch) {
        uint64_t below = row + 1 < TEXT_SIDE ? words_opaque_mask(words_load(glyph + (row + 1) * TEXT_SIDE)) : 0;
        if (above | current | below)
            draw_rim_row(d, above | current | below, rim);
        above = current;
        current = below;
    }
}

void text_draw_rim(struct fb *fb, const struct font *font, int x, int y, uint32_t code, uint8_t rim)
{
    const uint8_t *glyph = text_is_blank(code) ? NULL : text_find_glyph(font, code);
    struct image image = { glyph, TEXT_SIDE, TEXT_SIDE, TEXT_SIDE };

    if (!glyph)
        return;
    if (x > fb->x0 && y > fb->y0 && x < fb->x1 - TEXT_SIDE && y < fb->y1 - TEXT_SIDE)
        draw_unclipped_rim(fb->pix + (y - 1) * fb->pitch + x - 1, fb->pitch, glyph, rim);
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
            text_draw_glyph(fb, font, (int)at, (int)row, (uint8_t)*s, bank);
        at += TEXT_SIDE;
    }
}
