/*
 * clean.h - makes untrusted text (file names, the output and errors of a game, lines of a file) safe to display. utf8.h
 * defines which characters may be shown.
 */
#ifndef COMMON_CLEAN_H
#define COMMON_CLEAN_H

#include <stdint.h>

/* Decodes the first UTF-8 character of s, which must not be empty, into *c and returns the character's length in bytes.
 * An invalid byte gives U+FFFD and length 1. */
int clean_decode_character(const char *s, uint32_t *c);

/* Replaces characters that may not be shown, including newlines but not tabs, with spaces, in place. Bytes that belong
 * to no UTF-8 character become '?'. */
void clean_line(char *s);

/* Like clean_line, for several lines: keeps newlines. */
void clean_lines(char *s);

enum { CLEAN_MARKUP_SIZE = 8 };

/* Writes the first character of s, which must not be empty, to out, escaped for XML and HTML text and quoted
 * attributes. A character that may not be shown becomes a space, an invalid byte '?'. Returns the number of bytes read
 * from s. */
int clean_escape_character(const char *s, char out[CLEAN_MARKUP_SIZE]);

#endif
