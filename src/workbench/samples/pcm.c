/*
 * pcm.c - see pcm.h. A rate above SND_RATE is resampled with a windowed sinc of 2 * ZEROES zero crossings: frequencies
 * below 20 kHz don't change, aliases are 90 dB lower. The loop becomes a whole number of new samples, counted from its
 * start, so that it stays exact; the pitch of a loop longer than half a second changes by less than 0.1 cents.
 */
#include "pcm.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../sound/adpcm.h"
#include "../../sound/pitch.h"

static int16_t to_sample(double v)
{
    const double scaled = v * 32768;

    return (int16_t)(scaled >= 32767 ? 32767 : scaled > -32768 ? lrint(scaled) : -32768);
}

static uint64_t max_frames(const struct pcm *p)
{
    return p->rate <= SND_RATE ? SAMPLE_MAX_LENGTH : (uint64_t)SAMPLE_MAX_LENGTH * p->rate / SND_RATE;
}

/* Reserves memory for n more frames. */
static bool reserve(struct pcm *p, size_t n)
{
    if (p->n + (uint64_t)n > max_frames(p))
        return false;
    if (p->n + n > p->capacity) {
        const size_t capacity = 2 * (p->n + n);
        int16_t *more = realloc(p->frames, capacity * (size_t)p->channels * sizeof *more);
        if (more == NULL)
            return false;
        p->frames = more;
        p->capacity = (uint32_t)capacity;
    }
    return true;
}

bool pcm_add(struct pcm *p, const float *frames, size_t n)
{
    if (!reserve(p, n))
        return false;
    for (size_t i = 0; i < n * (size_t)p->channels; i++) {
        if ((frames[i] > 1 || frames[i] < -1) && p->clipped++ == 0)
            p->clipped_at = p->n + (uint32_t)(i / (size_t)p->channels);
        p->frames[p->n * (size_t)p->channels + i] = frames[i] == frames[i] ? to_sample((double)frames[i]) : 0;
    }
    p->n += (uint32_t)n;
    return true;
}

bool pcm_join(struct pcm *p, const struct pcm *more)
{
    if (!reserve(p, more->n))
        return false;
    memcpy(p->frames + p->n * (size_t)p->channels, more->frames, more->n * (size_t)p->channels * sizeof *more->frames);
    p->n += more->n;
    p->clipped += more->clipped;
    return true;
}

bool pcm_check(const struct pcm *p, char *err, size_t err_size)
{
    const int64_t end = p->loop_end < 0 ? p->n : p->loop_end;

    if (p->n < 1 || p->n > max_frames(p))
        return err_set(err, err_size, "expected 1 to %" PRIu64 " frames, got %" PRIu32, max_frames(p), p->n);
    if (p->loop >= 0 && (p->loop >= end || end > p->n))
        return err_set(err, err_size,
                       "the loop from frame %" PRId64 " to %" PRId64 " is not inside its %" PRIu32 " frames", p->loop,
                       end, p->n);
    return true;
}

/* ---- resampling ---- */

enum { ZEROES = 32, TABLE_STEPS = 512 /* table entries between two zero crossings */ };

/* The right half of the filter: a sinc with a cutoff at 22 of 24 kHz, in a Kaiser window. */
static double kernel(double x)
{
    const double beta = 9, cut = 22.0 / 24, in = x / ZEROES, pi = acos(-1);
    const double sinc = x == 0 ? cut : sin(pi * cut * x) / (pi * x);
    double bessel[2] = { 1, 1 };

    if (in >= 1)
        return 0;
    for (int k = 0; k < 2; k++) {
        const double y = k ? beta * beta / 4 : beta * beta / 4 * (1 - in * in);
        double term = 1;
        for (int i = 1; i < 40; i++)
            bessel[k] += term *= y / (i * i);
    }
    return sinc * bessel[0] / bessel[1];
}

/* Returns the index of source frame i, which is in the loop if i is after the end; -1: silence. */
static int64_t frame_at(const struct pcm *p, int64_t i)
{
    if (i >= p->n && p->loop >= 0)
        return p->loop + (i - p->loop) % (p->n - p->loop);
    return i >= 0 && i < p->n ? i : -1;
}

struct resampler {
    const struct pcm *source;
    double step; /* frames of `from` per new frame */
    float table[ZEROES * TABLE_STEPS + 2];
};

/* Computes the new frame at position x of the source. */
static void resample_frame(const struct resampler *l, double x, int16_t *out)
{
    const int channels = l->source->channels;
    const int64_t first = (int64_t)ceil(x - ZEROES * l->step), last = (int64_t)floor(x + ZEROES * l->step);
    double sum[PCM_CHANNELS] = { 0 };

    for (int64_t i = first; i <= last; i++) {
        const int64_t at = frame_at(l->source, i);
        if (at < 0)
            continue;
        const double position = fabs((double)i - x) / l->step * TABLE_STEPS;
        const int k = (int)position;
        const double weight = (double)l->table[k] + (double)(l->table[k + 1] - l->table[k]) * (position - k);
        for (int c = 0; c < channels; c++)
            sum[c] += weight * l->source->frames[at * channels + c];
    }
    for (int c = 0; c < channels; c++)
        out[c] = to_sample(sum[c] / l->step / 32768);
}

static bool resample(struct pcm *p)
{
    const double ratio = (double)p->rate / SND_RATE;
    const uint32_t loop_frames = p->loop < 0 ? 0 : (uint32_t)lrint((double)(p->n - p->loop) / ratio);
    struct resampler *l = malloc(sizeof *l);
    struct pcm to = { .rate = SND_RATE, .channels = p->channels, .clipped = p->clipped, .loop = -1, .loop_end = -1 };

    if (loop_frames > 0)
        to.loop = (int64_t)((double)p->loop / ratio);
    to.n = loop_frames > 0 ? (uint32_t)to.loop + loop_frames : (uint32_t)ceil(p->n / ratio);
    to.frames = malloc((size_t)to.n * (size_t)to.channels * sizeof *to.frames);
    if (l && to.frames) {
        l->source = p;
        l->step = loop_frames > 0 ? (double)(p->n - p->loop) / loop_frames : ratio;
        for (int i = 0; i < ZEROES * TABLE_STEPS + 2; i++)
            l->table[i] = (float)kernel((double)i / TABLE_STEPS);
        const double first_position = loop_frames > 0 ? (double)p->loop - (double)to.loop * l->step : 0;
        for (uint32_t i = 0; i < to.n; i++)
            resample_frame(l, first_position + i * l->step, to.frames + (size_t)i * (size_t)to.channels);
        free(p->frames);
        *p = to;
    } else {
        free(to.frames);
    }
    const bool good = p->rate == SND_RATE;
    free(l);
    return good;
}

bool pcm_prepare(struct pcm *p)
{
    if (p->loop >= 0 && p->loop_end >= 0)
        p->n = (uint32_t)p->loop_end;
    p->loop_end = -1;
    return p->rate <= SND_RATE || resample(p);
}

void pcm_channel(const struct pcm *p, int channel, int16_t *out)
{
    for (size_t i = 0; i < p->n; i++) {
        const int16_t *f = p->frames + i * (size_t)p->channels;
        out[i] = p->channels == 1 ? f[0] : channel < 0 ? (int16_t)((f[0] + f[1] + 1) >> 1) : f[channel];
    }
}

void pcm_free(struct pcm *p)
{
    free(p->frames);
    *p = (struct pcm){ .loop = -1, .loop_end = -1 };
}
