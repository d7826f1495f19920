/*
 * canvas_large.c - text in the large font (canvas.h).
 */
#include "canvas.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "letters.h"

enum { TAB_SPACES = 2, SPACING = CANVAS_LARGE_LETTER_SPACING };

static const char ellipsis[] = "\xE2\x80\xA6";

/* ---- a character ---- */

/* Advances *s past the next character and returns the character's width. */
static int advance(const char **s, const char *end, struct letter *l)
{
    uint32_t code = utf8_next(s, end);
    letter_load(l, code == '\t' ? ' ' : code);
    return code == '\t' ? TAB_SPACES * (LETTER_SPACE_WIDTH + SPACING) : l->w + SPACING;
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

static void draw_letter(const struct canvas *canvas, int x, int y, enum canvas_colour c, const struct letter *l)
{
    for (int i = 0; i < LETTER_ROWS; i++)
        draw_row(canvas->fb, x, y + i - LETTER_ACCENT_HEIGHT, l->rows[i], canvas->colour[c]);
}

/* ---- a line ---- */

int canvas_large_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n)
{
    const char *end = text + n;
    struct letter l;
    while (text < end) {
        int w = advance(&text, end, &l);
        draw_letter(canvas, x, y, c, &l);
        x += w;
    }
    return x;
}

int canvas_large_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    return canvas_large_text_n(canvas, x, y, c, text, strlen(text));
}

int canvas_large_text_outlined(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    for (int i = 0; i < 9; i++)
        if (i != 4)
            canvas_large_text(canvas, x + i % 3 - 1, y + i / 3 - 1, CANVAS_DARK, text);
    return canvas_large_text(canvas, x, y, c, text);
}

static int line_width(const char *text, size_t n)
{
    const char *end = text + n;
    struct letter l;
    int w = 0;
    while (text < end)
        w += advance(&text, end, &l);
    return w > SPACING ? w - SPACING : 0;
}

int canvas_large_text_width(const char *text)
{
    return line_width(text, strlen(text));
}

/* Returns how many bytes of the first line fit into `width` pixels. */
static size_t fitting_bytes(const char *text, int width)
{
    size_t line_bytes = strcspn(text, "\n");
    const char *s = text, *end = text + line_bytes;
    struct letter l;
    while (s < end) {
        const char *before = s;
        width -= advance(&s, end, &l);
        if (width < -SPACING)
            return (size_t)(before - text);
    }
    return line_bytes;
}

int canvas_large_text_truncated(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text,
                                int width)
{
    size_t n;
    if (canvas_large_text_width(text) <= width)
        return canvas_large_text(canvas, x, y, c, text);
    n = fitting_bytes(text, width - SPACING - canvas_large_text_width(ellipsis));
    while (n > 0 && text[n - 1] == ' ')
        n--;
    return canvas_large_text(canvas, canvas_large_text_n(canvas, x, y, c, text, n), y, c, ellipsis);
}

/* ---- lines ---- */

int canvas_large_text_fit(const char *text, int width)
{
    size_t n = fitting_bytes(text, width), break_at = n;
    const char *first = text;
    struct letter l;
    if (!text[n] || text[n] == '\n')
        return (int)n;
    while (break_at > 0 && text[break_at] != ' ' && text[break_at - 1] != ' ' && text[break_at - 1] != '/')
        break_at--;
    if (break_at > n / 2)
        return (int)(break_at + strspn(text + break_at, " "));
    advance(&first, text + strlen(text), &l);
    return (int)(n ? n : (size_t)(first - text));
}

int canvas_large_text_wrapped(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c,
                              const char *text)
{
    int lines = 0;
    for (; *text; lines++) {
        int n = canvas_large_text_fit(text, width);
        if (canvas)
            canvas_large_text_n(canvas, x, y + lines * CANVAS_LARGE_LINE_HEIGHT, c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
    return lines;
}
