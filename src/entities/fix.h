/*
 * fix.h - the fixed text layer: a grid of 8x8 characters that covers the whole screen.
 */
#ifndef ENTITIES_FIX_H
#define ENTITIES_FIX_H

#include "../base/slots.h"

enum {
    FIX_CELL_SIZE = 8,
    FIX_UNKNOWN = 1,     /* code of an unknown character; no font has a glyph for it */
    FIX_MAX_TEXT = 1024, /* maximum characters per write */
    FIX_GROUP_WIDE = 1,  /* column group */
    FIX_BANK = 15,       /* in `bank`: the palette banks to add */
    FIX_RIM = 1 << 4,    /* in `bank`: a dark outline, readable on any background */
    FIX_BIG = 1 << 5,    /* in `bank`, times (quarter + 1): the cell shows that quarter of a double-size character */
    FIX_QUARTERS = 7 << 5,
};

struct fix {
    struct slots s; /* a list of cols x rows cells, row by row */
    uint8_t *code;  /* low byte of the code point, 0: empty; without group FIX_GROUP_WIDE, FIX_UNKNOWN replaces code
                    * points over 255 */
    uint8_t *bank;  /* FIX_BANK, FIX_RIM and FIX_BIG bits */
    uint16_t *page; /* group FIX_GROUP_WIDE: the code point / 256 */
    uint8_t *font;  /* group FIX_GROUP_WIDE: font + 1; 0: the default font */
    uint32_t cols, rows;
};

extern const struct chip fix_chip;

/* Writes n bytes of UTF-8 text, starting at (col, row); `font` is ignored without group FIX_GROUP_WIDE. If `bank`
 * includes FIX_BIG, each character covers 2 x 2 cells. Characters outside the grid are clipped. */
void fix_write(struct fix *f, int col, int row, const char *text, size_t n, uint8_t bank, uint8_t font);

/* Returns the code point of a cell. */
static inline uint32_t fix_code(const struct fix *f, uint32_t cell)
{
    return f->page ? (uint32_t)f->page[cell] << 8 | f->code[cell] : f->code[cell];
}

/* Clears a rectangle of cells, clipped to the grid. */
void fix_clear(struct fix *f, int col, int row, int w, int h);

#endif
