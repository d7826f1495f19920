/*
 * tune_time.c - see tune_time.h. Reads the events of a tune in order without playing it, and adds up their time.
 */
#include "tune_time.h"

#include <math.h>
#include "../../sound/pitch.h"

enum { MOST_EVENTS = 1 << 21 };

/* A walk along a track; the conductor's gets the tempos. */
struct walk {
    const struct tune *t;
    int track;
    struct track_cursor at;
    int64_t units; /* of the next event */
    int loops;     /* ends of its loop so far */
    uint32_t tempo;
};

static struct walk begin(const struct tune *t, int track)
{
    struct walk w = { t, track, tune_track_start(t, track), 0, 0, t->tempo };

    w.units = w.at.units_left;
    return w;
}

/* Reads the events of one moment; false: the track has ended. */
static bool step(struct walk *w)
{
    const uint32_t was = w->at.cursor;
    struct tune_run run = { w->t, w->track, { was, 0 }, 1, 0, 1, 0 };
    struct tune_played_event e;

    if (was == 0)
        return false;
    while (tune_next_event(&run, &e))
        if (e.event == TUNE_TEMPO)
            w->tempo = (uint32_t)e.value;
    w->at = run.cursor;
    w->loops += w->at.cursor <= was;
    if (w->at.cursor != 0)
        w->units += w->at.units_left + 1;
    return true;
}

/* Units at the end of a track, or of its first loop; *loop: length of the loop, 0: none. */
static int64_t units_of(const struct tune *t, int track, int64_t *loop)
{
    struct walk w = begin(t, track);
    int64_t end = 0, ends[2] = { 0 };
    int seen = 0;

    *loop = 0;
    for (int i = 0; i < MOST_EVENTS && seen < 2; i++) {
        const int before = w.loops;
        end = w.units;
        if (!step(&w))
            return end;
        if (w.at.cursor != 0 && w.loops > before)
            ends[seen++] = end;
    }
    *loop = ends[1] - ends[0];
    return ends[0];
}

/* Seconds until `units`, by the conductor's tempos. */
static double seconds(const struct tune *t, int64_t units)
{
    struct walk w = begin(t, -1);
    int64_t at = 0;
    double sum = 0;

    for (int i = 0; i < MOST_EVENTS && w.at.cursor != 0 && w.units < units; i++) {
        const uint32_t tempo = w.tempo;
        const int64_t next = w.units;
        sum += (double)(next - at) / tempo / SND_RATE;
        at = next;
        step(&w);
    }
    return sum + (double)(units - at) / w.tempo / SND_RATE;
}

struct tune_time tune_time(const struct tune *t)
{
    int64_t end = 0, loop = 0;

    for (int i = 0; i < t->n_tracks; i++) {
        int64_t repeats;
        const int64_t u = units_of(t, i, &repeats);
        end = u > end ? u : end;
        loop = repeats > loop ? repeats : loop;
    }
    const double all = seconds(t, end);
    return (struct tune_time){ all, loop ? seconds(t, end + loop) - all : 0 };
}
