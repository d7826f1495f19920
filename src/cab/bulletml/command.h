/*
 * command.h - `curtain bulletml`.
 * floor: cab
 */
#ifndef CAB_BULLETML_COMMAND_H
#define CAB_BULLETML_COMMAND_H

#include "../host/result.h"
#include "../line/args.h"

/* Says of each document what is in it and what is hardly meant, on standard output; or prints the one that is given as
 * Lua. What is wrong has been told on plat_log, a line a document. */
enum result bulletml_command(const struct args *a);

#endif
