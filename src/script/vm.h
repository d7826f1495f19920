/*
 * vm.h - the Lua VM in RAM: its memory, sandbox, faults and guards.
 *
 * All memory of Lua is in a heap inside RAM. Scripts run only inside vm_call, so an error never leaves the board: it
 * becomes a fault, which ends the run and leaves the board's state invalid.
 */
#ifndef SCRIPT_VM_H
#define SCRIPT_VM_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../base/heap.h"
#include "../base/slots.h"
#include "../machine/vm_state.h"

/* Opens a Lua state and makes the given block its heap. Returns false if the block is too small for the state
 * itself. */
bool vm_open(struct board *b, void *block, size_t size);

/* Runs f(L) in a protected call. Returns false on a fault, which is stored in the board's output. */
bool vm_call(struct board *b, lua_CFunction f);

/* Returns the board that L belongs to. */
static inline struct board *vm_board(lua_State *L)
{
    return *(struct board **)lua_getextraspace(L);
}

/* Pushes the table that the registry holds under that key; creates it on first use. */
void vm_push_registry_table(lua_State *L, const void *key);

/* Raises a fault that no pcall catches. Prefixes the message with the "FILE:LINE: " that vm_get_location writes. */
int vm_fault(lua_State *L, enum board_fault_kind kind, const char *format, ...);

/* Raises FAULT_SCRIPT with the given place ("FILE:LINE: ") as prefix. */
int vm_fault_at(lua_State *L, const char *place, const char *format, ...);

/* Records that a script read a property of a despawned thing. If using the nil result causes a fault, its message says
 * so. */
void vm_note_dead_read(lua_State *L, const char *field);

/* Writes the current place as "FILE:LINE: ": the nearest caller outside @std or, if there is none, the author's line
 * that started the library's task or, if that is unknown, the nearest caller. Writes "" without any caller. Does not
 * change L. */
void vm_get_location(lua_State *L, char *place, size_t size);

/* Prefixes the message on top of the stack with the author's "FILE:LINE: " unless it has one. */
void vm_add_location(lua_State *L);

/* Resets the work counter at the start of a tick, of power-on or of a console line. Work beyond `limit` raises
 * FAULT_LOOP. */
void vm_reset_work(struct board *b, uint64_t limit);

/* Adds work, in units of about one VM instruction, to the counter. Raises FAULT_LOOP if the counter exceeds the
 * limit. */
void vm_charge(lua_State *L, uint64_t work);

/* Makes L the running thread and counts its instructions. Returns a value for vm_leave. */
uint32_t vm_enter(struct board *b, lua_State *L);

/* Makes L the running thread again, after vm_enter for another thread; `left` is the value vm_enter returned. */
void vm_leave(struct board *b, lua_State *L, uint32_t left);

/* Takes a look (vm_count.c): weighs the function running in L, charges for it, and schedules the next look. */
void vm_check_work(lua_State *L, lua_Debug *ar);

/* Called only while profiling (profile.h): vm_profile_begin_turn when a thread's turn starts, vm_profile_reset_work
 * before the work counter is reset. */
void vm_profile_begin_turn(struct vm *vm, lua_State *L);
void vm_profile_reset_work(struct vm *vm);

/* Called after each allocation: schedules a look at the next instruction if much was allocated. */
void vm_on_allocation(struct board *b);

/* Fills in the board's fault from the error value on top of `thread`, the thread that failed. */
void vm_report_fault(struct board *b, lua_State *thread, int status);

/* Adds the traceback of `thread` to the fault, unless it has one. */
void vm_add_traceback(struct board *b, lua_State *L, lua_State *thread);

/* Runs the garbage collector for its share of a frame. Called between frames only, through vm_call. */
int vm_collect_garbage(lua_State *L);

/* Appends n bytes to the frame's log; cuts off what does not fit. */
void vm_log(struct board *b, const char *s, size_t n);

/* The Lua function print: writes its arguments, the whole stack, to the frame's log. */
int vm_print(lua_State *L);

/* Runs a library piece such as "screens/title" (std.h) and pushes its result. Raises a fault if the ROM has no such
 * piece. Charges one unit of work per byte. */
void vm_run_library_file(lua_State *L, const char *name);

/* Loads a script such as "stages/one" or "@std/pattern" and pushes its function. Raises a fault on failure. */
void vm_load_script(lua_State *L, const char *name);

/* Compiles the text of a script and pushes its function. Raises an error on failure. */
void vm_load_text(lua_State *L, const char *name, const char *text, size_t size);

/* The end of a function require: calls the function of a script with the arguments above it, stores its result, or true
 * for nil, under the script's name in the table at index 2, and returns the result. */
int vm_finish_require(lua_State *L, const char *name, int args);

/* Makes space for n more entries of a growing list (struct part): moves its columns to larger memory in the Lua heap
 * if needed. Reserves no more than the list's capacity. Raises a Lua error if out of memory. Call it after everything
 * that may run Lua code, such as reading a table's fields, because that code may declare kinds too. */
enum { MAX_KIND_ROWS = 16 /* most entries that the declaration of a kind adds to its list */ };
void vm_reserve(lua_State *L, struct slots *list, uint32_t n);

/* The Lua function require: runs a script of the game, such as "stages/one", once, while loading. */
int vm_require(lua_State *L);

/* Runs module i of the library (std.h) with the sys table at `sys`, if the ROM has it and the table it adds to is
 * enabled, and binds its result: the prelude's entries as one global each, another module's table as the global with
 * the module's name. */
void vm_load_std(lua_State *L, int i, int sys);

/* Prepares for loading scripts; called before the first vm_load_script. sys: stack index of the sys table. */
void vm_open_scripts(lua_State *L, int sys);

/* Loads the standard library, then runs the entry script. Called through vm_call. */
int vm_boot(lua_State *L);

#endif
