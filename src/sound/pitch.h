/*
 * pitch.h - conversion of pitches to phase steps, and exponential decay.
 *
 * A pitch is in 65536ths of a semitone; 69 semitones are A4, 440 Hz. Everything is integer arithmetic.
 */
#ifndef SOUND_PITCH_H
#define SOUND_PITCH_H

#include <stdint.h>

enum {
    SND_RATE = 48000,  /* stereo samples a second */
    SND_FRAME = 800,   /* stereo samples in a frame of the board */
    PITCH_ONE = 65536, /* a semitone */
    PITCH_MAX = 131 * PITCH_ONE
};

/* Returns a pitch's phase step per sample at SND_RATE, in 2^-56 turns, accurate to 0.0001 cents. The pitch is clamped
 * to 0 .. PITCH_MAX. */
uint64_t pitch_step(int32_t pitch);

/* Returns the frequency ratio of an interval, 2^(semitones / 12), in Q32. The interval is clamped to -8..4 octaves. */
uint64_t pitch_ratio(int32_t pitch);

/* Returns 2^-x in Q30, for x in Q32; 0 if x is at least 30. */
uint32_t pitch_exp2_neg(uint64_t x);

#endif
