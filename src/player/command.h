/*
 * command.h - the commands play, help and version. Errors are logged with plat_log.
 */
#ifndef PLAYER_COMMAND_H
#define PLAYER_COMMAND_H

#include "../common/result.h"
#include "args/args.h"

/* Plays a game, and then those that are dropped on its window: *running is to be called, if there is one. a must last
 * as long. named: the word play was there. */
enum result command_play(const struct args *a, bool named, struct frame_command *running);

/* On standard output. */
enum result command_help(const struct args *a);
enum result command_version(void);

#endif
