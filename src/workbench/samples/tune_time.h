/*
 * tune_time.h - how long a tune is, read from it without playing it.
 */
#ifndef WORKBENCH_TUNE_TIME_H
#define WORKBENCH_TUNE_TIME_H

#include "../../sound/tune.h"

/* Seconds until the last track ends, or has played all it repeats once; and of those that repeat, how long that is, 0:
 * none does. */
struct tune_time {
    double all, loop;
};
struct tune_time tune_time(const struct tune *t);

#endif
