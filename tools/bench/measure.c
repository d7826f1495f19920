/*
 * measure.c - the clock and the figures of bench.h. The clock is the wall's: the thread's own costs a system call, which
 * is as long as some phases. So what else the machine does shows, and medians are taken over many frames.
 */
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "bench.h"

double bench_now(void)
{
    struct timespec t;

#ifdef CLOCK_MONOTONIC
    clock_gettime(CLOCK_MONOTONIC, &t);
#else
    timespec_get(&t, TIME_UTC);
#endif
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
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

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

double samples_quantile(struct samples *s, double share)
{
    if (!s->n)
        return 0;
    qsort(s->ns, (size_t)s->n, sizeof *s->ns, by_value);
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
    double now = bench_now();

    l->ns[lap] += now - l->last;
    l->last = now;
}

void laps_phase(void *laps, enum board_phase over)
{
    static const enum lap lap[PHASES] = { LAP_SCRIPTS, LAP_MOTION, LAP_HITS, LAP_EVENTS, LAP_REST };

    laps_end(laps, lap[over]);
}
