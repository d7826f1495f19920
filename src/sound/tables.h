/*
 * tables.h - wave and filter tables for the mixer: computed once by the host, identical on every machine.
 *
 * The tables are not part of a board's RAM, because no tick reads them. Each wave has WAVE_MIPS versions, each with
 * more harmonics than the one before, so that for every pitch there is a version with all audible harmonics and without
 * audible aliasing (snd_mip).
 */
#ifndef SOUND_TABLES_H
#define SOUND_TABLES_H

#include <stdint.h>

enum {
    WAVE_BITS = 12,
    WAVE_LENGTH = 1 << WAVE_BITS,
    WAVE_MIPS = 19,
    SINC_TAPS = 8,
    SINC_PHASES = 1024,
    LOW_PASS_ROWS = 11, /* low-pass filters for steps up to 7/6 of a sample times 2^(1/6), 2^(2/6), ... */
    LOW_PASS_TAPS = 64,
    FEEDBACK_BITS = 10,
    FEEDBACK_LENGTH = 1 << FEEDBACK_BITS,
    FEEDBACK_ROWS = 33,      /* for feedback of 0 to 1.5 radians */
    FEEDBACK_ROW_UNITS = 256 /* units of feedback from one row to the next */
};

struct snd_tables {
    int16_t saw[WAVE_MIPS][WAVE_LENGTH + 1], triangle[WAVE_MIPS][WAVE_LENGTH + 1];
    int16_t sine[WAVE_LENGTH + 1];
    union {
        int16_t sinc[SINC_PHASES + 1][SINC_TAPS]; /* Q15: interpolates between the 4th and 5th of eight samples */
        int32_t sine30[WAVE_LENGTH];              /* while the waves and `feedback` are computed */
    };
    int16_t low_pass[LOW_PASS_ROWS]
                    [LOW_PASS_TAPS]; /* Q14: low-pass for a recording played faster, centred on tap LOW_PASS_TAPS / 2 */
    union {
        int16_t feedback[FEEDBACK_ROWS + 1][FEEDBACK_LENGTH + 1]; /* y = sin(p + b y); the last row is repeated */
        int64_t harmonic_sums[2][WAVE_LENGTH / 2];                /* while the waves are computed */
    };
    int16_t pan[257];                   /* equal power: left is pan[256 - p], right pan[p]; Q15 */
    int32_t music_volume, sound_volume; /* the listener's volumes, percent; snd_tables_make sets both to 100 */
};

/* Fills all tables; takes some milliseconds. */
void snd_tables_make(struct snd_tables *t);

/* Returns the version of a wave to use at a phase step of `step` (2^-32 turns per sample). */
int snd_mip(uint32_t step);

/* Returns the row of `low_pass` for a recording played at `step` samples per sample, Q32; -1: no filter is needed,
 * because no frequency folds back into the audible range. */
int snd_low_pass_row(uint64_t step);

#endif
