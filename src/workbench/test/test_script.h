/*
 * test_script.h - a test script of a game: Lua that runs the game, inspects it and checks what it expects.
 *
 * A test script has its own Lua machine, with the sandbox of games and the table `test`. Its memory, work and frames
 * are limited.
 */
#ifndef WORKBENCH_TEST_SCRIPT_H
#define WORKBENCH_TEST_SCRIPT_H

#include <stdbool.h>
#include <stdio.h>

struct testing;

/* Runs the script `name` ("tests/boss.lua") of the game, and writes its outcome (outcome.h) to out. */
void test_script_run(const struct testing *t, const char *name, FILE *out);

/* Calls `line` for each function and field of test scripts, for help. */
void test_script_help(void (*line)(const char *));

/* Stores the n-th entry of the same list, for editors; false: there is none. */
struct test_script_entry {
    const char *name;    /* "test.expect", "run:step", "run.frame", and of the table test.run takes "options.stage" */
    const char *params;  /* "value: any, what: string?": names and types in LuaLS's notation; a field: "" */
    const char *returns; /* type; "": none */
    const char *help;
};
bool test_script_entry(int n, struct test_script_entry *out);

#endif
