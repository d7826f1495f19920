/*
 * trace.h - all that a part of the board holds, as lines to compare: `hash --trace`.
 *
 * A line is a part's registers, or one live slot:
 *
 *     FRAME PART - - live=HEX(DECIMAL) refused=... REGISTER=...
 *     FRAME PART SLOT GENERATION COLUMN=HEX(DECIMAL) COLUMN=HEX,HEX,...
 *
 * in the order of the hash: parts as the board has them, registers first, slots ascending. HEX is the value's bits, two
 * digits a byte; DECIMAL is the same as a signed number, left out for 0 to 9 and for values of 8 bytes. What is in a
 * list has no generation (`-`), and an entry of nothing but zeroes has no line. Derived columns are not hashed and not
 * here. So two boards have the same lines exactly when they have the same state.
 */
#ifndef DEMO_TRACE_H
#define DEMO_TRACE_H

#include <stdio.h>
#include "../board/board.h"

/* Prints these parts (1 << part) of the board as it is now. */
void trace_frame(FILE *out, const struct board *b, uint64_t parts);

#endif
