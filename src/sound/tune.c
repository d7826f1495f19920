/*
 * tune.c - see tune.h. tune_validate checks once that every event of every track is valid, that a loop starts at an
 * event and has a length, and that names are terminated. A run reads at most MAX_EVENTS_PER_RUN events, so that a track
 * with many simultaneous events does not make a tick slow.
 */
#include "tune.h"

#include <stdio.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "adpcm.h"
#include "pitch.h"

enum { MAX_EVENTS_PER_RUN = 64 };

static const uint8_t value_bytes[TUNE_EVENTS] = {
    [TUNE_NOTE] = 2,   [TUNE_SLUR] = 2,    [TUNE_GLIDE] = 4, [TUNE_INST] = 1,
    [TUNE_VOLUME] = 1, [TUNE_PANNING] = 1, [TUNE_TEMPO] = 2, [TUNE_MARKER] = 1,
};

/* ---- sections ---- */

enum { TRACK_TABLE_OFFSET = TUNE_HEADER_SIZE + TUNE_TITLE_SIZE, TRACK_ENTRY_BYTES = 8 };

static size_t insts_offset(const struct tune *t)
{
    return TRACK_TABLE_OFFSET + TRACK_ENTRY_BYTES * ((size_t)t->n_tracks + 1);
}

static size_t markers_offset(const struct tune *t)
{
    return insts_offset(t) + INST_BYTES * (size_t)t->n_insts;
}

struct tune tune_of(const uint8_t *p)
{
    return (struct tune){ .data = p,
                          .n_tracks = p[5],
                          .n_insts = p[6],
                          .n_markers = p[7],
                          .volume = p[1],
                          .priority = p[2],
                          .limit = p[3],
                          .beats_per_bar = p[4],
                          .channels = p[20],
                          .duck = p[TUNE_DUCK_AT],
                          .tempo = bytes_get32(p + 8),
                          .loop_units = bytes_get32(p + 24),
                          .lead = bytes_get32(p + 28) };
}

const char *tune_title(const struct tune *t)
{
    return (const char *)t->data + TUNE_HEADER_SIZE;
}

const char *tune_marker_name(const struct tune *t, int i)
{
    return (const char *)t->data + markers_offset(t) + TUNE_NAME_SIZE * (size_t)i;
}

const uint8_t *tune_inst(const struct tune *t, int i)
{
    return t->data + insts_offset(t) + INST_BYTES * (size_t)i;
}

/* track_start returns the offset where track i starts (-1: the conductor); track_loop, the offset where its loop
 * starts, or 0 if it has none. */
static uint32_t track_start(const struct tune *t, int i)
{
    return bytes_get32(t->data + TRACK_TABLE_OFFSET + TRACK_ENTRY_BYTES * (i + 1));
}

static uint32_t track_loop(const struct tune *t, int i)
{
    return bytes_get32(t->data + TRACK_TABLE_OFFSET + TRACK_ENTRY_BYTES * (i + 1) + 4);
}

bool tune_is_recording(const struct tune *t)
{
    return t->channels > 0;
}

bool tune_is_stream(const struct tune *t)
{
    return t->channels > 0 && bytes_get32(t->data + 12) == 0;
}

bool tune_is_endless(const struct tune *t)
{
    for (int i = 0; i < t->n_tracks; i++)
        if (track_loop(t, i))
            return true;
    return false;
}

/* ---- reading events ---- */

/* Reads the number of ticks at *at and advances *at past it. */
static uint32_t read_ticks(const uint8_t *data, uint32_t *at)
{
    uint32_t v = 0;

    for (int shift = 0; shift < 28; shift += 7) {
        const uint8_t b = data[(*at)++];
        v |= (uint32_t)(b & 127) << shift;
        if (b < 128)
            break;
    }
    return v;
}

struct track_cursor tune_track_start(const struct tune *t, int i)
{
    struct track_cursor c = { track_start(t, i), 0 };

    c.units_left = (int64_t)read_ticks(t->data, &c.cursor) * TUNE_TICK + (i < 0 ? (int64_t)t->lead * t->tempo : 0);
    return c;
}

/* Reads the event at c and moves c to the next one. Returns false for the end of a loop, which is not reported as an
 * event. */
static bool read_event(const struct tune *t, int track, struct track_cursor *c, struct tune_played_event *e)
{
    const uint8_t *p = t->data + c->cursor;

    e->event = p[0];
    e->value = p[1];
    e->value2 = 0;
    if (e->event == TUNE_END) {
        c->cursor = track_loop(t, track);
        if (c->cursor == 0)
            return true;
        c->units_left += t->loop_units;
    } else {
        c->cursor += 1u + value_bytes[e->event];
        if (value_bytes[e->event] >= 2)
            e->value = bytes_get16(p + 1);
        if (value_bytes[e->event] == 4)
            e->value2 = bytes_get16(p + 3);
    }
    c->units_left += (int64_t)read_ticks(t->data, &c->cursor) * TUNE_TICK;
    return p[0] != TUNE_END;
}

bool tune_next_event(struct tune_run *r, struct tune_played_event *e)
{
    struct track_cursor *c = &r->cursor;

    for (; c->cursor != 0 && r->events_read < MAX_EVENTS_PER_RUN; r->events_read++) {
        const int64_t at = c->units_left <= 0 ? 0 : (c->units_left + r->tempo - 1) / r->tempo;
        if (at >= r->n)
            break;
        e->sample = r->first + (int)at;
        if (read_event(r->t, r->track, c, e)) {
            r->events_read++;
            return true;
        }
    }
    c->units_left -= (int64_t)r->n * r->tempo;
    return false;
}

/* ---- checks ---- */

