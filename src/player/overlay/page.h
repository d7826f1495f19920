/*
 * page.h - draws a page of text in the large font: title, text, details, and a footer with instructions. The page
 * covers as much of the picture as it needs, from the top, and scrolls if it doesn't fit.
 */
#ifndef PLAYER_PAGE_H
#define PLAYER_PAGE_H

#include "canvas.h"

struct page {
    const char *title, *text, *details, *footer; /* UTF-8 with newlines; "": none. Details are grey */
    int top;                                     /* scroll position: the first visible line of text and details */
    int max_top;                                 /* set by page_draw: the last useful scroll position */
};

/* Draws the page from the top of the picture and sets p->max_top. If p->top is larger, draws from p->max_top. Returns
 * the row after the page. */
int page_draw(const struct canvas *canvas, struct page *p);

#endif
