/*
 * message.c - draws messages (message.h).
 */
#include <stdio.h>
#include "message.h"

enum {
    MARGIN = 8,        /* px beside a large line */
    MESSAGE_LINE = 512 /* bytes; the widest picture has fewer letters on a line */
};

/* Messages to players are in the large font, those to developers in the small one. */
static bool is_large(const struct canvas *canvas)
{
    return canvas->spare != NULL;
}

static int height_of(const struct canvas *canvas, bool large)
{
    return large ? canvas_line_height(canvas) : CANVAS_CELL_H;
}

/* Returns the bytes of text on a line. */
static int fit(const struct canvas *canvas, bool large, const char *text)
{
    const int w = canvas->fb->w - 1;

    return large ? canvas_large_text_fit(canvas, text, w) : canvas_text_fit(text, w / CANVAS_CELL_W);
}

int message_draw_above(const struct canvas *canvas, int end, const char *text)
{
    const bool large = is_large(canvas);
    int h = 1; /* the row above the text */

    for (const char *s = text; *s && h < end; h += height_of(canvas, large)) {
        s += fit(canvas, large, s);
        s += *s == '\n';
    }
    const int y = h < end ? end - h : 0;
    message_draw(canvas, y, text);
    return y;
}

/* Draws the first n bytes of text as a large line, centred on a band that is slightly wider. */
static void draw_centred(const struct canvas *canvas, int y, const char *text, int n)
{
    char line[MESSAGE_LINE];

    snprintf(line, sizeof line, "%.*s", n, text);
    const int w = canvas_large_text_width(canvas, line), x = (canvas->fb->w - w) / 2;
    canvas_rect(canvas, x - MARGIN, y, w + 2 * MARGIN, canvas_line_height(canvas), CANVAS_DARK);
    canvas_large_text(canvas, x, y + canvas->ascent, CANVAS_WHITE, line);
}

int message_draw(const struct canvas *canvas, int y, const char *text)
{
    const bool large = is_large(canvas);
    const int h = height_of(canvas, large);

    if (!large)
        canvas_rect(canvas, 0, y, canvas->fb->w, 1, CANVAS_DARK);
    for (y++; *text && y < canvas->fb->h; y += h) {
        const int n = fit(canvas, large, text);
        if (large) {
            draw_centred(canvas, y, text, n);
        } else {
            canvas_rect(canvas, 0, y, canvas->fb->w, h, CANVAS_DARK);
            canvas_text_n(canvas, 1, y, CANVAS_WHITE, text, n);
        }
        text += n;
        text += *text == '\n';
    }
    return y;
}
