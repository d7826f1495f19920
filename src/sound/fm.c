/*
 * fm.c - see fm.h. Sines are computed in 16-bit lanes. Within a quarter turn of a crest, a sine is a polynomial in w,
 * the square of the distance from the crest: cos = 1 - w - w (a - w (b - c w)), with a, b, c fitted to within about
 * 2^-16. Compilers do not emit the instruction for the high half of a product, so SSE2 builds use its builtin, with
 * bit-identical results. Compilers can vectorise all other loops for any width.
 */
#include "fm.h"

#include <string.h>

/* Makes GCC vectorise this file in the same way with -O2 and -O3. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O2", "tree-vectorize", "vect-cost-model=dynamic")
#endif

enum { POLY_A = 15303, POLY_B = 16560, POLY_C = 1257, POLY_ONE = 65534 };

static uint16_t mul_high(uint16_t a, uint16_t b)
{
    return (uint16_t)((uint32_t)a * b >> 16);
}

void fm_sines_portable(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK])
{
    for (int n = 0; n < FM_BLOCK; n++) {
        const int16_t x = (int16_t)(phase[n] >> 16), sign = (int16_t)(x >> 15);
        const int16_t from_crest = (int16_t)((x ^ sign) - 16384), distance = (int16_t)(from_crest ^ (from_crest >> 15));
        const uint16_t u = (uint16_t)(4 * distance + 2), w = mul_high(u, u); /* u: quarter turns from the crest, Q16 */
        const uint16_t correction =
            mul_high(w, (uint16_t)(POLY_A - mul_high(w, (uint16_t)(POLY_B - mul_high(w, POLY_C)))));
        const int16_t crest = (int16_t)((uint16_t)(POLY_ONE - w - correction) >> 1);
        out[n] = (int16_t)((crest ^ sign) - sign);
    }
}

#ifdef __SSE2__

enum { LANES = 8 };
__extension__ typedef int16_t lanes __attribute__((vector_size(2 * LANES)));
__extension__ typedef uint16_t ulanes __attribute__((vector_size(2 * LANES)));

static ulanes mul_high_lanes(ulanes a, ulanes b)
{
    return (ulanes)__builtin_ia32_pmulhuw128((lanes)a, (lanes)b);
}

static lanes sine_lanes(lanes x)
{
    const lanes sign = x >> 15, from_crest = (x ^ sign) - 16384, distance = from_crest ^ (from_crest >> 15);
    const ulanes u = (ulanes)(distance << 2) + 2, w = mul_high_lanes(u, u), c = (ulanes){ 0 } + POLY_C;
    const ulanes correction = mul_high_lanes(w, POLY_A - mul_high_lanes(w, POLY_B - mul_high_lanes(w, c)));
    const lanes crest = (lanes)((POLY_ONE - w - correction) >> 1);

    return (crest ^ sign) - sign;
}

void fm_sines(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK])
{
    int16_t x[FM_BLOCK];
    lanes v;

    for (int n = 0; n < FM_BLOCK; n++)
        x[n] = (int16_t)(phase[n] >> 16);
    for (int n = 0; n < FM_BLOCK; n += LANES) {
        memcpy(&v, x + n, sizeof v);
        v = sine_lanes(v);
        memcpy(out + n, &v, sizeof v);
    }
}

#else

void fm_sines(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK])
{
    fm_sines_portable(phase, out);
}

#endif

/* Interpolates between two rows and two columns of the feedback table. feedback: as for fm_compute_block. */
static void feedback_sines(const struct snd_tables *t, const uint32_t phase[FM_BLOCK], const int32_t feedback[2],
                           int16_t out[FM_BLOCK])
{
    const int32_t slope = (feedback[1] - feedback[0]) * 8; /* per sample, with 8 fraction bits: 256 / FM_BLOCK is 8 */

    for (int n = 0; n < FM_BLOCK; n++) {
        const int32_t b = feedback[0] + (slope * n >> 8);
        const int16_t *row = t->feedback[b / FEEDBACK_ROW_UNITS], *next = row + FEEDBACK_LENGTH + 1;
        const uint32_t i = phase[n] >> (32 - FEEDBACK_BITS);
        const int32_t f = (int32_t)(phase[n] >> (32 - FEEDBACK_BITS - 15) & 0x7fff);
        const int32_t y = row[i] + ((row[i + 1] - row[i]) * f >> 15), z = next[i] + ((next[i + 1] - next[i]) * f >> 15);
        out[n] = (int16_t)(y + ((z - y) * (b & (FEEDBACK_ROW_UNITS - 1)) >> 8));
    }
}

