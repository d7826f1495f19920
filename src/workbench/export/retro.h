/*
 * retro.h - the .info file of a libretro core, which front ends read before they load the core.
 */
#ifndef WORKBENCH_RETRO_H
#define WORKBENCH_RETRO_H

#include <stddef.h>
#include "../../rom/manifest.h"

/* The first line of a file that this program wrote. */
#define RETRO_INFO_FIRST "# A game made with Curtain."

/* Writes the text for a core that contains the game. */
void retro_info(const struct manifest *m, char *text, size_t size);

#endif
