/*
 * reporter.h - what came of tests, as lines for people, as TAP and as a JUnit file.
 */
#ifndef WORKBENCH_REPORTER_H
#define WORKBENCH_REPORTER_H

#include "outcome.h"

struct sums {
    int tests, fail, host; /* host: could not be run, or nothing could be written; they fail, too */
    uint32_t frames;
    uint64_t usec; /* from the beginning to the end of all */
};

/* Standard output. width: characters of the longest name. */
void reporter_line(const struct test *t, int width);
void reporter_sums(const struct sums *s);

/* The same as TAP: the plan first, then a line a test with what is wrong behind it. */
void reporter_tap_plan(int tests);
void reporter_tap(const struct test *t, int number);

/* A JUnit file's text. title: the game's. */
void reporter_junit(FILE *out, const char *title, const struct test *tests, const struct sums *s);

/* Text for XML and HTML. */
void reporter_escaped(FILE *out, const char *text);

#endif
