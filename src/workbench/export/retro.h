/*
 * retro.h - what front ends of libretro read of a core before they load it: its file .info.
 */
#ifndef WORKBENCH_RETRO_H
#define WORKBENCH_RETRO_H

#include <stddef.h>
#include "../../rom/manifest.h"

/* The line that such a file of ours begins with. */
#define RETRO_INFO_FIRST "# A game made with Curtain."

/* Writes the text of a core with that game in it. */
void retro_info(const struct manifest *m, char *text, size_t size);

#endif
