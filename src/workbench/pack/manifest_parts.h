/*
 * manifest_parts.h - the parts of rom.lua that files other than manifest_text.c read.
 */
#ifndef WORKBENCH_MANIFEST_PARTS_H
#define WORKBENCH_MANIFEST_PARTS_H

#include "value.h"

/* Reads all pictures and sounds. */
void manifest_read_art(const struct manifest_value *root, struct art *art);

/* Reads an entry of `sounds` or `music` into a struct art_sound. */
void manifest_read_sound(const struct manifest_value *v, void *sound, struct art *art);
void manifest_read_tune(const struct manifest_value *v, void *sound, struct art *art);

#endif
