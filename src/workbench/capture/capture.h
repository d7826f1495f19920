/*
 * capture.h - `curtain capture`: records a run as a video.
 *
 * Picture k is shown k / R seconds after the start, with R = 50 for GIF and 60 for the other formats, and is the last
 * frame that started by then. A frame of a GIF is therefore never more than a sixtieth late, and the others are exact.
 */
#ifndef WORKBENCH_CAPTURE_H
#define WORKBENCH_CAPTURE_H

#include "../../player/args/args.h"
#include "../../common/result.h"

/* The command. Errors have been reported. */
enum result capture_run(const struct args *a);

#endif
