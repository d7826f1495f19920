/*
 * report.c - see report.h. The page is kept in memory until it is whole.
 */
#include "report.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { STRINGS = 64, STRING_BYTES = 512, MOST_COLUMNS = 16 };

struct text {
    char *s;
    size_t n, room;
};

static struct {
    struct report about;
    struct text body, conclusions;
    bool plain[MOST_COLUMNS]; /* never bold */
    int columns;
} report;

void report_fail(const char *what)
{
    fprintf(stderr, "%s: %s\n", report.about.program, what);
    exit(2);
}

static void append(struct text *t, const char *s, size_t n)
{
    if (t->n + n + 1 > t->room) {
        t->room = 2 * (t->n + n + 1);
        t->s = realloc(t->s, t->room);
        if (!t->s)
            report_fail("out of memory");
    }
    memcpy(t->s + t->n, s, n);
    t->n += n;
    t->s[t->n] = 0;
}

static void put(struct text *t, const char *s)
{
    append(t, s, strlen(s));
}

static void say_n(const char *s, size_t n)
{
    append(&report.body, s, n);
    if (report.about.echo)
        fwrite(s, 1, n, stdout);
}

static void say(const char *s)
{
    say_n(s, strlen(s));
}

void report_begin(const struct report *r)
{
    report.about = *r;
}

const char *report_page(void)
{
    return report.about.page;
}

/* ---- the command line ---- */

static int part_of(const char *name, const struct report_part *parts, int n)
{
    for (int i = 0; i < n; i++)
        if (!strcmp(parts[i].name, name))
            return i;
    return -1;
}

static bool print_usage(const char *program, const struct report_part *parts, int n)
{
    fprintf(stderr, "usage: %s [SECTION...]\nsections:", program);
    for (int i = 0; i < n; i++)
        fprintf(stderr, " %s", parts[i].name);
    fprintf(stderr, "\n");
    return false;
}

bool report_options(struct report_options *o, int argc, char **argv, const struct report_part *parts, int n)
{
    o->all = true;
    for (int i = 1; i < argc; i++) {
        int part = part_of(argv[i], parts, n);
        if (o->takes_exact && !strcmp(argv[i], "--exact"))
            o->exact = true;
        else if (!strcmp(argv[i], "--out") && i + 1 < argc)
            o->folder = argv[++i];
        else if (part < 0)
            return print_usage(o->usage, parts, n);
        else
            o->chosen[part] = true, o->all = false;
    }
    return true;
}

void report_run(const struct report_options *o, const struct report_part *parts, int n)
{
    for (int i = 0; i < n; i++)
        if (o->all || o->chosen[i])
            parts[i].run();
}

/* ---- text ---- */

void report_section(const char *title)
{
    say("## ");
    say(title);
    say("\n\n");
}

static char *next_string(void)
{
    static char strings[STRINGS][STRING_BYTES];
    static int next;

    return strings[next++ % STRINGS];
}

void report_text(const char *format, ...)
{
    char line[8192];
    va_list args;

    va_start(args, format);
    if (vsnprintf(line, sizeof line, format, args) >= (int)sizeof line)
        report_fail("a text is too long");
    va_end(args);
    say(line);
    say("\n\n");
}

const char *report_string(const char *format, ...)
{
    char *s = next_string();
    va_list args;

    va_start(args, format);
    if (vsnprintf(s, STRING_BYTES, format, args) >= STRING_BYTES)
        report_fail("a string is too long");
    va_end(args);
    return s;
}

const char *report_count(int64_t n)
{
    char digits[32], *out = next_string(), *o = out;
    int len = snprintf(digits, sizeof digits, "%lld", (long long)(n < 0 ? -n : n));

    if (n < 0)
        *o++ = '-';
    for (int i = 0; i < len; i++) {
        if (i && (len - i) % 3 == 0)
            *o++ = ',';
        *o++ = digits[i];
    }
    *o = 0;
    return out;
}

/* 1.5e-9; printf's own exponents have two digits or three. */
static const char *tiny(double v)
{
    int e = 0;

    for (; fabs(v) < 0.995; e++)
        v *= 10;
    return report_string("%.1fe-%d", v, e);
}

const char *report_figure(double v)
{
    double size = fabs(v);

    if (v == 0)
        return "0";
    if (!isfinite(v))
        return "∞";
    if (size < 1e-4)
        return tiny(v);
    if (size < 99.95)
        return report_string("%.*f",
                             size < 0.000995  ? 5
                             : size < 0.00995 ? 4
                             : size < 0.0995  ? 3
                             : size < 9.95    ? 2
                                              : 1,
                             v);
    double unit = 1;
    while (size / unit >= 999.5)
        unit *= 10;
    return report_count((int64_t)(floor(size / unit + 0.5) * unit) * (v < 0 ? -1 : 1));
}

const char *report_percent(double share)
{
    double p = share * 100;

    if (p == 0)
        return "0";
    if (p < 0.01)
        return "<0.01 %";
    return report_string(p < 0.1 ? "%.2f %%" : p < 99.95 ? "%.1f %%" : "%.0f %%", p);
}

/* ---- tables ---- */

