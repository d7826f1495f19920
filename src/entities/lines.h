/*
 * lines.h - lines of text at any pixel, in proportional fonts.
 *
 * A line stores its text, not the positions of its letters. The positions are computed when the line is drawn, so no
 * script can depend on a font's widths.
 */
#ifndef ENTITIES_LINES_H
#define ENTITIES_LINES_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    LINE_MAX_TEXT = 240, /* maximum characters */

    LINE_SCREEN = 1 << 0, /* placed on the screen instead of the field */
    LINE_HIDDEN = 1 << 1,
    LINE_BOX = 1 << 2,
    LINE_FULL_WIDTH = 1 << 3, /* full-width letters are `screen.full_width` px wide */

    LINE_LEFT = 0, /* align: x is the left end, the middle or the right end of each row */
    LINE_CENTER,
    LINE_RIGHT,
};

struct lines {
    struct slots s;
    fx *x, *y;              /* position; unused if it follows an entity */
    fx *dx, *dy;            /* offset from (x, y), or from the entity it follows */
    int64_t *follow_target; /* handle of the entity it follows and despawns with; 0: none */
    int64_t *owner;         /* handle of the entity or scope it despawns with; 0: none */
    uint32_t *code;         /* LINE_MAX_TEXT per slot: code points, followed by zeroes */
    uint16_t *length;
    uint16_t *wrap_width;    /* px at which rows wrap; 0: only newlines break rows */
    uint16_t *letter_frames; /* frames per letter; 0: all at once */
    uint8_t *font;           /* font + 1; 0: the font of the fixed text layer */
    uint8_t *align;
    uint8_t *bank;
    uint8_t *flags;
    uint32_t *text_clock; /* clock when its text was set */
};

extern const struct chip lines_chip;

/* Sets slot i's text to n bytes of UTF-8. Returns false, and changes nothing, when it is longer than LINE_MAX_TEXT
 * characters. */
bool lines_set_text(struct lines *l, uint32_t i, const char *text, size_t n, uint32_t clock);

/* Returns the number of letters of line i that are visible at the given clock. */
uint32_t lines_visible_letters(const struct lines *l, uint32_t i, uint32_t clock);

#endif
