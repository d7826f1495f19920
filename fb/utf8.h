/*
 * utf8.h - the code points of a text.
 */
#ifndef FB_UTF8_H
#define FB_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    UTF8_MAX = 0x10ffff, /* the last code point */
    UTF8_BYTES = 4,      /* of one, at most */
};

/* The code point at *s, which moves behind it; *s < end. False: the byte there is no part of UTF-8; *s moves behind it,
 * and its value is the code. */
bool utf8_read(const char **s, const char *end, uint32_t *code);

/* May other people's text show this character? False for what controls instead of being seen: control characters (C0,
 * DEL, C1), line and paragraph separators, marks that turn the direction of text, annotations and tags, surrogates and
 * codes that are no character. Every place where text is shown, from the terminal to a page, asks this function. */
bool utf8_may_show(uint32_t code);

/* Blanks in place what may not be shown, but tabs, and newlines where they are kept; a byte that is no part of UTF-8
 * becomes '?'. */
void utf8_blank(char *text, bool newlines);

/* utf8_read; a byte that is no part of UTF-8 stands for the code of that number, as in Latin-1: 128 to 255. */
uint32_t utf8_next(const char **s, const char *end);

/* How many code points the n bytes have, but at most `most`; *bytes (may be NULL): so many bytes those take. */
size_t utf8_count(const char *s, size_t n, size_t most, size_t *bytes);

/* Writes a code point that is no surrogate, up to UTF8_MAX; returns its bytes. */
size_t utf8_put(char out[UTF8_BYTES], uint32_t code);

#endif
