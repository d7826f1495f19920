/*
 * flaws.c - see flaws.h. A click is a second difference that is much larger than those around it.
 */
#include "flaws.h"

#include <math.h>
#include <stdlib.h>

enum {
    FULL_SCALE = 32767,
    MIN_RUN = 3,
    NEARBY = 1024 /* frames */,
    INAUDIBLE = 128 /* an inaudible second difference */
};

static bool is_full_scale(int v)
{
    return v >= FULL_SCALE || v < -FULL_SCALE;
}

/* Counts the samples of a channel in runs at full scale. */
static void count_clipped(const struct pcm *p, int channel, struct flaws *out)
{
    uint32_t run = 0;

    for (uint32_t i = 0; i < p->n; i++) {
        run = is_full_scale(p->frames[(size_t)i * (size_t)p->channels + (size_t)channel]) ? run + 1 : 0;
        if (run < MIN_RUN)
            continue;
        if (out->clipped == 0)
            out->first_clipped = i + 1 - MIN_RUN;
        out->clipped += run == MIN_RUN ? MIN_RUN : 1;
    }
}

static double mean(const struct pcm *p, int channel)
{
    int64_t sum = 0;

    for (uint32_t i = 0; i < p->n; i++)
        sum += p->frames[(size_t)i * (size_t)p->channels + (size_t)channel];
    return p->n ? (double)sum / p->n / (FULL_SCALE + 1) : 0;
}

void flaws_measure_frames(const struct pcm *p, struct flaws *out)
{
    *out = (struct flaws){ 0 };
    for (int c = 0; c < p->channels; c++) {
        const double m = mean(p, c);
        count_clipped(p, c, out);
        out->dc_offset = fabs(m) > fabs(out->dc_offset) ? m : out->dc_offset;
    }
    if (p->clipped > out->clipped) {
        out->clipped = p->clipped;
        out->first_clipped = p->clipped_at;
    }
}

/* Returns the second difference at frame i; frames after the end are those of the loop. */
static int second_difference(const struct pcm *p, int channel, int64_t i)
{
    int x[3];

    for (int k = 0; k < 3; k++) {
        int64_t at = i - 1 + k;
        at = at < p->n ? at : p->loop + (at - p->n) % (p->n - p->loop);
        x[k] = p->frames[at * p->channels + channel];
    }
    return abs(x[0] - 2 * x[1] + x[2]);
}

void flaws_measure_loop(const struct pcm *p, struct flaws *out)
{
    if (p->loop < 0)
        return;
    for (int c = 0; c < p->channels; c++) {
        int jump = 0, nearby = 0;
        for (int64_t i = (int64_t)p->n - NEARBY; i < (int64_t)p->n + NEARBY; i++) {
            const bool at_loop_point = i == (int64_t)p->n - 1 || i == (int64_t)p->n;
            const int b = i > 0 ? second_difference(p, c, i) : 0;
            if (at_loop_point)
                jump = b > jump ? b : jump;
            else
                nearby = b > nearby ? b : nearby;
        }
        if (jump <= 2 * nearby + INAUDIBLE || (out->clicks && jump <= out->jump * (FULL_SCALE + 1)))
            continue;
        out->clicks = true;
        out->jump = (double)jump / (FULL_SCALE + 1);
        out->nearby = (double)nearby / (FULL_SCALE + 1);
    }
}
