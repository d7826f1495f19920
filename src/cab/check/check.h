/*
 * check.h - `curtain check DIR`: the author's lint.
 * floor: cab    used by: cli
 *
 * All that can be found wrong with a game's folder in one run, a line a finding, on standard output: what the packer and
 * the sandbox refuse, names nobody declared, values used as what they are not, missing and unused files and pictures,
 * colours outside their bank, and what happens when the game runs. It says nothing that may be right.
 */
#ifndef CAB_CHECK_H
#define CAB_CHECK_H

#include "../args.h"

/* Checks the folder a->words[0]. Returns an exit code of cli.h: 0 nothing found, 1 findings, 2 not a game's folder. */
int check_game(const struct args *a);

#endif
