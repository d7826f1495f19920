/*
 * command.h - `curtain bulletml`.
 */
#ifndef WORKBENCH_COMMAND_H
#define WORKBENCH_COMMAND_H

#include <stdbool.h>
#include "../../common/result.h"

/* Prints the contents of n documents and warnings about them to standard output; with lua, prints one document as a Lua
 * script. Errors are printed with plat_log, one line per document. */
enum result bulletml_command(char *const *files, int n, bool lua);

#endif
