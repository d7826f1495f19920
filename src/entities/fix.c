/*
 * fix.c - the fixed text layer (fix.h).
 */
#include "fix.h"
#include "../../fb/utf8.h"

static const struct column columns[] = {
    COLUMN(fix, code),
    COLUMN(fix, style),
    GROUP_COLUMN(fix, page, FIX_GROUP_WIDE),
    GROUP_COLUMN(fix, font, FIX_GROUP_WIDE),
    REGISTER(fix, cols),
    REGISTER(fix, rows),
};

const struct chip fix_chip = { .name = "fix", CHIP_COLUMNS(columns), .is_list = true };

static void set_cell(struct fix *f, int64_t col, int64_t row, uint32_t code, unsigned style, uint8_t font)
{
    if (col < 0 || row < 0 || col >= f->cols || row >= f->rows)
        return;
    size_t cell = (size_t)(row * f->cols + col);
    f->code[cell] = (uint8_t)(code > 255 && !f->page ? FIX_UNKNOWN : code);
    f->style[cell] = (uint16_t)style;
    if (!f->page)
        return;
    f->page[cell] = (uint16_t)(code >> 8);
    f->font[cell] = font;
}

/* Returns the `style` bits of a part of a character of size 2 or 3; 0 for size 1. */
static unsigned part_style(int size, int part)
{
    return size == 1 ? 0u : size == 2 ? (unsigned)(FIX_DOUBLE * (part + 1)) : (unsigned)(FIX_TRIPLE + (part << 5));
}

void fix_write(struct fix *f, int x, int y, const char *text, size_t n, int size, int full_width, unsigned style,
               uint8_t font)
{
    const char *end = text + n;
    const int shift_y = y & (FIX_CELL_SIZE - 1);
    const int64_t row = (y - shift_y) / FIX_CELL_SIZE;
    int64_t pen = x;

    for (int i = 0; text < end && i < FIX_MAX_TEXT; i++) {
        const uint32_t code = utf8_next(&text, end);
        const bool is_full = size == 1 && full_width > FIX_CELL_SIZE && utf8_is_full_width(code);
        const int shift_x = (int)(pen & (FIX_CELL_SIZE - 1));
        const int64_t col = (pen - shift_x) / FIX_CELL_SIZE;
        const unsigned letter_style = style | (unsigned)(FIX_SHIFT_X * shift_x + FIX_SHIFT_Y * shift_y) |
                                      (is_full ? (unsigned)FIX_FULL_WIDTH : 0u);
        for (int part = 0; part < size * size; part++)
            set_cell(f, col + part % size, row + part / size, code, letter_style | part_style(size, part), font);
        pen += is_full ? full_width : size * FIX_CELL_SIZE;
        if (is_full && pen >= (col + 2) * FIX_CELL_SIZE)
            set_cell(f, col + 1, row, 0, 0, 0);
    }
}

size_t fix_text_width(const char *text, size_t n, int full_width)
{
    const char *end = text + n;
    size_t px = 0;

    while (text < end)
        px += utf8_is_full_width(utf8_next(&text, end)) ? (size_t)full_width : FIX_CELL_SIZE;
    return px;
}

void fix_clear(struct fix *f, int col, int row, int w, int h)
{
    int64_t x1 = (int64_t)col + w, y1 = (int64_t)row + h;

    for (int64_t y = row < 0 ? 0 : row; y < y1 && y < f->rows; y++)
        for (int64_t x = col < 0 ? 0 : col; x < x1 && x < f->cols; x++)
            set_cell(f, x, y, 0, 0, 0);
}
