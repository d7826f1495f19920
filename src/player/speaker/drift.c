/*
 * drift.c - adjusts the sample rate (drift.h). For the error e, de/dt = 800 (drift - rate). With rate = e / (800 TAU) +
 * sum of e / (800 TAU LONG), the loop has two real poles, of about TAU and LONG frames, so it doesn't oscillate. Jitter
 * is smoothed over SMOOTH frames, far from both poles.
 */
#include "drift.h"

#include <math.h>

enum { BLOCK = 800, TAU = 60, LONG = 300, SMOOTH = 10 };

#define MOST_CHANGE 0.0001 /* of the rate, in a sixtieth: 0.006 a second */

static double limited(double v, double most)
{
    return fmax(-most, fmin(most, v));
}

double drift_step(struct drift *d, double off)
{
    d->off = d->known ? d->off + (off - d->off) / SMOOTH : off;
    d->known = true;
    const double now = d->off / (BLOCK * TAU), sum = d->sum + d->off / ((double)BLOCK * TAU * LONG);
    if (fabs(now + sum) < DRIFT_MOST || fabs(sum) < fabs(d->sum)) /* anti-windup */
        d->sum = limited(sum, DRIFT_MOST);
    d->rate += limited(limited(now + d->sum, DRIFT_MOST) - d->rate, MOST_CHANGE);
    return d->rate;
}

void drift_jump(struct drift *d)
{
    d->known = false;
}
