/*
 * outcome.c - see outcome.h.
 */
#include "outcome.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/clean.h"

enum { LINE = 4096 };

void outcome_write(FILE *out, enum line_kind kind, const char *format, ...)
{
    char line[LINE];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    clean_line(line);
    fprintf(out, "%c %s\n", (char)kind, line);
}

void outcome_each(const struct test *t, enum line_kind kind, void (*each)(void *context, const char *words),
                  void *context)
{
    char line[LINE + 4];

    for (size_t at = 0, n; at < t->n; at += n + 1) {
        const char *from = t->lines + at, *end = memchr(from, '\n', t->n - at);
        n = end ? (size_t)(end - from) : t->n - at;
        if (n < 2 || from[0] != (char)kind)
            continue;
        snprintf(line, sizeof line, "%.*s", (int)(n - 2 < LINE ? n - 2 : LINE), from + 2);
        each(context, line);
    }
}

static void mark_failed(void *verdict, const char *words)
{
    enum test_verdict *v = verdict;

    (void)words;
    *v = *v == TEST_PASSES ? TEST_FAILS : *v;
}

static void mark_host_error(void *verdict, const char *words)
{
    (void)words;
    *(enum test_verdict *)verdict = TEST_HOST_ERROR;
}

static void read_cost(void *test, const char *words)
{
    struct test *t = test;

    sscanf(words, "%" SCNu32 " %" SCNu64, &t->frames, &t->usec);
}

static bool append(struct test *t, const char *text, size_t n)
{
    char *more = realloc(t->lines, t->n + n + 1);

    if (!more)
        return false;
    memcpy(more + t->n, text, n);
    t->lines = more;
    t->n += n;
    t->lines[t->n] = 0;
    return true;
}

bool outcome_add(struct test *t, const char *sentence)
{
    char line[LINE];
    const int n = snprintf(line, sizeof line, "%c %s\n", LINE_FAILURE, sentence);
    const bool cut = t->n > 0 && t->lines[t->n - 1] != '\n'; /* the test's process died while writing */

    mark_failed(&t->verdict, NULL);
    return (!cut || append(t, "\n", 1)) && n > 0 && append(t, line, n < LINE ? (size_t)n : LINE - 1);
}

bool outcome_read(struct test *t, const char *lines, size_t n, int signal)
{
    char died[120];

    t->done = true;
    if (!append(t, lines, n))
        return false;
    outcome_each(t, LINE_FAILURE, mark_failed, &t->verdict);
    outcome_each(t, LINE_HOST_ERROR, mark_host_error, &t->verdict);
    outcome_each(t, LINE_COST, read_cost, t);
    if (!signal)
        return true;
    snprintf(died, sizeof died, "the program was killed by signal %d during the test", signal);
    return outcome_add(t, died);
}

const char *outcome_word(const struct test *t)
{
    return t->verdict == TEST_PASSES ? "ok" : "FAILS";
}
