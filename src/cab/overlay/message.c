/*
 * message.c - see message.h. 60 columns on a 240 px screen.
 */
#include "message.h"

int message_draw(const struct ink *ink, int y, const char *text)
{
    int columns = (ink->fb->w - 1) / INK_CELL_W;
    ink_rect(ink, 0, y, ink->fb->w, 1, INK_PAPER);
    for (y++; *text && y < ink->fb->h; y += INK_CELL_H) {
        int n = ink_fit(text, columns);
        ink_rect(ink, 0, y, ink->fb->w, INK_CELL_H, INK_PAPER);
        ink_bytes(ink, 1, y, INK_WHITE, text, n);
        text += n;
        text += *text == '\n';
    }
    return y;
}
