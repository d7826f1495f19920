/*
 * headless_run.h - a run without a window: power, then ticks with the demo's pads, or those of --press. What scripts
 * print goes to plat_log; what is not done has been told there.
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
    uint32_t outcomes, told; /* of power-on and ticks: so far; of these, what was said by the run before */
};

/* Powers the game of the arguments. Close it either way. */
enum result headless_run_open(struct headless_run *r, const struct args *a);

/* The same run once more, after headless_run_close: what the first one said, it does not say again. */
enum result headless_run_again(struct headless_run *r, const struct args *a);

/* One frame; what is not RESULT_DONE ends the run. */
enum result headless_run_tick(struct headless_run *r);

/* Ends the run and its recording; result is what it came to so far, and returned. */
enum result headless_run_close(struct headless_run *r, enum result result);

#endif
