/*
 * replays_print.h - `curtain list ROM --replays`: the saved runs of a game, one per line, newest first.
 */
#ifndef PLAYER_REPLAYS_PRINT_H
#define PLAYER_REPLAYS_PRINT_H

#include <stdbool.h>
#include "replays.h"

/* Prints each run as "FILE DATE LENGTH SHIP DIFFICULTY POINTS END[, flags][ "NAME"]", or with json as an object. DATE
 * is UTC. Returns false if there is not enough memory for all of them. */
bool replays_print(const char *id, bool json);

#endif
