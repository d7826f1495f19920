/*
 * tune.h - a compiled piece of music, or a sound: its instruments and its tracks, and the reading of them in time.
 *
 * A tune is TUNE_HEADER bytes, little-endian:
 *
 *      0  u8 TUNE_FORMAT            5  u8 tracks, 1 to TUNE_TRACKS      12  u32 where its samples are, or 0
 *      1  u8 volume, 0 to 255       6  u8 instruments                   16  u32 bytes in all
 *      2  u8 priority, 0 to 7       7  u8 markers
 *      3  u8 limit, 1 to 8          8  u32 tempo at its beginning,
 *      4  u8 beats a bar               hundredths of a quarter note a minute
 *     20  u8 samples of a recording 21  u8 duck, of 255; two zero bytes
 *     24  u32 units by which its loops are longer than their ticks    28  u32 samples before its first beat
 *
 * then its title, TUNE_TITLE bytes; for the conductor, which has tempo and markers, and for each track u32 where it is,
 * u32 where its endless loop begins, 0: it ends; its instruments, INST_BYTES each (inst.h); its markers, TUNE_NAME
 * bytes each; waves, curves and the tracks; and, aligned to 4, the samples of a recording (adpcm.h): one or, of left
 * and right, two, which its first and its second instrument play. Those of a stream, which is a recording as music,
 * stand in a lump of their own, wave/NAME, for scripts do not depend on them. Before the first beat, which is where the
 * conductor begins, the tracks of a recording may have played already.
 *
 * A track is events: how many ticks after the one before (seven bits a byte, low ones first, the eighth: more follow),
 * the event's byte, its values. TUNE_QUARTER ticks are a quarter note. Time is exact: a tick is TUNE_TICK units, a
 * sample as many as the tempo says, so nothing is rounded and nothing drifts.
 */
#ifndef SOUND_TUNE_H
#define SOUND_TUNE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "inst.h"

enum {
    TUNE_FORMAT = 2,
    TUNE_HEADER = 32,
    TUNE_DUCK_AT = 21, /* where in the header it is */
    TUNE_TITLE = 64,
    TUNE_TRACKS = 16,
    TUNE_INSTS = 64,
    TUNE_MARKS = 64,
    TUNE_NAME = INST_NAME, /* of a marker, with its NUL */
    TUNE_QUARTER = 480,
    TUNE_TICK = 600000,
    TEMPO_LEAST = 1000, /* 10 quarter notes a minute */
    TEMPO_MOST = 60000,
    TUNE_MOST = 1 << 20,  /* bytes without the sample */
    TUNE_PAUSE = 1 << 24, /* ticks between two events, at most */
    TUNE_SIDES = 2,
    TUNE_LEAD = 1 << 24, /* samples before the first beat, at most */
    TUNE_PAN = 64,       /* the middle; 0 left, 128 right */
    TUNE_LOUD = 127,
    RECORDING_NOTE = 60 * 256 /* pitch of the notes of a recording's tune, at which it is as recorded */
};

/* Events of a track. The conductor has TEMPO, MARK and END alone, the tracks all others. */
enum tune_event {
    TUNE_END,    /* of the track, or of its loop */
    TUNE_NOTE,   /* u16 pitch in 256ths of a semitone: a note begins */
    TUNE_SLUR,   /* u16 pitch: the note goes on at another one */
    TUNE_OFF,    /* the note is let go */
    TUNE_GLIDE,  /* u16 pitch, u16 ticks: the note slides there */
    TUNE_INST,   /* u8: of the notes from now on */
    TUNE_VOLUME, /* u8, 0 to TUNE_LOUD */
    TUNE_PLACE,  /* u8, 0 to 128: where it is heard */
    TUNE_TEMPO,  /* u16 */
    TUNE_MARK,   /* u8 */
    TUNE_EVENTS
};

/* The parts of a tune that was checked. */
struct tune {
    const uint8_t *data;
    int tracks, insts, marks, volume, priority, limit, bar, sides;
    int duck;                   /* of 255, how much softer music is meanwhile */
    uint32_t tempo, rest, lead; /* rest: units a loop is longer; lead: samples before the first beat */
};
struct tune tune_of(const uint8_t *data);
const char *tune_title(const struct tune *t);
const char *tune_mark(const struct tune *t, int i);
const uint8_t *tune_inst(const struct tune *t, int i);

/* Is it a recording; one whose samples stand elsewhere; does one of its tracks never end? */
bool tune_recording(const struct tune *t);
bool tune_streams(const struct tune *t);
bool tune_endless(const struct tune *t);

/* Checks every byte that is read later. False and one sentence. */
bool tune_open(const uint8_t *data, size_t size, char *err, size_t err_size);

/* A place in a track. */
struct tune_at {
    uint32_t at;  /* of the next event in the tune; 0: it is over */
    int64_t left; /* units until then */
};

/* The beginning of track i; -1: of the conductor. */
struct tune_at tune_begin(const struct tune *t, int i);

struct tune_played {
    enum tune_event event;
    int32_t value, more;
    int sample; /* of the frame */
};

/* The n samples from `first` of a frame on, as a track plays them. */
struct tune_run {
    const struct tune *t;
    int track;
    struct tune_at at; /* after the run: where the next one begins */
    uint32_t tempo;
    int first, n;
    int events; /* tune_next's: so many so far, for a run has a limit */
};

/* The next event that falls into the run; false: there is none, and the time has passed. */
bool tune_next(struct tune_run *r, struct tune_played *e);

#endif
