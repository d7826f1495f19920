/*
 * hear.h - one sound or piece of music, heard: a window with the mixer, until it is over or is closed.
 */
#ifndef WORKBENCH_HEAR_H
#define WORKBENCH_HEAR_H

#include <stdbool.h>
#include "../../common/result.h"

struct board;
struct hear;

/* b: a box (board.h), which must last until hear_close. RESULT_DONE, and *out; or RESULT_HOST_FAILED or RESULT_REFUSED
 * after a line that says why, and *out is NULL. */
enum result hear_open(struct hear **out, struct board *b, const char *name);

/* Does what is due. False: it is over. */
bool hear_frame(struct hear *h);

void hear_close(struct hear *h);

#endif
