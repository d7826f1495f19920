/*
 * message.c - draws messages (message.h).
 */
#include "message.h"

/* The large font has letters that the small one, which is ASCII, lacks. */
static bool is_large(const struct canvas *canvas, const char *text)
{
    while (*text && (unsigned char)*text < 128)
        text++;
    return *text && canvas->spare;
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
    const bool large = is_large(canvas, text);
    int h = 1; /* the row above the text */

    for (const char *s = text; *s && h < end; h += height_of(canvas, large)) {
        s += fit(canvas, large, s);
        s += *s == '\n';
    }
    const int y = h < end ? end - h : 0;
    message_draw(canvas, y, text);
    return y;
}

int message_draw(const struct canvas *canvas, int y, const char *text)
{
    const bool large = is_large(canvas, text);
    const int h = height_of(canvas, large);

    canvas_rect(canvas, 0, y, canvas->fb->w, 1, CANVAS_DARK);
    for (y++; *text && y < canvas->fb->h; y += h) {
        const int n = fit(canvas, large, text);
        canvas_rect(canvas, 0, y, canvas->fb->w, h, CANVAS_DARK);
        if (large)
            canvas_large_text_n(canvas, 1, y + canvas->ascent, CANVAS_WHITE, text, (size_t)n);
        else
            canvas_text_n(canvas, 1, y, CANVAS_WHITE, text, n);
        text += n;
        text += *text == '\n';
    }
    return y;
}
