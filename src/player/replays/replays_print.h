/*
 * replays_print.h - `curtain list ROM --replays`: the kept runs of a game, a line each, newest first.
 */
#ifndef PLAYER_REPLAYS_PRINT_H
#define PLAYER_REPLAYS_PRINT_H

#include <stdbool.h>
#include "replays.h"

/* Prints all of a game: "FILE DATE LENGTH_PARAM SHIP DIFFICULTY POINTS END[, flags][ "NAME"]", or with
 * json an object each. DATE is UTC. False: no memory for all of them. */
bool replays_print(const char *id, bool json);

#endif
