/*
 * clean.h - text of others (names of files, what a game prints or raises, lines of a file) made fit to be shown.
 * What may be shown at all utf8.h says.
 */
#ifndef COMMON_CLEAN_H
#define COMMON_CLEAN_H

#include <stdint.h>

/* The code point of the UTF-8 character at s, which is not its end, and how many bytes it has. Where none is: U+FFFD,
 * one byte. */
int clean_character(const char *s, uint32_t *c);

/* Blanks in place what may not be shown, and what would end the line. A byte that belongs to no UTF-8 character becomes
 * '?'. */
void clean_line(char *s);

/* The same of lines: newlines stay. */
void clean_lines(char *s);

enum { CLEAN_MARKUP = 8 };

/* The character at s, which is not its end, as XML and HTML have it, in text and in quotes; returns how many bytes of s
 * that was. */
int clean_markup(const char *s, char out[CLEAN_MARKUP]);

#endif
