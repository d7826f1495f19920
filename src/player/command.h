/*
 * command.h - the commands play, help and version. Errors are logged with plat_log.
 */
#ifndef PLAYER_COMMAND_H
#define PLAYER_COMMAND_H

#include "../common/result.h"
#include "args/args.h"

/* Plays a game, and then games that are dropped on its window. Call *running until it ends; *a must outlive it. named:
 * the command line contains `play`. */
enum result command_play(const struct args *a, bool named, struct frame_command *running);

/* Print to standard output. */
enum result command_help(const struct args *a);
enum result command_version(void);

#endif
