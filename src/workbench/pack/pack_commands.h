/*
 * pack_commands.h - the commands pack (a folder to a ROM), list (what is in a ROM, or its replays) and unpack (a ROM's
 * lumps as files).
 */
#ifndef WORKBENCH_PACK_COMMANDS_H
#define WORKBENCH_PACK_COMMANDS_H

#include "../../common/result.h"
#include "../../player/args/args.h"

enum result pack_command(const struct args *a);
enum result pack_command_list(const struct args *a);
enum result pack_command_unpack(const struct args *a);

#endif
