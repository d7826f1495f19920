/*
 * message.c - see message.h. 60 columns on a 240 px screen.
 */
#include "message.h"

int message_draw(const struct canvas *canvas, int y, const char *text)
{
    int columns = (canvas->fb->w - 1) / CANVAS_CELL_W;
    canvas_rect(canvas, 0, y, canvas->fb->w, 1, CANVAS_DARK);
    for (y++; *text && y < canvas->fb->h; y += CANVAS_CELL_H) {
        int n = canvas_fit(text, columns);
        canvas_rect(canvas, 0, y, canvas->fb->w, CANVAS_CELL_H, CANVAS_DARK);
        canvas_bytes(canvas, 1, y, CANVAS_WHITE, text, n);
        text += n;
        text += *text == '\n';
    }
    return y;
}
