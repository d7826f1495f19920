/*
 * recording.c - see recording.h. The result is a tune with a track for each channel, whose only note lasts to the end
 * or loops. The conductor has the markers: its time starts at the first beat, and its loop is exactly as long as that
 * of the samples, because the header has the units beyond whole ticks.
 */
#include "recording.h"

#include <inttypes.h>
#include <stdio.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../sound/pitch.h"
#include "../../sound/tune.h"
#include "../../common/files.h"
#include "encode.h"

/* ---- reading ---- */

/* ID3 tags may be around any file: version 2 at the start, one or more, each with its length in four bytes of seven
 * bits, and version 1, 128 bytes, at the end. Source: id3.org, "ID3 tag version 2.4.0", section 3.1. */
static void skip_id3(const uint8_t **data, size_t *n)
{
    enum { HEAD = 10, HAS_FOOTER = 16, TAIL = 128 };

    while (*n > HEAD && memcmp(*data, "ID3", 3) == 0 && (*data)[3] < 0xff && (*data)[4] < 0xff) {
        const uint8_t *p = *data;
        const size_t body =
            (size_t)(p[6] & 127) << 21 | (size_t)(p[7] & 127) << 14 | (size_t)(p[8] & 127) << 7 | (size_t)(p[9] & 127);
        const size_t tag = HEAD + body + (p[5] & HAS_FOOTER ? HEAD : 0);
        if (tag >= *n)
            break;
        *data += tag;
        *n -= tag;
    }
    if (*n > TAIL && memcmp(*data + *n - TAIL, "TAG", 3) == 0)
        *n -= TAIL;
}

bool recording_read(const char *file, const uint8_t *data, size_t n, const struct art_loop *loop, struct pcm *out,
                    char *err, size_t err_size)
{
    static const char *const library[] = { ".ogg", ".oga", ".opus", ".flac" };
    const bool wav = files_has_suffix(file, ".wav");
    bool sndfile = false;

    for (size_t i = 0; i < sizeof library / sizeof *library; i++)
        sndfile |= files_has_suffix(file, library[i]);
    if (!wav && !sndfile)
        return pcm_read_module(data, n, loop->kind == LOOP_FROM_FILE, out, err, err_size);
    skip_id3(&data, &n);
    return (wav ? pcm_read_wav : pcm_read_sndfile)(data, n, out, err, err_size);
}

bool recording_prepare(struct pcm *p, const struct art_loop *loop, char *err, size_t err_size)
{
    const double each = loop->in_seconds ? p->rate : 1;

    if (loop->kind != LOOP_FROM_FILE) {
        p->loop = loop->kind == LOOP_NONE ? -1 : 0;
        p->loop_end = -1;
    }
    if (loop->kind == LOOP_RANGE) {
        p->loop = llrint(loop->start * each);
        if (loop->length > 0)
            p->loop_end = p->loop + llrint(loop->length * each);
    }
    if (!pcm_check(p, err, err_size))
        return false;
    return pcm_prepare(p) ? true : result_set_host_error(err, err_size, "out of memory");
}

/* ---- samples ---- */

static int sides_of(const struct pcm *p, const struct art_sound *s)
{
    return p->channels == 2 && s->stereo ? 2 : 1;
}

/* Writes samples after `before` bytes. */
static bool write_samples(const struct pcm *p, const struct art_sound *s, size_t before, struct recording_bytes *out)
{
    const enum sample_coding coding = s->exact ? SAMPLE_PCM16 : SAMPLE_ADPCM;
    const int sides = sides_of(p, s);
    const size_t one = sample_size(p->n, coding);
    int16_t *side = malloc(p->n * sizeof *side);

    out->n = before + one * (size_t)sides;
    out->data = malloc(out->n);
    for (int i = 0; side && out->data && i < sides; i++) {
        pcm_side(p, sides == 1 ? -1 : i, side);
        encode_sample(out->data + before + one * (size_t)i, side, p->n, p->rate,
                      p->loop < 0 ? SAMPLE_NO_LOOP : (uint32_t)p->loop, coding);
    }
    const bool good = side && out->data;
    free(side);
    if (!good)
        free(out->data);
    return good;
}

/* ---- a tune ---- */

enum { RELEASE = 480 /* samples */, ROOM = 16384 /* bytes of any such tune */, SOUND_TEMPO = 6000 };

struct writer {
    uint8_t bytes[ROOM];
    size_t n;
    int track; /* number of started tracks, the conductor first */
};

static void add_byte(struct writer *w, int v)
{
    w->bytes[w->n++] = (uint8_t)v;
}

static void add_ticks(struct writer *w, uint32_t v)
{
    for (; v > 127; v >>= 7)
        add_byte(w, (int)(v & 127) | 128);
    add_byte(w, (int)v);
}

static void add_event(struct writer *w, uint32_t ticks, enum tune_event event, int v)
{
    add_ticks(w, ticks);
    add_byte(w, (int)event);
    if (event == TUNE_NOTE || event == TUNE_TEMPO)
        add_byte(w, v & 255);
    if (event != TUNE_END)
        add_byte(w, event == TUNE_NOTE || event == TUNE_TEMPO ? v >> 8 : v);
}

