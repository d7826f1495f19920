/*
 * speaker.h - a board's sound on the host's speaker: volume, and held in step with a clock that is not quite ours.
 * floor: cab
 */
#ifndef CAB_SPEAKER_H
#define CAB_SPEAKER_H

#include <stdbool.h>
#include <stdint.h>

enum {
    SPEAKER_RATE = 48000,
    SPEAKER_BLOCK = SPEAKER_RATE / 60, /* stereo frames a tick makes */
    SPEAKER_STRETCH = 4,               /* a block may become so much longer or shorter: 0.5 % */
    SPEAKER_AHEAD = 3 * SPEAKER_BLOCK  /* what we like to see queued: 50 ms */
};

struct speaker {
    int volume; /* percent */
    bool muted;
    int16_t last[2]; /* of the block before */
    void *tables;    /* of board_sound, once there is something to play; malloc */
};

/* in: SPEAKER_BLOCK frames after `last`; out: n frames of the same sound, n at most SPEAKER_BLOCK + SPEAKER_STRETCH. */
void speaker_stretch(const int16_t last[2], const int16_t *in, int16_t *out, int n);

/* Plays the sound of the frame that the board has just ticked. */
struct board;
void speaker_play(struct speaker *s, const struct board *b);
void speaker_close(struct speaker *s);

#endif
