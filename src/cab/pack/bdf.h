/*
 * bdf.h - fonts in Adobe's Glyph Bitmap Distribution Format, 2.1 and 2.2: text, one bit a pixel.
 * floor: cab
 */
#ifndef CAB_BDF_H
#define CAB_BDF_H

#include "faces.h"

enum { BDF_FILE = 64 << 20 /* bytes */ };

/* Reads the wanted characters of n bytes into f, which is empty before; ink is shade 15. The font's characters must be
 * those of Unicode, or of Latin-1. False and one sentence with the line, without the file's name; close f either way.
 */
bool bdf_read(struct faces *f, const char *text, size_t n, const struct faces_set *wanted, char *err, size_t err_size);

#endif
