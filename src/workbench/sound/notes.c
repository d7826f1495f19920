/*
 * notes.c - see notes.h. A track is played tick by tick with the board's own reader. The loop ends where the reader
 * jumps back, and starts at the target of the jump.
 */
#include "notes.h"
#include "../../common/report.h"

#include <stdio.h>

static const char *const kinds[INST_KINDS] = { "pulse", "triangle", "saw", "sine", "fm",
                                               "noise", "sample",   "fm4", "wave" };

struct walk {
    const struct tune *t;
    char track;
    uint32_t tick;
    bool silent;
};

static void print_inst(const struct walk *w, int i)
{
    const struct inst inst = inst_read(tune_inst(w->t, i));

    report_print("inst %d %s\n", i, inst.kind < INST_KINDS ? kinds[inst.kind] : "other");
}

static void print_event(const struct walk *w, const struct tune_played_event *e)
{
    if (w->silent)
        return;
    report_print("%c %u ", w->track, (unsigned)w->tick);
    switch (e->event) {
    case TUNE_END:
        report_print("end\n");
        break;
    case TUNE_NOTE:
    case TUNE_SLUR:
        report_print("%s %.2f\n", e->event == TUNE_NOTE ? "note" : "slur", e->value / 256.0);
        break;
    case TUNE_OFF:
        report_print("off\n");
        break;
    case TUNE_GLIDE:
        report_print("glide %.2f %d\n", e->value / 256.0, (int)e->value2);
        break;
    case TUNE_INST:
        print_inst(w, e->value);
        break;
    case TUNE_VOLUME:
        report_print("volume %d\n", (int)e->value);
        break;
    case TUNE_PANNING:
        report_print("place %d\n", (int)e->value);
        break;
    case TUNE_TEMPO:
        report_print("tempo %.2f\n", e->value / 100.0);
        break;
    case TUNE_MARKER:
        report_print("mark %s\n", tune_marker_name(w->t, e->value));
        break;
    default: /* shapes a note */
        report_print("event %d %d %d\n", (int)e->event, (int)e->value, (int)e->value2);
    }
}

/* Plays until the reader is at `until`, jumps back (returns the target) or ends (returns 0). */
static uint32_t walk(struct walk *w, int track, uint32_t until)
{
    struct track_cursor c = tune_track_start(w->t, track);

    for (w->tick = 0; c.cursor != 0; w->tick++) {
        const struct track_cursor before = c;
        struct tune_run run = { w->t, track, c, TUNE_TICK, 0, 1, 0 };
        struct tune_played_event e;
        while (tune_next_event(&run, &e))
            print_event(w, &e);
        c = run.cursor;
        /* A loop of one event jumps back to the same position, with all its time left. */
        const bool looped = c.cursor < before.cursor || (c.cursor == before.cursor && c.units_left > before.units_left);
        if (c.cursor == until || (c.cursor != 0 && looped))
            break;
    }
    return c.cursor;
}

void notes_print(const char *name, const struct tune *t)
{
    report_print("tune %s %d %d\n", name, (int)TUNE_QUARTER, t->beats_per_bar);
    for (int i = -1; i < t->n_tracks; i++) {
        struct walk w = { t, i < 0 ? '-' : (char)('A' + i), 0, false };
        const uint32_t at = walk(&w, i, 0);
        if (at == 0)
            continue;
        const uint32_t end = w.tick;
        w.silent = true;
        walk(&w, i, at);
        report_print("%c %u loop %u\n", w.track, (unsigned)end, (unsigned)w.tick);
    }
}
