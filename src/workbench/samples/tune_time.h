/*
 * tune_time.h - computes the length of a tune without playing it.
 */
#ifndef WORKBENCH_TUNE_TIME_H
#define WORKBENCH_TUNE_TIME_H

#include "../../sound/tune.h"

/* Seconds until every track has ended or looped once, and the length of the longest loop (0: none). */
struct tune_time {
    double all, loop;
};
struct tune_time tune_time(const struct tune *t);

#endif
