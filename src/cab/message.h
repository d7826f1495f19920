/*
 * message.h - the cabinet's own words over a picture, in a 3x5 font and colours of its own.
 * floor: cab    used by: cab
 */
#ifndef CAB_MESSAGE_H
#define CAB_MESSAGE_H

#include "../../fb/fb.h"

enum { MESSAGE_CELL_W = 4, MESSAGE_CELL_H = 6 };

/* Writes text on a dark band as wide as the picture, from line y down; lines are broken where they do not fit, tabs are
 * two blanks, what is not ASCII is a question mark. The two palette entries that the picture uses least are taken for
 * it. Returns the line after the band. */
int message_draw(struct fb *fb, uint32_t rgb[256], int y, const char *text);

#endif
