/*
 * lab.c - see lab.h. The page is collected in memory, because the conclusions stand before what they follow from.
 */
#include "lab.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

enum { ROUNDS = 25, STRINGS = 64, STRING_BYTES = 512, MOST_COLUMNS = 16 };

struct text {
    char *s;
    size_t n, room;
};

static struct {
    bool exact, wrong;
    const char *folder;
    struct text body, conclusions;
    bool plain[MOST_COLUMNS]; /* never bold */
    int columns;
} lab;

volatile int64_t lab_sink;

static void fail(const char *what)
{
    fprintf(stderr, "lab: %s\n", what);
    exit(2);
}

static void append(struct text *t, const char *s, size_t n)
{
    if (t->n + n + 1 > t->room) {
        t->room = 2 * (t->n + n + 1);
        t->s = realloc(t->s, t->room);
        if (!t->s)
            fail("out of memory");
    }
    memcpy(t->s + t->n, s, n);
    t->n += n;
    t->s[t->n] = 0;
}

static void put(struct text *t, const char *s)
{
    append(t, s, strlen(s));
}

void lab_begin(bool exact, const char *folder)
{
    lab.exact = exact;
    lab.folder = folder;
}

bool lab_exact(void)
{
    return lab.exact;
}

/* ---- text ---- */

void lab_section(const char *title)
{
    put(&lab.body, "## ");
    put(&lab.body, title);
    put(&lab.body, "\n\n");
}

static char *next_string(void)
{
    static char strings[STRINGS][STRING_BYTES];
    static int next;

    return strings[next++ % STRINGS];
}

void lab_text(const char *format, ...)
{
    char line[8192];
    va_list args;

    va_start(args, format);
    if (vsnprintf(line, sizeof line, format, args) >= (int)sizeof line)
        fail("a text is too long");
    va_end(args);
    put(&lab.body, line);
    put(&lab.body, "\n\n");
}

const char *lab_string(const char *format, ...)
{
    char *s = next_string();
    va_list args;

    va_start(args, format);
    if (vsnprintf(s, STRING_BYTES, format, args) >= STRING_BYTES)
        fail("a string is too long");
    va_end(args);
    return s;
}

const char *lab_count(int64_t n)
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
    return lab_string("%.1fe-%d", v, e);
}

const char *lab_figure(double v)
{
    double size = fabs(v);

    if (v == 0)
        return "0";
    if (!isfinite(v))
        return "∞";
    if (size < 1e-4)
        return tiny(v);
    if (size < 99.95)
        return lab_string("%.*f",
                          size < 0.000995  ? 5
                          : size < 0.00995 ? 4
                          : size < 0.0995  ? 3
                          : size < 9.95    ? 2
                                           : 1,
                          v);
    double unit = 1;
    while (size / unit >= 999.5)
        unit *= 10;
    return lab_count((int64_t)(floor(size / unit + 0.5) * unit) * (v < 0 ? -1 : 1));
}

const char *lab_percent(double share)
{
    double p = share * 100;

    if (p == 0)
        return "0";
    if (p < 0.01)
        return "<0.01 %";
    return lab_string(p < 0.1 ? "%.2f %%" : p < 99.95 ? "%.1f %%" : "%.0f %%", p);
}

/* ---- tables ---- */

void lab_table(const char *title, const char *columns)
{
    char head[1024], *at = head;
    bool rule[MOST_COLUMNS];

    if (title) {
        put(&lab.body, "**");
        put(&lab.body, title);
        put(&lab.body, "**\n\n");
    }
    snprintf(head, sizeof head, "%s", columns);
    lab.columns = 0;
    put(&lab.body, "|");
    for (char *bar; at; at = bar ? bar + 1 : NULL) {
        bar = strchr(at, '|');
        size_t n = bar ? (size_t)(bar - at) : strlen(at);
        while (n && *at == ' ')
            at++, n--;
        while (n && at[n - 1] == ' ')
            n--;
        bool right = n && at[n - 1] == '>';
        if (lab.columns == MOST_COLUMNS)
            fail("too many columns");
        rule[lab.columns] = right;
        lab.plain[lab.columns++] = n > 3 && !memcmp(at, "who", 3);
        put(&lab.body, " ");
        append(&lab.body, at, n - right);
        put(&lab.body, " |");
    }
    put(&lab.body, "\n|");
    for (int i = 0; i < lab.columns; i++)
        put(&lab.body, rule[i] ? "---:|" : "---|");
    put(&lab.body, "\n");
}

