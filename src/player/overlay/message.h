/*
 * message.h - sentences over a picture, broken into lines.
 */
#ifndef PLAYER_MESSAGE_H
#define PLAYER_MESSAGE_H

#include "canvas.h"

/* Writes text on a dark band as wide as the picture, from row y down. Lines are broken where they do not fit; tabs and
 * bytes that are not ASCII are drawn as by canvas_text. Returns the row after the band. */
int message_draw(const struct canvas *canvas, int y, const char *text);

/* The same, and the band ends before row `end`: it begins at row 0 if it does not fit. Returns the band's first row. */
int message_draw_above(const struct canvas *canvas, int end, const char *text);

#endif
