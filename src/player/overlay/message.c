/*
 * message.c - draws messages (message.h) in the small font.
 */
#include "message.h"

static int columns_of(const struct canvas *canvas)
{
    return (canvas->fb->w - 1) / CANVAS_CELL_W;
}

int message_draw_above(const struct canvas *canvas, int end, const char *text)
{
    int h = 1; /* the row above the text */

    for (const char *s = text; *s && h < end; h += CANVAS_CELL_H) {
        s += canvas_text_fit(s, columns_of(canvas));
        s += *s == '\n';
    }
    const int y = h < end ? end - h : 0;
    message_draw(canvas, y, text);
    return y;
}

int message_draw(const struct canvas *canvas, int y, const char *text)
{
    int columns = columns_of(canvas);
    canvas_rect(canvas, 0, y, canvas->fb->w, 1, CANVAS_DARK);
    for (y++; *text && y < canvas->fb->h; y += CANVAS_CELL_H) {
        int n = canvas_text_fit(text, columns);
        canvas_rect(canvas, 0, y, canvas->fb->w, CANVAS_CELL_H, CANVAS_DARK);
        canvas_text_n(canvas, 1, y, CANVAS_WHITE, text, n);
        text += n;
        text += *text == '\n';
    }
    return y;
}
