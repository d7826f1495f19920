/*
 * tune_time.h - length of a tune, without playing it.
 */
#ifndef WORKBENCH_TUNE_TIME_H
#define WORKBENCH_TUNE_TIME_H

#include "../../sound/tune.h"

/* Seconds until all tracks have ended or played their loop once, and length of the longest loop, 0: none. */
struct tune_time {
    double all, loop;
};
struct tune_time tune_time(const struct tune *t);

#endif
