/*
 * survive.h - `curtain survive`: searches for a run without a hit.
 */
#ifndef WORKBENCH_SURVIVE_H
#define WORKBENCH_SURVIVE_H

#include "../../common/result.h"
#include "../../player/args/args.h"

/* The command, for the game of the first word or the built-in game. RESULT_DIFFERS: no such run was found, or an easier
 * difficulty is harder. */
enum result survive_command(const struct args *a);

#endif
