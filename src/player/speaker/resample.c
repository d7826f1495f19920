/*
 * resample.c - resamples sound (resample.h). Coefficients are interpolated between two phases of the table; the error
 * of that is at -106 dB. With a Kaiser window, 24 taps and beta 10, errors up to 16 kHz are below the rounding of 16
 * bits.
 */
#include "resample.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double pi = 3.14159265358979323846, beta = 10;

/* The modified Bessel function of the first kind, order 0, by its series. */
static double bessel(double x)
{
    double sum = 1, term = 1;

    for (int k = 1; k < 40; k++) {
        term *= x / (2 * k) * (x / (2 * k));
        sum += term;
    }
    return sum;
}

/* Returns the weight of a sample at this distance from the position. */
static double weight(double distance)
{
    const double fraction = distance / (RESAMPLE_TAPS / 2);

    if (fabs(fraction) >= 1)
        return 0;
    const double window = bessel(beta * sqrt(1 - fraction * fraction)) / bessel(beta);
    return distance == 0 ? 1 : sin(pi * distance) / (pi * distance) * window;
}

/* Makes a row with the sum 1, so that levels don't change. */
static void make_row(float row[RESAMPLE_TAPS], double phase)
{
    double w[RESAMPLE_TAPS], sum = 0;

    for (int i = 0; i < RESAMPLE_TAPS; i++) {
        const double distance = i - RESAMPLE_BEFORE - phase;
        w[i] = phase == 0 || phase == 1 ? distance == 0 : weight(distance);
        sum += w[i];
    }
    for (int i = 0; i < RESAMPLE_TAPS; i++)
        row[i] = (float)(w[i] / sum);
}

void resample_open(struct resample *r)
{
    for (int i = 0; i <= RESAMPLE_PHASES; i++)
        make_row(r->kernel[i], i / (double)RESAMPLE_PHASES);
    resample_clear(r);
}

void resample_clear(struct resample *r)
{
    memset(r->in, 0, sizeof r->in);
    r->frames = RESAMPLE_BEFORE;
    r->position = RESAMPLE_BEFORE * RESAMPLE_ONE;
}

void resample_add(struct resample *r, const int16_t *lr, int frames)
{
    const int space = RESAMPLE_CAPACITY - r->frames;

    frames = frames < space ? frames : space;
    memcpy(r->in + 2 * r->frames, lr, (size_t)frames * 2 * sizeof *lr);
    r->frames += frames;
}

int resample_ready(const struct resample *r)
{
    const int frames = r->frames - RESAMPLE_AFTER - (int)(r->position >> 32);

    return frames > 0 ? frames : 0;
}

static int16_t rounded(float v)
{
    v = v < INT16_MIN ? INT16_MIN : v > INT16_MAX ? INT16_MAX : v;
    return (int16_t)lrintf(v);
}

static void interpolate(const struct resample *r, int16_t out[2])
{
    const uint32_t part = (uint32_t)r->position, phase = part / (UINT32_MAX / RESAMPLE_PHASES + 1);
    const float fraction =
        (float)(part % (UINT32_MAX / RESAMPLE_PHASES + 1)) / (float)(UINT32_MAX / RESAMPLE_PHASES + 1);
    const float *k0 = r->kernel[phase], *k1 = r->kernel[phase + 1];
    const int16_t *x = r->in + 2 * ((int)(r->position >> 32) - RESAMPLE_BEFORE);
    float left = 0, right = 0;

    for (int i = 0; i < RESAMPLE_TAPS; i++) {
        const float k = k0[i] + (k1[i] - k0[i]) * fraction;
        left += k * x[2 * i];
        right += k * x[2 * i + 1];
    }
    out[0] = rounded(left);
    out[1] = rounded(right);
}

/* Removes frames that have passed. */
static void drop_passed(struct resample *r)
{
    const int passed = (int)(r->position >> 32) - RESAMPLE_BEFORE;

    memmove(r->in, r->in + 2 * passed, (size_t)(r->frames - passed) * 2 * sizeof *r->in);
    r->frames -= passed;
    r->position -= (uint64_t)passed << 32;
}

int resample_take(struct resample *r, uint64_t step, int max_input, int16_t *out, int capacity)
{
    const int ready = resample_ready(r), pass = max_input < ready ? max_input : ready;
    const uint64_t end = ((r->position >> 32) + (uint64_t)pass) << 32;
    int frames = 0;

    step = step < RESAMPLE_MAX_STEP ? step : RESAMPLE_MAX_STEP;
    for (; r->position < end && frames < capacity; frames++, r->position += step) {
        const bool is_input_frame = (uint32_t)r->position == 0;
        if (is_input_frame)
            memcpy(out + 2 * frames, r->in + 2 * (r->position >> 32), 2 * sizeof *out);
        else
            interpolate(r, out + 2 * frames);
    }
    drop_passed(r);
    return frames;
}
