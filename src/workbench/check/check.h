/*
 * check.h - `curtain check DIR`: finds mistakes in a game's folder, and prints a line for each.
 *
 * It reports what the packer and the sandbox reject, undeclared names, values of the wrong type, missing and unused
 * files and pictures, colours outside of their bank, and problems in runs of the game. Every report is certain; others
 * are marked as notes.
 */
#ifndef WORKBENCH_CHECK_H
#define WORKBENCH_CHECK_H

#include <stdbool.h>
#include "../../common/result.h"

/* Checks the folder; nearest: as for pack. RESULT_DONE: no findings; RESULT_DIFFERS: findings; RESULT_REFUSED: not a
 * game's folder, which has been reported. */
enum result check_game(const char *dir, bool nearest);

#endif
