/*
 * clean.h - text of others (names of files, what a game prints or raises, lines of a file) made fit for a terminal.
 * floor: cab
 */
#ifndef CAB_CLEAN_H
#define CAB_CLEAN_H

#include <stdint.h>

/* The code point of the UTF-8 character at s, which is not its end, and how many bytes it has. Where none is: U+FFFD,
 * one byte. */
int clean_character(const char *s, uint32_t *c);

/* Blanks in place what a terminal would obey, and what would end the line: control characters but tabs, those of UTF-8
 * (U+0080 to U+009F) too. A byte that belongs to no UTF-8 character becomes '?'. */
void clean_line(char *s);

/* The same of lines: newlines stay. */
void clean_lines(char *s);

#endif
