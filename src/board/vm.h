/*
 * vm.h - the Lua machine in RAM: its memory, sandbox, faults and guards.
 * floor: board
 *
 * Every byte of Lua lives in the heap inside RAM. Scripts run only inside vm_call, so an error never leaves the board:
 * it becomes a fault, the run is over, and nothing of the board's state is trusted any more.
 */
#ifndef BOARD_VM_H
#define BOARD_VM_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../base/heap.h"
#include "board.h"

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
    lua_State *L;
    lua_State *running; /* the thread that runs, or ran last */
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

/* Opens Lua with the sandbox in the board's heap. False: not even that fits. */
bool vm_open(struct board *b, void *block, size_t size);

/* Runs f(L) protected. False: a fault, which stands in the board's out. */
bool vm_call(struct board *b, lua_CFunction f);

/* The board a script's API call belongs to. */
static inline struct board *vm_board(lua_State *L)
{
    return *(struct board **)lua_getextraspace(L);
}

/* Raises a fault no pcall catches; "FILE:LINE: " of the nearest caller outside @std stands before the message. */
int vm_fault(lua_State *L, enum board_fault_kind kind, const char *format, ...);

/* The same of a script, with that place ("FILE:LINE: ") in place of the nearest caller's. */
int vm_fault_at(lua_State *L, const char *place, const char *format, ...);

/* Notes that a property of a thing that despawned was read, for the hint of a fault that follows from it. */
void vm_note_dead(lua_State *L, const char *field);

/* "FILE:LINE: " of the nearest caller outside @std, else of the author's line that started the library's task, else of
 * the nearest caller, else "". Changes nothing of L. */
void vm_where(lua_State *L, char *place, size_t size);

/* Puts the author's "FILE:LINE: " before the message on top of the stack if it has none. */
void vm_place(lua_State *L);

/* Starts counting the work of a tick, of power-on or of a line from 0; more than `limit` is FAULT_LOOP. */
void vm_begin(struct board *b, uint64_t limit);

/* Adds work (1: about one VM instruction) to the sum and raises FAULT_LOOP over the limit. */
void vm_charge(lua_State *L, uint64_t work);

/* Thread L runs from now on, and its instructions are counted. Returns what vm_leave takes. */
uint32_t vm_enter(struct board *b, lua_State *L);

/* Thread L, which called vm_enter for another one, continues. */
void vm_leave(struct board *b, lua_State *L, uint32_t left);

/* Weighs the function that runs in L, charges it, and decides when to do so again. */
void vm_look(lua_State *L, lua_Debug *ar);

/* While lines are counted (profile.h): a thread gets its turn; work is counted from 0 again. */
void vm_profile_turn(struct vm *vm, lua_State *L);
void vm_profile_begin(struct vm *vm);

/* Called after each allocation: when much was allocated, the next instruction is looked at. */
void vm_allocated(struct board *b);

/* Fills the board's fault from the error value on top of `from` (the thread it happened in). */
void vm_report(struct board *b, lua_State *from, int status);

/* Adds the traceback of `from` to the fault. */
void vm_trace(struct board *b, lua_State *L, lua_State *from);

/* The collector's turn; between frames only. */
int vm_collect(lua_State *L);

/* Writes into the frame's log; what does not fit is cut off. */
void vm_log(struct board *b, const char *s, size_t n);

/* print: writes its arguments, the whole stack, into the frame's log. */
int vm_print(lua_State *L);

/* Takes two values off the stack: what answers reads of fields, and on top what answers writes. They become the
 * metatable of the value below, for good. */
void vm_seal(lua_State *L);

/* Runs the library's piece "screens/title" (std.h) and leaves what it returns; a fault when the ROM has none. It counts
 * as work: a unit a byte. */
void vm_read_piece(lua_State *L, const char *name);

/* Loads script "stages/one" or "@std/pattern" and leaves its function on the stack; a fault when it cannot. */
void vm_load(lua_State *L, const char *name);

/* The standard library, then the entry script. For vm_call. */
int vm_boot(lua_State *L);

#endif
