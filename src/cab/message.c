/*
 * message.c - see message.h. 60 columns on a 240 px screen.
 */
#include "message.h"

/* How many bytes of s stand on one line of so many columns. */
static int line_bytes(const char *s, int columns)
{
    int n = 0, used = 0, blank = 0;
    for (; s[n] && s[n] != '\n'; n++) {
        if (((unsigned char)s[n] & 0xC0) == 0x80)
            continue;
        used += s[n] == '\t' ? 2 : 1;
        if (used > columns)
            return blank > columns / 2 ? blank : n ? n : 1;
        if (s[n] == ' ')
            blank = n + 1;
    }
    return n;
}

int message_draw(const struct ink *ink, int y, const char *text)
{
    int columns = (ink->fb->w - 1) / INK_CELL_W;
    ink_rect(ink, 0, y, ink->fb->w, 1, INK_PAPER);
    for (y++; *text && y < ink->fb->h; y += INK_CELL_H) {
        int n = line_bytes(text, columns);
        ink_rect(ink, 0, y, ink->fb->w, INK_CELL_H, INK_PAPER);
        ink_bytes(ink, 1, y, INK_WHITE, text, n);
        text += n;
        text += *text == '\n';
    }
    return y;
}
