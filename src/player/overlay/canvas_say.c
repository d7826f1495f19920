/*
 * canvas_say.c - see canvas.h: text in the larger face.
 */
#include "canvas.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "letters.h"

enum { TAB_BLANKS = 2, GAP = CANVAS_SAY_GAP };

static const char ellipsis[] = "\xE2\x80\xA6";

/* ---- a character ---- */

/* Advances *s past the next character and returns the character's width. */
static int advance(const char **s, const char *end, struct letter *l)
{
    uint32_t code = utf8_next(s, end);
    letter_of(l, code == '\t' ? ' ' : code);
    return code == '\t' ? TAB_BLANKS * (LETTER_BLANK + GAP) : l->w + GAP;
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
        draw_row(canvas->fb, x, y + i - LETTER_UP, l->rows[i], canvas->colour[c]);
}

/* ---- a line ---- */

int canvas_say_bytes(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n)
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

int canvas_say(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    return canvas_say_bytes(canvas, x, y, c, text, strlen(text));
}

int canvas_say_outlined(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    for (int i = 0; i < 9; i++)
        if (i != 4)
            canvas_say(canvas, x + i % 3 - 1, y + i / 3 - 1, CANVAS_DARK, text);
    return canvas_say(canvas, x, y, c, text);
}

static int width_of(const char *text, size_t n)
{
    const char *end = text + n;
    struct letter l;
    int w = 0;
    while (text < end)
        w += advance(&text, end, &l);
    return w > GAP ? w - GAP : 0;
}

int canvas_say_width(const char *text)
{
    return width_of(text, strlen(text));
}

/* Returns how many bytes of the first line fit into `width` pixels. */
static size_t within(const char *text, int width)
{
    size_t most = strcspn(text, "\n");
    const char *s = text, *end = text + most;
    struct letter l;
    while (s < end) {
        const char *before = s;
        width -= advance(&s, end, &l);
        if (width < -GAP)
            return (size_t)(before - text);
    }
    return most;
}

int canvas_say_within(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, int width)
{
    size_t n;
    if (canvas_say_width(text) <= width)
        return canvas_say(canvas, x, y, c, text);
    n = within(text, width - GAP - canvas_say_width(ellipsis));
    while (n > 0 && text[n - 1] == ' ')
        n--;
    return canvas_say(canvas, canvas_say_bytes(canvas, x, y, c, text, n), y, c, ellipsis);
}

/* ---- lines ---- */

int canvas_say_fit(const char *text, int width)
{
    size_t n = within(text, width), blank = n;
    const char *first = text;
    struct letter l;
    if (!text[n] || text[n] == '\n')
        return (int)n;
    while (blank > 0 && text[blank] != ' ' && text[blank - 1] != ' ' && text[blank - 1] != '/')
        blank--;
    if (blank > n / 2)
        return (int)(blank + strspn(text + blank, " "));
    advance(&first, text + strlen(text), &l);
    return (int)(n ? n : (size_t)(first - text));
}

int canvas_say_lines(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c, const char *text)
{
    int lines = 0;
    for (; *text; lines++) {
        int n = canvas_say_fit(text, width);
        if (canvas)
            canvas_say_bytes(canvas, x, y + lines * CANVAS_LINE_H, c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
    return lines;
}
