/*
 * seq.h - the sequencers: one for the current piece of music, one for the playing sounds.
 *
 * Music is game state: scripts read its beat, bar and markers. Music advances a frame per tick, except while paused.
 * Track positions are not hashed, because they follow from two hashed values: the piece and the position in the piece.
 * A piece can be suspended while another one plays; suspended pieces resume where they stopped, the most recently
 * suspended one first. The playing sounds are the cues. Scripts cannot read cues, so cues are outside the combined
 * hash, like voices.
 */
#ifndef SOUND_SEQ_H
#define SOUND_SEQ_H

#include "pitch.h"
#include "tune.h"
#include "../base/slots.h"

enum {
    SEQ_TRACKS = 1 + TUNE_MAX_TRACKS, /* slot 0: the conductor */
    SEQ_MAX_SUSPENDED = 3,            /* maximum number of suspended pieces */
    SEQ_SLOTS = (1 + SEQ_MAX_SUSPENDED) * SEQ_TRACKS,
    SEQ_FULL_VOLUME = 32767, /* full volume of the music */
    SEQ_MAX_PIECES = 1024,
    CUE_SLOTS = 8,
    CUE_KINDS = 32
};

struct seq {
    struct slots s;
    uint16_t tune;                          /* the current piece, index in the ROM's music + 1; 0: none */
    uint16_t next_tune;                     /* the piece that starts after the fade, index + 1; 0: none */
    uint16_t fade_frames_left, fade_length; /* frames left of the fade-out, and its length; 0: no fade */
    uint16_t marker;                        /* the last marker passed, index + 1; 0: none yet */
    uint32_t markers_passed;                /* number of markers passed */
    uint32_t tempo;                         /* hundredths of a quarter note a minute */
    uint64_t pos; /* units since the first beat (TUNE_TICK per tick); negative in two's complement before that beat */
    uint8_t next_suspends;     /* 1: the current piece is suspended when `next_tune` starts */
    uint8_t next_is_scheduled; /* 1: `next_tune` starts at the sample where pos reaches `next_start` */
    uint64_t next_start;
    uint16_t level, level_target; /* volume and target volume, of SEQ_FULL_VOLUME */
    uint16_t level_frames;        /* frames until the target volume is reached */
    uint8_t is_skipping;          /* 1: a stage is skipping to a mark, and the music skips too */
    uint32_t frames_ahead,
        frames_skipped; /* frames by which the music is ahead of the stage's clock; frames skipped in total */
    uint64_t started_tunes[SEQ_MAX_PIECES / 64]; /* a bit for each piece that has started in this game */
    uint16_t
        suspended_count; /* number of suspended pieces; their tune, marker, markers_passed, tempo and pos are below */
    uint16_t suspended_tune[SEQ_MAX_SUSPENDED], suspended_marker[SEQ_MAX_SUSPENDED];
    uint32_t suspended_markers_passed[SEQ_MAX_SUSPENDED], suspended_tempo[SEQ_MAX_SUSPENDED];
    uint64_t suspended_pos[SEQ_MAX_SUSPENDED];
    uint32_t *at; /* track positions (struct track_cursor): of the current piece, then of the suspended ones */
    int64_t *units_left;
    uint8_t *inst, *volume, *pan; /* each track's settings for its next notes */
};

/* The pool of playing sounds, one cue for each track of a sound. */
struct cues {
    struct slots s;
    uint32_t *tune;        /* place of the sound (cart.h); 0: the slot is free */
    uint32_t *start_frame; /* the frame in which the sound started */
    uint8_t *track;
    uint32_t *at;
    int64_t *units_left;
    uint8_t *inst, *volume, *pan;
    uint16_t *cue_volume;            /* volume passed to cues_start, of 256 */
    int16_t *pan_offset;             /* pan added to that of the tune's events, of TUNE_PAN_CENTRE; positive: right */
    int32_t *pitch;                  /* transposition, 65536ths of a semitone */
    uint32_t last_played[CUE_KINDS]; /* frame + 1 in which each automatic sound (enum cart_cue) last played; 0: never */
};