static void make_phases(const struct fm_op *op, const int32_t modulation[FM_BLOCK], uint32_t out[FM_BLOCK])
{
    const uint32_t phase = op->phase, step = op->step;

    for (uint32_t n = 0; n < FM_BLOCK; n++)
        out[n] = phase + n * step + (uint32_t)modulation[n];
}

/* Adds the output of operator op, `sine` times its gain, to the phase modulation of another operator. */
static void add_modulation(const int16_t sine[FM_BLOCK], const struct fm_op *op, int32_t modulation[FM_BLOCK])
{
    const int scale = op->scale;

    for (int n = 0; n < FM_BLOCK; n++)
        modulation[n] = (int32_t)((uint32_t)modulation[n] + ((uint32_t)(sine[n] * op->gain[n]) << scale));
}

static void add_audible(const int16_t sine[FM_BLOCK], const struct fm_op *op, int16_t out[FM_BLOCK])
{
    for (int n = 0; n < FM_BLOCK; n++)
        out[n] = (int16_t)(out[n] + ((sine[n] * op->gain[n] + (1 << 14)) >> 15));
}

void fm_compute_block(const struct snd_tables *t, int ops, int algorithm, const struct fm_op *op,
                      const int32_t feedback[2], int16_t out[FM_BLOCK])
{
    const unsigned audible = inst_audible_ops(ops, algorithm);
    int32_t modulation[FM_OPS][FM_BLOCK] = { { 0 } };
    uint32_t phase[FM_BLOCK];
    int16_t sine[FM_BLOCK];

    memset(out, 0, FM_BLOCK * sizeof *out);
    for (int k = 0; k < ops; k++) {
        const unsigned modulated = inst_modulated_ops(ops, algorithm, k);
        make_phases(&op[k], modulation[k], phase);
        if (k == 0 && (feedback[0] | feedback[1]))
            feedback_sines(t, phase, feedback, sine);
        else
            fm_sines(phase, sine);
        for (int to = k + 1; to < ops; to++)
            if (modulated >> to & 1)
                add_modulation(sine, &op[k], modulation[to]);
        if (audible >> k & 1)
            add_audible(sine, &op[k], out);
    }
}

/* ---- feedback strength ---- */

enum { STRENGTHS = 8, OCTAVES = 7 /* from note 24 up */ };

/* For each b of the recursion y = sin(p + b (y' + y'') / 2) at 48 kHz, where y' and y'' are the last two samples: the b
 * of the closed form y = sin(p + b y) with the nearest harmonics, in 4096ths of a radian. Rows: the recursion's b, from
 * 1.5 / 8 to 1.5 radians; columns: the C of seven octaves. */
static const int16_t equivalent_b[STRENGTHS][OCTAVES] = {
    { 778, 778, 758, 758, 758, 758, 737 },        { 1536, 1536, 1536, 1536, 1516, 1475, 1393 },
    { 2294, 2294, 2294, 2273, 2212, 2109, 1987 }, { 3072, 3052, 3011, 2929, 2785, 2601, 2540 },
    { 3789, 3748, 3645, 3482, 3236, 3031, 2826 }, { 4424, 4301, 4116, 3891, 3604, 3400, 3359 },
    { 5018, 4813, 4526, 4198, 3891, 3707, 3645 }, { 5632, 5284, 4895, 4485, 4116, 3953, 3891 },
};
static const uint64_t note_24_step = 49094033266598; /* phase step of note 24, 2^-56 turns per sample */

/* Returns the number of octaves above note 24, in 256ths, interpolated linearly in `step` within an octave. It is at
 * least 0 and at most 256 * (OCTAVES - 1). */
static int32_t octave_position(uint64_t step)
{
    int32_t octave = 0;

    if (step <= note_24_step)
        return 0;
    while (step >> octave >= 2 * note_24_step && octave < OCTAVES - 1)
        octave++;
    if (octave == OCTAVES - 1)
        return 256 * octave;
    return 256 * octave + (int32_t)(((step >> octave) - note_24_step) / (note_24_step >> 8));
}

static int32_t interpolate_octave(int k, int32_t at)
{
    const int16_t *row = equivalent_b[k > 0 ? k - 1 : 0];
    const int32_t i = at >> 8, a = row[i], b = i < OCTAVES - 1 ? row[i + 1] : a;

    return k > 0 ? a + (b - a) * (at & 255) / 256 : 0;
}

