/*
 * capture.h - a run as a film: `curtain capture`.
 *
 * A film has time of its own: its picture k is shown k / R seconds after its beginning, R being 50 for GIF and 60 for
 * all others, and is the last frame that began by then. So the frames of a GIF lie at most a sixtieth from their time,
 * however long it is, and those of the others not at all.
 */
#ifndef WORKBENCH_CAPTURE_H
#define WORKBENCH_CAPTURE_H

#include "../../player/args/args.h"
#include "../../common/result.h"

/* What is not done has been told on plat_log. */
enum result capture_run(const struct args *a);

#endif