extern const struct chip seq_chip, cues_chip;

/* Starts piece t from its beginning. index: t's index in the ROM's music + 1; 0: stops the music, and t is not used. */
void seq_start(struct seq *s, uint16_t index, const struct tune *t);

/* seq_suspend suspends the current piece unless SEQ_MAX_SUSPENDED pieces are suspended already. seq_drop_suspended_from
 * drops the i-th suspended piece and all later ones, seq_drop_suspended only the i-th. seq_resume resumes the last
 * suspended piece; there must be one. */
void seq_suspend(struct seq *s);
void seq_drop_suspended_from(struct seq *s, int i);
void seq_drop_suspended(struct seq *s, int i);
void seq_resume(struct seq *s);

/* Returns the index of the last suspended piece that is the given piece, or -1 if there is none. index: the given
 * piece's index in the ROM's music + 1. */
int seq_find_suspended(const struct seq *s, uint16_t index);

/* Returns whether all tracks of the current piece have ended. */
bool seq_has_ended(const struct seq *s);

/* Returns whether the current piece, which is tune t, has marker `mark` ahead of its position, including after its loop
 * restarts. Stores in *work the number of events examined. */
bool seq_has_marker_ahead(const struct seq *s, const struct tune *t, int mark, uint32_t *work);

/* Iterates over the events of tune t in a frame, from sample `first` on. slot and run are private to seq_next_event and
 * start zeroed. */
struct seq_run {
    struct seq *s;
    const struct tune *t;
    int first; /* once seq_next_event has returned false: the sample at which `next_tune` must start, or SND_FRAME */
    int slot;  /* the last event is from track slot - 1 */
    struct tune_run run;
};

/* Reads the next event of any track and stores the settings it changes in w->s. Returns false if no event is left in
 * the frame. */
bool seq_next_event(struct seq_run *w, struct tune_played_event *e);

/* Delays the start of `next_tune` to the next multiple of `beats` beats in the current piece: 1 waits for a beat, the
 * number of beats in a bar waits for a bar. */
void seq_schedule_next(struct seq *s, int beats);

/* Cancels the requested piece; the current one continues. */
void seq_cancel_next(struct seq *s);

/* Returns the number of whole quarter notes since the first beat; 0 before the first beat. */
static inline uint64_t seq_beats(const struct seq *s)
{
    return (int64_t)s->pos < 0 ? 0 : s->pos / ((uint64_t)TUNE_QUARTER * TUNE_TICK);
}

struct cue {
    uint32_t tune; /* place of the sound (cart.h) */
    uint16_t volume;
    int16_t pan_offset;
    int32_t pitch;
};

/* Starts a sound in this frame. If the same sound already started in this frame, only the louder volume counts. If the
 * sound's limit is reached, its oldest instance ends. Each track needs a slot; if none is free, the oldest sound of the
 * lowest priority ends, unless its priority is higher than the new sound's, or equal and it also started in this frame;
 * then the remaining tracks are not played. ringing: a bit for each slot whose voice sounds, whether the slot is free
 * or not. Returns a bit for each slot whose voice has to fade. */
uint32_t cues_start(struct cues *c, const uint8_t *rom, const struct cue *cue, uint32_t frame, uint32_t ringing);

/* Ends all instances of the sound at place `tune`; 0: all sounds. Returns a bit for each slot that ended. */
uint32_t cues_stop(struct cues *c, uint32_t tune);

/* Iterates over the events of all cues in a frame; starts zeroed. */
struct cues_run {
    int slot; /* slot of the last event */
    bool begun;
    struct tune t;
    struct tune_run run;
};

/* Reads the next event of any cue into *e. If it sets an instrument, volume or pan, also stores the new value in c.
 * Returns false if no event is left in the frame. */
bool cues_next_event(struct cues *c, const uint8_t *rom, struct cues_run *w, struct tune_played_event *e);

#endif
