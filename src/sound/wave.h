/*
 * wave.h - a stretch of a wave, its level in time, and the mix of all.
 */
#ifndef SOUND_WAVE_H
#define SOUND_WAVE_H

#include "pitch.h"
#include "tables.h"
#include "tune.h"

enum { SND_BLOCK = 32, SND_BLOCKS = SND_FRAME / SND_BLOCK };

/* A block of SND_BLOCK samples. phase: of the first, 2^-56 turns; step: from one to the next; mips: the versions of a
 * wave at the frame's beginning and end, which is reached after `part` + 1 of SND_BLOCKS blocks; seed: of noise, of
 * which a turn has 16 values and whose phase and step are in 2^-44 turns, for it is not to repeat; wave: where the
 * tune's own is, of INST_WAVE. All kinds but FM and samples. */
struct wave_at {
    uint64_t phase, step;
    int mip0, mip1, part;
    uint32_t seed;
    const uint8_t *wave;
};
void wave_block(const struct snd_tables *t, const struct inst *inst, const struct wave_at *at, int16_t out[SND_BLOCK]);

/* The same of samples: x is the one at `phase`, in Q32, of which the whole part counts no more; three before and, after
 * all that the block passes, five more are there. */
void wave_sample(const struct snd_tables *t, const int16_t *x, uint32_t phase, uint64_t step, int16_t out[SND_BLOCK]);

/* What n samples are without what would fold back at those two steps, Q32 (snd_low): from the one's pass to the
 * other's. LOW_TAPS / 2 samples before x and behind its n, rounded up to four, are there. out is elsewhere. */
void wave_low(const struct snd_tables *t, const int16_t *x, int n, uint64_t step0, uint64_t step1, int16_t *out);

/* The level of a note, Q15, `age` samples after its beginning; it was let go at age `off`. */
int32_t wave_level(const struct env *e, int32_t age, int32_t off);

/* Is it silent from then on? */
bool wave_over(const struct env *e, int32_t age, int32_t off);

/* Does the level have a corner between two ages? */
bool wave_corner(const struct env *e, int32_t from, int32_t to, int32_t off);

/* Gains of the two sides, Q15. */
struct wave_sides {
    int32_t left, right;
};

/* Adds a block to the mix, Q22: the wave times its levels times gains that go from one pair to the other. */
void wave_add(const int16_t wave[SND_BLOCK], const int16_t level[SND_BLOCK], const struct wave_sides *from,
              const struct wave_sides *to, int32_t left[SND_BLOCK], int32_t right[SND_BLOCK]);

/* A mixed sample in Q22 to Q15: as it is to half of full scale, above it a curve that reaches full scale at 2. */
int16_t wave_limit(int32_t mixed);

enum { NOTE_HELD = INT32_MAX /* `off` of a note that is not let go */ };

#endif
