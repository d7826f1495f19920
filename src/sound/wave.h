/*
 * wave.h - blocks of waves, envelope levels, and the mix.
 */
#ifndef SOUND_WAVE_H
#define SOUND_WAVE_H

#include "pitch.h"
#include "tables.h"
#include "tune.h"

enum { SND_BLOCK = 32, SND_FRAME_BLOCKS = SND_FRAME / SND_BLOCK };

/* A block of SND_BLOCK samples, for all kinds of instrument except FM and samples. phase: at the first sample; step:
 * phase per sample, both in 2^-56 turns; for noise, which has 16 values per turn, in 2^-44 turns, so that it does not
 * repeat. mip0, mip1: the versions of the wave at the frame's start and end; block_index: the block's index in the
 * frame, of SND_FRAME_BLOCKS; seed: for noise; wave: for INST_WAVE, the instrument's wave (inst.h). */
struct wave_params {
    uint64_t phase, step;
    int mip0, mip1, block_index;
    uint32_t seed;
    const uint8_t *wave;
};
void wave_compute_block(const struct snd_tables *t, const struct inst *inst, const struct wave_params *params,
                        int16_t out[SND_BLOCK]);

/* Computes a block of a sampled instrument. x: the sample at the integer part of the position; phase: the position's
 * fraction, Q32; step: samples per sample, Q32. Three samples before x must exist, and five after the last position of
 * the block. */
void wave_resample_block(const struct snd_tables *t, const int16_t *x, uint32_t phase, uint64_t step,
                         int16_t out[SND_BLOCK]);

/* Copies n samples without the frequencies that would fold back when they are played at step0 or step1 (Q32), fading
 * from the filter for step0 to the filter for step1 (snd_low_pass_row). LOW_PASS_TAPS / 2 samples before x must exist,
 * and as many after x + n, with n rounded up to a multiple of four. out must not overlap x. */
void wave_filter_low_pass(const struct snd_tables *t, const int16_t *x, int n, uint64_t step0, uint64_t step1,
                          int16_t *out);

/* Returns the level of a note, Q15, `age` samples after its start. off: the age of its release, or AGE_NEVER. */
int32_t wave_level(const struct env *e, int32_t age, int32_t off);

/* Returns whether a note is silent from `age` on. off: as for wave_level. */
bool wave_is_silent(const struct env *e, int32_t age, int32_t off);

/* Returns whether the slope of a note's level can jump between two ages. */
bool wave_has_corner(const struct env *e, int32_t from, int32_t to, int32_t off);

/* Gains of the two channels, Q15. */
struct wave_gains {
    int32_t left, right;
};

/* Adds a block to the mix, Q22: the wave times the levels times gains that change linearly from `from` to `to`. */
void wave_add_to_mix(const int16_t wave[SND_BLOCK], const int16_t level[SND_BLOCK], const struct wave_gains *from,
                     const struct wave_gains *to, int32_t left[SND_BLOCK], int32_t right[SND_BLOCK]);

/* Converts a mixed sample from Q22 to Q15. Values up to half of full scale are unchanged; above that, a curve reaches
 * full scale at twice full scale. */
int16_t wave_limit(int32_t mixed);

enum { AGE_NEVER = INT32_MAX /* age of an event that does not happen, such as `off` of a note that is not released */ };

#endif
