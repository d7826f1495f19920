/*
 * options_run.h - spawns, removes and moves the ships' options.
 */
#ifndef SCRIPT_OPTIONS_RUN_H
#define SCRIPT_OPTIONS_RUN_H

#include "../machine/machine.h"

/* Spawns and removes options so that each ship has the number of options its level calls for. Called once a frame,
 * before the moves. */
void options_adjust_count(struct board *b, lua_State *L);

/* Moves options along with their ships. */
void options_follow(struct board *b);

#endif
