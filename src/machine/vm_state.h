/*
 * vm_state.h - the board's state of the Lua machine (script/vm.h), and the functions by which the board's parts call
 * that machine.
 */
#ifndef MACHINE_VM_STATE_H
#define MACHINE_VM_STATE_H

#include "../base/heap.h"
#include "board_types.h"

struct api_table;
struct board;
struct profile;

/* Most VM instructions, or equivalent work in C, in one tick. Tests of endless loops lower this limit. */
#ifndef WORK_LIMIT
#define WORK_LIMIT 200000000
#endif

enum {
    WORK_TASK = 1000,     /* work of starting a task */
    WORK_CALL = 100,      /* work of calling an API function */
    WORK_FIRE = 20,       /* work of firing one bullet from a motion program */
    VM_LOCATION_SIZE = 80 /* size of a buffer for "FILE:LINE: " */
};

/* A VM instruction counts as 1 + `extra` instructions if it may have to process n items of the kind `kind`. */
enum vm_weight_kind {
    WEIGHT_TEXT,
    WEIGHT_ZEROS,
    WEIGHT_NUMERAL,
    WEIGHT_EXTREME_NUMBER,
    WEIGHT_FLOAT,
    WEIGHT_CHAIN,
    WEIGHT_ARGUMENTS
};

struct vm_weight {
    size_t extra;
    enum vm_weight_kind kind;
    size_t n;
};

/* A cache of name lookups, indexed by api_guess_index: each entry holds where the last name with that index was found.
 * The cache affects only the speed of lookups. */
enum { VM_GUESS_COUNT = 128 };
struct vm_guesses {
    uint8_t props[VM_GUESS_COUNT];
    uint16_t names[VM_GUESS_COUNT];
};

struct vm {
    const struct api_table *api; /* functions that scripts can call */
    struct lua_State *L;
    struct lua_State *running; /* the running thread, or the last one that ran */
    struct heap *heap;
    uint64_t work;                /* work done in this tick */
    uint64_t limit;               /* limit on `work`: WORK_LIMIT in a tick, less in board_eval */
    uint64_t checked_heap_work;   /* heap_work when the work done was last checked */
    uint32_t rng_state;           /* state of the random numbers that space the checks */
    uint32_t until_check;         /* instructions until the next check, while there is a profile */
    struct vm_weight heaviest;    /* the heaviest instruction of this tick */
    uint64_t swept_heap_work;     /* heap_work when the collector last had a chance to run */
    size_t heap_size, collect_at; /* bytes: size of the heap, and heap use at which the next collection starts */
    bool collecting;              /* a collection is in progress */
    size_t text_block_size, max_text_block; /* bytes that Lua allocated for the last string; most bytes allowed */
    struct profile *profile;                /* the host's profile while it counts lines (profile.h); otherwise NULL */
    bool loading;                           /* scripts are being loaded */
    bool practice_read;                     /* a script has read the practice start (sys.practice) */
    enum board_fault_kind raised_kind;      /* kind of the error being raised, if it is not FAULT_SCRIPT */
    bool skips_plans;                       /* set by tests: read arguments without plans (api_plan.c) */
    uint32_t plan_count;                    /* for tests: how often arguments were read by a plan */
    struct vm_guesses guesses;
};

/* The functions of the Lua machine that the board calls, set by vm_open. Call them only while scripts run, in vm_call.
 */
struct vm_calls {
    /* Raises a fault that pcall does not catch, prefixed with the location of the nearest caller. Does not return. */
    void (*fault)(struct board *b, enum board_fault_kind kind, const char *message);
    /* Stores "FILE:LINE: " of the running script, or "". */
    void (*get_location)(struct board *b, char *place, size_t size);
    /* Returns a block in Lua's heap for the queue of emits. old_block: the queue's present block, or NULL if the queue
     * has none in this frame yet. If `old_block` is NULL and a block of an earlier frame exists, returns that block and
     * stores its size in *size; otherwise returns a new, zeroed block of *size bytes. Raises a Lua error if out of
     * memory. */
    void *(*alloc_emissions)(const struct board *b, const void *old_block, size_t *size);
};

#endif
