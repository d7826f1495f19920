/*
 * notes.h - `curtain sound GAME NAME --notes`: prints the events of a tune as the board reads them.
 */
#ifndef WORKBENCH_NOTES_H
#define WORKBENCH_NOTES_H

#include "../../sound/tune.h"

/* Prints a line for each event: TRACK TICK EVENT VALUES; the conductor's track is -. docs/measured/music.md explains
 * the events. A looping track is printed up to the end of its loop, followed by TRACK END loop START. */
void notes_print(const char *name, const struct tune *t);

#endif
