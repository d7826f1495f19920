/*
 * tune_time.c - see tune_time.h. Reads the events of a tune in order without playing it, and adds up their time.
 */
#include "tune_time.h"

#include <math.h>
#include "../../sound/pitch.h"

enum { MAX_EVENTS = 1 << 21 };

/* Iterates over a track; on the conductor's track, it also follows the tempo. */
struct walk {
    const struct tune *t;
    int track;
    struct track_cursor position;
    int64_t units; /* of the next event */
    int loops;     /* how often the loop has ended */
    uint32_t tempo;
};

static struct walk walk_start(const struct tune *t, int track)
{
    struct walk w = { t, track, tune_track_start(t, track), 0, 0, t->tempo };

    w.units = w.position.units_left;
    return w;
}

/* Reads the events at one time; false: the track has ended. */
static bool walk_step(struct walk *w)
{
    const uint32_t was = w->position.cursor;
    struct tune_run run = { w->t, w->track, { was, 0 }, 1, 0, 1, 0 };
    struct tune_played_event e;

    if (was == 0)
        return false;
    while (tune_next_event(&run, &e))
        if (e.event == TUNE_TEMPO)
            w->tempo = (uint32_t)e.value;
    w->position = run.cursor;
    w->loops += w->position.cursor <= was;
    if (w->position.cursor != 0)
        w->units += w->position.units_left + 1;
    return true;
}

/* Returns the units up to the end of a track, or of its first loop. *loop: length of the loop, 0: none. */
static int64_t track_units(const struct tune *t, int track, int64_t *loop)
{
    struct walk w = walk_start(t, track);
    int64_t end = 0, ends[2] = { 0 };
    int loops_seen = 0;

    *loop = 0;
    for (int i = 0; i < MAX_EVENTS && loops_seen < 2; i++) {
        const int before = w.loops;
        end = w.units;
        if (!walk_step(&w))
            return end;
        if (w.position.cursor != 0 && w.loops > before)
            ends[loops_seen++] = end;
    }
    *loop = ends[1] - ends[0];
    return ends[0];
}

/* Converts units to seconds by the conductor's tempos. */
static double units_to_seconds(const struct tune *t, int64_t units)
{
    struct walk w = walk_start(t, -1);
    int64_t now = 0;
    double sum = 0;

    for (int i = 0; i < MAX_EVENTS && w.position.cursor != 0 && w.units < units; i++) {
        const uint32_t tempo = w.tempo;
        const int64_t next = w.units;
        sum += (double)(next - now) / tempo / SND_RATE;
        now = next;
        walk_step(&w);
    }
    return sum + (double)(units - now) / w.tempo / SND_RATE;
}

struct tune_time tune_time(const struct tune *t)
{
    int64_t end = 0, loop = 0;

    for (int i = 0; i < t->n_tracks; i++) {
        int64_t repeats;
        const int64_t u = track_units(t, i, &repeats);
        end = u > end ? u : end;
        loop = repeats > loop ? repeats : loop;
    }
    const double all = units_to_seconds(t, end);
    return (struct tune_time){ all, loop ? units_to_seconds(t, end + loop) - all : 0 };
}
