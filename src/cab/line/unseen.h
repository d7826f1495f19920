/*
 * unseen.h - a run without a window: power, then ticks with the demo's pads, or those of --press. What scripts print
 * goes to plat_log; what is not done has been told there.
 */
#ifndef CAB_UNSEEN_H
#define CAB_UNSEEN_H

#include "args.h"
#include "game.h"
#include "../../common/result.h"
#include "../run/guard.h"

struct unseen {
    struct game game;
    struct guard guard;
    struct demo_writer writer; /* of --record */
    const struct args *a;
    uint32_t outcomes, told; /* of power-on and ticks: so far; of these, what was said by the run before */
};

/* Powers the game of the arguments. Close it either way. */
enum result unseen_open(struct unseen *r, const struct args *a);

/* The same run once more, after unseen_close: what the first one said, it does not say again. */
enum result unseen_again(struct unseen *r, const struct args *a);

/* One frame; what is not RESULT_DONE ends the run. */
enum result unseen_tick(struct unseen *r);

/* Ends the run and its recording; result is what it came to so far, and returned. */
enum result unseen_close(struct unseen *r, enum result result);

#endif
