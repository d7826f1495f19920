/*
 * wave.c - see wave.h. Within a block, phases have 32 bits, so that compilers can vectorise the loops; each block
 * starts at its exact phase.
 */
#include "wave.h"

#include <string.h>

/* Makes GCC vectorise this file in the same way with -O2 and -O3; -O3 would unroll the eight taps, which is slower. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O2", "tree-vectorize", "vect-cost-model=dynamic")
#endif

static void read_wave(const int16_t *wave, uint32_t phase, uint32_t step, int16_t out[SND_BLOCK])
{
    for (uint32_t n = 0; n < SND_BLOCK; n++) {
        const uint32_t q = phase + n * step, i = q >> (32 - WAVE_BITS);
        const int32_t f = (int32_t)(q >> (32 - WAVE_BITS - 15) & 0x7fff);
        out[n] = (int16_t)(wave[i] + ((wave[i + 1] - wave[i]) * f >> 15));
    }
}

/* A pulse is the difference of two saws. */
static void read_pulse(const int16_t *saw, uint32_t phase, uint32_t step, uint32_t duty, int16_t out[SND_BLOCK])
{
    int16_t shifted[SND_BLOCK];

    read_wave(saw, phase, step, out);
    read_wave(saw, phase - duty, step, shifted);
    for (int n = 0; n < SND_BLOCK; n++)
        out[n] = (int16_t)((out[n] - shifted[n]) >> 1);
}

/* Reads one version of the wave of an INST_WAVE instrument. */
static void read_custom_wave(const uint8_t *wave, int version, uint32_t phase, uint32_t step, int16_t out[SND_BLOCK])
{
    const uint8_t *p = wave + inst_wave_offset(version);
    const int bits = inst_wave_bits(version);

    for (uint32_t n = 0; n < SND_BLOCK; n++) {
        const uint32_t q = phase + n * step, i = 2 * (q >> (32 - bits));
        const int32_t a = (int16_t)bytes_get16(p + i), b = (int16_t)bytes_get16(p + i + 2);
        out[n] = (int16_t)(a + ((b - a) * (int32_t)(q >> (32 - bits - 15) & 0x7fff) >> 15));
    }
}

/* Reads version `mip` of an instrument's wave. Not for kinds whose wave has a single version. */
static void read_version(const struct snd_tables *t, const struct inst *inst, const struct wave_params *params, int mip,
                         int16_t out[SND_BLOCK])
{
    const uint32_t phase = (uint32_t)(params->phase >> 24), step = (uint32_t)(params->step >> 24);

    if (inst->kind == INST_PULSE)
        read_pulse(t->saw[mip], phase, step, (uint32_t)inst->duty << 16, out);
    else if (inst->kind == INST_WAVE)
        read_custom_wave(params->wave, mip < params->wave[0] ? mip : params->wave[0] - 1, phase, step, out);
    else
        read_wave(inst->kind == INST_SAW ? t->saw[mip] : t->triangle[mip], phase, step, out);
}

/* Reads a wave. If the frame's end needs another version than its start, crossfades between the two. */
static void read_versions(const struct snd_tables *t, const struct inst *inst, const struct wave_params *params,
                          int16_t out[SND_BLOCK])
{
    int16_t second[SND_BLOCK];

    read_version(t, inst, params, params->mip0, out);
    if (params->mip0 == params->mip1)
        return;
    read_version(t, inst, params, params->mip1, second);
    for (int n = 0; n < SND_BLOCK; n++)
        out[n] = (int16_t)(out[n] + (second[n] - out[n]) * (params->block_index * SND_BLOCK + n) / SND_FRAME);
}

