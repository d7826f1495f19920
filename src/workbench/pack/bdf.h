/*
 * bdf.h - fonts in Adobe's Glyph Bitmap Distribution Format, 2.1 and 2.2, and with greys, of 2, 4 or 8 bits a pixel.
 */
#ifndef WORKBENCH_BDF_H
#define WORKBENCH_BDF_H

#include "faces.h"

enum { BDF_FILE = 64 << 20 /* bytes */ };

/* Reads the wanted characters of n bytes into f, which is empty before; ink is shade 15, greys are shades below.
 * Numbers of characters become Unicode by the font's registry and encoding (bdf.c lists those that are known); without
 * either, and of a FontSpecific font whose names tell no code, a number is the code. False and one sentence with the
 * line, without the file's name; close f either way. */
bool bdf_read(struct faces *f, const char *text, size_t n, const struct faces_set *wanted, char *err, size_t err_size);

#endif
