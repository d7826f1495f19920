/*
 * jukebox.h - plays a sound or music in a window that shows the mixer.
 */
#ifndef WORKBENCH_JUKEBOX_H
#define WORKBENCH_JUKEBOX_H

#include <stdbool.h>
#include "../../common/result.h"

struct board;
struct jukebox;

/* Opens the window. b: from board_jukebox_open; it must outlive the jukebox. On failure, reports the reason and sets
 * *out to NULL. */
enum result jukebox_open(struct jukebox **out, struct board *b, const char *name);

/* Runs a frame if one is due. False: the sound is over, or the window was closed. */
bool jukebox_frame(struct jukebox *j);

void jukebox_close(struct jukebox *j);

#endif
