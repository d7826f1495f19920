/*
 * check.h - `curtain check DIR`: the author's lint.
 *
 * All that can be found wrong with a game's folder in one run, a line a diagnostic, on standard output: what the packer
 * and the sandbox refuse, names that are not declared, values used as what they are not, missing and unused files and
 * pictures, colours outside their bank, and what happens when the game runs. It says nothing that may be right.
 */
#ifndef WORKBENCH_CHECK_H
#define WORKBENCH_CHECK_H

#include <stdbool.h>
#include "../../common/result.h"

/* Checks the folder; nearest: as pack. RESULT_DONE: nothing was found; RESULT_DIFFERS: diagnostics; RESULT_REFUSED: not
 * a game's folder, as plat_log says. */
enum result check_game(const char *dir, bool nearest);

#endif