int32_t fm_equivalent_feedback(int32_t b, uint64_t step)
{
    const int32_t at = octave_position(step), scaled = b * STRENGTHS, i = scaled / FM_MAX_FEEDBACK;
    const int32_t below = interpolate_octave(i, at), above = i < STRENGTHS ? interpolate_octave(i + 1, at) : below;
    const int32_t radians = below + (above - below) * (scaled % FM_MAX_FEEDBACK) / FM_MAX_FEEDBACK;

    return radians * (FEEDBACK_ROWS - 1) * (FEEDBACK_ROW_UNITS / 256) / (FM_MAX_FEEDBACK / 256);
}

/* ---- notes ---- */

/* Returns the age at which an operator is released; AGE_NEVER if it ignores the note's release at age `release_age`. */
static int32_t op_release_age(const struct op *o, int32_t release_age)
{
    return o->env.release ? release_age : AGE_NEVER;
}

static void store_levels(struct fm_note *f, int32_t age, int32_t release_age)
{
    f->level_age = age;
    for (int k = 0; k < f->n_ops; k++)
        f->level[k] = wave_level(&f->op[k].env, age, op_release_age(&f->op[k], release_age));
}

void fm_begin(struct fm_note *f, const struct inst *inst, const uint8_t *bytes)
{
    f->n_ops = inst_op_count(inst->kind);
    f->algorithm = inst->algorithm;
    f->feedback = inst->feedback;
    f->level_age = INT32_MIN;
    for (int k = 0; k < f->n_ops; k++)
        f->op[k] = inst_read_op(bytes, k);
}

/* Returns unit * level / 32767, rounded to nearest. */
static int32_t gain_of(int32_t unit, int32_t level)
{
    const int64_t gain = ((int64_t)unit * level * 65538 + (1 << 30)) >> 31; /* 65538: 2^31 / 32767 */

    return gain > 32767 ? 32767 : (int32_t)gain;
}

/* Computes an operator's gains in a block: its own level times its envelope. level: the envelope's level at `age` and
 * at the block's end. */
static void make_gains(const struct op *o, bool is_audible, int32_t age, int32_t release_age, const int32_t level[2],
                       struct fm_op *out)
{
    const struct env *e = &o->env;
    int32_t unit = o->level;

    out->scale = 0;
    if (!is_audible) {
        while (o->level >= 1024 << out->scale)
            out->scale++;
        unit = o->level * 32 >> out->scale;
    }
    if (wave_has_corner(e, age, age + FM_BLOCK, release_age)) {
        for (int n = 0; n < FM_BLOCK; n++)
            out->gain[n] = (int16_t)gain_of(unit, wave_level(e, age + n, release_age));
        return;
    }
    const int32_t from = gain_of(unit, level[0]), delta = gain_of(unit, level[1]) - from;
    for (int n = 0, v = from * FM_BLOCK; n < FM_BLOCK; n++, v += delta)
        out->gain[n] = (int16_t)(v >> 5);
}

void fm_compute_note_block(struct fm_note *f, const struct snd_tables *t, int32_t age, int32_t release_age,
                           uint64_t phase, uint64_t step, int16_t out[FM_BLOCK])
{
    const unsigned audible = inst_audible_ops(f->n_ops, f->algorithm);
    struct fm_op op[FM_OPS];
    int32_t from[FM_OPS], feedback[2] = { 0, 0 };

    if (f->level_age != age)
        store_levels(f, age, release_age);
    memcpy(from, f->level, sizeof from);
    store_levels(f, age + FM_BLOCK, release_age);
    for (int k = 0; k < f->n_ops; k++) {
        const struct op *o = &f->op[k];
        const int32_t level[2] = { from[k], f->level[k] };
        op[k].phase = (uint32_t)(phase * o->ratio >> 32) + (uint32_t)age * (uint32_t)o->detune;
        op[k].step = (uint32_t)(step * o->ratio >> 32) + (uint32_t)o->detune;
        make_gains(o, audible >> k & 1, age, op_release_age(o, release_age), level, &op[k]);
        if (k == 0 && f->feedback)
            for (int end = 0; end < 2; end++)
                feedback[end] = fm_equivalent_feedback(f->feedback * level[end] >> 15, (step >> 8) * o->ratio);
    }
    fm_compute_block(t, f->n_ops, f->algorithm, op, feedback, out);
}
