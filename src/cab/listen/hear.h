/*
 * hear.h - one sound or piece of music, heard: a window with the mixer, until it is over or is closed.
 * floor: cab
 */
#ifndef CAB_HEAR_H
#define CAB_HEAR_H

#include "../host/result.h"

/* b: a box (board.h). RESULT_HOST after a line that says why: there is no window. */
struct board;
enum result hear(struct board *b, const char *name);

#endif
