/*
 * resample.h - resamples sound at almost the same rate, for a sound card with another clock, or much slower, for slow
 * motion.
 *
 * A sample between two others is a sum of the RESAMPLE_TAPS samples around it, weighted by a windowed sinc. As long as
 * every step is exactly RESAMPLE_ONE, the sound passes through unchanged, delayed by RESAMPLE_AFTER frames.
 */
#ifndef PLAYER_RESAMPLE_H
#define PLAYER_RESAMPLE_H

#include <stdint.h>

enum {
    RESAMPLE_TAPS = 24,
    RESAMPLE_AFTER = RESAMPLE_TAPS / 2,      /* frames needed after the position */
    RESAMPLE_BEFORE = RESAMPLE_TAPS / 2 - 1, /* frames needed before it */
    RESAMPLE_PHASES = 512,
    RESAMPLE_CAPACITY = 8192 /* frames */
};

#define RESAMPLE_ONE      ((uint64_t)1 << 32)
#define RESAMPLE_MAX_STEP (RESAMPLE_BEFORE * RESAMPLE_ONE) /* a longer step could leave the buffer */

struct resample {
    float kernel[RESAMPLE_PHASES + 1][RESAMPLE_TAPS];
    int16_t in[2 * RESAMPLE_CAPACITY]; /* stereo */
    int frames;                        /* stored in `in` */
    uint64_t position;                 /* of the next output frame in `in`, Q32 */
};

/* resample_open makes the table, in a few milliseconds, and starts after silence; resample_clear only restarts. */
void resample_open(struct resample *r);
void resample_clear(struct resample *r);

/* Adds frames. Drops those that don't fit. */
void resample_add(struct resample *r, const int16_t *lr, int frames);

/* Returns the number of input frames that could be resampled now. */
int resample_ready(const struct resample *r);

/* Resamples at most max_input input frames, in steps of `step` (Q32 frames, at most RESAMPLE_MAX_STEP). Returns the
 * number of output frames, at most capacity. */
int resample_take(struct resample *r, uint64_t step, int max_input, int16_t *out, int capacity);

#endif
