/*
 * readme.h - the README that a download of a game has for players.
 */
#ifndef CAB_README_H
#define CAB_README_H

#include "../../rom/manifest.h"
#include "../film/reel.h"
#include "export.h"

/* Adds the text, in lines that end in \n, for EXPORT_LINUX to EXPORT_LIBRETRO. */
void readme_write(struct reel *out, enum export_kind kind, const struct manifest *m);

#endif
