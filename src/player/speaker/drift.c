/*
 * drift.c - adjusts the sample rate (drift.h). For the error e, de/dt = 800 (drift - rate). With rate = e / (800 TAU) +
 * sum of e / (800 TAU LONG), the loop has two real poles, of about TAU and LONG frames, so it doesn't oscillate. Jitter
 * is smoothed over SMOOTH frames, far from both poles.
 */
#include "drift.h"

#include <math.h>

enum { BLOCK = 800, TAU = 60, LONG = 300, SMOOTH = 10 };

#define MAX_CHANGE 0.0001 /* of the rate, in a sixtieth: 0.006 a second */

static double clamp(double v, double limit)
{
    return fmax(-limit, fmin(limit, v));
}

double drift_step(struct drift *d, double error)
{
    d->error = d->known ? d->error + (error - d->error) / SMOOTH : error;
    d->known = true;
    const double now = d->error / (BLOCK * TAU), sum = d->sum + d->error / ((double)BLOCK * TAU * LONG);
    if (fabs(now + sum) < DRIFT_MAX || fabs(sum) < fabs(d->sum)) /* anti-windup */
        d->sum = clamp(sum, DRIFT_MAX);
    d->rate += clamp(clamp(now + d->sum, DRIFT_MAX) - d->rate, MAX_CHANGE);
    return d->rate;
}

void drift_reset_error(struct drift *d)
{
    d->known = false;
}
