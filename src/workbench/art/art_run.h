/*
 * art_run.h - `curtain art` and `curtain palette`.
 */
#ifndef WORKBENCH_ART_RUN_H
#define WORKBENCH_ART_RUN_H

#include <stdbool.h>
#include "../../common/result.h"

/* Lists the sprites of the game at path (a folder or a .rom file), or puts them on the picture `atlas`, a PNG;
 * NULL: not asked for. What is not done has been told on plat_log. */
enum result art_run(const char *path, bool nearest, const char *atlas);

/* Puts the colours of a .hex or .gpl into a bank of the palette `out`, or a bank of a palette into such a file. bank:
 * below 0, and out: NULL: not given. */
enum result art_run_palette(const char *from, int bank, const char *out);

#endif
