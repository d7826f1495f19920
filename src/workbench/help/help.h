/*
 * help.h - the command `help` with the topics of the workbench: the Lua API, and the functions of test scripts.
 */
#ifndef WORKBENCH_HELP_H
#define WORKBENCH_HELP_H

#include "../../common/result.h"
#include "../../player/args/args.h"

enum result help_command(const struct args *a);

#endif
