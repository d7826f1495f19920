/*
 * recording.c - see recording.h. The result is a tune with a track for each channel, whose only note lasts to the end
 * or loops. The conductor has the markers. Its time starts at the first beat, and its loop is exactly as long as that
 * of the samples, because the header contains the remainder that is less than a tick.
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

/* Any file may have ID3 tags: one or more of version 2 at the start, each with its length in four bytes of seven bits,
 * and one of version 1, 128 bytes, at the end. Source: id3.org, "ID3 tag version 2.4.0", section 3.1. */
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
    const double frames_per_unit = loop->in_seconds ? p->rate : 1;

    if (loop->kind != LOOP_FROM_FILE) {
        p->loop = loop->kind == LOOP_NONE ? -1 : 0;
        p->loop_end = -1;
    }
    if (loop->kind == LOOP_RANGE) {
        p->loop = llrint(loop->start * frames_per_unit);
        if (loop->length > 0)
            p->loop_end = p->loop + llrint(loop->length * frames_per_unit);
    }
    if (!pcm_check(p, err, err_size))
        return false;
    return pcm_prepare(p) ? true : result_set_host_error(err, err_size, "out of memory");
}

/* ---- samples ---- */

static int channel_count(const struct pcm *p, const struct art_sound *s)
{
    return p->channels == 2 && s->stereo ? 2 : 1;
}

/* Allocates `before` bytes and the encoded samples after them. */
static bool encode_channels(const struct pcm *p, const struct art_sound *s, size_t before, struct recording_bytes *out)
{
    const enum sample_coding coding = s->exact ? SAMPLE_PCM16 : SAMPLE_ADPCM;
    const int channels = channel_count(p, s);
    const size_t channel_size = sample_size(p->n, coding);
    int16_t *samples = malloc(p->n * sizeof *samples);

    out->n = before + channel_size * (size_t)channels;
    out->data = malloc(out->n);
    for (int i = 0; samples && out->data && i < channels; i++) {
        pcm_channel(p, channels == 1 ? -1 : i, samples);
        encode_sample(out->data + before + channel_size * (size_t)i, samples, p->n, p->rate,
                      p->loop < 0 ? SAMPLE_NO_LOOP : (uint32_t)p->loop, coding);
    }
    const bool good = samples && out->data;
    free(samples);
    if (!good)
        free(out->data);
    return good;
}

/* ---- a tune ---- */

enum { RELEASE = 480 /* samples */, MAX_TUNE = 16384 /* bytes; enough for any of these tunes */, SOUND_TEMPO = 6000 };

