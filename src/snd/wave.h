/*
 * wave.h - a stretch of a wave, its level in time, and the mix of all.
 * floor: snd
 */
#ifndef SND_WAVE_H
#define SND_WAVE_H

#include "pitch.h"
#include "tables.h"
#include "tune.h"

enum { SND_BLOCK = 32, SND_BLOCKS = SND_FRAME / SND_BLOCK };

/* A block of SND_BLOCK samples. phase: of the first, 2^-56 turns; step: from one to the next; mips: the versions of a
 * wave at the frame's beginning and end, which is reached after `part` + 1 of SND_BLOCKS blocks; depth: of FM, at
 * the block's beginning and end, 2^-32 turns; seed: of noise. All waves but samples. */
struct wave_at {
    uint64_t phase, step;
    int mip0, mip1, part;
    int64_t depth0, depth1;
    uint32_t seed;
};
void wave_block(const struct snd_tables *t, const struct inst *inst, const struct wave_at *at, int16_t out[SND_BLOCK]);

/* The same of samples: x is the one at `phase`, in Q32, of which the whole part counts no more; three before and, after
 * all that the block passes, five more are there. */
void wave_sample(const struct snd_tables *t, const int16_t *x, uint32_t phase, uint64_t step, int16_t out[SND_BLOCK]);

/* The level of a note, Q15, `age` samples after its beginning; it was let go at age `off`. */
int32_t wave_level(const struct inst *i, int32_t age, int32_t off);

/* Is it silent from then on? */
bool wave_over(const struct inst *i, int32_t age, int32_t off);

/* Does the level have a corner between two ages? */
bool wave_corner(const struct inst *i, int32_t from, int32_t to, int32_t off);

/* A mixed sample in Q22 to Q15: as it is to half of full scale, above it a curve that reaches full scale at 2. */
int16_t wave_limit(int32_t mixed);

enum { NOTE_HELD = INT32_MAX /* `off` of a note that is not let go */ };

#endif
