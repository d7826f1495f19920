/*
 * speaker.h - plays boards' sound on the host's speaker: volume, crossfades at breaks, and synchronisation with the
 * sound card's clock.
 *
 * In each frame of the program, speaker_add_frame gets the sound of each tick, and speaker_advance the elapsed time;
 * missing sound becomes silence. Where a block doesn't continue the previous one (after a rewind, a reload or silence),
 * the first SPEAKER_CROSSFADE frames are a crossfade. All other samples are exactly the board's.
 *
 * A tick's sound is heard SPEAKER_LATENCY frames after the tick is due.
 */
#ifndef PLAYER_SPEAKER_H
#define PLAYER_SPEAKER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "drift.h"
#include "resample.h"

enum {
    SPEAKER_RATE = 48000,
    SPEAKER_BLOCK = SPEAKER_RATE / 60, /* stereo frames per tick */

    /* Frames in the queue, including the card's own buffer, when a frame of the program is on time: 40 ms. */
    SPEAKER_TARGET_QUEUE = 1920,
    SPEAKER_MAX_QUEUE = SPEAKER_TARGET_QUEUE + 2 * SPEAKER_BLOCK, /* above it, blocks are dropped */
    SPEAKER_LATENCY = SPEAKER_TARGET_QUEUE + RESAMPLE_AFTER,
    SPEAKER_CROSSFADE = 384 /* 8 ms */
};

enum speaker_mode {
    SPEAKER_FORWARD,
    SPEAKER_REVERSE, /* frames, and the samples in each, are played backwards */
    SPEAKER_FAST     /* most frames are skipped; at half volume */
};

/* The host's speaker at the last speaker_advance. */
enum speaker_state { SPEAKER_UNUSED, SPEAKER_MISSING, SPEAKER_RUNNING };

struct speaker_stats {
    uint64_t measurements, queued_sum; /* of frames that were on time: their number, and the sum of queue lengths */
    uint32_t queued_max;
    uint32_t underruns;
    uint32_t dropped; /* blocks, because the queue was too long */
};

struct speaker {
    int volume;        /* percent */
    int music, sounds; /* percent of it */
    bool muted;
    bool exact;                /* sound is not resampled; the card's clock sets the pace */
    bool metering;             /* measure `peak` even when muted */
    void *tables;              /* for board_mix_sound; malloc when first needed */
    struct resample *resample; /* the same */
    struct drift drift;
    enum speaker_state state;

    /* The last block. */
    const struct board *board; /* NULL: it was silence */
    uint32_t frame;
    enum speaker_mode mode;
    int peak[2]; /* before volume */

    int16_t recent[2 * SPEAKER_CROSSFADE];     /* the last samples that were queued */
    int16_t fading_out[2 * SPEAKER_CROSSFADE]; /* `recent` at the start of the crossfade */
    int crossfade_left;                        /* frames */
    int fade_in_left;                          /* frames, after an underrun */
    int buffered;                              /* sound added before its time has elapsed: percent of a tick */
    int drop_blocks;                           /* number of blocks still to be dropped */
    int queued;                                /* frames in the queue at the last speaker_advance */
    double game_speed;                         /* relative to the clock; below 1 if the game is too slow */
    int stall_window;                          /* frames in which another stall counts as slowness */
    int slow_left;                             /* frames until the game counts as fast enough again */
    struct speaker_stats stats;
};

/* The time that a frame of the program stands for. */
struct speaker_elapsed {
    int sixtieths;
    int speed;     /* percent of full speed */
    uint64_t late; /* usec since the first sixtieth was due */
    uint64_t lost; /* usec that are skipped, because the game is too slow */
};

void speaker_open(struct speaker *s, int volume, bool muted, bool exact);

/* Sets the levels of music and of other sounds, in percent of the volume; initially 100. */
void speaker_set_levels(struct speaker *s, int music, int sounds);

/* Adds the sound of the board's last tick, together with that of `over` if it is not NULL. Does nothing for a
 * board without sound, or when muted. */
struct board;
void speaker_add_frame(struct speaker *s, const struct board *b, const struct board *over, enum speaker_mode mode);

/* Sends the sound of the elapsed time to the card. */
void speaker_advance(struct speaker *s, const struct speaker_elapsed *t);

/* Returns whether the card's clock sets the pace (with `exact`), and whether it says that the next frame is due. */
bool speaker_sets_pace(const struct speaker *s);
bool speaker_is_due(const struct speaker *s);

/* Writes a line with latency, clock drift, underruns and dropped blocks. */
void speaker_report(const struct speaker *s, char *line, size_t size);

/* Fades out, waits briefly until the queue is empty, and frees the memory. */
void speaker_close(struct speaker *s);

#endif