void report_table(const char *title, const char *columns)
{
    char head[1024], *at = head;
    bool rule[MOST_COLUMNS];

    if (title) {
        say("**");
        say(title);
        say("**\n\n");
    }
    snprintf(head, sizeof head, "%s", columns);
    report.columns = 0;
    say("|");
    for (char *bar; at; at = bar ? bar + 1 : NULL) {
        bar = strchr(at, '|');
        size_t n = bar ? (size_t)(bar - at) : strlen(at);
        while (n && *at == ' ')
            at++, n--;
        while (n && at[n - 1] == ' ')
            n--;
        bool right = n && at[n - 1] == '>';
        if (report.columns == MOST_COLUMNS)
            report_fail("too many columns");
        rule[report.columns] = right;
        report.plain[report.columns++] = n > 3 && !memcmp(at, "who", 3);
        say(" ");
        say_n(at, n - right);
        say(" |");
    }
    say("\n|");
    for (int i = 0; i < report.columns; i++)
        say(rule[i] ? "---:|" : "---|");
    say("\n");
}

void report_cells(int standard, const char *const *cells, int n)
{
    say("|");
    for (int i = 0; i < n; i++) {
        bool bold = standard && *cells[i] && i < report.columns && !report.plain[i];
        say(bold ? " **" : " ");
        if (standard && i == 0)
            say("▶ ");
        say(cells[i]);
        say(bold ? "** |" : " |");
    }
    say("\n");
    if (n != report.columns)
        report_fail(report_string("a row of %d cells in a table of %d columns", n, report.columns));
}

void report_row(int standard, ...)
{
    const char *cells[MOST_COLUMNS], *cell;
    int n = 0;
    va_list args;

    va_start(args, standard);
    while ((cell = va_arg(args, const char *)) != NULL && n < MOST_COLUMNS)
        cells[n++] = cell;
    va_end(args);
    report_cells(standard, cells, n);
}

void report_table_end(void)
{
    say("\n");
}

/* ---- the page ---- */

static FILE *open_file(const char *path)
{
    FILE *f = fopen(path, "wb");

    if (!f)
        report_fail(report_string("cannot write %s", path));
    return f;
}

void *report_plot_file(const char *file, bool timed)
{
    const struct report *r = &report.about;

    if (!r->folder || (timed && r->exact))
        return NULL;
    mkdir(report_string("%s/%s", r->folder, r->page), 0777); /* it may be there */
    return open_file(report_string("%s/%s/%s.svg", r->folder, r->page, file));
}

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "a C11 compiler"
#endif
#ifndef REPORT_FLAGS
#define REPORT_FLAGS "unknown flags"
#endif

/* Without the blanks that an empty CFLAGS leaves. */
static size_t flags_length(void)
{
    size_t n = strlen(REPORT_FLAGS);

    while (n && REPORT_FLAGS[n - 1] == ' ')
        n--;
    return n;
}

/* The script's lines; the compiler's name goes through the environment, so nothing is quoted. */
static const char *measured(void)
{
    char lines[512];
    size_t n = 0;
    FILE *f;

    setenv("WITH", report_string("%s; `%.*s`", COMPILER, (int)flags_length(), REPORT_FLAGS), 1);
    f = popen(report.about.exact ? "tools/docs/measured.sh" : "tools/docs/measured.sh \"$WITH\"", "r");
    if (f) {
        n = fread(lines, 1, sizeof lines - 1, f);
        pclose(f);
    }
    lines[n] = 0;
    return report_string("%s", lines);
}

void report_conclude(const char *const *cells, int n)
{
    put(&report.conclusions, "|");
    for (int i = 0; i < n; i++) {
        put(&report.conclusions, i == 1 ? " **" : " ");
        put(&report.conclusions, cells[i]);
        put(&report.conclusions, i == 1 ? "** |" : " |");
    }
    put(&report.conclusions, "\n");
}

void report_finish(const char *intro, const char *conclusions)
{
    struct text *body = &report.body;

    if (report.about.echo && report.conclusions.n)
        printf("%s%s\n", conclusions, report.conclusions.s);
    while (body->n > 1 && body->s[body->n - 2] == '\n')
        body->s[--body->n] = 0;
    if (report.about.folder) {
        FILE *f = open_file(report_string("%s/%s.md", report.about.folder, report.about.page));
        fprintf(f, "%s%s", intro, measured());
        if (report.conclusions.n)
            fprintf(f, "%s%s\n", conclusions, report.conclusions.s);
        fputs(body->s ? body->s : "", f);
        if (fclose(f))
            report_fail("cannot write the page");
    }
    free(body->s);
    free(report.conclusions.s);
    *body = report.conclusions = (struct text){ 0 };
}

/* ---- mathematics ---- */

/* log2(x) = e + 2 atanh((m - 1) / (m + 1)) / ln 2 with m in [1/sqrt 2, sqrt 2). */
double report_log10(double x)
{
    int e;
    double m = frexp(x, &e);

    if (m < 0.70710678118654752440)
        m *= 2, e--;
    double t = (m - 1) / (m + 1), z = t * t, sum = 0;
    for (int k = 41; k > 0; k -= 2)
        sum = sum * z + 1.0 / k;
    return (e * 0.69314718055994530942 + 2 * t * sum) / 2.30258509299404568402;
}