/* Starts the next track, or its loop, here. */
static void begin_track(struct writer *w)
{
    bytes_put32(w->bytes + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * w->track++, (uint32_t)w->n);
}

static void begin_loop(struct writer *w)
{
    bytes_put32(w->bytes + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * (w->track - 1) + 4, (uint32_t)w->n);
}

/* Header, title, space for offsets, instruments. */
static void add_head(struct writer *w, const struct art_sound *s, int sides, int markers, uint32_t tempo)
{
    const uint8_t head[] = { TUNE_FORMAT,       (uint8_t)s->volume,        (uint8_t)s->priority,
                             (uint8_t)s->limit, (uint8_t)s->beats_per_bar, (uint8_t)sides,
                             (uint8_t)sides,    (uint8_t)markers };
    const struct inst inst = { .kind = INST_SAMPLE,
                               .env = { .sustain = 32767, .release = RELEASE },
                               .root = RECORDING_NOTE * (PITCH_ONE / 256) };
    const struct op none[FM_OPS] = { 0 };

    memset(w, 0, sizeof *w);
    memcpy(w->bytes, head, sizeof head);
    bytes_put32(w->bytes + 8, tempo);
    w->bytes[20] = (uint8_t)sides;
    w->bytes[TUNE_DUCK_AT] = (uint8_t)s->duck;
    snprintf((char *)w->bytes + TUNE_HEADER_SIZE, TUNE_TITLE_SIZE, "%s", s->title);
    w->n = TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * ((size_t)sides + 1);
    for (int i = 0; i < sides; i++, w->n += INST_BYTES)
        inst_write(w->bytes + w->n, &inst, none, "");
}

/* A track that plays sample i for `ticks`; an endless one has a loop of `ticks` after `before` ticks. */
static void add_track(struct writer *w, int i, int sides, bool endless, uint32_t before, uint32_t ticks)
{
    begin_track(w);
    add_event(w, 0, TUNE_INST, i);
    add_event(w, 0, TUNE_PANNING, sides == 1 ? TUNE_PAN_CENTRE : i * 2 * TUNE_PAN_CENTRE);
    add_event(w, 0, TUNE_VOLUME, TUNE_MAX_VOLUME);
    add_event(w, 0, TUNE_NOTE, RECORDING_NOTE);
    if (endless) {
        add_event(w, before, TUNE_VOLUME, TUNE_MAX_VOLUME);
        begin_loop(w);
        add_event(w, 0, TUNE_VOLUME, TUNE_MAX_VOLUME);
    }
    add_event(w, ticks, TUNE_END, 0);
}

/* Padding that may be read, and the length. */
static void end_tune(struct writer *w)
{
    w->n += 8 + (0 - w->n) % 4;
    bytes_put32(w->bytes + 16, (uint32_t)w->n);
}

/* Frames to units at a tempo, rounded; at most 2^25 * 48000 * 60000. */
static uint64_t units_of(const struct pcm *p, uint64_t frames, uint32_t tempo)
{
    return (frames * SND_RATE * tempo + p->rate / 2) / p->rate;
}

static uint32_t ticks_up(uint64_t units)
{
    return (uint32_t)((units + TUNE_TICK - 1) / TUNE_TICK);
}

bool recording_sound(const struct pcm *p, const struct art_sound *s, struct recording_bytes *tune, char *err,
                     size_t err_size)
{
    const int sides = sides_of(p, s);
    const uint32_t ticks = ticks_up(units_of(p, p->n, SOUND_TEMPO));
    struct art_sound about = *s;
    struct writer w;

    about.beats_per_bar = 4;
    add_head(&w, &about, sides, 0, SOUND_TEMPO);
    begin_track(&w);
    add_event(&w, 0, TUNE_END, 0);
    for (int i = 0; i < sides; i++)
        add_track(&w, i, sides, p->loop >= 0, 0, ticks);
    end_tune(&w);
    if (!write_samples(p, s, w.n, tune))
        return result_set_host_error(err, err_size, "out of memory");
    bytes_put32(w.bytes + 12, (uint32_t)w.n);
    bytes_put32(w.bytes + 16, (uint32_t)tune->n);
    memcpy(tune->data, w.bytes, w.n);
    return true;
}

/* ---- markers ---- */

/* A marker: ticks after the first beat, and index. */
struct place {
    uint32_t tick;
    int i;
};

static int by_tick(const void *a, const void *b)
{
    const struct place *x = a, *y = b;

    return x->tick != y->tick ? (x->tick < y->tick ? -1 : 1) : x->i - y->i;
}

/* Start of the loop and end of p, in units after the first beat; negative before it. */
struct span {
    int64_t loop, end;
};

/* A script sees only the last marker of a frame. */
static bool marks_apart(const struct art_sound *s, const struct art_marker *markers, const struct place *places,
                        uint32_t tempo, char *err, size_t err_size)
{
    for (int i = 1; i < s->n_markers; i++)
        if ((uint64_t)(places[i].tick - places[i - 1].tick) * TUNE_TICK < (uint64_t)SND_FRAME * tempo)
            return err_set(
                err, err_size, "marker \"%s\" is within a frame (1/60 s) of \"%s\", so scripts would never see it",
                markers[s->first_marker + places[i].i].name, markers[s->first_marker + places[i - 1].i].name);
    return true;
}

