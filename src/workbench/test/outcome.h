/*
 * outcome.h - a test and its outcome.
 */
#ifndef WORKBENCH_OUTCOME_H
#define WORKBENCH_OUTCOME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum test_verdict { TEST_PASSES, TEST_FAILS, TEST_HOST_ERROR };

/* A test writes its outcome as lines: the letter of the line's kind, a blank, text. */
enum line_kind {
    LINE_FAILURE = 'F',    /* a failed check, or a script's error */
    LINE_HOST_ERROR = 'H', /* an error of the host */
    LINE_PRINTED = 'P',    /* a line that the script printed */
    LINE_TRACE = 'T',      /* a line of a traceback */
    LINE_UPDATED = 'U',    /* a file that --update wrote */
    LINE_GOLDEN = 'N',     /* a file in tests/golden that was compared */
    LINE_COST = 'C'        /* frames and microseconds; the last line */
};

struct test {
    char *name;     /* "demos/run.demo", "tests/boss.lua" */
    bool is_script; /* otherwise a demo */
    bool done;
    char *lines; /* malloc; each ends in \n */
    size_t n;    /* bytes of them */
    enum test_verdict verdict;
    uint32_t frames;
    uint64_t usec;
};

/* Writes a line, with control characters blanked. */
void outcome_write(FILE *out, enum line_kind kind, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Stores the lines of a test, and sets its verdict and cost. signal: what ended its process, or 0. False: out of
 * memory. */
bool outcome_read(struct test *t, const char *lines, size_t n, int signal);

/* Adds a failure to a test that is done. False: out of memory. */
bool outcome_add(struct test *t, const char *sentence);

/* Calls `each` with the text of every line of a kind. */
void outcome_each(const struct test *t, enum line_kind kind, void (*each)(void *context, const char *words),
                  void *context);

/* "ok" or "FAILS" */
const char *outcome_word(const struct test *t);

#endif
