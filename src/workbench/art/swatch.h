/*
 * swatch.h - lists of colours in the formats of palette sites and editors: .hex and .gpl.
 *
 * .hex: one colour per line, six hexadecimal digits, optionally after #. .gpl (GIMP): the first line is `GIMP Palette`;
 * then lines `Name:` and `Columns:`, comments after #, and one colour per line: red, green and blue from 0 to 255, and
 * a name.
 */
#ifndef WORKBENCH_SWATCH_H
#define WORKBENCH_SWATCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

enum {
    SWATCH_BANK = 15, /* colours of a bank */
    SWATCH_MAX_COLOURS = 16 * SWATCH_BANK,
    SWATCH_MAX_FILE = 1 << 20, /* bytes */
    SWATCH_TEXT = 1024         /* bytes that swatch_write needs */
};

struct swatch {
    uint8_t rgb[SWATCH_MAX_COLOURS][3];
    int n;
};

/* Reads a list of n bytes. On failure, err starts with file and line ("warm.hex:3: ..."). */
bool swatch_read(struct swatch *s, const char *text, size_t n, const char *file, bool gpl, char *err, size_t err_size);

/* Stores the colours in columns 1 to 15 of the bank and of as many following banks as needed; the rest of the last bank
 * becomes black. Returns the last bank; if it is above 15, nothing was stored. */
int swatch_put(const struct swatch *s, int bank, uint8_t rgb[CART_PALETTE_SIZE]);

/* Writes columns 1 to 15 of a bank as a list; returns its length in bytes. */
size_t swatch_write(const uint8_t rgb[CART_PALETTE_SIZE], int bank, bool gpl, char out[SWATCH_TEXT]);

#endif
