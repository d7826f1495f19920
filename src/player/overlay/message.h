/*
 * message.h - draws messages over a picture, broken into lines.
 */
#ifndef PLAYER_MESSAGE_H
#define PLAYER_MESSAGE_H

#include "canvas.h"

/* Draws text on a dark band from row y down, breaking lines that don't fit: in the large font, centred, if the canvas
 * has a spare font, otherwise in the small one, on a band as wide as the picture. Returns the row after the band. */
int message_draw(const struct canvas *canvas, int y, const char *text);

/* The same for a band that ends before row `end`, or starts at row 0 if it doesn't fit. Returns the first row. */
int message_draw_above(const struct canvas *canvas, int end, const char *text);

#endif
