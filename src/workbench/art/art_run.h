/*
 * art_run.h - `curtain art` and `curtain palette`.
 */
#ifndef WORKBENCH_ART_RUN_H
#define WORKBENCH_ART_RUN_H

#include <stdbool.h>
#include "../../common/result.h"

/* Lists the sprites of the game at `path` (a directory or a .rom file). With `atlas`, saves a PNG of all sprites there
 * instead. Errors have been reported. */
enum result art_run(const char *path, bool nearest, const char *atlas);

/* Imports a .hex or .gpl file into a bank of the palette `out`, or exports a bank of the palette `from` to such a file.
 * A negative bank or `out` NULL means that the option is missing, which is refused. */
enum result art_run_palette(const char *from, int bank, const char *out);

#endif
