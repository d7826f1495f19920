/*
 * seq.c - see seq.h. A frame in which the conductor changes the tempo is played in sections, so that all tracks change
 * tempo at exactly the same sample.
 */
#include "seq.h"

#include "../base/int.h"

#define WHY_DERIVED "computed from tune and pos"
static const struct column seq_columns[] = {
    REGISTER(seq, tune),
    REGISTER(seq, next_tune),
    REGISTER(seq, fade_frames_left),
    REGISTER(seq, fade_length),
    REGISTER(seq, marker),
    REGISTER(seq, markers_passed),
    REGISTER(seq, tempo),
    REGISTER(seq, pos),
    REGISTER(seq, next_suspends),
    REGISTER(seq, next_is_scheduled),
    REGISTER(seq, next_start),
    REGISTER(seq, level),
    REGISTER(seq, level_target),
    REGISTER(seq, level_frames),
    REGISTER(seq, is_skipping),
    REGISTER(seq, frames_ahead),
    REGISTER(seq, frames_skipped),
    REGISTERS(seq, started_tunes),
    REGISTER(seq, suspended_count),
    REGISTERS(seq, suspended_tune),
    REGISTERS(seq, suspended_marker),
    REGISTERS(seq, suspended_markers_passed),
    REGISTERS(seq, suspended_tempo),
    REGISTERS(seq, suspended_pos),
    DERIVED_COLUMN(seq, at, WHY_DERIVED),
    DERIVED_COLUMN(seq, units_left, WHY_DERIVED),
    DERIVED_COLUMN(seq, inst, WHY_DERIVED),
    DERIVED_COLUMN(seq, volume, WHY_DERIVED),
    DERIVED_COLUMN(seq, pan, WHY_DERIVED),
};
static const struct column cues_columns[] = {
    COLUMN(cues, tune),       COLUMN(cues, start_frame), COLUMN(cues, track),  COLUMN(cues, at),
    COLUMN(cues, units_left), COLUMN(cues, inst),        COLUMN(cues, volume), COLUMN(cues, pan),
    COLUMN(cues, cue_volume), COLUMN(cues, pan_offset),  COLUMN(cues, pitch),  REGISTERS(cues, last_played),
};

const struct chip seq_chip = { .name = "music", CHIP_COLUMNS(seq_columns), .is_list = true };
const struct chip cues_chip = { .name = "cues", CHIP_COLUMNS(cues_columns), .is_list = true, .unhashed = true };

enum { INITIAL_VOLUME = 100 };

void seq_cancel_next(struct seq *s)
{
    s->next_tune = s->fade_frames_left = s->fade_length = 0;
    s->next_suspends = s->next_is_scheduled = 0;
    s->next_start = 0;
}

void seq_start(struct seq *s, uint16_t index, const struct tune *t)
{
    s->tune = index;
    seq_cancel_next(s);
    s->marker = 0;
    s->markers_passed = 0;
    s->pos = index ? 0 - (uint64_t)t->lead * t->tempo : 0;
    s->tempo = index ? t->tempo : 0;
    for (int i = 0; i < SEQ_TRACKS; i++) {
        const struct track_cursor c =
            index && i <= t->n_tracks ? tune_track_start(t, i - 1) : (struct track_cursor){ 0, 0 };
        s->at[i] = c.cursor;
        s->units_left[i] = c.units_left;
        s->inst[i] = 0;
        s->volume[i] = INITIAL_VOLUME;
        s->pan[i] = TUNE_PAN_CENTRE;
    }
}

/* Copies the track slots of piece `from` to those of piece `to`; 0: the current piece, 1 + i: suspended piece i. */
static void copy_tracks(struct seq *s, int to, int from)
{
    slots_copy_rows(&seq_chip, s, (uint32_t)(to * SEQ_TRACKS), (uint32_t)(from * SEQ_TRACKS), SEQ_TRACKS);
}

void seq_suspend(struct seq *s)
{
    const int i = s->suspended_count;

    if (i == SEQ_MAX_SUSPENDED || !s->tune)
        return;
    s->suspended_tune[i] = s->tune;
    s->suspended_marker[i] = s->marker;
    s->suspended_markers_passed[i] = s->markers_passed;
    s->suspended_tempo[i] = s->tempo;
    s->suspended_pos[i] = s->pos;
    copy_tracks(s, 1 + i, 0);
    s->suspended_count++;
}

