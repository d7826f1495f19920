/*
 * lines.c - lines of text (lines.h).
 */
#include "lines.h"
#include <string.h>
#include "../../fb/utf8.h"

static const struct column columns[] = {
    COLUMN(lines, x),
    COLUMN(lines, y),
    COLUMN(lines, dx),
    COLUMN(lines, dy),
    COLUMN(lines, follow_target),
    COLUMN(lines, owner),
    COLUMNS(lines, code, LINE_MAX_TEXT),
    COLUMN(lines, length),
    COLUMN(lines, wrap_width),
    COLUMN(lines, letter_frames),
    COLUMN(lines, font),
    COLUMN(lines, align),
    COLUMN(lines, bank),
    COLUMN(lines, flags),
    COLUMN(lines, text_clock),
};

const struct chip lines_chip = { .name = "lines", CHIP_COLUMNS(columns) };

bool lines_set_text(struct lines *l, uint32_t i, const char *text, size_t n, uint32_t clock)
{
    const char *end = text + n;
    uint32_t *to = l->code + (size_t)i * LINE_MAX_TEXT;
    size_t count = utf8_count(text, n, LINE_MAX_TEXT + 1, NULL);

    if (count > LINE_MAX_TEXT)
        return false;
    memset(to, 0, LINE_MAX_TEXT * sizeof *to);
    while (text < end)
        *to++ = utf8_next(&text, end);
    l->length[i] = (uint16_t)count;
    l->text_clock[i] = clock;
    return true;
}

uint32_t lines_visible_letters(const struct lines *l, uint32_t i, uint32_t clock)
{
    uint32_t n = l->letter_frames[i] ? (clock - l->text_clock[i]) / l->letter_frames[i] : l->length[i];

    return n < l->length[i] ? n : l->length[i];
}
