/*
 * tables.h - waves and filters that the sound is made of: computed once by the host, equal on every machine.
 *
 * They are no part of a board's RAM, for no tick reads them. A wave is there in WAVE_MIPS versions, each with fewer
 * harmonics than the one before, so that at every pitch one has all that can be heard and nothing that folds back.
 */
#ifndef SOUND_TABLES_H
#define SOUND_TABLES_H

#include <stdint.h>

enum {
    WAVE_BITS = 12,
    WAVE_LONG = 1 << WAVE_BITS,
    WAVE_MIPS = 19,
    SINC_TAPS = 8,
    SINC_PHASES = 1024,
    LOW_ROWS = 11, /* passes for steps up to 7/6 of a sample times 2^(1/6), 2^(2/6) ... */
    LOW_TAPS = 64,
    FEEDBACK_BITS = 10,
    FEEDBACK_LONG = 1 << FEEDBACK_BITS,
    FEEDBACK_ROWS = 33, /* of 0 to 1.5 radians */
    FEEDBACK_ROW = 256  /* between two of them */
};

struct snd_tables {
    uint16_t harmonics[WAVE_MIPS]; /* of each version, ascending */
    int16_t saw[WAVE_MIPS][WAVE_LONG + 1], triangle[WAVE_MIPS][WAVE_LONG + 1];
    int16_t sine[WAVE_LONG + 1];
    int16_t sinc[SINC_PHASES + 1][SINC_TAPS]; /* Q15: between the 4th and the 5th of eight samples */
    int16_t low[LOW_ROWS][LOW_TAPS];          /* Q14: what a sample read faster must lose, around tap LOW_TAPS / 2 */
    int16_t feedback[FEEDBACK_ROWS + 1][FEEDBACK_LONG + 1]; /* y = sin(p + b y); the last row stands there again */
    int16_t pan[257];               /* of equal power: left is pan[256 - p], right pan[p]; Q15 */
    int64_t work[2][WAVE_LONG / 2]; /* what the sums were made in */
    int32_t sine30[WAVE_LONG];
    int32_t music, sounds; /* percent: how loud whoever listens wants them; 100 and 100 when made */
};

/* Fills all of it: some milliseconds. */
void snd_tables_make(struct snd_tables *t);

/* The version for notes of that step (2^-32 turns a sample). */
int snd_mip(const struct snd_tables *t, uint32_t step);

/* The row of `low` for a recording at that step, Q32; -1: nothing of it folds back to where it is heard. */
int snd_low(uint64_t step);

#endif
