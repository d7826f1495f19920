/*
 * seq.h - the sequencers: of the piece of music that plays, and of the sounds that do.
 *
 * Music is game state: scripts read its beat, its bar and its markers. It has frames of its own, which a pause holds.
 * Where its tracks are follows from what is hashed: which piece, how far it is. Pieces may be put aside while another
 * plays, to go on where they were, the last of them first. The cues, which are the sounds that play, no script can
 * read; they are outside the combined hash, as voices are.
 */
#ifndef SOUND_SEQ_H
#define SOUND_SEQ_H

#include "pitch.h"
#include "tune.h"
#include "../base/slots.h"

enum {
    SEQ_TRACKS = 1 + TUNE_TRACKS, /* slot 0: the conductor */
    SEQ_ASIDE = 3,                /* pieces that may be put aside */
    SEQ_SLOTS = (1 + SEQ_ASIDE) * SEQ_TRACKS,
    SEQ_FULL = 32767, /* of its volume */
    SEQ_HEARD = 1024,
    CUES = 8,
    CUE_KINDS = 32
};

struct seq {
    struct slots s;
    uint16_t tune;            /* of the ROM's music, its index + 1; 0: none plays */
    uint16_t next;            /* what begins when it has faded */
    uint16_t fade, fade_over; /* frames it still fades, of how many; 0: it does not */
    uint16_t mark;            /* the last marker it came by, its index + 1; 0: none yet */
    uint32_t marks;           /* how many it came by */
    uint32_t tempo;           /* hundredths of a quarter note a minute */
    uint64_t pos;             /* units since its first beat (TUNE_TICK a tick), of two's complement before it */
    uint8_t next_back;        /* what plays is put aside when `next` begins */
    uint8_t next_waits;       /* `next` begins when pos is `when`, exactly there */
    uint64_t when;
    uint16_t level, level_to;       /* its volume, of SEQ_FULL, and where that goes */
    uint16_t level_over;            /* frames until it is there */
    uint8_t passes;                 /* a stage is on its way to a mark, and the music with it: */
    uint32_t ahead, passed;         /* how many frames beyond the stage's clock; in all */
    uint64_t heard[SEQ_HEARD / 64]; /* a bit for each piece that began in this game */
    uint16_t aside;                 /* how many are put aside: tune, mark, marks, tempo, pos of each */
    uint16_t kept[SEQ_ASIDE], kept_mark[SEQ_ASIDE];
    uint32_t kept_marks[SEQ_ASIDE], kept_tempo[SEQ_ASIDE];
    uint64_t kept_pos[SEQ_ASIDE];
    uint32_t *at; /* cursors: of what plays, then of what is put aside */
    int64_t *left;
    uint8_t *inst, *volume, *pan; /* of the notes to come */
};

/* A sound that plays is as many cues as it has tracks. */
struct cues {
    struct slots s;
    uint32_t *tune; /* its place (cart.h); 0: none plays */
    uint32_t *born; /* the frame in which it began */
    uint8_t *track;
    uint32_t *at;
    int64_t *left;
    uint8_t *inst, *volume, *pan;
    uint16_t *loud;           /* of 256: how loud the script asks for it */
    int16_t *place;           /* to the right, of TUNE_PAN */
    int32_t *pitch;           /* higher, in 65536ths of a semitone */
    uint32_t last[CUE_KINDS]; /* frame in which each cue of the game's own played last (cart.h) */
};

extern const struct chip seq_chip, cues_chip;

/* Begins tune `index` + 1 at its beginning; 0: stops. t is that tune. */
void seq_start(struct seq *s, uint16_t index, const struct tune *t);

/* Puts what plays aside, if there is room; forgets what was put aside from the i-th on, or the i-th alone; the last one
 * put aside plays on. */
void seq_keep(struct seq *s);
void seq_forget(struct seq *s, int i);
void seq_drop(struct seq *s, int i);
void seq_back(struct seq *s);

/* The last one put aside that is piece `index`; -1: none. */
int seq_kept(const struct seq *s, uint16_t index);

/* Have all its tracks ended? */
bool seq_over(const struct seq *s);

/* Will it come by that marker? work: events looked at. */
bool seq_comes(const struct seq *s, const struct tune *t, int mark, uint32_t *work);

/* A frame of tune t from sample `first` on. The last two are seq_next's. */
struct seq_run {
    struct seq *s;
    const struct tune *t;
    int first; /* after the run: the sample at which `next` is to begin, or SND_FRAME */
    int slot;  /* whose events they are: of track slot - 1 */
    struct tune_run run;
};

/* The next event of a track; false: there is none. What it sets is kept. */
bool seq_next(struct seq_run *w, struct tune_played *e);

/* `next` is to begin at the piece's next beat; or bar, of so many beats. */
void seq_wait(struct seq *s, int beats);

/* Whole quarter notes since its first beat; 0 before it. */
static inline uint64_t seq_beats(const struct seq *s)
{
    return (int64_t)s->pos < 0 ? 0 : s->pos / ((uint64_t)TUNE_QUARTER * TUNE_TICK);
}

struct cue {
    uint32_t tune; /* its place (cart.h) */
    uint16_t loud;
    int16_t place;
    int32_t pitch;
};

/* Begins a sound in this frame. The same one twice in a frame is one, the louder. Where its limit is reached, the
 * oldest of its kind goes; where there is no room, the oldest of the least priority, if that is not above its own.
 * ringing: a bit for each slot whose voice sounds, free or not. Returns a bit for each slot whose voice has to fade. */
uint32_t cues_start(struct cues *c, const uint8_t *rom, const struct cue *cue, uint32_t frame, uint32_t ringing);

/* Ends the sound at that place, 0: all. Returns a bit for each slot. */
uint32_t cues_stop(struct cues *c, uint32_t tune);

/* A frame of all; begins as zeroes. */
struct cues_run {
    int slot; /* whose events they are */
    bool begun;
    struct tune t;
    struct tune_run run;
};

/* The next event of a sound; false: there is none. What it sets is kept. */
bool cues_next(struct cues *c, const uint8_t *rom, struct cues_run *w, struct tune_played *e);

#endif
