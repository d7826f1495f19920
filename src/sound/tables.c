/*
 * tables.c - see tables.h. Each version of a wave is the previous one with more harmonics. Half a period is summed; the
 * other half follows by symmetry. The sums are integers, so the order of summation does not matter. The interpolation
 * filter is a Kaiser-windowed sinc; its SNR is 80 dB at 1 kHz and 67 dB at 10 kHz.
 */
#include "tables.h"

#include <string.h>
#include "../base/trig.h"

enum { HALF = WAVE_LENGTH / 2, WEIGHT_SHIFT = 2 * SINC_TAPS };

/* Number of harmonics of each version, ascending, in steps of about half an octave. */
static const uint16_t harmonics[WAVE_MIPS] = { 1,  2,  3,  4,   6,   8,   11,  16,  23, 32,
                                               45, 64, 91, 128, 181, 256, 362, 512, 640 };

/* Adds harmonic h to the sums: sine / h for the saw; +-sine / h^2 for the triangle, which has only odd harmonics. */
static void add_harmonic(struct snd_tables *t, uint32_t h)
{
    const int64_t amplitude = ((int64_t)1 << 20) / h;

    for (uint32_t i = 0, k = 0; i < HALF; i++, k += h) {
        const int64_t s = t->sine30[k % WAVE_LENGTH] * amplitude >> 20;
        t->harmonic_sums[0][i] += s;
        if (h & 1)
            t->harmonic_sums[1][i] += h & 2 ? -(s * amplitude >> 20) : s * amplitude >> 20;
    }
}

/* Stores the current sums as version m of the waves. A saw of full amplitude would overshoot to 1.18 between its
 * samples, so its amplitude is 0.84. */
static void store_version(struct snd_tables *t, int m)
{
    for (int i = 0; i < HALF; i++) {
        const int16_t saw = (int16_t)((t->harmonic_sums[0][i] * 41722 >> 16) * 27600 >> 30);
        const int16_t triangle = (int16_t)((t->harmonic_sums[1][i] * 53120 >> 16) * 32700 >> 30);
        t->saw[m][i] = saw;
        if (i > 0)
            t->saw[m][WAVE_LENGTH - i] = (int16_t)-saw;
        t->triangle[m][i] = triangle;
        t->triangle[m][HALF + i] = (int16_t)-triangle;
    }
    t->saw[m][HALF] = 0;
    t->saw[m][WAVE_LENGTH] = t->saw[m][0];
    t->triangle[m][WAVE_LENGTH] = t->triangle[m][0];
}

static void make_waves(struct snd_tables *t)
{
    uint32_t h = 1;

    memset(t->harmonic_sums, 0, sizeof t->harmonic_sums);
    for (int m = 0; m < WAVE_MIPS; m++) {
        for (; h <= harmonics[m]; h++)
            add_harmonic(t, h);
        store_version(t, m);
    }
}

/* Returns the Kaiser window with beta 7 at x / 4096 of its half width, not normalised: the Bessel function I0 in Q22,
 * summed from its power series. */
static int64_t kaiser(int32_t x)
{
    const int64_t q = ((int64_t)49 << 20) - ((int64_t)49 * x * x >> 4); /* (7/2)^2 (1 - (x/4096)^2), Q22 */
    int64_t term = (int64_t)1 << 30, sum = term;

    for (int k = 1; term > 0; k++) {
        term = (term * q >> 22) / (k * k);
        sum += term;
    }
    return sum >> 8;
}

/* Returns sin(pi c x) / (pi c x), Q30, with c = 993/1024 and x in 1024ths. */
static int64_t sinc(int32_t x)
{
    if (x == 0)
        return (int64_t)1 << 30;
    return (int64_t)trig_sin30((ang)(x * 993) << 11) * ((int64_t)1 << 32) / ((int64_t)x * 993 * 205887 / 16);
}

/* Scales n weights so that their sum is exactly `one`: rounds each to nearest, and corrects the one at `centre`. */
static void scale_weights(const int64_t *weight, int n, int32_t one, int centre, int16_t *out)
{
    int64_t sum = 0;
    int32_t deficit = one;

    for (int j = 0; j < n; j++)
        sum += weight[j];
    for (int j = 0; j < n; j++) {
        const int64_t twice = weight[j] * 2 * one + sum;
        out[j] = (int16_t)((twice - (twice < 0 ? 2 * sum - 1 : 0)) / (2 * sum));
        deficit -= out[j];
    }
    out[centre] = (int16_t)(out[centre] + deficit);
}

/* Computes the weights for one phase, Q15. */
static void make_sinc(int16_t out[SINC_TAPS], int phase)
{
    int64_t weight[SINC_TAPS];

    for (int j = 0; j < SINC_TAPS; j++) {
        const int32_t x = (j - 3) * SINC_PHASES - phase;
        weight[j] = (sinc(x) * kaiser(x)) >> WEIGHT_SHIFT;
    }
    scale_weights(weight, SINC_TAPS, 1 << 15, phase < SINC_PHASES / 2 ? 3 : 4, out);
}

