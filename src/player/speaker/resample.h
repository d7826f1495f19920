/*
 * resample.h - sound at a rate that is almost its own, or much slower: for a card whose clock is not ours, and for slow
 * motion.
 *
 * A sample between two is a sum of RESAMPLE_TAPS round it, by a table of a windowed sinc. At a step of exactly
 * RESAMPLE_ONE from the beginning the sound passes as it is, to the bit, RESAMPLE_AFTER frames late.
 */
#ifndef PLAYER_RESAMPLE_H
#define PLAYER_RESAMPLE_H

#include <stdint.h>

enum {
    RESAMPLE_TAPS = 24,
    RESAMPLE_AFTER = RESAMPLE_TAPS / 2,      /* frames that must be there behind the place */
    RESAMPLE_BEFORE = RESAMPLE_TAPS / 2 - 1, /* and before it */
    RESAMPLE_PHASES = 512,
    RESAMPLE_ROOM = 8192 /* frames */
};

#define RESAMPLE_ONE       ((uint64_t)1 << 32)
#define RESAMPLE_STEP_MOST (RESAMPLE_BEFORE * RESAMPLE_ONE) /* a longer step would leave what is in the buffer */

struct resample {
    float kernel[RESAMPLE_PHASES + 1][RESAMPLE_TAPS];
    int16_t in[2 * RESAMPLE_ROOM]; /* stereo; the first ones have passed */
    int n;                         /* frames in it */
    uint64_t at;                   /* where we are in it, Q32 */
};

/* Makes the table, some milliseconds; empty, after silence. resample_clear: empty again. */
void resample_open(struct resample *r);
void resample_clear(struct resample *r);

/* Adds frames; those there is no room for are lost. */
void resample_add(struct resample *r, const int16_t *lr, int frames);

/* Frames that could pass now. */
int resample_ready(const struct resample *r);

/* Lets at most `most` frames pass, a step (Q32 of a frame, cut to RESAMPLE_STEP_MOST) after the other. Returns how many
 * frames came out, room at most. */
int resample_take(struct resample *r, uint64_t step, int most, int16_t *out, int room);

#endif
