/*
 * told.h - what came of tests, as lines for people, as TAP and as a JUnit file.
 */
#ifndef CAB_TOLD_H
#define CAB_TOLD_H

#include "outcome.h"

struct sums {
    int tests, fail, host; /* host: could not be run, or nothing could be written; they fail, too */
    uint32_t frames;
    uint64_t usec; /* from the beginning to the end of all */
};

/* Standard output. width: characters of the longest name. */
void told_line(const struct test *t, int width);
void told_sums(const struct sums *s);

/* The same as TAP: the plan first, then a line a test with what is wrong behind it. */
void told_tap_plan(int tests);
void told_tap(const struct test *t, int number);

/* A JUnit file's text. title: the game's. */
void told_junit(FILE *out, const char *title, const struct test *tests, const struct sums *s);

/* Do the first bytes of a file show that told_junit wrote it? */
bool told_is_junit(const uint8_t *head, size_t n);

/* Text for XML and HTML. */
void told_escaped(FILE *out, const char *text);

#endif
