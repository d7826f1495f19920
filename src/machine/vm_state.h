/*
 * vm_state.h - what the board keeps of the Lua machine (script/vm.h), and what the board's parts ask of it.
 */
#ifndef MACHINE_VM_STATE_H
#define MACHINE_VM_STATE_H

#include "../base/heap.h"
#include "board_types.h"

struct api_table;
struct board;
struct profile;

/* VM instructions, or work in C worth as many, in one tick. Tests of endless loops lower it. */
#ifndef WORK_LIMIT
#define WORK_LIMIT 200000000
#endif

enum {
    WORK_TASK = 1000, /* the work of starting a task */
    WORK_CALL = 100,  /* of calling an API function */
    WORK_FIRE = 20,   /* of firing one bullet of a motion program */
    VM_PLACE = 80     /* bytes of "FILE:LINE: " */
};

/* Why an instruction counts as 1 + more: it may work on this, of which there are n. */
enum vm_why {
    WEIGHT_TEXT,
    WEIGHT_ZEROS,
    WEIGHT_NUMERAL,
    WEIGHT_NUMBER,
    WEIGHT_FRACTION,
    WEIGHT_CHAIN,
    WEIGHT_ARGUMENTS
};

struct vm_weight {
    size_t more;
    enum vm_why why;
    size_t n;
};

/* Where something of a name was found when a name that looked like it was last searched for: api_guess. What stands
 * here changes nothing but the time that a search takes. */
enum { VM_GUESSES = 128 };
struct vm_guesses {
    uint8_t props[VM_GUESSES];
    uint16_t names[VM_GUESSES];
};

struct vm {
    const struct api_table *api; /* what scripts can call */
    struct lua_State *L;
    struct lua_State *running; /* the thread that runs, or ran last */
    struct heap *heap;
    uint64_t work;                /* of this tick */
    uint64_t limit;               /* of work: WORK_LIMIT in a tick, less in a line of board_eval */
    uint64_t looked;              /* heap_work at the last look */
    uint32_t stream;              /* state of the random numbers that place the looks */
    uint32_t left;                /* instructions before the next look, while there is a profile */
    struct vm_weight heaviest;    /* of this tick */
    uint64_t swept;               /* heap_work when the collector last could have had its turn */
    size_t heap_size, collect_at; /* bytes: the heap's, and in use when the collector's next round begins */
    bool collecting;              /* a round is going on */
    size_t text_block, text_max;  /* bytes of Lua's block for the last text, and for the longest that is allowed */
    struct profile *profile;      /* the host's, while it counts lines (profile.h); else NULL */
    bool loading;
    bool practice_read;         /* a script read the practice start (sys.practice) */
    enum board_fault_kind kind; /* what the error on its way is, when it is not FAULT_SCRIPT */
    bool plain;                 /* a test's: arguments are read without plans (api_plan.c) */
    uint32_t planned;           /* how often they were read by one, for tests */
    struct vm_guesses guesses;
};

/* What the machine calls in the Lua machine, which sets it (vm_open). Only while scripts run, in vm_call. */
struct vm_calls {
    /* Raises a fault no pcall catches, with the place of the nearest caller before it. Does not return. */
    void (*fault)(struct board *b, enum board_fault_kind kind, const char *message);
    /* "FILE:LINE: " of the script that runs, or "". */
    void (*where)(struct board *b, char *place, size_t size);
    /* *size zeroed bytes in Lua's heap for the queue of emits. had: those that it has; NULL: none in this frame yet, so
     * it gets those of an earlier frame, if there are, and their *size. Raises Lua's error when memory is short. */
    void *(*emit_room)(const struct board *b, const void *had, size_t *size);
};

#endif