void seq_drop_suspended_from(struct seq *s, int i)
{
    while (s->suspended_count > i) {
        const int last = --s->suspended_count;
        s->suspended_tune[last] = s->suspended_marker[last] = 0;
        s->suspended_markers_passed[last] = s->suspended_tempo[last] = 0;
        s->suspended_pos[last] = 0;
    }
}

void seq_drop_suspended(struct seq *s, int i)
{
    for (; i + 1 < s->suspended_count; i++) {
        s->suspended_tune[i] = s->suspended_tune[i + 1];
        s->suspended_marker[i] = s->suspended_marker[i + 1];
        s->suspended_markers_passed[i] = s->suspended_markers_passed[i + 1];
        s->suspended_tempo[i] = s->suspended_tempo[i + 1];
        s->suspended_pos[i] = s->suspended_pos[i + 1];
        copy_tracks(s, 1 + i, 2 + i);
    }
    seq_drop_suspended_from(s, i);
}

void seq_resume(struct seq *s)
{
    const int i = s->suspended_count - 1;

    s->tune = s->suspended_tune[i];
    s->marker = s->suspended_marker[i];
    s->markers_passed = s->suspended_markers_passed[i];
    s->tempo = s->suspended_tempo[i];
    s->pos = s->suspended_pos[i];
    seq_cancel_next(s);
    copy_tracks(s, 0, 1 + i);
    seq_drop_suspended_from(s, i);
}

int seq_find_suspended(const struct seq *s, uint16_t index)
{
    int i = s->suspended_count - 1;

    while (i >= 0 && s->suspended_tune[i] != index)
        i--;
    return i;
}

bool seq_has_ended(const struct seq *s)
{
    for (int i = 1; i < SEQ_TRACKS; i++)
        if (s->at[i] != 0)
            return false;
    return true;
}

/* Reads the conductor's events from the current position on, ignoring their times: up to the end of the loop, then the
 * whole loop again. A run of simultaneous events that wraps around stops before the position where it started,
 * because a loop has a length; so the run passes the loop's end only once. */
bool seq_has_marker_ahead(const struct seq *s, const struct tune *t, int mark, uint32_t *work)
{
    struct track_cursor c = { s->at[0], 0 };
    struct tune_played_event e;
    bool found = false;
    int loops = 0;

    *work = 0;
    while (c.cursor != 0 && loops < 2 && !found) {
        struct tune_run r = { t, -1, { c.cursor, 0 }, 1, 0, 1, 0 };
        for (; tune_next_event(&r, &e); ++*work)
            found = found || (e.event == TUNE_MARKER && e.value == mark);
        ++*work;
        loops += r.cursor.cursor <= c.cursor;
        c = r.cursor;
    }
    return found;
}

/* Stores the setting of a track that an event changes. */
static void store_track_setting(uint8_t *inst, uint8_t *volume, uint8_t *pan, const struct tune_played_event *e)
{
    if (e->event == TUNE_INST)
        *inst = (uint8_t)e->value;
    if (e->event == TUNE_VOLUME)
        *volume = (uint8_t)e->value;
    if (e->event == TUNE_PANNING)
        *pan = (uint8_t)e->value;
}

/* Stores the setting that an event of the conductor changes. */
static void store_conductor_setting(struct seq *s, const struct tune_played_event *e)
{
    if (e->event == TUNE_TEMPO)
        s->tempo = (uint32_t)e->value;
    if (e->event == TUNE_MARKER) {
        s->marker = (uint16_t)(e->value + 1);
        s->markers_passed++;
    }
}

/* Returns a run over n samples of the frame, from sample `first` on, at the current tempo. slot: 0: the
 * conductor, 1 + i: track i. */
static struct tune_run run_of(const struct seq *s, const struct tune *t, int slot, int first, int n)
{
    return (struct tune_run){ t, slot - 1, { s->at[slot], s->units_left[slot] }, s->tempo, first, n, 0 };
}

static void store_cursor(struct seq *s, int slot, const struct tune_run *r)
{
    s->at[slot] = r->cursor.cursor;
    s->units_left[slot] = r->cursor.units_left;
}

