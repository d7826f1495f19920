/*
 * trial.h - a test script of a game: Lua that runs games, looks into them and says what it expects.
 *
 * A test script has a Lua machine of its own, with the games' sandbox and the table `test`; nothing of any board is in
 * it. Memory, work and frames are bounded. What it does with games goes through struct trial_host: the cabinet powers
 * boards, keeps snapshots and compares pictures.
 */
#ifndef BOARD_TRIAL_H
#define BOARD_TRIAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../board/board.h"

enum {
    TRIAL_RUNS = 4,              /* runs that can be looked into at one time; a new one takes the oldest one's place */
    TRIAL_HEAP = 16 << 20,       /* bytes of Lua's memory */
    TRIAL_WORK = 1000000000,     /* instructions of a whole test script */
    TRIAL_FRAMES = 60 * 60 * 60, /* frames of all runs of a script: an hour of play */
    TRIAL_SETTINGS = 16,         /* DIP switches, and registers, that test.run can set */
    TRIAL_NAME = 64              /* of a picture or hash, with its 0 */
};

/* What test.run asks for. Texts are good during the call; NULL: not given. */
struct trial_start {
    const char *stage, *difficulty, *lang, *demo, *pads;
    uint64_t seed;
    int lives; /* 0: not given */
    bool invincible, seeded;
    const char *dips[TRIAL_SETTINGS], *registers[TRIAL_SETTINGS]; /* "NAME=VALUE" */
    int n_dips, n_registers;
};

/* What the cabinet does for a script. run: 0 to TRIAL_RUNS - 1. Where err is given, false or NULL comes with a
 * sentence. None of these may return anywhere but to its caller. */
struct trial_host {
    void *context;

    /* The text of the script that require "NAME" names; NULL: there is none. Good until the script has ended. */
    const char *(*script)(void *context, const char *name, size_t *size);

    /* Powers a board in place of run's last one; *frames: those of its demo, else 0. */
    struct board *(*power)(void *context, int run, const struct trial_start *start, uint32_t *frames, char *err,
                           size_t err_size);

    /* From the next tick on these buttons are held, as --press takes them. */
    bool (*press)(void *context, int run, const char *list, char *err, size_t err_size);

    /* One frame, with the buttons of the run. */
    void (*tick)(void *context, int run);

    /* Before RAM is changed from outside (false: no memory); to put back what it was then. */
    bool (*keep)(void *context, int run);
    void (*back)(void *context, int run);

    /* Compares the picture, or the hashes, with those kept under that name. False: they differ, and why. */
    bool (*shot)(void *context, int run, const char *name, char *err, size_t err_size);
    bool (*hash)(void *context, int run, const char *name, char *err, size_t err_size);

    /* An expectation that does not hold, "tests/one.lua:12: ..."; a line that was printed. */
    void (*fails)(void *context, const char *sentence);
    void (*print)(void *context, const char *line);
};

/* Bytes of memory, aligned to 16, that trial_script needs. */
size_t trial_size(void);

/* Runs a script to its end. chunk is its name, "tests/one". False: it has a mistake, runs without end, or has no
 * memory; fault says what and where. *frames: how many it ran. */
bool trial_script(void *memory, const struct trial_host *host, const char *chunk, const char *text, size_t n,
                  struct board_fault *fault, uint32_t *frames);

/* The functions and fields of test scripts, a line each, for help. */
void trial_help(void (*line)(const char *));

/* The same for editors: the n-th entry; false: there are no more. */
struct trial_entry {
    const char *name;    /* "test.expect", "run:step", "run.frame", and of the table test.run takes "options.stage" */
    const char *params;  /* "value: any, what: string?": names and types as LuaLS writes them; a field: "" */
    const char *returns; /* type; "": none */
    const char *help;
};
bool trial_entry(int n, struct trial_entry *out);

#endif
