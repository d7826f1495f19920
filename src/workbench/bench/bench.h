/*
 * bench.h - `curtain bench`: what a game's frames cost, by section and by line of Lua, and what of its room it uses.
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
    struct board_start start; /* of the runs that are not a demo's; with a section: of this one alone */
    const struct demo *demo;  /* this one alone; NULL: those of the game */
    const char *demo_name;
    bool own_start; /* the start is no other than the plain one: demos, which hold their own, are not played */
    int slower;     /* shares of a frame are told of a machine so many times slower; 1: of this one */
    bool json;
};

/* Plays, measures and prints. RESULT_REFUSED: a run faulted or cannot begin; RESULT_HOST_FAILED: no memory. */
enum result bench_run(const struct bench *b);

/* The command: the game of the first word is opened, measured and closed. */
enum result bench_command(const struct args *a);

#endif
