/*
 * readme.h - the README that a download of a game has for players.
 */
#ifndef WORKBENCH_README_H
#define WORKBENCH_README_H

#include "../../rom/manifest.h"
#include "../../common/byte_buffer.h"
#include "export.h"

/* Adds the text, in lines that end in \n, for EXPORT_LINUX to EXPORT_LIBRETRO. */
void readme_write(struct byte_buffer *out, enum export_kind kind, const struct manifest *m);

#endif
