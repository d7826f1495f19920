/*
 * vm.h - the Lua VM in RAM: its memory, sandbox, faults and guards.
 *
 * Every byte of Lua lives in the heap inside RAM. Scripts run only inside vm_call, so an error never leaves the board:
 * it becomes a fault, which ends the run; the board's state is no longer valid.
 */
#ifndef SCRIPT_VM_H
#define SCRIPT_VM_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../base/heap.h"
#include "../machine/vm_state.h"

/* Opens a Lua state in the given block, the board's Lua heap. Returns false if even that does not fit. */
bool vm_open(struct board *b, void *block, size_t size);

/* Runs f(L) in a protected call. Returns false on a fault, which is stored in the board's output. */
bool vm_call(struct board *b, lua_CFunction f);

/* Returns the board that L belongs to. */
static inline struct board *vm_board(lua_State *L)
{
    return *(struct board **)lua_getextraspace(L);
}

/* Raises a fault that no pcall catches. The message is prefixed with "FILE:LINE: " as vm_where finds it. */
int vm_fault(lua_State *L, enum board_fault_kind kind, const char *format, ...);

/* Raises FAULT_SCRIPT with the given place ("FILE:LINE: ") as prefix. */
int vm_fault_at(lua_State *L, const char *place, const char *format, ...);

/* Notes that a script read a property of a despawned thing, for the hint of a fault that this may cause. */
void vm_note_dead(lua_State *L, const char *field);

/* Writes "FILE:LINE: " of the nearest caller outside @std; otherwise of the author's line that started the library's
 * task; otherwise of the nearest caller; otherwise "". Does not change L. */
void vm_where(lua_State *L, char *place, size_t size);

/* Prefixes the message on top of the stack with the author's "FILE:LINE: " unless it has one. */
void vm_place(lua_State *L);

/* Resets the work counter at the start of a tick, of power-on or of a console line. More than `limit` is FAULT_LOOP. */
void vm_begin(struct board *b, uint64_t limit);

/* Adds work (1: about one VM instruction) to the counter. Raises FAULT_LOOP over the limit. */
void vm_charge(lua_State *L, uint64_t work);

/* Makes L the running thread and counts its instructions. Returns a value for vm_leave. */
uint32_t vm_enter(struct board *b, lua_State *L);

/* Makes L, which called vm_enter for another thread, the running thread again; `left` is what vm_enter returned. */
void vm_leave(struct board *b, lua_State *L, uint32_t left);

/* Weighs the function running in L, charges for it, and schedules the next look. */
void vm_look(lua_State *L, lua_Debug *ar);

/* While profiling (profile.h): vm_profile_turn starts a thread's turn, vm_profile_begin precedes a reset of the work
 * counter. */
void vm_profile_turn(struct vm *vm, lua_State *L);
void vm_profile_begin(struct vm *vm);

/* Called after each allocation: schedules a look at the next instruction if much was allocated. */
void vm_allocated(struct board *b);

/* Fills in the board's fault from the error value on top of `from`, the thread that failed. */
void vm_report(struct board *b, lua_State *from, int status);

/* Adds the traceback of `from` to the fault, unless it has one. */
void vm_trace(struct board *b, lua_State *L, lua_State *from);

/* Runs the garbage collector for its share of a frame. Only between frames; for vm_call. */
int vm_collect(lua_State *L);

/* Appends n bytes to the frame's log; cuts off what does not fit. */
void vm_log(struct board *b, const char *s, size_t n);

/* The Lua function print: writes its arguments, the whole stack, to the frame's log. */
int vm_print(lua_State *L);

/* Runs a library piece such as "screens/title" (std.h) and pushes its result. Raises a fault if the ROM has no such
 * piece. Charges one unit of work per byte. */
void vm_read_piece(lua_State *L, const char *name);

/* Loads a script such as "stages/one" or "@std/pattern" and pushes its function. Raises a fault on failure. */
void vm_load(lua_State *L, const char *name);

/* The Lua function require: runs a script of the game, such as "stages/one", once, while loading. */
int vm_require(lua_State *L);

/* Runs module i of the library (std.h) with the sys table at `sys`, if the ROM has it and the table it adds to is
 * enabled, and binds its result as a global: each entry of the prelude, otherwise the table under the module's name. */
void vm_load_std(lua_State *L, int i, int sys);

/* Prepares for loading scripts; called before the first one. */
void vm_open_scripts(lua_State *L, int sys);

/* Loads the standard library, then runs the entry script. For vm_call. */
int vm_boot(lua_State *L);

#endif
