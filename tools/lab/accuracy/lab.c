/*
 * lab.c - see lab.h.
 */
#include "lab.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../numbers.h"

enum { ROUNDS = 25 };

static struct {
    bool exact, wrong;
} lab;

volatile int64_t lab_sink;

void lab_begin(bool exact, const char *folder)
{
    lab.exact = exact;
    report_begin(&(struct report){ .program = "lab", .folder = folder, .page = "accuracy", .exact = exact });
}

bool lab_exact(void)
{
    return lab.exact;
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

void lab_time(struct lab_rival *rivals, int n, int standard)
{
    double(*ns)[ROUNDS] = lab.exact ? NULL : malloc((size_t)n * sizeof *ns);

    for (int i = 0; i < n; i++)
        rivals[i].ns = rivals[i].low = rivals[i].high = rivals[i].ratio = 0;
    if (lab.exact)
        return;
    if (!ns)
        report_fail("out of memory");
    for (int round = -1; round < ROUNDS; round++) /* the first warms up */
        for (int i = 0; i < n; i++) {
            double from = now_ns();
            rivals[i].run(rivals[i].data);
            if (round >= 0)
                ns[i][round] = (now_ns() - from) / rivals[i].ops;
        }
    for (int i = 0; i < n; i++) {
        numbers_sort(ns[i], ROUNDS);
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
    return lab.exact ? "≈" : report_string("≈%s", report_figure(v));
}

static const char *with_spread(const struct lab_rival *r, const char *unit)
{
    if (lab.exact)
        return report_string("≈ %s", unit);

    const char *time = report_figure(r->ns), *dot = strchr(time, '.');

    return report_string("≈%s±%.*f %s", time, dot ? (int)strlen(dot + 1) : 0, (r->high - r->low) / 2, unit);
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

    lab_claim(justified, report_string("%s: %s", question, engine));
    report_conclude(cells, 4);
}

/* ---- the page ---- */

static const char ABOUT[] =
    "# Accuracy: the cost of each choice\n"
    "\n"
    "`make accuracy` takes the measurements and writes this page and its plots; do not edit them. Each section "
    "compares one\n"
    "design choice with cheaper and more expensive alternatives, and says when to use each. The engine's rows run its "
    "actual\n"
    "code, not a copy.\n"
    "\n"
    "How to read the tables:\n"
    "\n"
    "* **▶** and bold type mark the engine's default. *Gives up* lists the disadvantages of the other methods.\n"
    "* An error is the distance from the true result, which is computed with higher precision. *max* is the largest "
    "error\n"
    "  over all cases, and *rms* is the root mean square. 0 means no error at all.\n"
    "* **≈** marks numbers that depend on the machine. A *time* is the median of 25 rounds, ± half the interquartile "
    "range.\n"
    "  Every round runs each row of the table once, so compare times only within a table. *Ratio* is the time divided "
    "by the\n"
    "  time of the engine's row.\n"
    "* All other numbers are the same on every machine; `make test` recomputes them and compares them with this page.\n"
    "* px is a pixel, and a frame is 1/60 s. 1 ulp is 1/65536 px, the last bit of a position in the engine's Q15.16 "
    "format.\n"
    "* A *tie* is a result exactly halfway between two representable values.\n"
    "* An *integer twin* is the engine's own version of a function for processors without hardware doubles.\n"
    "\n";

int lab_finish(void)
{
    report_finish(ABOUT, "## Conclusions\n"
                         "\n"
                         "| choice | engine default | reason | alternative |\n"
                         "|---|---|---|---|\n");
    return lab.wrong;
}

/* ---- mathematics ---- */

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