/* Executes the conductor's events that are due at sample `first`. Returns the number of samples until its next event,
 * at least 1 and at most the rest of the frame. */
static int step_conductor(struct seq *s, const struct tune *t, int first)
{
    const uint32_t tempo = s->tempo;
    struct tune_run r = run_of(s, t, 0, first, 1);
    struct tune_played_event e;

    while (tune_next_event(&r, &e))
        store_conductor_setting(s, &e);
    store_cursor(s, 0, &r);
    s->units_left[0] += tempo; /* the events of this one sample are done, but no time has passed */
    const int64_t left =
        s->at[0] == 0 || s->units_left[0] <= 0 ? SND_FRAME : (s->units_left[0] + s->tempo - 1) / s->tempo;
    return left < 1 ? 1 : left > SND_FRAME - first ? SND_FRAME - first : (int)left;
}

void seq_schedule_next(struct seq *s, int beats)
{
    const uint64_t step = (uint64_t)beats * TUNE_QUARTER * TUNE_TICK;

    s->next_is_scheduled = 1;
    s->next_start = (int64_t)s->pos < 0 ? 0 : s->pos / step * step + step;
}

/* Returns the number of samples until the next piece starts, at most SND_FRAME. */
static int samples_until_next(const struct seq *s)
{
    const int64_t left = (int64_t)(s->next_start - s->pos);

    if (!s->next_is_scheduled || left > (int64_t)SND_FRAME * s->tempo)
        return SND_FRAME;
    return left <= 0 ? 0 : (int)((left + s->tempo - 1) / s->tempo);
}

/* A frame is read in sections. A section ends at the conductor's next event, where the next piece starts, or with the
 * frame. */
bool seq_next_event(struct seq_run *w, struct tune_played_event *e)
{
    struct seq *s = w->s;

    for (;;) {
        if (w->slot == 0) {
            if (w->first >= SND_FRAME || samples_until_next(s) == 0)
                return false;
            const int until_conductor = step_conductor(s, w->t, w->first);
            const int n = int_min(until_conductor, samples_until_next(s));
            s->units_left[0] -= (int64_t)n * s->tempo;
            w->slot = 1;
            w->run = run_of(s, w->t, 1, w->first, n);
        }
        for (; w->slot <= w->t->n_tracks; w->run = run_of(s, w->t, w->slot, w->first, w->run.n)) {
            if (tune_next_event(&w->run, e)) {
                store_track_setting(&s->inst[w->slot], &s->volume[w->slot], &s->pan[w->slot], e);
                return true;
            }
            store_cursor(s, w->slot++, &w->run);
        }
        s->pos += (uint64_t)w->run.n * s->tempo;
        w->first += w->run.n;
        w->slot = 0;
    }
}

/* ---- cues ---- */

static void end_cue(struct cues *c, int i)
{
    c->tune[i] = 0;
    c->at[i] = 0;
    c->units_left[i] = 0;
}

/* Ends the instance of a sound that started in frame `start_frame`. Returns a bit for each of its slots. */
static uint32_t end_sound(struct cues *c, uint32_t tune, uint32_t start_frame)
{
    uint32_t ended = 0;

    for (int i = 0; i < CUE_SLOTS; i++)
        if (c->tune[i] == tune && c->start_frame[i] == start_frame) {
            end_cue(c, i);
            ended |= 1u << i;
        }
    return ended;
}

/* Returns whether the same sound already started in this frame; if so, raises its volume to cue->volume if that is
 * higher. */
static bool join_same_cue(struct cues *c, const struct cue *cue, uint32_t frame)
{
    bool found = false;

    for (int i = 0; i < CUE_SLOTS; i++)
        if (c->tune[i] == cue->tune && c->start_frame[i] == frame) {
            found = true;
            if (cue->volume > c->cue_volume[i])
                c->cue_volume[i] = cue->volume;
        }
    return found;
}

/* Returns the first slot of the oldest playing instance of a sound, or -1. Stores the number of instances in *n. */
static int find_oldest(const struct cues *c, uint32_t tune, int *n)
{
    int oldest = -1;

    *n = 0;
    for (int i = 0; i < CUE_SLOTS; i++) {
        if (c->tune[i] != tune || c->track[i] != 0)
            continue;
        ++*n;
        if (oldest < 0 || c->start_frame[i] < c->start_frame[oldest])
            oldest = i;
    }
    return oldest;
}

