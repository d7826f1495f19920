/*
 * golden.h - pictures and hashes that a game's tests keep in tests/golden, and what is seen now beside them.
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
    FILE *out; /* sayings of outcome.h: files taken and kept, pictures that differ, what the host could not do */
};

/* The board's picture is DIR/tests/golden/NAME.png; with update it becomes so. False and one sentence: it is not, and
 * NAME.expected.png, NAME.got.png and NAME.difference.png are in tests/failed. */
bool golden_picture(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size);

/* The same of the hash of each part, in NAME.hash, lines of PART HASH; no picture is written. */
bool golden_hash(const struct golden *g, const struct board *b, const char *name, char *err, size_t err_size);

/* The picture alone, as tests/failed/NAME.got.png. */
void golden_show(const struct golden *g, const struct board *b, const char *name);

#endif
