/*
 * testing.h - curtain test: every demo and every test script of a game's folder, told as lines, TAP, JUnit and a page.
 *
 * Each test runs in a process of its own, several at a time. What it finds it writes as lines of words (outcome.h), of
 * which all reports are made.
 */
#ifndef WORKBENCH_TESTING_H
#define WORKBENCH_TESTING_H

#include "../../rom/cart.h"
#include "trial.h"
#include "../../common/result.h"
#include "../../player/args/args.h"

struct testing {
    const char *dir;
    const struct cart *cart; /* of that folder */
    char **names;            /* of the tests that are wanted; n_names 0: all */
    int n_names;
    bool update;              /* what is kept of pictures and hashes becomes what is seen now */
    bool tap;                 /* in place of lines for people */
    const char *junit, *page; /* files; NULL: none, or the page in tests/failed */
    int jobs;                 /* 0: as many as there are processors */

    /* The command line's part: what test.run asks for as a start (demo is not looked at), and the buttons held. False
     * and one sentence. */
    void *user;
    bool (*start)(void *user, const struct trial_start *want, struct board_start *start, char *err, size_t err_size);
    bool (*press)(void *user, int run, const char *list, char *err, size_t err_size);
    void (*pressed)(void *user, int run, uint32_t frame, uint16_t pads[MAX_PLAYERS]);
};

enum result testing_run(const struct testing *t);

/* The command: the game of the first word is opened, tested and closed. */
enum result testing_command(const struct args *a);

/* The functions of test scripts, a line each, for help. */
void testing_help(void (*line)(const char *));

#endif
