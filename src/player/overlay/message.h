/*
 * message.h - draws messages over a picture, broken into lines.
 */
#ifndef PLAYER_MESSAGE_H
#define PLAYER_MESSAGE_H

#include "canvas.h"

/* Draws text on a dark band as wide as the picture, from row y down, breaking lines that don't fit. Text with
 * characters beyond ASCII is in the large font if the canvas has a spare font, otherwise all text is in the small one.
 * Returns the row after the band. */
int message_draw(const struct canvas *canvas, int y, const char *text);

/* The same for a band that ends before row `end`, or starts at row 0 if it doesn't fit. Returns the first row. */
int message_draw_above(const struct canvas *canvas, int end, const char *text);

#endif
