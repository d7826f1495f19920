/*
 * swatch.h - lists of colours as palette sites and editors hand them on: .hex and .gpl.
 *
 * .hex: a colour a line, six hexadecimal digits, with or without a # before them. .gpl, GIMP's: a first line `GIMP
 * Palette`, lines `Name:` and `Columns:`, remarks behind #, and a colour a line: red, green, blue from 0 to 255, and a
 * name.
 */
#ifndef WORKBENCH_SWATCH_H
#define WORKBENCH_SWATCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

enum { SWATCH_MOST = 240 /* colours: 15 of each bank */, SWATCH_BANK = 15, SWATCH_FILE = 1 << 20 /* bytes */ };

struct swatch {
    uint8_t rgb[SWATCH_MOST][3];
    int n;
};

/* Reads the n bytes of a list. False and one sentence that begins with file and line ("warm.hex:3: ..."). */
bool swatch_read(struct swatch *s, const char *text, size_t n, const char *file, bool gpl, char *err, size_t err_size);

/* Puts the colours into columns 1 to 15 of the bank, and of the banks behind it while there are more; what is left of
 * the last one becomes black. Returns the last bank; above 15: there was no room, and nothing was done. */
int swatch_put(const struct swatch *s, int bank, uint8_t rgb[CART_PALETTE_SIZE]);

/* Writes columns 1 to 15 of a bank as such a list, a text of at most SWATCH_TEXT bytes; returns how many. */
enum { SWATCH_TEXT = 1024 };
size_t swatch_write(const uint8_t rgb[CART_PALETTE_SIZE], int bank, bool gpl, char out[SWATCH_TEXT]);

#endif
