/*
 * tune.h - a compiled piece of music or sound: its instruments, its tracks, and the reader of their events.
 *
 * A tune is TUNE_HEADER_SIZE bytes, little-endian:
 *
 *      0  u8 TUNE_FORMAT            5  u8 tracks, 1 to TUNE_MAX_TRACKS      12  u32 offset of the samples, or 0
 *      1  u8 volume, 0 to 255       6  u8 instruments                   16  u32 total bytes
 *      2  u8 priority, 0 to 7       7  u8 markers
 *      3  u8 limit, 1 to 8          8  u32 tempo at the start,
 *      4  u8 beats a bar               hundredths of a quarter note a minute
 *     20  u8 channels of a recording, 0: no recording    21  u8 duck, of 255; two zero bytes
 *     24  u32 units added to the ticks of each loop      28  u32 samples before the first beat
 *
 * followed by the title, TUNE_TITLE_SIZE bytes; for the conductor, which has tempo and markers, and then for each
 * track, u32 its offset and u32 the offset where its endless loop starts, 0: it ends; the instruments, INST_BYTES each
 * (inst.h); the markers, TUNE_NAME_SIZE bytes each; waves, curves and the tracks; and, aligned to 4, the samples of a
 * recording (adpcm.h): one set or, for left and right, two, which the first and the second instrument play. A stream is
 * a recording used as music; its samples are in a separate lump, wave/NAME, because scripts do not depend on them. The
 * conductor starts at the first beat; the tracks of a recording can start before it.
 *
 * A track is a list of events: the ticks since the previous event (seven bits per byte, low bits first; the eighth bit
 * is set if more bytes follow), the event's byte, its values. TUNE_QUARTER ticks are a quarter note. Time is exact: a
 * tick is TUNE_TICK units and a sample is `tempo` units, so nothing is rounded and nothing drifts.
 */
#ifndef SOUND_TUNE_H
#define SOUND_TUNE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "inst.h"

enum {
    TUNE_FORMAT = 2,
    TUNE_HEADER_SIZE = 32,
    TUNE_DUCK_AT = 21, /* offset of `duck` in the header */
    TUNE_TITLE_SIZE = 64,
    TUNE_MAX_TRACKS = 16,
    TUNE_MAX_INSTS = 64,
    TUNE_MAX_MARKERS = 64,
    TUNE_NAME_SIZE = INST_NAME_SIZE, /* bytes of a marker's name, with its NUL */
    TUNE_QUARTER = 480,
    TUNE_TICK = 600000,
    TEMPO_MIN = 1000, /* 10 quarter notes a minute */
    TEMPO_MAX = 60000,
    TUNE_MAX_BYTES = 1 << 20, /* maximum bytes, without the samples */
    TUNE_MAX_PAUSE = 1 << 24, /* ticks between two events, at most */
    TUNE_MAX_CHANNELS = 2,
    TUNE_MAX_LEAD = 1 << 24, /* samples before the first beat, at most */
    TUNE_PAN_CENTRE = 64,    /* centre; 0: left, 128: right */
    TUNE_MAX_VOLUME = 127,
    RECORDING_NOTE = 60 * 256 /* pitch at which a recording's tune plays it as recorded, 256ths of a semitone */
};

/* Events and their values. The conductor has only TEMPO, MARK and END; the tracks have END and all others. */
enum tune_event {
    TUNE_END,     /* end of the track or of its loop */
    TUNE_NOTE,    /* u16 pitch, 256ths of a semitone: starts a note */
    TUNE_SLUR,    /* u16 pitch: the note continues at this pitch */
    TUNE_OFF,     /* releases the note */
    TUNE_GLIDE,   /* u16 pitch, u16 ticks: the note slides to this pitch */
    TUNE_INST,    /* u8: the instrument of the following notes */
    TUNE_VOLUME,  /* u8, 0 to TUNE_MAX_VOLUME */
    TUNE_PANNING, /* u8, 0 to 128: pan */
    TUNE_TEMPO,   /* u16, hundredths of a quarter note a minute */
    TUNE_MARKER,  /* u8: marker index */
    TUNE_EVENTS
};

/* The header of a tune that tune_validate has accepted. */
struct tune {
    const uint8_t *data;
    int n_tracks, n_insts, n_markers, volume, priority, limit, beats_per_bar, channels;
    int duck;                         /* how much softer music is while the tune plays, of 255 */
    uint32_t tempo, loop_units, lead; /* loop_units: units added to a loop; lead: samples before the first beat */
};
struct tune tune_of(const uint8_t *data);
const char *tune_title(const struct tune *t);
const char *tune_marker_name(const struct tune *t, int i);
const uint8_t *tune_inst(const struct tune *t, int i);

/* tune_is_recording returns whether a tune is a recording; tune_is_stream, whether it is a recording whose samples are
 * in a separate lump; tune_is_endless, whether any of its tracks loops forever. */
bool tune_is_recording(const struct tune *t);
bool tune_is_stream(const struct tune *t);
bool tune_is_endless(const struct tune *t);

/* Checks a tune of `size` bytes, so that the other functions can read it without checks. Returns false, with one
 * sentence in err, if the tune is invalid. */
bool tune_validate(const uint8_t *data, size_t size, char *err, size_t err_size);

/* A position in a track. */
struct track_cursor {
    uint32_t cursor;    /* byte offset of the next event in the tune; 0: the track has ended */
    int64_t units_left; /* units until the next event */
};

/* Returns the position at the start of track i; -1: the conductor. */
struct track_cursor tune_track_start(const struct tune *t, int i);

struct tune_played_event {
    enum tune_event event;
    int32_t value, value2; /* the event's first and second value */
    int sample;            /* index in the frame */
};

/* Iterates over the events of a track in n samples of a frame, from sample `first` on. track: -1: the conductor. */
struct tune_run {
    const struct tune *t;
    int track;
    /* Current position; once tune_next_event has returned false, where the next run starts. */
    struct track_cursor cursor;
    uint32_t tempo;
    int first, n;
    int events_read; /* private to tune_next_event: number of events read, which is limited; starts as 0 */
};

/* Reads the next event of the run. Returns false if none is left; r->cursor is then at the end of the run. */
bool tune_next_event(struct tune_run *r, struct tune_played_event *e);

#endif
