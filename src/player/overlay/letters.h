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
    LETTER_UP = 3,    /* rows above a capital's top, for its accent */
    LETTER_ROWS = 12, /* those, 7 of capitals, 2 below the line */
    LETTER_BLANK = 3  /* px of a blank */
};

struct letter {
    int w;                      /* px, without the gap behind it */
    uint16_t rows[LETTER_ROWS]; /* bit n: the pixel n from the left */
};

/* Stores the glyph of a code point, or a box if the font has none. */
void letter_of(struct letter *l, uint32_t code);

/* Returns whether the font has the code point. */
bool letter_known(uint32_t code);

#endif
