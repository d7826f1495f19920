/*
 * page.c - draws a page (page.h). Title and foot are fixed; the lines between them scroll.
 */
#include "page.h"

#include <stdbool.h>

enum { MARGIN = 6, GAP = 4, BAR = 2 /* px: the scroll bar's width */ };

struct body {
    int x, y, w;      /* of the first line, px */
    int first, shown; /* lines */
    int at;           /* index of the next line */
    const struct canvas *canvas;
};

static int lines_of(const char *text, int w)
{
    return text[0] ? canvas_say_lines(0, 0, 0, w, CANVAS_WHITE, text) : 0;
}

/* Draws the visible lines of a text. */
static void draw_part(struct body *b, const char *text, enum canvas_colour c)
{
    for (; *text; b->at++) {
        int n = canvas_say_fit(text, b->w), row = b->at - b->first;
        if (row >= 0 && row < b->shown)
            canvas_say_bytes(b->canvas, b->x, b->y + row * CANVAS_LINE_H, c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
}

/* Draws the scroll bar at the right. */
static void draw_bar(const struct body *b, int lines)
{
    int x = b->canvas->fb->w - MARGIN / 2 - BAR, h = b->shown * CANVAS_LINE_H;

    canvas_rect(b->canvas, x, b->y, BAR, h, CANVAS_GREY);
    canvas_rect(b->canvas, x, b->y + h * b->first / lines, BAR, h * b->shown / lines + 1, CANVAS_WHITE);
}

int page_draw(const struct canvas *canvas, struct page *p)
{
    const int w = canvas->fb->w - 2 * MARGIN, h = canvas->fb->h;
    const int title = lines_of(p->title, w), foot = lines_of(p->foot, w);
    const int text = lines_of(p->text, w), more = lines_of(p->more, w), lines = text + more + (text && more);
    const int head_h = MARGIN + title * CANVAS_LINE_H + (title ? GAP : 0);
    const int foot_h = MARGIN + foot * CANVAS_LINE_H + (foot ? GAP : 0);
    const int room = (h - head_h - foot_h) / CANVAS_LINE_H;
    const int shown = lines < room ? lines : room > 1 ? room : 1, most = lines - shown;
    struct body b = { MARGIN, head_h, w, p->top < most ? p->top : most, shown, 0, canvas };
    const int bottom = head_h + shown * CANVAS_LINE_H;

    canvas_rect(canvas, 0, 0, canvas->fb->w, bottom + foot_h, CANVAS_DARK);
    canvas_rect(canvas, 0, bottom + foot_h - 1, canvas->fb->w, 1, CANVAS_GREY);
    canvas_say_lines(canvas, MARGIN, MARGIN, w, CANVAS_YELLOW, p->title);
    draw_part(&b, p->text, CANVAS_WHITE);
    b.at += text && more;
    draw_part(&b, p->more, CANVAS_GREY);
    canvas_say_lines(canvas, MARGIN, bottom + GAP, w, CANVAS_CYAN, p->foot);
    p->most = most;
    if (most > 0)
        draw_bar(&b, lines);
    return bottom + foot_h;
}
