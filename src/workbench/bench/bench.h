/*
 * bench.h - `curtain bench`: the cost of a game's frames, by section and by line of Lua, and its use of capacities.
 */
#ifndef WORKBENCH_BENCH_H
#define WORKBENCH_BENCH_H

#include <stdbool.h>
#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../demo/demo.h"
#include "../../common/result.h"
#include "../../player/args/args.h"

struct bench {
    const char *path; /* of the game, as typed */
    const struct cart *cart;
    struct board_start start; /* of runs without a demo; if it has a section, only that is played */
    const struct demo *demo;  /* the only run; NULL: the game's demos are played */
    const char *demo_name;
    bool custom_start; /* the command line changes the start, so demos, which have their own start, are not played */
    int slower;        /* shares of a frame are for a machine this many times slower */
    bool json;
};

/* The command: measures the game of the first word. RESULT_REFUSED: a run faulted or cannot start. */
enum result bench_command(const struct args *a);

#endif
