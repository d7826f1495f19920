/*
 * headless_run.h - a run without a window, with the buttons of the demo or of --press. Output of scripts and errors go
 * to plat_log.
 */
#ifndef WORKBENCH_HEADLESS_RUN_H
#define WORKBENCH_HEADLESS_RUN_H

#include "../../player/args/args.h"
#include "../../player/game/game.h"
#include "../../common/result.h"
#include "../../player/run/guard.h"

struct headless_run {
    struct game game;
    struct guard guard;
    struct demo_writer writer; /* of --record */
    const struct args *a;
    uint32_t outcomes; /* number of outcomes (of power-on and ticks) so far */
    uint32_t reported; /* outcomes that an earlier run has reported */
};

/* Opens the game of the arguments and powers it on. Close it in either case. */
enum result headless_run_open(struct headless_run *r, const struct args *a);

/* Repeats the run after headless_run_close. Faults and script output that have been reported are not reported again. */
enum result headless_run_repeat(struct headless_run *r, const struct args *a);

/* Runs a frame; any result but RESULT_DONE ends the run. */
enum result headless_run_tick(struct headless_run *r);

/* Ends the run and its recording. Returns `result`, or the error of the recording. */
enum result headless_run_close(struct headless_run *r, enum result result);

#endif