void lab_row(int standard, ...)
{
    const char *cell;
    int n = 0;
    va_list args;

    va_start(args, standard);
    put(&lab.body, "|");
    for (; (cell = va_arg(args, const char *)) != NULL; n++) {
        bool bold = standard && *cell && n < lab.columns && !lab.plain[n];
        put(&lab.body, bold ? " **" : " ");
        if (standard && n == 0)
            put(&lab.body, "▶ ");
        put(&lab.body, cell);
        put(&lab.body, bold ? "** |" : " |");
    }
    va_end(args);
    put(&lab.body, "\n");
    if (n != lab.columns)
        fail(lab_string("a row of %d cells in a table of %d columns", n, lab.columns));
}

void lab_table_end(void)
{
    put(&lab.body, "\n");
}

/* ---- times ---- */

/* The thread's own time, so that other programs disturb less. */
static double now_ns(void)
{
    struct timespec t;

#ifdef CLOCK_THREAD_CPUTIME_ID
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
#else
    timespec_get(&t, TIME_UTC);
#endif
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

void lab_time(struct lab_rival *rivals, int n, int standard)
{
    double(*ns)[ROUNDS] = lab.exact ? NULL : malloc((size_t)n * sizeof *ns);

    for (int i = 0; i < n; i++)
        rivals[i].ns = rivals[i].low = rivals[i].high = rivals[i].ratio = 0;
    if (lab.exact)
        return;
    if (!ns)
        fail("out of memory");
    for (int round = -1; round < ROUNDS; round++) /* the first warms up */
        for (int i = 0; i < n; i++) {
            double from = now_ns();
            rivals[i].run(rivals[i].data);
            if (round >= 0)
                ns[i][round] = (now_ns() - from) / rivals[i].ops;
        }
    for (int i = 0; i < n; i++) {
        qsort(ns[i], ROUNDS, sizeof ns[i][0], by_value);
        rivals[i].low = ns[i][ROUNDS / 4];
        rivals[i].ns = ns[i][ROUNDS / 2];
        rivals[i].high = ns[i][ROUNDS - 1 - ROUNDS / 4];
    }
    for (int i = 0; i < n; i++)
        rivals[i].ratio = rivals[i].ns / rivals[standard].ns;
    free(ns);
}

const char *lab_about(double v)
{
    return lab.exact ? "≈" : lab_string("≈%s", lab_figure(v));
}

static const char *with_spread(const struct lab_rival *r, const char *unit)
{
    if (lab.exact)
        return lab_string("≈ %s", unit);

    const char *time = lab_figure(r->ns), *dot = strchr(time, '.');

    return lab_string("≈%s±%.*f %s", time, dot ? (int)strlen(dot + 1) : 0, (r->high - r->low) / 2, unit);
}

const char *lab_ns(const struct lab_rival *r)
{
    return with_spread(r, "ns");
}

const char *lab_us(const struct lab_rival *r)
{
    return with_spread(r, "µs");
}

const char *lab_ratio(const struct lab_rival *r)
{
    return lab_about(r->ratio);
}

/* ---- conclusions ---- */

void lab_claim(bool holds, const char *claim)
{
    if (holds)
        return;
    fprintf(stderr, "lab: does not hold: %s\n", claim);
    lab.wrong = true;
}

void lab_conclude(const char *question, const char *engine, const char *because, const char *instead, bool justified)
{
    const char *cells[] = { question, engine, because, instead };

    lab_claim(justified, lab_string("%s: %s", question, engine));
    put(&lab.conclusions, "|");
    for (int i = 0; i < 4; i++) {
        put(&lab.conclusions, i == 1 ? " **" : " ");
        put(&lab.conclusions, cells[i]);
        put(&lab.conclusions, i == 1 ? "** |" : " |");
    }
    put(&lab.conclusions, "\n");
}

/* ---- the page ---- */

static FILE *open_file(const char *name)
{
    char path[1024];
    FILE *f;

    snprintf(path, sizeof path, "%s/%s", lab.folder, name);
    f = fopen(path, "wb");
    if (!f)
        fail(lab_string("cannot write %s", path));
    return f;
}

void *lab_plot_file(const char *file)
{
    char path[1024];

    snprintf(path, sizeof path, "%s/accuracy", lab.folder);
    mkdir(path, 0777); /* it may be there */
    return open_file(lab_string("accuracy/%s.svg", file));
}

/* What the system tells of the processor under that key, or `otherwise`; *times: how often, as a rule once a core. */
static const char *cpuinfo(const char *key, const char *otherwise, int *times)
{
    char line[4096];
    const char *value = otherwise;
    FILE *f = fopen("/proc/cpuinfo", "r");

    *times = 0;
    while (f && fgets(line, sizeof line, f)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, key, strlen(key)) || !colon || !colon[1])
            continue;
        line[strcspn(line, "\n")] = 0;
        value = ++*times == 1 ? lab_string("%.200s", colon + 2) : value;
    }
    if (f)
        fclose(f);
    return value;
}

