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
static double weight(double away)
{
    const double share = away / (RESAMPLE_TAPS / 2);

    if (fabs(share) >= 1)
        return 0;
    const double window = bessel(beta * sqrt(1 - share * share)) / bessel(beta);
    return away == 0 ? 1 : sin(pi * away) / (pi * away) * window;
}

/* Makes a row with the sum 1, so that levels don't change. */
static void make_row(float row[RESAMPLE_TAPS], double phase)
{
    double w[RESAMPLE_TAPS], sum = 0;

    for (int i = 0; i < RESAMPLE_TAPS; i++) {
        const double away = i - RESAMPLE_BEFORE - phase;
        w[i] = phase == 0 || phase == 1 ? away == 0 : weight(away);
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
    r->n = RESAMPLE_BEFORE;
    r->at = RESAMPLE_BEFORE * RESAMPLE_ONE;
}

void resample_add(struct resample *r, const int16_t *lr, int frames)
{
    const int room = RESAMPLE_ROOM - r->n;

    frames = frames < room ? frames : room;
    memcpy(r->in + 2 * r->n, lr, (size_t)frames * 2 * sizeof *lr);
    r->n += frames;
}

int resample_ready(const struct resample *r)
{
    const int n = r->n - RESAMPLE_AFTER - (int)(r->at >> 32);

    return n > 0 ? n : 0;
}

static int16_t rounded(float v)
{
    v = v < INT16_MIN ? INT16_MIN : v > INT16_MAX ? INT16_MAX : v;
    return (int16_t)lrintf(v);
}

static void between(const struct resample *r, int16_t out[2])
{
    const uint32_t part = (uint32_t)r->at, phase = part / (UINT32_MAX / RESAMPLE_PHASES + 1);
    const float share = (float)(part % (UINT32_MAX / RESAMPLE_PHASES + 1)) / (float)(UINT32_MAX / RESAMPLE_PHASES + 1);
    const float *k0 = r->kernel[phase], *k1 = r->kernel[phase + 1];
    const int16_t *x = r->in + 2 * ((int)(r->at >> 32) - RESAMPLE_BEFORE);
    float left = 0, right = 0;

    for (int i = 0; i < RESAMPLE_TAPS; i++) {
        const float k = k0[i] + (k1[i] - k0[i]) * share;
        left += k * x[2 * i];
        right += k * x[2 * i + 1];
    }
    out[0] = rounded(left);
    out[1] = rounded(right);
}

/* Removes frames that have passed. */
static void forget(struct resample *r)
{
    const int passed = (int)(r->at >> 32) - RESAMPLE_BEFORE;

    memmove(r->in, r->in + 2 * passed, (size_t)(r->n - passed) * 2 * sizeof *r->in);
    r->n -= passed;
    r->at -= (uint64_t)passed << 32;
}

int resample_take(struct resample *r, uint64_t step, int most, int16_t *out, int room)
{
    const int ready = resample_ready(r), pass = most < ready ? most : ready;
    const uint64_t end = ((r->at >> 32) + (uint64_t)pass) << 32;
    int n = 0;

    step = step < RESAMPLE_STEP_MOST ? step : RESAMPLE_STEP_MOST;
    for (; r->at < end && n < room; n++, r->at += step) {
        const bool whole = (uint32_t)r->at == 0;
        if (whole)
            memcpy(out + 2 * n, r->in + 2 * (r->at >> 32), 2 * sizeof *out);
        else
            between(r, out + 2 * n);
    }
    forget(r);
    return n;
}