struct check {
    const struct tune *t;
    uint32_t end; /* end offset of the tracks */
    char *err;
    size_t err_size;
};

static bool fail(const struct check *c, int track, const char *problem)
{
    return track < 0 ? err_set(c->err, c->err_size, "conductor: %s", problem)
                     : err_set(c->err, c->err_size, "track %d: %s", track + 1, problem);
}

static bool ticks_ok(const struct check *c, uint32_t *at, uint32_t *ticks)
{
    const uint32_t from = *at;

    if (from + 5 > c->end)
        return false;
    *ticks = read_ticks(c->t->data, at);
    return *ticks <= TUNE_MAX_PAUSE && (*at - from < 4 || c->t->data[*at - 1] < 128);
}

static bool values_ok(const struct tune *t, int track, const uint8_t *p)
{
    switch (p[0]) {
    case TUNE_NOTE:
    case TUNE_SLUR:
    case TUNE_GLIDE:
        return track >= 0 && bytes_get16(p + 1) <= PITCH_MAX / 256;
    case TUNE_OFF:
        return track >= 0;
    case TUNE_INST:
        return track >= 0 && p[1] < t->n_insts;
    case TUNE_VOLUME:
        return track >= 0 && p[1] <= TUNE_MAX_VOLUME;
    case TUNE_PANNING:
        return track >= 0 && p[1] <= 2 * TUNE_PAN_CENTRE;
    case TUNE_TEMPO:
        return track < 0 && bytes_get16(p + 1) >= TEMPO_MIN && bytes_get16(p + 1) <= TEMPO_MAX;
    case TUNE_MARKER:
        return track < 0 && p[1] < t->n_markers;
    default:
        return true;
    }
}

static bool track_ok(const struct check *c, int track)
{
    const uint32_t loop = track_loop(c->t, track);
    uint32_t at = track_start(c->t, track), ticks;
    uint64_t loop_ticks = 0; /* ticks since the loop's start */
    bool loop_found = loop == 0;

    if (at < markers_offset(c->t) + TUNE_NAME_SIZE * (size_t)c->t->n_markers || at >= c->end)
        return fail(c, track, "its start is out of range");
    for (;;) {
        if (at == loop) {
            loop_found = true;
            loop_ticks = 0;
        }
        if (!ticks_ok(c, &at, &ticks))
            return fail(c, track, "it runs past the end of the tune");
        loop_ticks += ticks;
        const uint8_t *p = c->t->data + at;
        if (p[0] >= TUNE_EVENTS || at + 1 + value_bytes[p[0]] > c->end || !values_ok(c->t, track, p))
            return fail(c, track, "an event is unknown or out of range");
        if (p[0] == TUNE_END)
            return loop_found && (loop == 0 || loop_ticks > 0) ? true : fail(c, track, "its loop has no length");
        at += 1u + value_bytes[p[0]];
    }
}

static bool name_ok(const char *s, size_t n)
{
    size_t end = 0;

    while (end < n && s[end])
        if ((unsigned char)s[end] < 32 || s[end++] == 127)
            return false;
    for (size_t i = end; i < n; i++)
        if (s[i])
            return false;
    return end < n;
}

bool tune_validate(const uint8_t *data, size_t size, char *err, size_t err_size)
{
    if (size < TUNE_HEADER_SIZE + TUNE_TITLE_SIZE || data[0] != TUNE_FORMAT || bytes_get32(data + 16) != size ||
        bytes_get16(data + 22) != 0)
        return err_set(err, err_size, "not a tune in format %d", TUNE_FORMAT);
    const struct tune t = tune_of(data);
    const uint32_t sample_at = bytes_get32(data + 12);
    struct check c = { &t, sample_at ? sample_at : (uint32_t)size, err, err_size };
    if (t.n_tracks < 1 || t.n_tracks > TUNE_MAX_TRACKS || t.n_insts > TUNE_MAX_INSTS ||
        t.n_markers > TUNE_MAX_MARKERS || t.priority > 7 || t.limit < 1 || t.limit > 8 || t.beats_per_bar < 1 ||
        t.tempo < TEMPO_MIN || t.tempo > TEMPO_MAX || t.channels > TUNE_MAX_CHANNELS ||
        (t.channels == 0 && sample_at) || t.loop_units >= TUNE_TICK || t.lead > TUNE_MAX_LEAD)
        return err_set(err, err_size, "its header is out of range");
    if (size > UINT32_MAX / 2 || c.end > size || c.end > TUNE_MAX_BYTES + 4 ||
        markers_offset(&t) + TUNE_NAME_SIZE * (size_t)t.n_markers > c.end || sample_at % 4 != 0)
        return err_set(err, err_size, "shorter than its header says");
    if (!name_ok(tune_title(&t), TUNE_TITLE_SIZE))
        return err_set(err, err_size, "its title is not a single line of text");
    if (sample_at && !samples_are_valid(data + sample_at, size - sample_at, t.channels))
        return err_set(err, err_size, "its samples are invalid");
    for (int i = 0; i < t.n_insts; i++)
        if (!inst_is_valid(tune_inst(&t, i), (size_t)(data + c.end - tune_inst(&t, i)), tune_is_recording(&t)) ||
            !name_ok(inst_sample_name(tune_inst(&t, i)), INST_NAME_SIZE))
            return err_set(err, err_size, "instrument %d is out of range", i + 1);
    for (int i = 0; i < t.n_markers; i++)
        if (!name_ok(tune_marker_name(&t, i), TUNE_NAME_SIZE))
            return err_set(err, err_size, "marker %d has no name", i + 1);
    for (int i = -1; i < t.n_tracks; i++)
        if (!track_ok(&c, i))
            return false;
    return true;
}
