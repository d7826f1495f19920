/*
 * test_script_parts.h - the state of a running test script, shared by the files test_script*.c.
 */
#ifndef WORKBENCH_TEST_SCRIPT_PARTS_H
#define WORKBENCH_TEST_SCRIPT_PARTS_H

#include "../../demo/demo.h"
#include "../../machine/machine.h"
#include "../../player/args/args.h"
#include "../../player/run/guard.h"
#include "../../script/values.h"
#include "../../script/vm.h"
#include "golden.h"
#include "outcome.h"
#include "test_script.h"
#include "testing.h"

enum {
    MAX_TEST_RUNS = 4,          /* runs that are open at a time; a new run replaces the oldest */
    TEST_HEAP = 16 << 20,       /* bytes of Lua memory */
    TEST_WORK = 1000000000,     /* instructions of a test script */
    TEST_FRAMES = 60 * 60 * 60, /* frames of all runs of a script: an hour of play */
    TEST_GOLDENS = 256,         /* pictures and hashes that a script can compare */
    TEST_SCRIPTS = 64,          /* scripts that a script can require */
    TEST_NAME_SIZE = 64,        /* of the name of a picture or hash */
    TEST_ERR_SIZE = 700
};

/* A run of the game. Its printed lines, moments and sounds are Lua tables (test_script_runs.c). */
struct test_run {
    struct guard guard;
    struct board *b; /* the guard's; NULL: not powered on */
    struct demo demo;
    bool plays_demo;
    struct args held; /* the buttons: --press alone */
    void *snapshot, *output;
    size_t snapshot_size;
    lua_Integer serial;              /* 1 for the first run of the script */
    int pads_function;               /* reference; LUA_NOREF: none */
    int records;                     /* reference to { log, moments, heard } */
    bool may_fault;                  /* a fault of the game does not end the test */
    uint32_t sound_start[CUE_SLOTS]; /* the frame in which the sound of each slot started, plus 1 */
};

/* vm_board returns the address of `board`, and so of this struct. The board has no chips: vm.h and lualib.h use its
 * machine and output. */
struct test_script {
    struct board board;
    struct output output;
    const struct testing *testing;
    FILE *out;
    struct golden golden;
    const char *chunk;
    const uint8_t *text;
    size_t text_size;
    struct test_run run[MAX_TEST_RUNS];
    lua_Integer runs;
    uint32_t frames;
    char compared[TEST_GOLDENS][TEST_NAME_SIZE + 8]; /* "one.png" */
    int n_compared;
    uint8_t *required[TEST_SCRIPTS]; /* texts; malloc */
    int n_required;
    struct values values;
    uint8_t value_bytes[VALUES_CAPACITY];
};

static inline struct test_script *test_script_of(lua_State *L)
{
    return (struct test_script *)vm_board(L);
}

/* Registers the metatable of runs. */
void test_script_open_runs(lua_State *L);

/* Closes a run and frees its memory. */
void test_run_close(struct test_run *r);

/* Returns the run at idx or, if there is no argument, the newest run. Raises a fault if it has ended. */
struct test_run *test_script_newest(lua_State *L, int idx);

/* Functions of scripts, listed in test_script_api.c. */
int test_script_start_run(lua_State *L);
int test_script_expect(lua_State *L);
int test_script_equal(lua_State *L);
int test_script_shot(lua_State *L);
int test_script_hash(lua_State *L);
int test_run_step(lua_State *L);
int test_run_wait(lua_State *L);
int test_run_press(lua_State *L);
int test_run_eval(lua_State *L);
int test_run_exec(lua_State *L);
int test_run_live(lua_State *L);
int test_run_refused(lua_State *L);
int test_run_heard(lua_State *L);
int test_run_printed(lua_State *L);
int test_run_moment(lua_State *L);

/* Sets the functions whose names start with prefix ("test.", "run:") in the table on top. */
void test_script_set_functions(lua_State *L, const char *prefix);

/* The options of test.run. The texts belong to its table. */
struct test_options {
    struct args start;       /* as the command line gives it */
    const char *demo, *pads; /* NULL: not given */
    uint32_t frames;
    bool has_frames;
    bool pads_is_function;
    bool faults;
};

/* Reads the table at index 1; raises a fault for a mistake in it. */
void test_options_read(lua_State *L, struct test_options *o);

#endif
