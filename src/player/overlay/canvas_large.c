/*
 * canvas_large.c - text in the large font (canvas.h).
 */
#include "canvas.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "../../../fb/blit.h"
#include "../../../fb/line_break.h"
#include "../../../fb/utf8.h"
#include "letters.h"

enum { TAB_SPACES = 2, SPACING = CANVAS_LARGE_LETTER_SPACING, BRIGHTEST = 15 /* shade */ };

static const char ellipsis[] = "\xE2\x80\xA6";

/* ---- a character ---- */

/* A character in the theme's font or, if that font lacks it, in letters.h's. Without a theme, letters.h is first, and
 * the spare font second. */
struct glyph {
    bool is_letter;
    struct letter letter;
    struct face_glyph face;
};

static const struct theme *font_for(const struct canvas *canvas, uint32_t code)
{
    return canvas->theme ? canvas->theme : letter_exists(code) ? NULL : canvas->spare;
}

/* Advances *s past the next character and returns the character's width with its spacing. */
static int advance(const struct canvas *canvas, const char **s, const char *end, struct glyph *g)
{
    const uint32_t code = utf8_next(s, end), shown = code == '\t' ? ' ' : code;
    int w;

    const struct theme *font = font_for(canvas, shown);
    g->is_letter = !font || !theme_find_glyph(font, shown, &g->face);
    if (g->is_letter)
        letter_load(&g->letter, shown);
    w = g->is_letter ? g->letter.w + SPACING : g->face.advance;
    return code == '\t' ? TAB_SPACES * w : w;
}

/* Draws a row, adjacent pixels as one rectangle. */
static void draw_row(struct fb *fb, int x, int y, unsigned bits, uint8_t colour)
{
    for (int n; bits; bits >>= n, x += n) {
        bool ink = bits & 1;
        for (n = 0; bits >> n && (bool)(bits >> n & 1) == ink;)
            n++;
        if (ink)
            fb_fill_rect(fb, x, y, n, 1, colour);
    }
}

/* Draws a letter in one colour, without its shadow, which is shade 1. */
static void draw_in_colour(struct fb *fb, const struct image *image, int x, int y, uint8_t colour)
{
    for (int i = 0; i < image->w * image->h; i++)
        if (image->pix[i / image->w * image->pitch + i % image->w] > 1)
            fb_fill_rect(fb, x + i % image->w, y + i / image->w, 1, 1, colour);
}

/* Outline fonts have letters in the brightest shade alone, which is nearly white in every bank. */
static bool is_flat(const struct image *image)
{
    for (int i = 0; i < image->w * image->h; i++) {
        const uint8_t shade = image->pix[i / image->w * image->pitch + i % image->w];
        if (shade > 1 && shade != BRIGHTEST)
            return false;
    }
    return true;
}

/* y: the top of capitals. */
static void draw_glyph(const struct canvas *canvas, int x, int y, enum canvas_colour c, const struct glyph *g)
{
    const struct theme *font = canvas->theme ? canvas->theme : canvas->spare;
    const struct image image = { g->face.pix, g->face.w, g->face.h, g->face.pitch };
    const int base = y + canvas->capital_height;

    if (g->is_letter) {
        for (int i = 0; i < LETTER_ROWS; i++)
            draw_row(canvas->fb, x, base - LETTER_CAPITAL_HEIGHT - LETTER_ACCENT_HEIGHT + i, g->letter.rows[i],
                     canvas->colour[c]);
        return;
    }
    const int top = base - font->capital_height - font->capital_top + g->face.y;
    if (canvas->theme)
        blit_sprite(canvas->fb, &image, x + g->face.x, top, canvas->bank[c], 0);
    if (!canvas->theme || is_flat(&image))
        draw_in_colour(canvas->fb, &image, x + g->face.x, top, canvas->colour[c]);
}

/* ---- a line ---- */

int canvas_large_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n)
{
    const char *end = text + n;
    struct glyph g;
    while (text < end) {
        int w = advance(canvas, &text, end, &g);
        draw_glyph(canvas, x, y, c, &g);
        x += w;
    }
    return x;
}

int canvas_large_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    return canvas_large_text_n(canvas, x, y, c, text, strlen(text));
}

static int line_width(const struct canvas *canvas, const char *text, size_t n)
{
    const char *end = text + n;
    struct glyph g;
    int w = 0;
    while (text < end)
        w += advance(canvas, &text, end, &g);
    return w > SPACING ? w - SPACING : 0;
}

int canvas_large_text_width(const struct canvas *canvas, const char *text)
{
    return line_width(canvas, text, strlen(text));
}

/* Returns how many bytes of the first line fit into `width` pixels. */
static size_t fitting_bytes(const struct canvas *canvas, const char *text, int width)
{
    size_t line_bytes = strcspn(text, "\n");
    const char *s = text, *end = text + line_bytes;
    struct glyph g;
    while (s < end) {
        const char *before = s;
        width -= advance(canvas, &s, end, &g);
        if (width < -SPACING)
            return (size_t)(before - text);
    }
    return line_bytes;
}

int canvas_large_text_truncated(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text,
                                int width)
{
    size_t n;
    if (canvas_large_text_width(canvas, text) <= width)
        return canvas_large_text(canvas, x, y, c, text);
    n = fitting_bytes(canvas, text, width - SPACING - canvas_large_text_width(canvas, ellipsis));
    while (n > 0 && text[n - 1] == ' ')
        n--;
    return canvas_large_text(canvas, canvas_large_text_n(canvas, x, y, c, text, n), y, c, ellipsis);
}

/* ---- lines ---- */

static int advance_of(const void *canvas, uint32_t code)
{
    char bytes[UTF8_MAX_BYTES];
    const char *s = bytes;
    struct glyph g;

    return advance(canvas, &s, bytes + utf8_put(bytes, code), &g);
}

int canvas_large_text_fit(const struct canvas *canvas, const char *text, int width)
{
    const size_t n = strcspn(text, "\n");
    size_t fitting;
    const size_t at = line_break_find(text, n, width + SPACING, advance_of, canvas, &fitting);

    return (int)(at > fitting / 2 ? at + strspn(text + at, " ") : fitting);
}

/* Draws the lines if `draws`. Returns their number. */
static int wrap(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c, const char *text,
                bool draws)
{
    int lines = 0;

    for (; *text; lines++) {
        const int n = canvas_large_text_fit(canvas, text, width);
        if (draws)
            canvas_large_text_n(canvas, x, y + lines * canvas_line_height(canvas), c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
    return lines;
}

void canvas_large_text_wrapped(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c,
                               const char *text)
{
    wrap(canvas, x, y, width, c, text, true);
}

int canvas_large_text_lines(const struct canvas *canvas, const char *text, int width)
{
    return wrap(canvas, 0, 0, width, CANVAS_WHITE, text, false);
}

int canvas_line_height(const struct canvas *canvas)
{
    return canvas->ascent + canvas->capital_height + canvas->descent;
}

uint32_t canvas_glyph(const struct canvas *canvas, uint32_t code, uint32_t plain)
{
    struct face_glyph g;

    return canvas->theme && theme_find_glyph(canvas->theme, code, &g) ? code : plain;
}
