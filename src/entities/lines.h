/*
 * lines.h - lines of text at any pixel, in fonts whose characters have widths of their own.
 *
 * A line holds what it says, not where its letters stand: that is found when it is drawn, so no script can depend on a
 * font's widths.
 */
#ifndef ENTITIES_LINES_H
#define ENTITIES_LINES_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    LINE_TEXT = 240, /* characters */

    LINE_SCREEN = 1 << 0, /* placed on the screen instead of the field */
    LINE_HIDDEN = 1 << 1,
    LINE_BOX = 1 << 2,

    LINE_LEFT = 0, /* align: its x is the left end of each row, the middle or the right end */
    LINE_CENTER,
    LINE_RIGHT,
};

struct lines {
    struct slots s;
    fx *x, *y;       /* of one that follows a thing: nothing */
    fx *dx, *dy;     /* it stands so far from there, or from the thing */
    int64_t *follow; /* it goes when that thing does, 0: none; the board gives it a meaning */
    int64_t *owner;  /* the same of what it ends with */
    uint32_t *code;  /* LINE_TEXT a slot: code points, 0 behind the last */
    uint16_t *length;
    uint16_t *width;  /* px it is broken at, 0: nowhere but at newlines */
    uint16_t *letter; /* frames a letter, 0: all at once */
    uint8_t *font;    /* 0: the cells' font; else font + 1 */
    uint8_t *align;
    uint8_t *bank;
    uint8_t *flags;
    uint32_t *born; /* clock, when its text was set */
};

extern const struct chip lines_chip;

/* Sets slot i's text, the n bytes; false, and nothing changes: it is longer than LINE_TEXT characters. */
bool lines_say(struct lines *l, uint32_t i, const char *text, size_t n, uint32_t clock);

/* How many letters are seen at that clock. */
uint32_t lines_seen(const struct lines *l, uint32_t i, uint32_t clock);

/* Removes what has that owner. */
void lines_drop_of(struct lines *l, int64_t owner);

#endif
