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
    FIX_MAX_SIZE = 3,    /* a character of size n covers n x n cells */

    /* in `style` */
    FIX_BANK = 15,         /* the palette banks to add */
    FIX_RIM = 1 << 4,      /* a dark outline, readable on any background */
    FIX_DOUBLE = 1 << 5,   /* times (part + 1): the part of a double-size character that the cell shows, row by row */
    FIX_TRIPLE = 5 << 5,   /* plus part << 5: the same for a triple-size character */
    FIX_PART = 15 << 5,    /* 0: the cell shows a whole character */
    FIX_SHIFT_X = 1 << 9,  /* times 0 to 7: the cell is drawn so many px further right */
    FIX_SHIFT_Y = 1 << 12, /* times 0 to 7: and further down */
    FIX_FULL_WIDTH = 1 << 15, /* a full-width letter, centred in `full_width` px and on the row */
};

struct fix {
    struct slots s;  /* a list of cols x rows cells, row by row */
    uint8_t *code;   /* low byte of the code point, 0: empty; without group FIX_GROUP_WIDE, FIX_UNKNOWN replaces code
                     * points over 255 */
    uint16_t *style; /* FIX_BANK, FIX_RIM, FIX_PART, FIX_SHIFT and FIX_FULL_WIDTH bits */
    uint16_t *page;  /* group FIX_GROUP_WIDE: the code point / 256 */
    uint8_t *font;   /* group FIX_GROUP_WIDE: font + 1; 0: the default font */
    uint32_t cols, rows;
};

extern const struct chip fix_chip;

/* Writes n bytes of UTF-8 text in letters of the given size (1 to FIX_MAX_SIZE), with the top-left corner at (x, y) px.
 * The text is stored in the cells that contain the corners of its letters and drawn shifted from there. `style` has
 * bank and rim; `font` is ignored without group FIX_GROUP_WIDE. full_width, FIX_CELL_SIZE to twice that: px from a
 * full-width letter of size 1 to the next; cells between them are cleared. Cells outside the grid are clipped. */
void fix_write(struct fix *f, int x, int y, const char *text, size_t n, int size, int full_width, unsigned style,
               uint8_t font);

/* Returns the width of n bytes of text of size 1, px. */
size_t fix_text_width(const char *text, size_t n, int full_width);

/* Returns where a cell is drawn, px. */
static inline int fix_x(const struct fix *f, uint32_t cell)
{
    return (int)(cell % f->cols) * FIX_CELL_SIZE + f->style[cell] / FIX_SHIFT_X % FIX_CELL_SIZE;
}

static inline int fix_y(const struct fix *f, uint32_t cell)
{
    return (int)(cell / f->cols) * FIX_CELL_SIZE + f->style[cell] / FIX_SHIFT_Y % FIX_CELL_SIZE;
}

/* Returns the code point of a cell. */
static inline uint32_t fix_code(const struct fix *f, uint32_t cell)
{
    return f->page ? (uint32_t)f->page[cell] << 8 | f->code[cell] : f->code[cell];
}

/* Clears a rectangle of cells, clipped to the grid. */
void fix_clear(struct fix *f, int col, int row, int w, int h);

#endif
