/*
 * reporter.c - see reporter.h.
 */
#include "reporter.h"

#include <string.h>
#include "../../common/clean.h"
#include "../../common/files.h"
#include "../../common/output_paths.h"
#include "../../common/report.h"

static void indented(void *context, const char *words)
{
    report_print("      %s%s\n", (const char *)context, words);
}

void reporter_line(const struct test *t, int width)
{
    char name[FILES_PATH_SIZE];

    snprintf(name, sizeof name, "%s", t->name);
    clean_line(name);
    report_print("%-5s %-*s %7u frames %8.2f s\n", outcome_word(t), width, name, (unsigned)t->frames,
                 (double)t->usec / 1e6);
    outcome_each(t, LINE_FAILURE, indented, "");
    outcome_each(t, LINE_HOST_ERROR, indented, "");
    outcome_each(t, LINE_TRACE, indented, "  ");
    outcome_each(t, LINE_UPDATED, indented, "kept ");
    outcome_each(t, LINE_PRINTED, indented, "| ");
}

void reporter_sums(const struct sums *s)
{
    const int good = s->tests - s->fail;

    report_print("%d test%s: ", s->tests, s->tests == 1 ? "" : "s");
    if (s->fail == 0)
        report_print("%s", s->tests == 1 ? "passed" : "all passed");
    else
        report_print("%d passed, %d failed", good, s->fail);
    report_print("; %u frames in %.2f s\n", (unsigned)s->frames, (double)s->usec / 1e6);
}

/* ---- TAP ---- */

static void diagnostic(void *context, const char *words)
{
    report_print("# %s%s\n", (const char *)context, words);
}

void reporter_tap_plan(int tests)
{
    report_print("TAP version 13\n1..%d\n", tests);
}

/* Escapes #, which would start a directive. */
static void tap_name(const char *name, char *out, size_t size)
{
    size_t n = 0;

    for (; *name && n + 2 < size; name++) {
        if (*name == '#' || *name == '\\')
            out[n++] = '\\';
        out[n++] = *name;
    }
    out[n] = '\0';
}

void reporter_tap(const struct test *t, int number)
{
    char name[2 * FILES_PATH_SIZE];

    tap_name(t->name, name, sizeof name);
    clean_line(name);
    report_print("%s %d - %s\n", t->verdict == TEST_PASSES ? "ok" : "not ok", number, name);
    outcome_each(t, LINE_FAILURE, diagnostic, "");
    outcome_each(t, LINE_HOST_ERROR, diagnostic, "");
    outcome_each(t, LINE_TRACE, diagnostic, "  ");
    outcome_each(t, LINE_UPDATED, diagnostic, "kept ");
    outcome_each(t, LINE_PRINTED, diagnostic, "| ");
    report_print("# %u frames, %.3f s\n", (unsigned)t->frames, (double)t->usec / 1e6);
}

/* ---- JUnit ---- */

static void put_escaped(struct byte_buffer *out, const char *text)
{
    char as[CLEAN_MARKUP_SIZE];

    while (*text) {
        text += clean_escape_character(text, as);
        byte_buffer_put(out, as, strlen(as));
    }
}

static void escaped_line(void *out, const char *words)
{
    put_escaped(out, words);
    byte_buffer_byte(out, '\n');
}

struct first {
    struct byte_buffer *out;
    bool done;
};

static void put_first(void *context, const char *words)
{
    struct first *f = context;

    if (!f->done)
        put_escaped(f->out, words);
    f->done = true;
}

static void junit_test(struct byte_buffer *out, const struct test *t)
{
    struct first first = { .out = out };
    const char *what = t->verdict == TEST_HOST_ERROR ? "error" : "failure";

    byte_buffer_print(out, "    <testcase classname=\"");
    put_escaped(out, t->is_script ? "tests" : "demos");
    byte_buffer_print(out, "\" name=\"");
    put_escaped(out, t->name);
    byte_buffer_print(out, "\" time=\"%.3f\">\n", (double)t->usec / 1e6);
    if (t->verdict != TEST_PASSES) {
        byte_buffer_print(out, "      <%s message=\"", what);
        outcome_each(t, t->verdict == TEST_HOST_ERROR ? LINE_HOST_ERROR : LINE_FAILURE, put_first, &first);
        byte_buffer_print(out, "\">");
        outcome_each(t, LINE_HOST_ERROR, escaped_line, out);
        outcome_each(t, LINE_FAILURE, escaped_line, out);
        outcome_each(t, LINE_TRACE, escaped_line, out);
        byte_buffer_print(out, "</%s>\n", what);
    }
    byte_buffer_print(out, "      <system-out>");
    outcome_each(t, LINE_PRINTED, escaped_line, out);
    byte_buffer_print(out, "%u frames</system-out>\n    </testcase>\n", (unsigned)t->frames);
}

void reporter_junit(struct byte_buffer *out, const char *title, const struct test *tests, const struct sums *s)
{
    byte_buffer_print(out, JUNIT_HEAD);
    byte_buffer_print(out, " tests=\"%d\" failures=\"%d\" errors=\"%d\" time=\"%.3f\">\n  <testsuite name=\"", s->tests,
                      s->fail - s->host, s->host, (double)s->usec / 1e6);
    put_escaped(out, title);
    byte_buffer_print(out, "\" tests=\"%d\" failures=\"%d\" errors=\"%d\" time=\"%.3f\">\n", s->tests,
                      s->fail - s->host, s->host, (double)s->usec / 1e6);
    for (int i = 0; i < s->tests; i++)
        junit_test(out, &tests[i]);
    byte_buffer_print(out, "  </testsuite>\n</testsuites>\n");
}
