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

void bench_own_clock(bool on)
{
    enum { TIMES = 64 };
    double from;

    own_clock = on;
    from = bench_now();
    for (int i = 1; i < TIMES; i++)
        bench_now();
    reading = on ? (bench_now() - from) / TIMES : 0;
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

double samples_quantile(struct samples *s, double share)
{
    if (!s->n)
        return 0;
    numbers_sort(s->ns, (size_t)s->n);
    return s->ns[(int)(share * (s->n - 1) + 0.5)];
}

double samples_median(struct samples *s)
{
    return samples_quantile(s, 0.5);
}

const char *samples_figure(struct samples *s, double by)
{
    double half = (samples_quantile(s, 0.75) - samples_quantile(s, 0.25)) / 2 / by;
    const char *figure = report_figure(samples_median(s) / by), *dot = strchr(figure, '.');

    return report_string("%s±%.*f", figure, dot ? (int)strlen(dot + 1) : 0, half);
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