struct writer {
    uint8_t bytes[MAX_TUNE];
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

/* Start the next track, or the loop of the current track. */
static void start_track(struct writer *w)
{
    bytes_put32(w->bytes + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * w->track++, (uint32_t)w->n);
}

static void start_loop(struct writer *w)
{
    bytes_put32(w->bytes + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * (w->track - 1) + 4, (uint32_t)w->n);
}

/* Writes the header, the title, space for offsets, and the instruments. */
static void add_header(struct writer *w, const struct art_sound *s, int channels, int markers, uint32_t tempo)
{
    const uint8_t header[] = { TUNE_FORMAT,       (uint8_t)s->volume,        (uint8_t)s->priority,
                               (uint8_t)s->limit, (uint8_t)s->beats_per_bar, (uint8_t)channels,
                               (uint8_t)channels, (uint8_t)markers };
    const struct inst inst = { .kind = INST_SAMPLE,
                               .env = { .sustain = 32767, .release = RELEASE },
                               .root = RECORDING_NOTE * (PITCH_ONE / 256) };
    const struct op none[FM_OPS] = { 0 };

    memset(w, 0, sizeof *w);
    memcpy(w->bytes, header, sizeof header);
    bytes_put32(w->bytes + 8, tempo);
    w->bytes[20] = (uint8_t)channels;
    w->bytes[TUNE_DUCK_AT] = (uint8_t)s->duck;
    snprintf((char *)w->bytes + TUNE_HEADER_SIZE, TUNE_TITLE_SIZE, "%s", s->title);
    w->n = TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * ((size_t)channels + 1);
    for (int i = 0; i < channels; i++, w->n += INST_BYTES)
        inst_write(w->bytes + w->n, &inst, none, "");
}

/* Writes a track that plays sample i for `ticks`, or that loops `ticks` after `before` ticks. */
static void add_track(struct writer *w, int i, int channels, bool loops, uint32_t before, uint32_t ticks)
{
    start_track(w);
    add_event(w, 0, TUNE_INST, i);
    add_event(w, 0, TUNE_PANNING, channels == 1 ? TUNE_PAN_CENTRE : i * 2 * TUNE_PAN_CENTRE);
    add_event(w, 0, TUNE_VOLUME, TUNE_MAX_VOLUME);
    add_event(w, 0, TUNE_NOTE, RECORDING_NOTE);
    if (loops) {
        add_event(w, before, TUNE_VOLUME, TUNE_MAX_VOLUME);
        start_loop(w);
        add_event(w, 0, TUNE_VOLUME, TUNE_MAX_VOLUME);
    }
    add_event(w, ticks, TUNE_END, 0);
}

/* Writes padding, which readers may read, and the length. */
static void end_tune(struct writer *w)
{
    w->n += 8 + (0 - w->n) % 4;
    bytes_put32(w->bytes + 16, (uint32_t)w->n);
}

/* Converts frames to units at a tempo, rounded; at most 2^25 * 48000 * 60000. */
static uint64_t frames_to_units(const struct pcm *p, uint64_t frames, uint32_t tempo)
{
    return (frames * SND_RATE * tempo + p->rate / 2) / p->rate;
}

static uint32_t units_to_ticks(uint64_t units)
{
    return (uint32_t)((units + TUNE_TICK - 1) / TUNE_TICK);
}

bool recording_sound(const struct pcm *p, const struct art_sound *s, struct recording_bytes *tune, char *err,
                     size_t err_size)
{
    const int channels = channel_count(p, s);
    const uint32_t ticks = units_to_ticks(frames_to_units(p, p->n, SOUND_TEMPO));
    struct art_sound settings = *s;
    struct writer w;

    settings.beats_per_bar = 4;
    add_header(&w, &settings, channels, 0, SOUND_TEMPO);
    start_track(&w);
    add_event(&w, 0, TUNE_END, 0);
    for (int i = 0; i < channels; i++)
        add_track(&w, i, channels, p->loop >= 0, 0, ticks);
    end_tune(&w);
    if (!encode_channels(p, s, w.n, tune))
        return result_set_host_error(err, err_size, "out of memory");
    bytes_put32(w.bytes + 12, (uint32_t)w.n);
    bytes_put32(w.bytes + 16, (uint32_t)tune->n);
    memcpy(tune->data, w.bytes, w.n);
    return true;
}

/* ---- markers ---- */

/* The position of a marker in ticks after the first beat, and its index. */
struct marker_position {
    uint32_t tick;
    int i;
};

static int compare_positions(const void *a, const void *b)
{
    const struct marker_position *x = a, *y = b;

    return x->tick != y->tick ? (x->tick < y->tick ? -1 : 1) : x->i - y->i;
}

/* Start of the loop and end of p, in units after the first beat; negative before it. */
struct span {
    int64_t loop, end;
};

/* Checks that no two markers are in the same frame: scripts would only see the second. */
static bool check_marker_distances(const struct art_sound *s, const struct art_marker *markers,
                                   const struct marker_position *places, uint32_t tempo, char *err, size_t err_size)
{
    for (int i = 1; i < s->n_markers; i++)
        if ((uint64_t)(places[i].tick - places[i - 1].tick) * TUNE_TICK < (uint64_t)SND_FRAME * tempo)
            return err_set(
                err, err_size, "marker \"%s\" is within a frame (1/60 s) of \"%s\", so scripts would never see it",
                markers[s->first_marker + places[i].i].name, markers[s->first_marker + places[i - 1].i].name);
    return true;
}

static bool place_markers(const struct art_sound *s, const struct art_marker *markers, struct span span,
                          struct marker_position *out, char *err, size_t err_size)
{
    for (int i = 0; i < s->n_markers; i++) {
        const struct art_marker *m = &markers[s->first_marker + i];
        out[i] = (struct marker_position){ (uint32_t)llrint(m->beat * TUNE_QUARTER), i };
        if ((int64_t)out[i].tick * TUNE_TICK >= span.end)
            return err_set(err, err_size, "marker \"%s\", at beat %g, is after the end, at beat %.2f", m->name, m->beat,
                           (double)span.end / TUNE_TICK / TUNE_QUARTER);
    }
    qsort(out, (size_t)s->n_markers, sizeof *out, compare_positions);
    return true;
}

/* Writes the markers before and in the loop. The conductor's loop starts at the first marker in the loop; only its
 * length must be that of the samples' loop. */
static void add_conductor(struct writer *w, const struct art_sound *s, uint32_t tempo,
                          const struct marker_position *places, const struct span *span, bool loops,
                          uint32_t loop_ticks)
{
    uint32_t now = 0, from = 0;
    bool looping = false;

    start_track(w);
    for (int i = 0; i < s->n_markers; i++) {
        if (loops && !looping && (int64_t)places[i].tick * TUNE_TICK >= span->loop) {
            looping = true;
            from = places[i].tick;
            add_event(w, from - now, TUNE_TEMPO, (int)tempo);
            now = from;
            start_loop(w);
        }
        add_event(w, places[i].tick - now, TUNE_MARKER, places[i].i);
        now = places[i].tick;
    }
    add_event(w, looping ? loop_ticks - (now - from) : 0, TUNE_END, 0);
}

/* Returns the length of the loop in frames; a short loop is repeated. */
static uint64_t loop_frames(const struct pcm *p)
{
    uint64_t n = p->loop < 0 ? 0 : p->n - (uint64_t)p->loop;

    while (n > 0 && n < p->rate / 4)
        n *= 2;
    return n;
}

/* Returns the tempo in hundredths: of rom.lua, of the file, or 120. */
static uint32_t tempo_of(const struct pcm *p, const struct art_sound *s)
{
    const double file_tempo = p->tempo * 100;

    if (s->tempo)
        return (uint32_t)s->tempo;
    return file_tempo >= TEMPO_MIN && file_tempo <= TEMPO_MAX ? (uint32_t)lrint(file_tempo) : 12000;
}

bool recording_music(const struct pcm *p, const struct art_sound *s, const struct art_marker *markers,
                     struct recording_bytes *tune, struct recording_bytes *wave, char *err, size_t err_size)
{
    const uint32_t tempo = tempo_of(p, s), lead = (uint32_t)llrint(s->offset * SND_RATE);
    const bool loops = p->loop >= 0;
    const uint64_t all = frames_to_units(p, p->n, tempo), loop = frames_to_units(p, loop_frames(p), tempo);
    const int64_t end = (int64_t)(all - (uint64_t)lead * tempo);
    const uint64_t loop_units = frames_to_units(p, loops ? p->n - (uint64_t)p->loop : 0, tempo);
    const struct span span = { end - (int64_t)loop_units, end };
    const uint32_t loop_ticks = (uint32_t)(loop / TUNE_TICK);
    struct marker_position places[TUNE_MAX_MARKERS];
    struct writer w;

