/*
 * letters.h - the glyphs of the canvas's larger font: capitals 7 px high, proportional widths.
 *
 * It has printable ASCII, the letters of Latin-1 and nearly all of Latin Extended-A, punctuation, arrows, the symbols
 * on controllers, and check boxes. All digits have the same width.
 */
#ifndef PLAYER_LETTERS_H
#define PLAYER_LETTERS_H

#include <stdbool.h>
#include <stdint.h>

enum {
    LETTER_ACCENT_HEIGHT = 3, /* rows above the top of capitals */
    LETTER_CAPITAL_HEIGHT = 7,
    LETTER_ROWS = 12,      /* including the accent, 7 of capitals, and 2 below the baseline */
    LETTER_SPACE_WIDTH = 3 /* px */
};

struct letter {
    int w;                      /* px, without letter spacing */
    uint16_t rows[LETTER_ROWS]; /* bit n: pixel n from the left */
};

/* Stores the glyph of a code point, or a box if the font has none. */
void letter_load(struct letter *l, uint32_t code);

/* Returns whether the font has the code point. */
bool letter_exists(uint32_t code);

#endif
