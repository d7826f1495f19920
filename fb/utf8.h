/*
 * utf8.h - the code points of a text.
 * floor: fb
 */
#ifndef FB_UTF8_H
#define FB_UTF8_H

#include <stddef.h>
#include <stdint.h>

enum {
    UTF8_MAX = 0x10ffff, /* the last code point */
    UTF8_BYTES = 4,      /* of one, at most */
};

/* The code point at *s, which moves behind it; *s < end. A byte that is no part of UTF-8 stands for the code of that
 * number, as in Latin-1: 128 to 255. */
uint32_t utf8_next(const char **s, const char *end);

/* How many code points the n bytes have, but at most `most`; *bytes (may be NULL): so many bytes those take. */
size_t utf8_count(const char *s, size_t n, size_t most, size_t *bytes);

/* Writes a code point that is no surrogate, up to UTF8_MAX; returns its bytes. */
size_t utf8_put(char out[UTF8_BYTES], uint32_t code);

#endif
