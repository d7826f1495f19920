/*
 * reporter.h - the outcomes of tests as text, as TAP and as a JUnit file.
 */
#ifndef WORKBENCH_REPORTER_H
#define WORKBENCH_REPORTER_H

#include "../../common/byte_buffer.h"
#include "outcome.h"

struct sums {
    int tests, fail, host; /* host: those of `fail` that failed because of an error of the host */
    uint32_t frames;
    uint64_t usec; /* from the start of the first to the end of the last */
};

/* Print to standard output. width: of the longest name. */
void reporter_line(const struct test *t, int width);
void reporter_sums(const struct sums *s);

/* Print TAP: the plan first, then each test with its failures. */
void reporter_tap_plan(int tests);
void reporter_tap(const struct test *t, int number);

/* Appends a JUnit file. title: the game's. */
void reporter_junit(struct byte_buffer *out, const char *title, const struct test *tests, const struct sums *s);

#endif