static const char *processor(void)
{
    int times, cores;
    const char *name = cpuinfo("model name", "a processor that does not tell its name", &times);
    const char *mhz = cpuinfo("cpu MHz", "?", &times), *cache = cpuinfo("cache size", "? KB", &times);

    cpuinfo("processor", "", &cores);
    return lab_string("%s, %d cores, %.*s MHz, %s of cache", name, cores, (int)strcspn(mhz, "."), mhz, cache);
}

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "a C11 compiler"
#endif
#ifndef LAB_FLAGS
#define LAB_FLAGS "unknown flags"
#endif

static const char ABOUT[] =
    "# Accuracy: what each choice costs\n"
    "\n"
    "`make accuracy` measures this page and writes it with its plots; do not edit it. Each section takes one choice "
    "of\n"
    "the engine, sets it beside cheaper and dearer ones, and says who should take which. Rows of the engine run the\n"
    "engine's own code, not a copy.\n"
    "\n"
    "How to read it\n"
    "\n"
    "* **▶ bold** is what the engine does unless told otherwise: formats are read from its headers, defaults of "
    "scripts from\n"
    "  its API table, functions are the engine's own calls.\n"
    "* *Error* is the distance to the true result, which is computed with more bits: the largest (max) and the root "
    "mean\n"
    "  square (rms) over all cases, in the unit named. An error of 0 is exact.\n"
    "* **≈** marks what depends on the machine. *Time* is the median of 25 rounds in which all rows of a table take\n"
    "  turns, ± half the distance of the quartiles; *ratio* is to the engine's row. Only compare within a table.\n"
    "* All other figures are the same on every machine; a test of `make test` computes them again and compares.\n"
    "* px is a pixel, a frame is 1/60 s; 1 ulp is 1/65536 px, the last bit of a position.\n"
    "\n";

/* Without the blanks that an empty CFLAGS leaves. */
static size_t flags_length(void)
{
    size_t n = strlen(LAB_FLAGS);

    while (n && LAB_FLAGS[n - 1] == ' ')
        n--;
    return n;
}

int lab_finish(void)
{
    FILE *f = open_file("accuracy.md");

    fputs(ABOUT, f);
    if (lab.exact)
        fputs("Measured on: ≈\n\n", f);
    else
        fprintf(f, "Measured on: %s; %s; `%.*s`\n\n", processor(), COMPILER, (int)flags_length(), LAB_FLAGS);
    if (lab.conclusions.n)
        fprintf(
            f,
            "## Conclusions\n\n| choice | the engine's default | because | choose instead |\n|---|---|---|---|\n%s\n",
            lab.conclusions.s);
    while (lab.body.n > 1 && lab.body.s[lab.body.n - 2] == '\n')
        lab.body.s[--lab.body.n] = 0;
    fputs(lab.body.s ? lab.body.s : "", f);
    if (fclose(f))
        fail("cannot write the page");
    free(lab.body.s);
    free(lab.conclusions.s);
    return lab.wrong;
}

/* ---- mathematics ---- */

/* log2(x) = e + 2 atanh((m - 1) / (m + 1)) / ln 2 with m in [1/sqrt 2, sqrt 2). */
double lab_log10(double x)
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

/* Taylor's series for an eighth of a turn, which lies within 1 of 0. */
void lab_direction(double turns, double *c, double *s)
{
    double eighths = turns * 8, whole = floor(eighths), x = (eighths - whole) * 0.78539816339744830962;
    int octant = (int)fmod(whole, 8);
    double parts[2] = { 0, 0 }, term = 1;

    octant = octant < 0 ? octant + 8 : octant;
    if (octant & 1)
        x = 0.78539816339744830962 - x;
    for (int i = 0; i < 22; i++) {
        parts[i & 1] += i & 2 ? -term : term;
        term = term * x / (i + 1);
    }
    if ((octant + 1) & 2) { /* nearer to a vertical axis */
        double swap = parts[0];
        parts[0] = parts[1];
        parts[1] = swap;
    }
    *c = octant >= 2 && octant < 6 ? -parts[0] : parts[0];
    *s = octant >= 4 ? -parts[1] : parts[1];
}

double lab_random(struct rng *r, double low, double high)
{
    return low + (high - low) * ((double)(rng_next(r) >> 11) / 9007199254740992.0);
}
