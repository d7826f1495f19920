/*
 * page.h - draws a page of text in the larger font: title, text, details, and instructions at the foot. It covers as
 * much of the picture as it needs, from the top, and scrolls if it doesn't fit.
 */
#ifndef PLAYER_PAGE_H
#define PLAYER_PAGE_H

#include "canvas.h"

struct page {
    const char *title, *text, *more, *foot; /* UTF-8 with \n; "": none. more is drawn in grey */
    int top;                                /* index of the first line of text and more that is shown */
    int most;                               /* set by page_draw: the largest useful top */
};

/* Draws the page from the picture's top and sets p->most. If p->top is larger, uses p->most. Returns the row after the
 * page. */
int page_draw(const struct canvas *canvas, struct page *p);

#endif
