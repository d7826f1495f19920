/*
 * message.h - sentences over a picture, broken into lines.
 * floor: cab    used by: cab
 */
#ifndef CAB_MESSAGE_H
#define CAB_MESSAGE_H

#include "ink.h"

/* Writes text on a dark band as wide as the picture, from line y down; lines are broken where they do not fit, tabs are
 * two blanks, what is not ASCII is a question mark. Returns the line after the band. */
int message_draw(const struct ink *ink, int y, const char *text);

#endif
