/*
 * fix.h - the fixed text layer: a grid of 8x8 characters over the whole screen.
 */
#ifndef ENTITIES_FIX_H
#define ENTITIES_FIX_H

#include "../base/slots.h"

enum {
    FIX_CELL = 8,
    FIX_OTHER = 1,    /* no character; no font has a picture of it */
    FIX_TEXT = 1024,  /* characters that are written at a time */
    FIX_WIDE = 1,     /* group of columns */
    FIX_BANK = 15,    /* of `bank`: banks to add */
    FIX_RIM = 1 << 4, /* of `bank`: a dark rim, to be read over anything */
    FIX_BIG = 1 << 5, /* of `bank`: times the quarter + 1 of a character twice as large that the cell shows */
    FIX_QUARTERS = 7 << 5,
};

struct fix {
    struct slots s; /* a list of cols x rows cells, row by row */
    uint8_t *code;  /* code point, 0: nothing; FIX_OTHER: one over 255 */
    uint8_t *bank;  /* FIX_ */
    uint16_t *page; /* of group FIX_WIDE: the rest of the code point, / 256; FIX_OTHER is not used then */
    uint8_t *font;  /* of group FIX_WIDE: 0, or a font + 1 */
    uint32_t cols, rows;
};

extern const struct chip fix_chip;

/* Writes the characters of n bytes from (col, row) on; without group FIX_WIDE the font is left out. With FIX_BIG in its
 * bank each takes two cells by two. What falls outside the grid is cut off. */
void fix_put(struct fix *f, int col, int row, const char *text, size_t n, uint8_t bank, uint8_t font);

/* The code point of a cell. */
static inline uint32_t fix_code(const struct fix *f, uint32_t cell)
{
    return f->page ? (uint32_t)f->page[cell] << 8 | f->code[cell] : f->code[cell];
}

/* Empties a rectangle of cells, cut to the grid. */
void fix_clear(struct fix *f, int col, int row, int w, int h);

#endif