    if (units_to_ticks(all) > TUNE_MAX_PAUSE)
        return err_set(err, err_size, "too long: %" PRIu32 " beats at that tempo, expected at most %d",
                       units_to_ticks(all) / TUNE_QUARTER, TUNE_MAX_PAUSE / TUNE_QUARTER);
    if (!place_markers(s, markers, span, places, err, err_size) ||
        !check_marker_distances(s, markers, places, tempo, err, err_size))
        return false;
    add_header(&w, s, channel_count(p, s), s->n_markers, tempo);
    for (int i = 0; i < s->n_markers; i++, w.n += TUNE_NAME_SIZE)
        snprintf((char *)w.bytes + w.n, TUNE_NAME_SIZE, "%s", markers[s->first_marker + i].name);
    bytes_put32(w.bytes + 24, loops ? (uint32_t)(loop % TUNE_TICK) : 0);
    bytes_put32(w.bytes + 28, lead);
    add_conductor(&w, s, tempo, places, &span, loops, loop_ticks);
    for (int i = 0; i < channel_count(p, s); i++)
        add_track(&w, i, channel_count(p, s), loops, (uint32_t)((all - loop_units) / TUNE_TICK),
                  loops ? loop_ticks : units_to_ticks(all));
    end_tune(&w);
    tune->n = w.n;
    tune->data = malloc(w.n);
    if (!tune->data || !encode_channels(p, s, 0, wave)) {
        free(tune->data);
        return result_set_host_error(err, err_size, "out of memory");
    }
    memcpy(tune->data, w.bytes, w.n);
    return true;
}
