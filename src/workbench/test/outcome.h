/*
 * outcome.h - a test, and what came of it.
 */
#ifndef WORKBENCH_OUTCOME_H
#define WORKBENCH_OUTCOME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum verdict_of { TEST_HOLDS, TEST_FAILS, TEST_HOST };

/* What a test says of itself, a line each: the kind's letter, a blank, words. */
enum saying {
    SAYS_WRONG = 'F',   /* what does not hold, or a script's mistake */
    SAYS_HOST = 'H',    /* what the host could not do */
    SAYS_PRINTED = 'P', /* what the script printed */
    SAYS_TRACE = 'T',   /* a line of a traceback */
    SAYS_PICTURE = 'G', /* the name of a picture that differs: files of it are in tests/failed */
    SAYS_KEPT = 'U',    /* a file that --update has written */
    SAYS_TAKEN = 'N',   /* a file of tests/golden that was compared */
    SAYS_COST = 'C'     /* frames and microseconds, at the end */
};

struct test {
    char *name;  /* "demos/run.demo", "tests/boss.lua" */
    bool script; /* else a demo */
    bool done;
    char *said; /* lines, ending in \n */
    size_t n;
    enum verdict_of verdict;
    uint32_t frames;
    uint64_t usec;
};

/* Writes a line; what would end it or a terminal would obey is blanked. */
void outcome_say(FILE *out, enum saying kind, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Takes what a test has written, and reads verdict and cost of it. signal: what ended its process, or 0. False: no
 * memory. */
bool outcome_take(struct test *t, const char *said, size_t n, int signal);

/* One more line of a test that is done; it fails. False: no memory. */
bool outcome_add(struct test *t, const char *sentence);

/* Calls each with every line of that kind, without its letter. */
void outcome_each(const struct test *t, enum saying kind, void (*each)(void *context, const char *words),
                  void *context);

/* "HOLDS", ... as reports say it */
const char *outcome_word(const struct test *t);

#endif
