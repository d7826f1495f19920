/*
 * notes.h - `curtain sound GAME NAME --notes`: the events of a tune as text, as the board reads them.
 */
#ifndef WORKBENCH_NOTES_H
#define WORKBENCH_NOTES_H

#include "../../sound/tune.h"

/* Prints the tune, a line an event: TRACK TICK WHAT VALUES; the conductor's track is -. Lines are explained in
 * docs/measured/music.md. A track that is endless is printed up to its loop's end and says where it goes on: TRACK END
 * loop FROM. */
void notes_print(const char *name, const struct tune *t);

#endif
