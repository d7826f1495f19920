/*
 * vm.h - the Lua machine in RAM: its memory, sandbox, faults and guards.
 *
 * Every byte of Lua lives in the heap inside RAM. Scripts run only inside vm_call, so an error never leaves the board:
 * it becomes a fault, the run is over, and nothing of the board's state is trusted any more.
 */
#ifndef SCRIPT_VM_H
#define SCRIPT_VM_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../base/heap.h"
#include "../machine/vm_state.h"

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

/* Runs the library's piece "screens/title" (std.h) and leaves what it returns; a fault when the ROM has none. It counts
 * as work: a unit a byte. */
void vm_read_piece(lua_State *L, const char *name);

/* Loads script "stages/one" or "@std/pattern" and leaves its function on the stack; a fault when it cannot. */
void vm_load(lua_State *L, const char *name);

/* require "stages/one": runs a script of the game once, at load. */
int vm_require(lua_State *L);

/* Runs module i of the library (std.h) with the sys table at `sys`, if the ROM has it and what it adds to is on, and
 * binds what it returns: prelude's entries one by one, the others under their name. */
void vm_load_std(lua_State *L, int i, int sys);

/* Before the first script. */
void vm_open_scripts(lua_State *L, int sys);

/* The standard library, then the entry script. For vm_call. */
int vm_boot(lua_State *L);

#endif
