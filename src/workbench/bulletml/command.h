/*
 * command.h - `curtain bulletml`.
 */
#ifndef WORKBENCH_COMMAND_H
#define WORKBENCH_COMMAND_H

#include <stdbool.h>
#include "../../common/result.h"

/* Says of each of n documents what is in it and what is hardly meant, on standard output; or with lua prints the one
 * that is given as a script. What is wrong has been told on plat_log, a line a document. */
enum result bulletml_command(char *const *files, int n, bool lua);

#endif
