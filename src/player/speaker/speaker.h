/*
 * speaker.h - boards' sound on the host's speaker: volume, joints that do not click, and held in step with a clock that
 * is not quite ours.
 *
 * Each frame of the program hands in the sound of the frames it ticked, none to some, and says how many sixtieths have
 * passed; what is missing is silence. Wherever a block does not go on from the one before, after a rewind, a reload, a
 * silence, the first SPEAKER_JOIN frames pass from one into the other; what follows is to the bit what the board says.
 *
 * From the moment a tick is due until its sound is heard, SPEAKER_LATENCY frames pass.
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
    SPEAKER_BLOCK = SPEAKER_RATE / 60, /* stereo frames a tick makes */
    SPEAKER_AHEAD = 1920, /* that wait when a frame is on time, before its own come, the card's own included: 40 ms */
    SPEAKER_LATENCY = SPEAKER_AHEAD + RESAMPLE_AFTER,
    SPEAKER_MOST = SPEAKER_AHEAD + 2 * SPEAKER_BLOCK, /* with more, what comes is not played */
    SPEAKER_JOIN = 384                                /* 8 ms */
};

/* How the frame of a block follows the one heard before. */
enum speaker_way {
    SPEAKER_ON,   /* in time */
    SPEAKER_BACK, /* backwards, and so is the block */
    SPEAKER_FAST  /* one of many that passed: half as loud */
};

/* The state of the host's speaker, as speaker_frame found it. */
enum speaker_state { SPEAKER_OFF, SPEAKER_GONE, SPEAKER_GOOD };

/* What was measured since the beginning. */
struct speaker_seen {
    uint64_t looks, sum; /* frames on time; frames of sound before theirs, added up */
    uint32_t most;
    uint32_t dry;     /* how often nothing waited any more */
    uint32_t refused; /* blocks that were not played, for too much waited */
};

struct speaker {
    int volume;        /* percent */
    int music, sounds; /* percent of it */
    bool muted;
    bool exact;                /* blocks are played as they are: the rate is not adjusted, the card's clock leads */
    bool meter;                /* levels are wanted, be it muted or not */
    void *memory;              /* of board_mix_sound, once there is something to play; malloc */
    struct resample *resample; /* malloc, as memory */
    struct drift drift;
    enum speaker_state state;
    const struct board *board; /* of the last block; NULL: it was silence */
    uint32_t frame;            /* and its frame */
    enum speaker_way way;
    int16_t past[2 * SPEAKER_JOIN], from[2 * SPEAKER_JOIN]; /* the end of what was heard; as it was at the last joint */
    int joint;                                              /* frames that a joint still takes */
    int rises;                                              /* frames in which what comes after a gap gets loud */
    int credit;                                             /* sixtieths that have been handed in and not passed */
    int refuse;                                             /* blocks that are not taken: too much waits */
    int waiting;                                            /* frames that waited at the last look */
    double pace;                                            /* of the game, by the clock: 1, or it cannot follow */
    int stumbled;                                           /* frames in which another stop would not be the only one */
    int slowed;                                             /* frames until it is believed that it can again */
    int peak[2];                                            /* of the board's last block, as it made it */
    struct speaker_seen seen;
};

/* The sixtieths that a frame of the program stands for. */
struct speaker_time {
    int sixtieths;
    int slow;      /* of them a tick lasts: 1, 2, 4 */
    uint64_t late; /* usec since the first one was due */
    uint64_t lost; /* usec that passed and are left out: the game cannot follow */
};

void speaker_open(struct speaker *s, int volume, bool muted, bool exact);

/* How loud music and the other sounds are from the next frame on: percent of the volume, 100 at first. */
void speaker_levels(struct speaker *s, int music, int sounds);

/* Takes the sound of the frame that the board has just ticked; slow: sixtieths it is to last. Does nothing for a
 * board without sound, or muted. */
struct board;
void speaker_hear(struct speaker *s, const struct board *b, enum speaker_way way, int slow);

/* So much time has passed: what was heard goes to the card. */
void speaker_frame(struct speaker *s, const struct speaker_time *t);

/* With `exact`: does the card's clock lead? Is the next frame due by it? */
bool speaker_leads(const struct speaker *s);
bool speaker_due(const struct speaker *s);

/* Writes a line: how long a sound takes to the air, how the clocks differ, what was lost. */
void speaker_report(const struct speaker *s, char *line, size_t size);

/* Fades what sounds and waits, not long, until it has been heard; gives memory back. */
void speaker_close(struct speaker *s);

#endif
