/*
 * capture.h - `curtain capture`: records a run as a video.
 *
 * Picture k is shown k / R seconds after the start, where R is 50 for GIF and 60 for other formats. It is the last
 * frame that has started at this time, so a frame of a GIF is at most a sixtieth of a second late, and others are
 * exact.
 */
#ifndef WORKBENCH_CAPTURE_H
#define WORKBENCH_CAPTURE_H

#include "../../player/args/args.h"
#include "../../common/result.h"

/* The command. Errors have been reported. */
enum result capture_run(const struct args *a);

#endif
