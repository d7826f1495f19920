/*
 * measure.c - see measure.h.
 */
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>
#include "plan.h"

enum { RADII = 12, MAX_FLIGHT = 240 /* frames that a bullet is followed */, MOVES_GAP = 1 << 18 };

/* ---- the narrowest gap ---- */

/* Returns whether a ship with a larger radius has a path. */
static bool has_path(const struct forecast *f, fx extra_radius, fx x, fx y)
{
    struct reach r;
    struct plan p = { 0 };
    bool good = reach_compute(&r, f, 2 * FX_ONE, extra_radius, x, y) && !reach_is_empty(&r);

    if (good) {
        reach_prune(&r);
        good = plan_make(&p, &r, x, y, MOVES_GAP, 0, 0) && p.frames == f->frames;
    }
    plan_free(&p);
    reach_free(&r);
    return good;
}

/* Returns whether it survives on the path of the run. */
static bool run_survives(const struct forecast *f, fx extra_radius)
{
    for (uint32_t i = 0; i < f->frames; i++)
        if (plan_hits(f, i, &f->frame[i].ship.path, extra_radius))
            return false;
    return true;
}

static void measure_gap(struct measure *m, const struct forecast *f, fx x, fx y)
{
    static const int extra[RADII] = { 0, 2, 5, 10, 15, 20, 30, 40, 60, 80, 120, 160 }; /* tenths of a px of radius */
    int lo = 0, hi = RADII; /* extra[lo] has a path, extra[hi] has none */

    while (lo + 1 < RADII && run_survives(f, (fx)((int64_t)extra[lo + 1] * FX_ONE / 10)))
        lo++;
    while (hi - lo > 1) {
        const int at = (lo + hi) / 2;
        if (has_path(f, (fx)((int64_t)extra[at] * FX_ONE / 10), x, y))
            lo = at;
        else
            hi = at;
    }
    m->gap = m->ship + 2 * extra[lo];
}

/* ---- reaction ---- */

/* Returns the bullet or laser in a frame, or NULL after its end. Dangers are in slot order. */
static const struct danger *find_danger(const struct forecast *f, uint32_t frame, const struct danger *d)
{
    const struct forecast_frame *at = &f->frame[frame];
    uint32_t lo = 0, hi = at->n;

    while (lo < hi) {
        const uint32_t mid = (lo + hi) / 2;
        const struct danger *e = &f->list[at->first + mid];
        if (e->source < d->source || (e->source == d->source && e->slot < d->slot))
            lo = mid + 1;
        else
            hi = mid;
    }
    const struct danger *e = lo < at->n ? &f->list[at->first + lo] : NULL;
    return e && e->source == d->source && e->slot == d->slot ? e : NULL;
}

/* Returns the frames until the bullet would hit a ship that doesn't move, or 0. */
static int until_hit(const struct forecast *f, uint32_t frame, const struct danger *d)
{
    struct danger_path stay = f->frame[frame].ship.path;

    stay.prev_x = stay.x;
    stay.prev_y = stay.y;
    for (uint32_t i = 1; i < MAX_FLIGHT && frame + i < f->frames; i++) {
        if (f->frame[frame + i].n == 0)
            continue;
        const struct danger *now = find_danger(f, frame + i, d);
        if (!now || now->age < d->age)
            return 0;
        if (danger_would_hit(now, &stay))
            return (int)i;
    }
    return 0;
}

static int compare_ints(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static void measure_reaction(struct measure *m, const struct forecast *f)
{
    int *frames = malloc((size_t)(m->fired + 1) * sizeof *frames);

    for (uint32_t i = 0; frames && i < f->frames; i++) {
        const struct forecast_frame *at = &f->frame[i];
        for (uint32_t k = 0; k < at->n; k++) {
            const struct danger *d = &f->list[at->first + k];
            const int until = d->source == DANGER_BULLET && (d->age == 0 || i == 0) ? until_hit(f, i, d) : 0;
            if (until && m->aimed < (int)m->fired)
                frames[m->aimed++] = until;
        }
    }
    if (m->aimed) {
        qsort(frames, (size_t)m->aimed, sizeof *frames, compare_ints);
        m->reaction = frames[m->aimed / 10];
    }
    free(frames);
}

void measure_run(struct measure *m, const struct forecast *course, fx x, fx y)
{
    for (uint32_t i = 0; i < course->frames; i++) {
        m->fired += course->frame[i].fired;
        m->most = course->frame[i].n > m->most ? course->frame[i].n : m->most;
        if (course->frame[i].ship.in_game)
            m->ship = (int)((int64_t)course->frame[i].ship.path.radius * 20 / FX_ONE);
    }
    m->seconds100 = course->frames * 100 / 60;
    for (uint32_t i = 0; course->frames && i < course->frame[0].n; i++) /* older ones */
        m->fired += course->list[i].source != DANGER_ENEMY && course->list[i].age > 0;
    measure_reaction(m, course);
    measure_gap(m, course, x, y);
}

uint32_t measure_per_second(const struct measure *m)
{
    return m->seconds100 ? (uint32_t)((uint64_t)m->fired * 10000 / m->seconds100) : 0;
}

void measure_compare(const struct measure *easier, const struct measure *harder, char *why, size_t size)
{
    const int live = bots_survived(&easier->bots), live_then = bots_survived(&harder->bots);
    const uint32_t rate = measure_per_second(easier), rate_then = measure_per_second(harder);
    const uint32_t last = bots_mean(&easier->bots), last_then = bots_mean(&harder->bots);

    why[0] = 0;
    if (live + 2 < live_then)
        snprintf(why, size, "%d of %d bots survive, compared with %d", live, bots_count(&easier->bots), live_then);
    else if (live <= live_then && last + last / 5 + 60 < last_then)
        snprintf(why, size, "bots survive %u.%u s on average, compared with %u.%u", (unsigned)(last / 60),
                 (unsigned)(last / 6 % 10), (unsigned)(last_then / 60), (unsigned)(last_then / 6 % 10));
    else if (rate > rate_then + rate_then / 10 + 100 && live <= live_then)
        snprintf(why, size, "%u bullets per second, compared with %u", (unsigned)(rate / 100),
                 (unsigned)(rate_then / 100));
    else if (easier->gap > 0 && easier->gap + 20 < harder->gap && live <= live_then)
        snprintf(why, size, "narrowest gap %d.%d px, compared with %d.%d", easier->gap / 10, easier->gap % 10,
                 harder->gap / 10, harder->gap % 10);
}
