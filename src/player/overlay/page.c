/*
 * page.c - draws a page (page.h). Title and footer are fixed; the lines between them scroll.
 */
#include "page.h"

#include <stdbool.h>

enum { MARGIN = 6, GAP = 4, BAR_W = 2 /* px: the scroll bar's width */ };

struct body {
    int x, y, w;      /* of the first line, px */
    int first, shown; /* lines */
    int line;         /* index of the next line */
    const struct canvas *canvas;
};

/* Draws the visible lines of a text. */
static void draw_lines(struct body *b, const char *text, enum canvas_colour c)
{
    for (; *text; b->line++) {
        int n = canvas_large_text_fit(b->canvas, text, b->w), row = b->line - b->first;
        if (row >= 0 && row < b->shown)
            canvas_large_text_n(b->canvas, b->x, b->y + row * CANVAS_LARGE_LINE_HEIGHT, c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
}

/* Draws the scroll bar at the right. */
static void draw_bar(const struct body *b, int lines)
{
    int x = b->canvas->fb->w - MARGIN / 2 - BAR_W, h = b->shown * CANVAS_LARGE_LINE_HEIGHT;

    canvas_rect(b->canvas, x, b->y, BAR_W, h, CANVAS_GREY);
    canvas_rect(b->canvas, x, b->y + h * b->first / lines, BAR_W, h * b->shown / lines + 1, CANVAS_WHITE);
}

int page_draw(const struct canvas *canvas, struct page *p)
{
    const int w = canvas->fb->w - 2 * MARGIN, h = canvas->fb->h;
    const int title = canvas_large_text_lines(canvas, p->title, w),
              footer = canvas_large_text_lines(canvas, p->footer, w);
    const int text = canvas_large_text_lines(canvas, p->text, w),
              details = canvas_large_text_lines(canvas, p->details, w), lines = text + details + (text && details);
    const int header_h = MARGIN + title * CANVAS_LARGE_LINE_HEIGHT + (title ? GAP : 0);
    const int footer_h = MARGIN + footer * CANVAS_LARGE_LINE_HEIGHT + (footer ? GAP : 0);
    const int room = (h - header_h - footer_h) / CANVAS_LARGE_LINE_HEIGHT;
    const int shown = lines < room ? lines : room > 1 ? room : 1, max_top = lines - shown;
    struct body b = { MARGIN, header_h, w, p->top < max_top ? p->top : max_top, shown, 0, canvas };
    const int bottom = header_h + shown * CANVAS_LARGE_LINE_HEIGHT;

    canvas_rect(canvas, 0, 0, canvas->fb->w, bottom + footer_h, CANVAS_DARK);
    canvas_rect(canvas, 0, bottom + footer_h - 1, canvas->fb->w, 1, CANVAS_GREY);
    canvas_large_text_wrapped(canvas, MARGIN, MARGIN, w, CANVAS_YELLOW, p->title);
    draw_lines(&b, p->text, CANVAS_WHITE);
    b.line += text && details;
    draw_lines(&b, p->details, CANVAS_GREY);
    canvas_large_text_wrapped(canvas, MARGIN, bottom + GAP, w, CANVAS_CYAN, p->footer);
    p->max_top = max_top;
    if (max_top > 0)
        draw_bar(&b, lines);
    return bottom + footer_h;
}
