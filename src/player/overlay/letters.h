/*
 * letters.h - the pictures of the canvas's larger face: capitals 7 px high, widths of their own.
 *
 * It has printable ASCII, the letters of Latin-1 and nearly all of Latin Extended-A, marks of punctuation, arrows,
 * shapes that stand on controllers, and boxes with and without a tick. Digits are equally wide.
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

/* The picture of a code point; of one that it does not have, a box. */
void letter_of(struct letter *l, uint32_t code);

/* Has it a picture of its own? */
bool letter_known(uint32_t code);

#endif
