/*
 * utf8.h - reads and writes the code points of UTF-8 text.
 */
#ifndef FB_UTF8_H
#define FB_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    UTF8_MAX_CODE = 0x10ffff, /* the highest code point */
    UTF8_MAX_BYTES = 4,       /* maximum length of a code point, in bytes */
};

/* Reads the code point at *s, and moves *s past it; *s < end. Returns false if the byte there is not part of valid
 * UTF-8: *s moves past that byte, and *code is its value. */
bool utf8_read(const char **s, const char *end, uint32_t *code);

/* Returns whether the code may be shown in text written by others. False for codes that control text instead of being
 * seen: control characters (C0, DEL, C1), line and paragraph separators, marks that change the direction of text,
 * annotations and tags, surrogates and noncharacters. Every place that shows text, from the terminal to a page, uses
 * this function. */
bool utf8_may_show(uint32_t code);

/* Returns whether the code is a full-width letter: East Asian Wide or Fullwidth (Unicode Standard Annex 11), from
 * U+2E80 on. Blocks of pictographs count as a whole. */
bool utf8_is_full_width(uint32_t code);

/* Replaces characters that may not be shown with spaces, in place, except tabs and, if `newlines`, newlines; a byte
 * that is not part of valid UTF-8 becomes '?'. */
void utf8_replace_hidden(char *text, bool newlines);

/* Like utf8_read, but returns the code; a byte that is not part of valid UTF-8 is returned as the code of the same
 * value, 128 to 255, as in Latin-1. */
uint32_t utf8_next(const char **s, const char *end);

/* Returns the number of code points in n bytes, but at most `most`. If `bytes` is not NULL, stores in *bytes how many
 * bytes the counted code points occupy. */
size_t utf8_count(const char *s, size_t n, size_t most, size_t *bytes);

/* Writes a code point, at most UTF8_MAX_CODE and not a surrogate; returns the bytes written. */
size_t utf8_put(char out[UTF8_MAX_BYTES], uint32_t code);

#endif
