/*
 * command.h - the commands that no room has: play, those of ROMs, and what the program says of itself.
 *
 * What is not done has been told on plat_log.
 */
#ifndef CAB_COMMAND_H
#define CAB_COMMAND_H

#include "../common/result.h"
#include "line/args.h"

/* Plays a game, and then those that are dropped on its window: *running is to be called, if there is one. a must last
 * as long. named: the word play was there. */
enum result command_play(const struct args *a, bool named, struct frame_command *running);

/* A folder to a ROM; what is in one, or the replays of it; its lumps as files; a program of it. */
enum result command_pack(const struct args *a);
enum result command_list(const struct args *a);
enum result command_unpack(const struct args *a);
enum result command_export(const struct args *a);

/* On standard output. */
enum result command_help(const struct args *a);
enum result command_version(void);

#endif
