/*
 * drift.h - holds what waits at the speaker at a target, by a rate that is hardly another.
 *
 * Two clocks of one machine differ by some hundredths of a percent, and now and then by three tenths. What waits shows
 * the difference, added up. The rate answers to how far that is off (what is wrong is halved in three quarters of a
 * second) and to the sum of it, so that a lasting difference of clocks is met by a lasting rate and nothing stays off.
 * It is never more than DRIFT_MOST, a seventh of a semitone, and moves slowly.
 */
#ifndef PLAYER_DRIFT_H
#define PLAYER_DRIFT_H

#include <stdbool.h>

#define DRIFT_MOST 0.008

struct drift {
    bool known;
    double off;  /* frames above the target, the jitter smoothed away */
    double sum;  /* of it */
    double rate; /* of ours: 0.001 is a thousandth faster */
};

/* To be called each sixtieth: `off` frames more than the target wait. Returns the rate from now on. */
double drift_step(struct drift *d, double off);

/* What waits is another from here on (it ran dry, or was thrown away); the clocks are not. */
void drift_jump(struct drift *d);

#endif