static uint32_t mix_bits(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

/* Each value of the noise is a hash of its index; the phase is in 2^-44 turns (struct wave_params). */
static void read_noise(const struct wave_params *params, int16_t out[SND_BLOCK])
{
    for (uint32_t n = 0; n < SND_BLOCK; n++) {
        const uint32_t number = (uint32_t)((params->phase + n * params->step) >> 40);
        out[n] = (int16_t)(mix_bits(number * 0x9e3779b9u + params->seed) >> 16);
    }
}

void wave_compute_block(const struct snd_tables *t, const struct inst *inst, const struct wave_params *params,
                        int16_t out[SND_BLOCK])
{
    switch (inst->kind) {
    case INST_SINE:
        read_wave(t->sine, (uint32_t)(params->phase >> 24), (uint32_t)(params->step >> 24), out);
        break;
    case INST_NOISE:
        read_noise(params, out);
        break;
    default:
        read_versions(t, inst, params, out);
    }
}

/* ---- sums of products ---- */

enum { GROUP_SIZE = 4, SINC_SHIFT = 15, LOW_PASS_SHIFT = 14 };

/* One pointer for each sample of a group. */
typedef const int16_t *group[GROUP_SIZE];

#if defined(__SSE2__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define HAS_SHUFFLEVECTOR
#endif
#endif

#ifdef HAS_SHUFFLEVECTOR

__extension__ typedef int16_t lanes __attribute__((vector_size(16)));
__extension__ typedef int32_t sums __attribute__((vector_size(16)));

/* Returns the sum of the lanes of each argument, in one lane per argument. */
static inline sums sum_lanes(sums v, sums w, sums x, sums y)
{
    const sums a = __builtin_shufflevector(v, w, 0, 4, 1, 5) + __builtin_shufflevector(v, w, 2, 6, 3, 7);
    const sums b = __builtin_shufflevector(x, y, 0, 4, 1, 5) + __builtin_shufflevector(x, y, 2, 6, 3, 7);

    return __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
}

static inline sums multiply_add(sums sum, const int16_t *x, const int16_t *weights)
{
    lanes a, b;

    memcpy(&a, x, sizeof a);
    memcpy(&b, weights, sizeof b);
    return sum + (sums)__builtin_ia32_pmaddwd128(a, b);
}

/* Computes a group of samples, each the sum of `taps` values of x times their weights, shifted right by `shift` and
 * rounded. Gives the same results as the version below, but adds up the lanes of four samples together; compilers add
 * up the lanes of each sample separately. */
static inline void weighted_sums(const group x, const group weights, int taps, int shift, int16_t out[GROUP_SIZE])
{
    sums a = { 0 }, b = a, c = a, d = a;

    for (int j = 0; j < taps; j += 8) {
        a = multiply_add(a, x[0] + j, weights[0] + j);
        b = multiply_add(b, x[1] + j, weights[1] + j);
        c = multiply_add(c, x[2] + j, weights[2] + j);
        d = multiply_add(d, x[3] + j, weights[3] + j);
    }
    const int32_t half = 1 << (shift - 1);
    const sums halves = { half, half, half, half }, sum = (sum_lanes(a, b, c, d) + halves) >> shift;
    const lanes packed = (lanes)__builtin_ia32_packssdw128(sum, sum);
    memcpy(out, &packed, GROUP_SIZE * sizeof *out);
}

#else

static inline void weighted_sums(const group x, const group weights, int taps, int shift, int16_t out[GROUP_SIZE])
{
    for (int k = 0; k < GROUP_SIZE; k++) {
        int32_t sum = 1 << (shift - 1);
        for (int j = 0; j < taps; j++)
            sum += x[k][j] * weights[k][j];
        sum >>= shift;
        out[k] = (int16_t)(sum > 32767 ? 32767 : sum < -32768 ? -32768 : sum);
    }
}

#endif

void wave_resample_block(const struct snd_tables *t, const int16_t *x, uint32_t phase, uint64_t step,
                         int16_t out[SND_BLOCK])
{
    uint64_t at = phase;
    group from, weights;

    for (int n = 0; n < SND_BLOCK; n += GROUP_SIZE) {
        for (int k = 0; k < GROUP_SIZE; k++, at += step) {
            from[k] = x + (at >> 32) - 3;
            weights[k] = t->sinc[((at & 0xffffffff) + (1 << 21)) >> 22];
        }
        weighted_sums(from, weights, SINC_TAPS, SINC_SHIFT, out + n);
    }
}

/* ---- low-pass filters ---- */

/* Filters the group of samples that starts at x with a row of `low_pass`; -1: copies the group unchanged. */
static void filter_group(const struct snd_tables *t, int row, const int16_t *x, int16_t out[GROUP_SIZE])
{
    if (row < 0) {
        memcpy(out, x, GROUP_SIZE * sizeof *out);
        return;
    }
    const int16_t *w = t->low_pass[row], *from = x - LOW_PASS_TAPS / 2;
    weighted_sums((group){ from, from + 1, from + 2, from + 3 }, (group){ w, w, w, w }, LOW_PASS_TAPS, LOW_PASS_SHIFT,
                  out);
}

void wave_filter_low_pass(const struct snd_tables *t, const int16_t *x, int n, uint64_t step0, uint64_t step1,
                          int16_t *out)
{
    const int row0 = snd_low_pass_row(step0), row1 = snd_low_pass_row(step1);
    int16_t group0[GROUP_SIZE], group1[GROUP_SIZE];

    for (int i = 0; i < n; i += GROUP_SIZE) {
        const int count = n - i < GROUP_SIZE ? n - i : GROUP_SIZE;
        filter_group(t, row0, x + i, group0);
        if (row0 != row1)
            filter_group(t, row1, x + i, group1);
        for (int k = 0; row0 != row1 && k < count; k++)
            group0[k] = (int16_t)(group0[k] + (group1[k] - group0[k]) * (int64_t)(i + k) / n);
        memcpy(out + i, group0, (size_t)count * sizeof *out);
    }
}

/* ---- level ---- */

/* Returns the level that is left after `samples` samples, halving every `half_life` samples; half_life 0: it does not
 * fall. */
static int32_t decay_level(int32_t level, int32_t samples, uint32_t half_life)
{
    if (half_life == 0)
        return level;
    return (int32_t)((int64_t)level * pitch_exp2_neg(((uint64_t)(uint32_t)samples << 32) / half_life) >> 30);
}

static int32_t held_level(const struct env *e, int32_t age)
{
    const int32_t attack = (int32_t)e->attack;

    if (age < attack)
        return (int32_t)((int64_t)32767 * age / attack);
    const int32_t sustain = e->decay ? e->sustain : 32767;
    return decay_level(sustain + decay_level(32767 - sustain, age - attack, e->decay), age - attack, e->fade);
}

/* Returns the half-life of the release, at least 16 samples: a release of 0 would click. */
static uint32_t release_half_life(const struct env *e)
{
    return e->release > 16 ? e->release : 16;
}

int32_t wave_level(const struct env *e, int32_t age, int32_t release_age)
{
    if (age < 0)
        return 0;
    return age < release_age ? held_level(e, age)
                             : decay_level(held_level(e, release_age), age - release_age, release_half_life(e));
}

enum { HALVINGS = 15 /* halvings from full level to silence */ };

bool wave_is_silent(const struct env *e, int32_t age, int32_t release_age)
{
    const uint32_t attack = e->attack;

    if (release_age != AGE_NEVER && age > release_age &&
        (uint32_t)(age - release_age) / HALVINGS > release_half_life(e))
        return true;
    if (age < 0 || (uint32_t)age < attack)
        return false;
    const uint32_t since_attack = (uint32_t)age - attack;
    return (e->fade && since_attack / HALVINGS > e->fade) ||
           (e->decay && !e->sustain && since_attack / HALVINGS > e->decay);
}

bool wave_has_corner(const struct env *e, int32_t from, int32_t to, int32_t release_age)
{
    const int32_t attack = (int32_t)e->attack;

    return (from < 0 && to > 0) || (from < attack && to > attack) || (from < release_age && to > release_age);
}

static void add_channel(const int16_t wave[SND_BLOCK], int32_t g0, int32_t g1, int32_t mix[SND_BLOCK])
{
    int16_t gain[SND_BLOCK];

    for (int k = 0, g = g0 * SND_BLOCK; k < SND_BLOCK; k++, g += g1 - g0)
        gain[k] = (int16_t)(g >> 5);
    for (int k = 0; k < SND_BLOCK; k++)
        mix[k] += wave[k] * gain[k] >> 8;
}

void wave_add_to_mix(const int16_t wave[SND_BLOCK], const int16_t level[SND_BLOCK], const struct wave_gains *from,
                     const struct wave_gains *to, int32_t left[SND_BLOCK], int32_t right[SND_BLOCK])
{
    int16_t scaled[SND_BLOCK];

    for (int k = 0; k < SND_BLOCK; k++)
        scaled[k] = (int16_t)((wave[k] * level[k] + (1 << 14)) >> 15);
    add_channel(scaled, from->left, to->left, left);
    add_channel(scaled, from->right, to->right, right);
}

/* The curve is (2 - (3 - u)^3 / 27) / 2, where u is the excess over one half of full scale, in halves. It starts with
 * slope 1 and is flat at full scale. */
int16_t wave_limit(int32_t v)
{
    const int32_t half = 1 << 21;
    int32_t a = v < 0 ? -v : v;

    if (a > half) {
        const int64_t remaining = a - half > 3 * half ? 0 : 3 * half - (a - half);
        a = 2 * half - (int32_t)((remaining * remaining >> 21) * remaining / 27 >> 21);
    }
    a = (a + 64) >> 7;
    a = a > 32767 ? 32767 : a;
    return (int16_t)(v < 0 ? -a : a);
}
