/*
 * measure.c - the clock and the figures of bench.h. The thread's own clock leaves out what else the machine did, but is
 * a system call, which takes as long as the shortest phases; so it is for what takes long, where being interrupted is
 * likely too. The other is the wall's, whose medians bear a few interruptions.
 */
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "bench.h"
#include "../numbers.h"

static const double LONG = 3e5; /* ns */

static bool own_clock;
static double reading; /* ns that reading the clock takes, to be taken off */

double bench_now(void)
{
    struct timespec t;

#if defined CLOCK_MONOTONIC && defined CLOCK_THREAD_CPUTIME_ID
    clock_gettime(own_clock ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &t);
#else
    timespec_get(&t, TIME_UTC);
#endif
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* The least of some means: nothing that is measured takes less. */
void bench_own_clock(bool on)
{
    enum { MEANS = 8, TIMES = 64 };

    own_clock = on;
    for (int k = 0; k < MEANS; k++) {
        const double from = bench_now();
        for (int i = 1; i < TIMES; i++)
            bench_now();
        const double took = (bench_now() - from) / TIMES;
        reading = k == 0 || took < reading ? took : reading;
    }
}

void bench_clock_for(double ns)
{
    bench_own_clock(ns > LONG);
}

double bench_since(double from)
{
    double ns = bench_now() - from - reading;

    return ns > 0 ? ns : 0;
}

void samples_add(struct samples *s, double ns)
{
    if (s->n == s->room) {
        s->room = s->room ? 2 * s->room : 256;
        s->ns = realloc(s->ns, (size_t)s->room * sizeof *s->ns);
        if (!s->ns)
            report_fail("out of memory");
    }
    s->ns[s->n++] = ns;
}

void samples_free(struct samples *s)
{
    free(s->ns);
    *s = (struct samples){ 0 };
}

double samples_quantile(const struct samples *s, double share)
{
    if (!s->n)
        return 0;
    double *sorted = malloc((size_t)s->n * sizeof *sorted);
    if (!sorted)
        report_fail("out of memory");
    memcpy(sorted, s->ns, (size_t)s->n * sizeof *sorted);
    numbers_sort(sorted, (size_t)s->n);
    const double found = sorted[(int)(share * (s->n - 1) + 0.5)];
    free(sorted);
    return found;
}

double samples_ratio(const struct samples *a, const struct samples *b)
{
    struct samples ratios = { 0 };

    for (int i = 0; i < a->n && i < b->n; i++)
        samples_add(&ratios, b->ns[i] > 0 ? a->ns[i] / b->ns[i] : 0);
    const double found = samples_median(&ratios);
    samples_free(&ratios);
    return found;
}

double samples_median(const struct samples *s)
{
    return samples_quantile(s, 0.5);
}

const char *samples_figure(const struct samples *s, double by)
{
    double half = (samples_quantile(s, 0.75) - samples_quantile(s, 0.25)) / 2 / by;
    const char *figure = report_figure(samples_median(s) / by), *dot = strchr(figure, '.');

    return report_string("%s±%.*f", figure, dot ? (int)strlen(dot + 1) : 0, half);
}

/* ---- the machine's clock ---- */

enum { CHAIN = 2000 };

static struct samples looks;
static volatile uint64_t chained;

void bench_look(void)
{
    uint64_t x = chained | 1;
    const double from = bench_now();

    for (int i = 0; i < CHAIN; i++)
        x += x >> 1 | 1;
    chained = x;
    samples_add(&looks, bench_since(from) / CHAIN);
}

void bench_say_clock(void)
{
    if (looks.n)
        report_text("CPU speed during this section: one step in a chain of additions took %s ns (the median of %s "
                    "samples; 90 %% of them were between %s and %s ns).",
                    report_string("%s", report_figure(samples_median(&looks))), report_count(looks.n),
                    report_string("%s", report_figure(samples_quantile(&looks, 0.05))),
                    report_figure(samples_quantile(&looks, 0.95)));
    looks.n = 0;
}

void laps_begin(struct laps *l)
{
    memset(l->ns, 0, sizeof l->ns);
    l->last = bench_now();
}

void laps_end(struct laps *l, enum lap lap)
{
    l->ns[lap] += bench_since(l->last);
    l->last = bench_now();
}

void laps_phase(void *laps, enum board_phase phase)
{
    static const enum lap lap[PHASES] = { LAP_SCRIPTS, LAP_MOTION, LAP_HITS, LAP_EVENTS, LAP_REST };

    laps_end(laps, lap[phase]);
}
