/*
 * readme.h - the README for players in a game's zip file.
 */
#ifndef WORKBENCH_README_H
#define WORKBENCH_README_H

#include "../../rom/manifest.h"
#include "../../common/byte_buffer.h"
#include "export.h"

/* Appends the text for an export, EXPORT_LINUX to EXPORT_LIBRETRO. Lines end in \n. */
void readme_write(struct byte_buffer *out, enum export_kind kind, const struct manifest *m);

#endif
