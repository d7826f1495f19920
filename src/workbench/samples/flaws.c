/*
 * flaws.c - see flaws.h. A click is a second difference that is much larger than those around it.
 */
#include "flaws.h"

#include <math.h>
#include <stdlib.h>

enum { FULL = 32767, IN_A_ROW = 3, AROUND = 1024 /* frames */, QUIET = 128 /* an inaudible bend */ };

static bool full(int v)
{
    return v >= FULL || v < -FULL;
}

/* Counts samples of a channel at full scale, in runs. */
static void count_full(const struct pcm *p, int channel, struct flaws *out)
{
    uint32_t row = 0;

    for (uint32_t i = 0; i < p->n; i++) {
        row = full(p->frames[(size_t)i * (size_t)p->channels + (size_t)channel]) ? row + 1 : 0;
        if (row < IN_A_ROW)
            continue;
        if (out->clipped == 0)
            out->first = i + 1 - IN_A_ROW;
        out->clipped += row == IN_A_ROW ? IN_A_ROW : 1;
    }
}

static double mean(const struct pcm *p, int channel)
{
    int64_t sum = 0;

    for (uint32_t i = 0; i < p->n; i++)
        sum += p->frames[(size_t)i * (size_t)p->channels + (size_t)channel];
    return p->n ? (double)sum / p->n / (FULL + 1) : 0;
}

void flaws_of_frames(const struct pcm *p, struct flaws *out)
{
    *out = (struct flaws){ 0 };
    for (int c = 0; c < p->channels; c++) {
        const double m = mean(p, c);
        count_full(p, c, out);
        out->mean = fabs(m) > fabs(out->mean) ? m : out->mean;
    }
    if (p->clipped > out->clipped) {
        out->clipped = p->clipped;
        out->first = p->clipped_at;
    }
}

/* The second difference at frame i; frames after the end continue in the loop. */
static int bend(const struct pcm *p, int channel, int64_t i)
{
    int x[3];

    for (int k = 0; k < 3; k++) {
        int64_t at = i - 1 + k;
        at = at < p->n ? at : p->loop + (at - p->n) % (p->n - p->loop);
        x[k] = p->frames[at * p->channels + channel];
    }
    return abs(x[0] - 2 * x[1] + x[2]);
}

void flaws_of_loop(const struct pcm *p, struct flaws *out)
{
    if (p->loop < 0)
        return;
    for (int c = 0; c < p->channels; c++) {
        int jump = 0, usual = 0;
        for (int64_t i = (int64_t)p->n - AROUND; i < (int64_t)p->n + AROUND; i++) {
            const bool border = i == (int64_t)p->n - 1 || i == (int64_t)p->n;
            const int b = i > 0 ? bend(p, c, i) : 0;
            if (border)
                jump = b > jump ? b : jump;
            else
                usual = b > usual ? b : usual;
        }
        if (jump <= 2 * usual + QUIET || (out->clicks && jump <= out->jump * (FULL + 1)))
            continue;
        out->clicks = true;
        out->jump = (double)jump / (FULL + 1);
        out->usual = (double)usual / (FULL + 1);
    }
}