static bool place_markers(const struct art_sound *s, const struct art_marker *markers, struct span span,
                          struct place *out, char *err, size_t err_size)
{
    for (int i = 0; i < s->n_markers; i++) {
        const struct art_marker *m = &markers[s->first_marker + i];
        out[i] = (struct place){ (uint32_t)llrint(m->beat * TUNE_QUARTER), i };
        if ((int64_t)out[i].tick * TUNE_TICK >= span.end)
            return err_set(err, err_size, "marker \"%s\", at beat %g, is after the end, at beat %.2f", m->name, m->beat,
                           (double)span.end / TUNE_TICK / TUNE_QUARTER);
    }
    qsort(out, (size_t)s->n_markers, sizeof *out, by_tick);
    return true;
}

/* Markers before the loop, and those in it. The conductor's loop starts at the first marker in it; only its length must
 * be that of the samples' loop. */
static void add_conductor(struct writer *w, const struct art_sound *s, uint32_t tempo, const struct place *places,
                          const struct span *span, bool endless, uint32_t loop_ticks)
{
    uint32_t now = 0, from = 0;
    bool looping = false;

    begin_track(w);
    for (int i = 0; i < s->n_markers; i++) {
        if (endless && !looping && (int64_t)places[i].tick * TUNE_TICK >= span->loop) {
            looping = true;
            from = places[i].tick;
            add_event(w, from - now, TUNE_TEMPO, (int)tempo);
            now = from;
            begin_loop(w);
        }
        add_event(w, places[i].tick - now, TUNE_MARKER, places[i].i);
        now = places[i].tick;
    }
    add_event(w, looping ? loop_ticks - (now - from) : 0, TUNE_END, 0);
}

/* Frames of the loop; short ones are repeated. */
static uint64_t loop_frames(const struct pcm *p)
{
    uint64_t n = p->loop < 0 ? 0 : p->n - (uint64_t)p->loop;

    while (n > 0 && n < p->rate / 4)
        n *= 2;
    return n;
}

/* The tempo of rom.lua, or of the file, or 120, in hundredths. */
static uint32_t tempo_of(const struct pcm *p, const struct art_sound *s)
{
    const double own = p->tempo * 100;

    if (s->tempo)
        return (uint32_t)s->tempo;
    return own >= TEMPO_MIN && own <= TEMPO_MAX ? (uint32_t)lrint(own) : 12000;
}

bool recording_music(const struct pcm *p, const struct art_sound *s, const struct art_marker *markers,
                     struct recording_bytes *tune, struct recording_bytes *wave, char *err, size_t err_size)
{
    const uint32_t tempo = tempo_of(p, s), lead = (uint32_t)llrint(s->offset * SND_RATE);
    const bool endless = p->loop >= 0;
    const uint64_t all = units_of(p, p->n, tempo), loop = units_of(p, loop_frames(p), tempo);
    const int64_t end = (int64_t)(all - (uint64_t)lead * tempo);
    const uint64_t once = units_of(p, endless ? p->n - (uint64_t)p->loop : 0, tempo);
    const struct span span = { end - (int64_t)once, end };
    const uint32_t loop_ticks = (uint32_t)(loop / TUNE_TICK);
    struct place places[TUNE_MAX_MARKERS];
    struct writer w;

    if (ticks_up(all) > TUNE_MAX_PAUSE)
        return err_set(err, err_size, "too long: %" PRIu32 " beats at that tempo, expected at most %d",
                       ticks_up(all) / TUNE_QUARTER, TUNE_MAX_PAUSE / TUNE_QUARTER);
    if (!place_markers(s, markers, span, places, err, err_size) ||
        !marks_apart(s, markers, places, tempo, err, err_size))
        return false;
    add_head(&w, s, sides_of(p, s), s->n_markers, tempo);
    for (int i = 0; i < s->n_markers; i++, w.n += TUNE_NAME_SIZE)
        snprintf((char *)w.bytes + w.n, TUNE_NAME_SIZE, "%s", markers[s->first_marker + i].name);
    bytes_put32(w.bytes + 24, endless ? (uint32_t)(loop % TUNE_TICK) : 0);
    bytes_put32(w.bytes + 28, lead);
    add_conductor(&w, s, tempo, places, &span, endless, loop_ticks);
    for (int i = 0; i < sides_of(p, s); i++)
        add_track(&w, i, sides_of(p, s), endless, (uint32_t)((all - once) / TUNE_TICK),
                  endless ? loop_ticks : ticks_up(all));
    end_tune(&w);
    tune->n = w.n;
    tune->data = malloc(w.n);
    if (!tune->data || !write_samples(p, s, 0, wave)) {
        free(tune->data);
        return result_set_host_error(err, err_size, "out of memory");
    }
    memcpy(tune->data, w.bytes, w.n);
    return true;
}
