/*
 * loudness.c - see loudness.h. The K-weighting filters are those of the recommendation's tables for 48 kHz: a high
 * shelf, which models the head, and a high pass.
 */
#include "loudness.h"

#include <math.h>
#include <stdlib.h>

enum { STEP = 4800, BLOCK_STEPS = 4 /* blocks overlap: one starts at each step */ };

#define SILENCE_LUFS  (-70.0)
#define RELATIVE_GATE (-10.0)
#define OFFSET        (-0.691)

struct biquad {
    double b0, b1, b2, a1, a2;
};

static const struct biquad shelf = { 1.53512485958697, -2.69169618940638, 1.19839281085285, -1.69065929318241,
                                     0.73248077421585 };
static const struct biquad high_pass = { 1, -2, 1, -1.99004745483398, 0.99007225036621 };

static double filter(const struct biquad *f, double z[2], double x)
{
    const double y = f->b0 * x + z[0];

    z[0] = f->b1 * x - f->a1 * y + z[1];
    z[1] = f->b2 * x - f->a2 * y;
    return y;
}

/* Adds up the power of each step over both channels; the last step may be short. */
static void add_power(const int16_t *lr, size_t frames, double *power)
{
    for (int c = 0; c < 2; c++) {
        double z0[2] = { 0 }, z1[2] = { 0 };
        for (size_t i = 0; i < frames; i++) {
            const double y = filter(&high_pass, z1, filter(&shelf, z0, lr[2 * i + (size_t)c] / 32768.0));
            power[i / STEP] += y * y;
        }
    }
}

static double lufs(double power)
{
    return power > 0 ? OFFSET + 10 * log10(power) : -HUGE_VAL;
}

/* Returns the mean of the blocks louder than the gate, in LUFS. */
static double gated_mean(const double *power, size_t blocks, double gate)
{
    double sum = 0;
    size_t n = 0;

    for (size_t i = 0; i < blocks; i++) {
        const double p = (power[i] + power[i + 1] + power[i + 2] + power[i + 3]) / (STEP * BLOCK_STEPS);
        if (lufs(p) <= gate)
            continue;
        sum += p;
        n++;
    }
    return n ? lufs(sum / (double)n) : -HUGE_VAL;
}

double loudness(const int16_t *lr, size_t frames)
{
    const size_t steps = frames / STEP;
    double *power = calloc(steps + 1, sizeof *power), result = SILENCE_LUFS;

    if (!power || !frames) {
        free(power);
        return SILENCE_LUFS;
    }
    add_power(lr, frames, power);
    if (steps < BLOCK_STEPS) {
        double sum = 0;
        for (size_t i = 0; i <= steps; i++)
            sum += power[i];
        result = lufs(sum / (double)frames);
    } else {
        result = gated_mean(power, steps - BLOCK_STEPS + 1, SILENCE_LUFS);
        result = gated_mean(power, steps - BLOCK_STEPS + 1, result + RELATIVE_GATE);
    }
    free(power);
    return result > SILENCE_LUFS ? result : SILENCE_LUFS;
}

static double decibels(double level)
{
    return level > 0 ? 20 * log10(level / 32768) : -120;
}

double loudness_peak(const int16_t *lr, size_t frames)
{
    int peak = 0;

    for (size_t i = 0; i < 2 * frames; i++)
        peak = abs(lr[i]) > peak ? abs(lr[i]) : peak;
    return decibels(peak);
}

double loudness_mean(const int16_t *lr, size_t frames)
{
    double sum = 0;

    for (size_t i = 0; i < 2 * frames; i++)
        sum += (double)lr[i] * lr[i];
    return decibels(sqrt(sum / (frames ? 2 * (double)frames : 1)));
}
