/*
 * fix.h - the fixed text layer: a grid of 8x8 characters over the whole screen.
 * floor: chips
 */
#ifndef CHIPS_FIX_H
#define CHIPS_FIX_H

#include "slots.h"

enum {
    FIX_CELL = 8,
    FIX_BANK = 15,    /* of `bank`: banks to add */
    FIX_RIM = 1 << 4, /* of `bank`: a dark rim, to be read over anything */
};

struct fix {
    struct slots s; /* a list of cols x rows cells, row by row */
    uint8_t *code;  /* character, 0 or 32: nothing */
    uint8_t *bank;  /* FIX_ */
    uint32_t cols, rows;
};

extern const struct chip fix_chip;

/* Writes n characters from (col, row) on; what falls outside the grid is cut off. */
void fix_put(struct fix *f, int col, int row, const char *text, size_t n, uint8_t bank);

/* Empties a rectangle of cells, cut to the grid. */
void fix_clear(struct fix *f, int col, int row, int w, int h);

#endif
