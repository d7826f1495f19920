/*
 * clean.h - makes untrusted text (file names, what a game prints or raises, lines of a file) safe to display.
 * utf8.h defines which characters may be shown.
 */
#ifndef COMMON_CLEAN_H
#define COMMON_CLEAN_H

#include <stdint.h>

/* Decodes the UTF-8 character at s, which must not be at its end, into *c and returns its length in bytes. An invalid
 * byte gives U+FFFD and length 1. */
int clean_character(const char *s, uint32_t *c);

/* Replaces characters that may not be shown, and those that would end the line, with blanks, in place. Bytes that
 * belong to no UTF-8 character become '?'. */
void clean_line(char *s);

/* Like clean_line, for several lines: newlines stay. */
void clean_lines(char *s);

enum { CLEAN_MARKUP = 8 };

/* Writes the character at s, which must not be at its end, as XML and HTML need it in text and in quotes; returns the
 * number of bytes of s it read. */
int clean_markup(const char *s, char out[CLEAN_MARKUP]);

#endif
