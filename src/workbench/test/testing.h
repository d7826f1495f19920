/*
 * testing.h - `curtain test`: runs the demos and test scripts of a game, and reports their outcomes as text, TAP and
 * JUnit.
 *
 * Each test runs in its own process, several at a time. It writes its outcome as lines (outcome.h), and all reports are
 * made from these.
 */
#ifndef WORKBENCH_TESTING_H
#define WORKBENCH_TESTING_H

#include "../../common/result.h"
#include "../../player/args/args.h"
#include "../../player/game/game.h"

struct testing {
    const char *dir; /* the game's folder */
    struct game *game;
    const struct args *args; /* update, tap, junit and jobs are used */
    char **names;            /* of the wanted tests; n_names 0: all tests */
    int n_names;
};

/* The command: tests the game of the first word. */
enum result testing_command(const struct args *a);

#endif
