/*
 * golden.h - compares a board with the expected pictures and hashes in the game's tests/golden.
 */
#ifndef WORKBENCH_GOLDEN_H
#define WORKBENCH_GOLDEN_H

#include <stdio.h>
#include "../../board/board.h"

#define GOLDEN "tests/golden"
#define FAILED "tests/failed"

struct golden {
    const char *dir; /* the game's folder */
    bool update;
    FILE *out; /* gets lines of outcome.h: files compared and updated, pictures that differ, errors of the host */
};

/* Compares the board's picture with tests/golden/NAME.png; with `update`, saves it there if it differs. If it differs,
 * sets err, writes NAME.expected.png, NAME.got.png and NAME.difference.png to tests/failed, and returns false. */
bool golden_picture(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size);

/* Does the same for the hashes of all parts and NAME.hash, which has a line PART HASH for each; writes no picture. */
bool golden_hash(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size);

/* Saves the board's picture as tests/failed/NAME.got.png. */
void golden_save_got(const struct golden *g, const struct board *b, const char *name);

#endif
