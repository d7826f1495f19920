/*
 * pitch.h - pitches to steps, and levels that halve.
 *
 * A pitch is in 65536ths of a semitone; 69 semitones are the a of 440 Hz. All of it is integers.
 */
#ifndef SOUND_PITCH_H
#define SOUND_PITCH_H

#include <stdint.h>

enum {
    SND_RATE = 48000,  /* stereo frames a second */
    SND_FRAME = 800,   /* of them in a tick of the board */
    PITCH_ONE = 65536, /* a semitone */
    PITCH_MOST = 131 * PITCH_ONE
};

/* The phase step of a sample at SND_RATE, in 2^-56 of a turn; right to 0.0001 cents. Clamped to 0 .. PITCH_MOST. */
uint64_t pitch_step(int32_t pitch);

/* 2^(semitones / 12) in Q32. Clamped to eight octaves down and four up. */
uint64_t pitch_ratio(int32_t pitch);

/* 2^-x in Q30, x in Q32; 0 from x = 30 on. */
uint32_t pitch_halved(uint64_t x);

#endif
