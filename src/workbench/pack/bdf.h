/*
 * bdf.h - reads fonts in Adobe's Glyph Bitmap Distribution Format, versions 2.1 and 2.2, with 1, 2, 4 or 8 bits per
 * pixel.
 */
#ifndef WORKBENCH_BDF_H
#define WORKBENCH_BDF_H

#include "pack_font.h"

enum { BDF_MAX_FILE = 64 << 20 /* bytes */ };

/* Reads the wanted characters of n bytes into f. Black is shade 15; greys are lower shades. Character numbers are
 * converted to Unicode by the font's registry and encoding (bdf.c lists the known ones). Without either, and in a
 * FontSpecific font whose names contain no code point, the number is the code point. On failure, err has the line but
 * not the file's name. Free f in either case. */
bool bdf_read(struct pack_font *f, const char *text, size_t n, const struct pack_font_chars *wanted, char *err,
              size_t err_size);

#endif
