/*
 * ttf.h - draws the characters of a TrueType font as pixels, so that a ROM contains pixels and players need no font
 * reader.
 */
#ifndef WORKBENCH_TTF_H
#define WORKBENCH_TTF_H

#include "pack_font.h"

enum { TTF_MAX_FILE = 64 << 20, /* bytes */ TTF_MAX_SIZE = 64 /* px */ };

/* Draws the wanted characters that the font of n bytes has into f, `size` px per em. A pixel is of shade 15 if at least
 * half of it is covered, and otherwise transparent. Lines are as high as the font's ascent and descent. On failure,
 * err doesn't name the file. Free f in either case. */
bool ttf_read(struct pack_font *f, const uint8_t *data, size_t n, int size, const struct pack_font_chars *wanted,
              char *err, size_t err_size);

#endif
