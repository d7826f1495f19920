/*
 * page.h - a message that is to be read, in the larger face: a title, what happened, what more there is, what to do. It
 * covers as much of the picture as it needs, from the top, and can be scrolled where that is not enough.
 */
#ifndef PLAYER_PAGE_H
#define PLAYER_PAGE_H

#include "canvas.h"

struct page {
    const char *title, *text, *more, *foot; /* in UTF-8, \n ends a line; "": none. more is fainter */
    int top;                                /* the first line that is shown, of text and more */
    int most;                               /* page_draw's: how far top may go */
};

/* Draws it from the picture's top down, and sets p->most. A top that is too large is as the largest. Returns the row
 * after it. */
int page_draw(const struct canvas *canvas, struct page *p);

#endif
