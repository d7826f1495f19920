/*
 * fix.c - the fixed text layer (fix.h).
 */
#include "fix.h"
#include "../../fb/utf8.h"

static const struct column columns[] = {
    COLUMN(fix, code),
    COLUMN(fix, bank),
    GROUP_COLUMN(fix, page, FIX_GROUP_WIDE),
    GROUP_COLUMN(fix, font, FIX_GROUP_WIDE),
    REGISTER(fix, cols),
    REGISTER(fix, rows),
};

const struct chip fix_chip = { .name = "fix", CHIP_COLUMNS(columns), .is_list = true };

static void set_cell(struct fix *f, int64_t col, int64_t row, uint32_t code, uint8_t bank, uint8_t font)
{
    if (col < 0 || row < 0 || col >= f->cols || row >= f->rows)
        return;
    size_t cell = (size_t)(row * f->cols + col);
    f->code[cell] = (uint8_t)(code > 255 && !f->page ? FIX_UNKNOWN : code);
    f->bank[cell] = bank;
    if (!f->page)
        return;
    f->page[cell] = (uint16_t)(code >> 8);
    f->font[cell] = font;
}

/* Writes a double-size character to four cells: its quarters, row by row. */
static void set_big_char(struct fix *f, int64_t col, int64_t row, uint32_t code, uint8_t bank, uint8_t font)
{
    for (int q = 0; q < 4; q++)
        set_cell(f, col + q % 2, row + q / 2, code, (uint8_t)((bank & ~FIX_QUARTERS) | FIX_BIG * (q + 1)), font);
}

void fix_write(struct fix *f, int col, int row, const char *text, size_t n, uint8_t bank, uint8_t font)
{
    const char *end = text + n;

    for (int64_t i = 0; text < end && i < FIX_MAX_TEXT; i++) {
        if (bank & FIX_QUARTERS)
            set_big_char(f, col + 2 * i, row, utf8_next(&text, end), bank, font);
        else
            set_cell(f, col + i, row, utf8_next(&text, end), bank, font);
    }
}

void fix_clear(struct fix *f, int col, int row, int w, int h)
{
    int64_t x1 = (int64_t)col + w, y1 = (int64_t)row + h;

    for (int64_t y = row < 0 ? 0 : row; y < y1 && y < f->rows; y++)
        for (int64_t x = col < 0 ? 0 : col; x < x1 && x < f->cols; x++)
            set_cell(f, x, y, 0, 0, 0);
}
