/*
 * drift.h - holds the length of the speaker's queue at a target by adjusting the sample rate slightly.
 *
 * Two clocks of a machine usually differ by a few hundredths of a percent, sometimes by 0.3 %. The length of the queue
 * shows the accumulated difference. drift_step is a PI controller: the rate depends on the error, which is halved in
 * three quarters of a second, and on the sum of past errors, so a constant difference leaves no error. The adjustment
 * changes slowly and is at most DRIFT_MAX, a seventh of a semitone.
 */
#ifndef PLAYER_DRIFT_H
#define PLAYER_DRIFT_H

#include <stdbool.h>

#define DRIFT_MAX 0.008

struct drift {
    bool known;   /* `error` is valid */
    double error; /* smoothed: frames above the target */
    double sum;   /* of past errors, scaled */
    double rate;  /* adjustment: 0.001 is 0.1 % faster */
};

/* Call it every sixtieth of a second. error: frames that the queue has above the target. Returns the new adjustment. */
double drift_step(struct drift *d, double error);

/* Forgets the smoothed error, after the queue ran empty or was cleared. Keeps the difference of the clocks. */
void drift_reset_error(struct drift *d);

#endif
