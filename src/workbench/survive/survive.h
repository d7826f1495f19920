/*
 * survive.h - can a game be survived? `curtain survive`.
 */
#ifndef WORKBENCH_SURVIVE_H
#define WORKBENCH_SURVIVE_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../common/result.h"
#include "../../player/args/args.h"

enum { SURVIVE_FRAMES = 7200, SURVIVE_EFFORT = 4 /* where nothing is said */ };

struct survive_options {
    const char *path; /* of the game, for messages */
    const struct rom *rom;
    const struct cart *cart;
    struct board_start start;
    bool all;        /* every stage and phase, but for `stage` (NULL: none is named) of that name, ... */
    bool difficulty; /* and but for start's difficulty every one */
    const char *stage;
    const char *out; /* the demo, or a folder for those of all; NULL: as survive.demo, none */
    const char *map; /* NULL: none */
    uint32_t frames, effort;
    int bots;   /* so many fly on when they are hit, and no way is looked for; 0: a way is looked for */
    int prints; /* of demos, as enum demo_checksum_rate */
    bool json, verbose;
};

/* What is not done has been told on plat_log. RESULT_DIFFERS: no way was found, or an easier difficulty is harder. */
enum result survive_run(const struct survive_options *o);

/* The command: the game of the first word, or the built-in one, is opened, tried and closed. */
enum result survive_command(const struct args *a);

#endif
