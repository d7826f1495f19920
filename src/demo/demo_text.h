/*
 * demo_text.h - a demo as lines of text, in a file that says something else as well: a report that is mailed.
 *
 * The lines between DEMO_TEXT_BEGIN and DEMO_TEXT_END are the demo's bytes in base64, 72 characters a line. Lines
 * before and behind are anybody's.
 */
#ifndef DEMO_DEMO_TEXT_H
#define DEMO_DEMO_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define DEMO_TEXT_BEGIN "-----BEGIN CURTAIN DEMO-----"
#define DEMO_TEXT_END   "-----END CURTAIN DEMO-----"

enum { DEMO_TEXT_LINE = 72 };

/* Writing, in pieces; it takes no memory, so that a handler of a crash may. */
struct demo_text {
    void (*out)(void *to, const void *bytes, size_t n);
    void *to;
    uint8_t held[3];
    int n;                         /* bytes in held */
    char line[DEMO_TEXT_LINE + 1]; /* and a \n */
    int at;                        /* characters in line */
};

void demo_text_begin(struct demo_text *t, void (*out)(void *to, const void *bytes, size_t n), void *to);
void demo_text_add(struct demo_text *t, const void *bytes, size_t n);
void demo_text_end(struct demo_text *t);

/* Finds a demo in a text and puts its bytes in the place of the text: *size becomes theirs. A text that stops before
 * the end line gives what it has. False: there is no line that begins one, and nothing has changed. What is no base64
 * ends it, so that a damaged one is found by its CRC. */
bool demo_text_decode(uint8_t *data, size_t *size);

#endif