static int priority_of(const struct cues *c, const uint8_t *rom, int i)
{
    return tune_of(rom + c->tune[i]).priority;
}

/* Returns a free slot, preferably one whose voice is silent; otherwise the slot to replace, or -1 if every slot's
 * sound has a higher priority, or the same priority and started in this frame. ringing: a bit for each slot whose voice
 * still sounds. */
static int find_slot(const struct cues *c, const uint8_t *rom, int priority, uint32_t frame, uint32_t ringing)
{
    int replaceable = -1, free_slot = -1;

    for (int i = CUE_SLOTS - 1; i >= 0; i--)
        if (c->tune[i] == 0 && (free_slot < 0 || !(ringing >> i & 1) || ringing >> free_slot & 1))
            free_slot = i;
    if (free_slot >= 0)
        return free_slot;
    for (int i = 0; i < CUE_SLOTS; i++) {
        const int p = priority_of(c, rom, i);
        if (p > priority || (p == priority && c->start_frame[i] == frame))
            continue;
        if (replaceable < 0 || p < priority_of(c, rom, replaceable) ||
            (p == priority_of(c, rom, replaceable) && c->start_frame[i] < c->start_frame[replaceable]))
            replaceable = i;
    }
    return replaceable;
}

static void set_cue(struct cues *c, int i, const struct tune *t, int track, const struct cue *cue, uint32_t frame)
{
    const struct track_cursor cursor = tune_track_start(t, track);

    c->tune[i] = cue->tune;
    c->start_frame[i] = frame;
    c->track[i] = (uint8_t)track;
    c->at[i] = cursor.cursor;
    c->units_left[i] = cursor.units_left;
    c->inst[i] = 0;
    c->volume[i] = INITIAL_VOLUME;
    c->pan[i] = TUNE_PAN_CENTRE;
    c->cue_volume[i] = cue->volume;
    c->pan_offset[i] = cue->pan_offset;
    c->pitch[i] = cue->pitch;
}

uint32_t cues_start(struct cues *c, const uint8_t *rom, const struct cue *cue, uint32_t frame, uint32_t ringing)
{
    const struct tune t = tune_of(rom + cue->tune);
    uint32_t ended = 0;
    int n, oldest = find_oldest(c, cue->tune, &n);

    if (join_same_cue(c, cue, frame))
        return 0;
    if (n >= t.limit)
        ended = end_sound(c, cue->tune, c->start_frame[oldest]);
    for (int track = 0; track < t.n_tracks; track++) {
        const int i = find_slot(c, rom, t.priority, frame, ringing);
        if (i < 0)
            break;
        if (c->tune[i])
            ended |= end_sound(c, c->tune[i], c->start_frame[i]);
        set_cue(c, i, &t, track, cue, frame);
    }
    return ended;
}

uint32_t cues_stop(struct cues *c, uint32_t tune)
{
    uint32_t ended = 0;

    for (int i = 0; i < CUE_SLOTS; i++)
        if (c->tune[i] && (!tune || c->tune[i] == tune))
            ended |= end_sound(c, c->tune[i], c->start_frame[i]);
    return ended;
}

bool cues_next_event(struct cues *c, const uint8_t *rom, struct cues_run *w, struct tune_played_event *e)
{
    for (; w->slot < CUE_SLOTS; w->slot++, w->begun = false) {
        const int i = w->slot;
        if (!c->tune[i])
            continue;
        if (!w->begun) {
            w->t = tune_of(rom + c->tune[i]);
            w->run =
                (struct tune_run){ &w->t, c->track[i], { c->at[i], c->units_left[i] }, w->t.tempo, 0, SND_FRAME, 0 };
            w->begun = true;
        }
        if (tune_next_event(&w->run, e)) {
            store_track_setting(&c->inst[i], &c->volume[i], &c->pan[i], e);
            return true;
        }
        c->at[i] = w->run.cursor.cursor;
        c->units_left[i] = w->run.cursor.units_left;
        if (c->at[i] == 0)
            end_cue(c, i);
    }
    return false;
}
