/*
 * simulate.c - see simulate.h. A refresh is a moment k / hz; what was handed in last before it is what it shows.
 */
#include "simulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/base/rng.h"
#include "../../../src/player/play/pace.h"

enum { START = 5000000 /* usec: no clock begins at 0 */ };

struct host {
    const struct simulate *s;
    struct rng rng;
    double now; /* usec */
    double from;
    int32_t *shown; /* ticks, by refresh */
    int64_t n;      /* refreshes */
};

static double between(struct host *h, double lo, double hi)
{
    return lo + (hi - lo) * (double)(rng_next(&h->rng) >> 11) / 9007199254740992.0;
}

static double refresh_at(const struct host *h, int64_t k)
{
    return h->from + (double)k * 1e6 / h->s->hz;
}

/* The first refresh that is not before now. */
static int64_t next_refresh(const struct host *h)
{
    return (int64_t)ceil((h->now - h->from) * h->s->hz / 1e6);
}

static void show(struct host *h, int64_t ticks, struct simulated *out)
{
    const int64_t k = next_refresh(h);

    if (k < h->n)
        h->shown[k] = (int32_t)ticks;
    if (h->s->waits)
        h->now = refresh_at(h, k) + between(h, 0, h->s->late);
    (void)out;
}

static void work(struct host *h)
{
    const bool stalls = h->s->stalls && rng_next(&h->rng) % (uint64_t)h->s->stalls == 0;

    h->now += stalls ? 25000 : between(h, h->s->work[0], h->s->work[1]);
}

/* What each refresh shows: where nothing new came, what was there. */
static void count(struct host *h, struct simulated *out)
{
    int64_t was = -1;

    for (int64_t k = 0; k < h->n; k++) {
        int64_t now = h->shown[k] ? h->shown[k] : was;
        if (was > 0) {
            out->refreshes++;
            out->with[now - was > 3 ? 3 : now - was]++;
        }
        was = now;
    }
    out->least = (int64_t)fabs((double)out->refreshes * (60 / h->s->hz - 1));
}

struct simulated simulate(const struct simulate *s)
{
    struct host h = { .s = s, .from = START + 3333, .now = START, .n = (int64_t)(s->hz * s->seconds) };
    struct simulated out = { 0 };
    struct pace pace;
    int64_t frames = 0;

    h.shown = calloc((size_t)h.n, sizeof *h.shown);
    if (!h.shown)
        return out;
    rng_seed(&h.rng, s->seed);
    pace_open(&pace, (uint64_t)h.now);
    while (h.now < START + 1e6 * s->seconds) {
        pace_refresh(&pace, s->waits ? (int)lrint(s->told * 1000) : 0, (uint64_t)h.now);
        const double due = (double)pace_due(&pace);
        if (due > h.now)
            h.now = due + between(&h, 0, s->late);
        if (!pace_frame_due(&pace, (uint64_t)h.now))
            continue;
        const double began = h.now;
        out.ticks += pace_take(&pace, (uint64_t)h.now).ticks;
        out.off = fmax(out.off, fabs((double)out.ticks - 1 - (h.now - START) * 60 / 1e6));
        work(&h);
        pace_worked(&pace, (uint64_t)(h.now - began));
        const double shown = refresh_at(&h, next_refresh(&h)) - began;
        show(&h, out.ticks, &out);
        out.mean += shown;
        out.most = fmax(out.most, shown);
        frames++;
    }
    out.mean /= (double)(frames ? frames : 1);
    count(&h, &out);
    free(h.shown);
    return out;
}

int64_t simulated_uneven(const struct simulated *s)
{
    return s->with[0] + s->with[2] + 2 * s->with[3] - s->least;
}