/* ---- low-pass filters ---- */

/* cutoffs: the centre of each filter's transition band, in 2^-32 turns per sample; each filter stops the frequencies
 * that would alias below 20 kHz. max_steps: Q32; for each row, the largest step for which the row before it (for row 0,
 * no filter) is enough. */
static const uint32_t cutoffs[LOW_PASS_ROWS] = { 1761148586, 1552417058, 1366458407, 1200788083, 1053192604, 921699981,
                                                 804553372,  700187608,  607208282,  524373120,  450575381 };
static const uint64_t max_steps[LOW_PASS_ROWS] = { 5010795178,  5624427419,  6313206322,  7086334499,
                                                   7954141537,  8928222003,  10021590357, 11248854839,
                                                   12626412644, 14172668999, 15908283075 };

int snd_low_pass_row(uint64_t step)
{
    int row = -1;

    while (row < LOW_PASS_ROWS - 1 && step > max_steps[row + 1])
        row++;
    return row;
}

static void make_low_pass(int16_t out[LOW_PASS_TAPS], uint32_t cutoff)
{
    int64_t weight[LOW_PASS_TAPS] = { 0 };

    for (int j = 1; j < LOW_PASS_TAPS; j++) {
        const int32_t x = j - LOW_PASS_TAPS / 2;
        const int64_t ideal = x ? (int64_t)trig_sin30((ang)x * cutoff) * ((int64_t)1 << 16) / (x * (int64_t)205887)
                                : (int64_t)cutoff >> 1;
        weight[j] = (ideal * kaiser(x * (8192 / LOW_PASS_TAPS))) >> WEIGHT_SHIFT;
    }
    scale_weights(weight, LOW_PASS_TAPS, 1 << 14, LOW_PASS_TAPS / 2, out);
}

/* ---- feedback ---- */

/* Returns the sine of a phase in 2^-32 turns, Q30. */
static int32_t sine_at(const struct snd_tables *t, uint32_t phase)
{
    const uint32_t i = phase >> (32 - WAVE_BITS);
    const int64_t a = t->sine30[i], b = t->sine30[(i + 1) % WAVE_LENGTH];

    return (int32_t)(a + ((b - a) * (phase & ((1u << (32 - WAVE_BITS)) - 1)) >> (32 - WAVE_BITS)));
}

/* Solves y = sin(p + b y) for the b of a row. p goes around the turn, starting at half a turn, where y is 0; y follows
 * the stable branch, as a slow recursion would. */
static void make_feedback(struct snd_tables *t, int row)
{
    const int64_t modulation = (int64_t)row * 500658; /* 1.5 / 32 radians per row, in 2^-26 turns */
    int64_t y = 0;

    for (uint32_t k = 0; k < FEEDBACK_LENGTH; k++) {
        const uint32_t i = (k + FEEDBACK_LENGTH / 2) % FEEDBACK_LENGTH, phase = i << (32 - FEEDBACK_BITS);
        for (int iteration = 0; iteration < 24; iteration++)
            y += (sine_at(t, phase + (uint32_t)(y * modulation >> 24)) - y) / 2;
        t->feedback[row][i] = (int16_t)(y * 32767 >> 30);
    }
    t->feedback[row][FEEDBACK_LENGTH] = t->feedback[row][0];
}

void snd_tables_make(struct snd_tables *t)
{
    for (uint32_t i = 0; i < WAVE_LENGTH; i++)
        t->sine30[i] = trig_sin30((ang)i << (32 - WAVE_BITS));
    for (uint32_t i = 0; i <= WAVE_LENGTH; i++)
        t->sine[i] = (int16_t)((int64_t)t->sine30[i % WAVE_LENGTH] * 32767 >> 30);
    for (uint32_t i = 0; i <= 256; i++)
        t->pan[i] = (int16_t)((int64_t)trig_sin30((ang)i << 22) * 32767 >> 30);
    make_waves(t);
    for (int i = 0; i < FEEDBACK_ROWS; i++)
        make_feedback(t, i);
    for (int i = 0; i <= SINC_PHASES; i++) /* overwrites sine30 */
        make_sinc(t->sinc[i], i);
    for (int i = 0; i < LOW_PASS_ROWS; i++)
        make_low_pass(t->low_pass[i], cutoffs[i]);
    memcpy(t->feedback[FEEDBACK_ROWS], t->feedback[FEEDBACK_ROWS - 1], sizeof t->feedback[0]);
    t->music_volume = t->sound_volume = 100;
}

/* Allows harmonics up to 28 kHz: above half the sample rate, they fold back to 20 kHz or more, which is inaudible. */
int snd_mip(uint32_t step)
{
    int m = WAVE_MIPS - 1;

    while (m > 0 && (uint64_t)harmonics[m] * step > 2505397589u)
        m--;
    return m;
}
