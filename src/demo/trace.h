/*
 * trace.h - dumps the complete state of parts of a board as lines that can be compared: `hash --trace`.
 *
 * A line is a part's registers, or one live slot:
 *
 *     FRAME PART - - live=HEX(DECIMAL) refused=... REGISTER=...
 *     FRAME PART SLOT GENERATION COLUMN=HEX(DECIMAL) COLUMN=HEX,HEX,...
 *
 * Lines are in hash order: parts in the board's order, registers first, slots ascending. HEX is the value's bits, two
 * digits a byte; DECIMAL is the same value as a signed number, left out for 0 to 9 and for 8-byte values. List entries
 * have no generation (`-`), and list entries that are all zero have no line. Derived columns are neither hashed nor
 * printed. So two boards have the same lines exactly when they have the same state.
 */
#ifndef DEMO_TRACE_H
#define DEMO_TRACE_H

#include <stdio.h>
#include "../board/board.h"

/* Prints these parts (1 << part) of the board's current state. */
void trace_frame(FILE *out, const struct board *b, uint64_t parts);

#endif
