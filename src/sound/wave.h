/*
 * wave.h - blocks of waves, envelope levels, and the mix.
 */
#ifndef SOUND_WAVE_H
#define SOUND_WAVE_H

#include "pitch.h"
#include "tables.h"
#include "tune.h"

enum { SND_BLOCK = 32, SND_BLOCKS = SND_FRAME / SND_BLOCK };

/* A block of SND_BLOCK samples, of any kind of instrument except FM and samples. phase: of the first sample, step:
 * phase per sample, both in 2^-56 turns; mip0, mip1: the versions of the wave at the frame's start and end; part: the
 * block's index in the frame, of SND_BLOCKS; seed: for noise, which has 16 values per turn and whose phase and step are
 * in 2^-44 turns, so that it does not repeat; wave: for INST_WAVE, the tune's own wave. */
struct wave_at {
    uint64_t phase, step;
    int mip0, mip1, part;
    uint32_t seed;
    const uint8_t *wave;
};
void wave_block(const struct snd_tables *t, const struct inst *inst, const struct wave_at *at, int16_t out[SND_BLOCK]);

/* Computes a block of a recording. x: the sample at the integer part of the position; phase: the fraction, Q32; step:
 * Q32. x must have three samples before it, and five after all that the block passes. */
void wave_sample(const struct snd_tables *t, const int16_t *x, uint32_t phase, uint64_t step, int16_t out[SND_BLOCK]);

/* Removes from n samples the frequencies that would fold back at the two steps, Q32, fading from the filter for step0
 * to the one for step1 (snd_low). x must have LOW_TAPS / 2 samples before it, and as many after its n, rounded up to a
 * multiple of four. out must not overlap x. */
void wave_low(const struct snd_tables *t, const int16_t *x, int n, uint64_t step0, uint64_t step1, int16_t *out);

/* Returns the level of a note, Q15, `age` samples after its start. off: the age of its release, or NOTE_HELD. */
int32_t wave_level(const struct env *e, int32_t age, int32_t off);

/* Returns whether a note is silent from that age on. */
bool wave_over(const struct env *e, int32_t age, int32_t off);

/* Returns whether the level's slope can jump between two ages. */
bool wave_corner(const struct env *e, int32_t from, int32_t to, int32_t off);

/* Gains of the two channels, Q15. */
struct wave_sides {
    int32_t left, right;
};

/* Adds a block to the mix, Q22: the wave times its levels times gains that change linearly from `from` to `to`. */
void wave_add(const int16_t wave[SND_BLOCK], const int16_t level[SND_BLOCK], const struct wave_sides *from,
              const struct wave_sides *to, int32_t left[SND_BLOCK], int32_t right[SND_BLOCK]);

/* Converts a mixed sample from Q22 to Q15: unchanged up to half of full scale, above that a curve that reaches full
 * scale at 2. */
int16_t wave_limit(int32_t mixed);

enum { NOTE_HELD = INT32_MAX /* `off` of a note that is not released */ };

#endif
