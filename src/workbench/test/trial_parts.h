/*
 * trial_parts.h - what the files of this room share.
 */
#ifndef BOARD_TRIAL_PARTS_H
#define BOARD_TRIAL_PARTS_H

#include "../../script/values.h"
#include "../../machine/machine.h"
#include "../../script/vm.h"
#include "trial.h"

enum { TRIAL_ERR = 700, TRIAL_CUES = CUE_SLOTS };

/* A run that a script looks into. What it has printed, and its moments and sounds, are tables of Lua (trial_run.c). */
struct trial_run {
    struct board *b;    /* NULL: none */
    lua_Integer serial; /* of the runs of the script, from 1 */
    int held;           /* reference to the function that says what is held; LUA_NOREF: none */
    int kept;           /* reference to { log, moments, heard } */
    bool may_fault;
    uint32_t began[TRIAL_CUES]; /* the frame in which the sound of each slot did */
};

/* board comes first: vm_board gives both. Its chips are never powered; vm.h and lualib.h want its machine, its output
 * and no task. */
struct trial {
    struct board board;
    struct output output;
    const struct trial_host *host;
    const char *chunk, *text;
    size_t text_size;
    struct trial_run run[TRIAL_RUNS];
    lua_Integer runs;
    uint32_t frames;
    struct values values;
    uint8_t value_bytes[VALUES_CAPACITY];
};

static inline struct trial *trial_of(lua_State *L)
{
    return (struct trial *)vm_board(L);
}

/* Puts the metatable of runs into the registry. */
void trial_open_runs(lua_State *L);

/* The newest run, or that at idx if there is one; a fault when it is over. */
int trial_newest(lua_State *L, int idx);

/* Functions of scripts; trial_api.c lists them. */
int trial_test_run(lua_State *L);
int trial_test_expect(lua_State *L);
int trial_test_equal(lua_State *L);
int trial_test_shot(lua_State *L);
int trial_test_hash(lua_State *L);
int trial_run_step(lua_State *L);
int trial_run_wait(lua_State *L);
int trial_run_press(lua_State *L);
int trial_run_eval(lua_State *L);
int trial_run_exec(lua_State *L);
int trial_run_live(lua_State *L);
int trial_run_refused(lua_State *L);
int trial_run_heard(lua_State *L);
int trial_run_printed(lua_State *L);
int trial_run_moment(lua_State *L);

/* Sets the functions whose names start with prefix ("test.", "run:") in the table on top. */
void trial_set_functions(lua_State *L, const char *prefix);

/* test.run's options: trial_start.c. The table at index 1 is read; what is a fault of a script is raised. Texts lie in
 * it. */
struct trial_options {
    struct trial_start start;
    uint32_t frames;
    bool framed;   /* frames was given */
    bool function; /* pads is one */
    bool faults;
};
void trial_read_options(lua_State *L, struct trial_options *o);

/* Pushes the words for the value at idx, as a script would write it. */
void trial_push_words(lua_State *L, int idx);

/* Are they equal, tables by what is in them? */
bool trial_same(lua_State *L, int a, int b, int depth);

#endif
