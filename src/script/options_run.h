/*
 * options_run.h - options on the board.
 */
#ifndef SCRIPT_OPTIONS_RUN_H
#define SCRIPT_OPTIONS_RUN_H

#include "../machine/machine.h"

/* Each ship gets the options of its level, and loses those it has no more: once a frame, before the moves. */
void options_count(struct board *b, lua_State *L);

/* They go where their ships went. */
void options_follow(struct board *b);

#endif
