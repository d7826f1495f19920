/*
 * luacheck.h - `curtain help lua --luacheck`: the names of the API table as settings of luacheck, the linter, so that
 * it knows what a game has: no os, no math.random, bullet.fire but not bullet.fyre.
 */
#ifndef WORKBENCH_LUACHECK_H
#define WORKBENCH_LUACHECK_H

/* Prints a .luacheckrc to standard output. */
void luacheck_print(void);

#endif
