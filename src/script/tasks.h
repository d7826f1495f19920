/*
 * tasks.h - tasks: coroutines with owners, which scripts use for everything that takes time.
 *
 * Tasks get their turns in the order they were started. The Lua registry keeps a task's thread alive; all other state
 * is in the columns of struct tasks. A scope is a task without a body: it only owns other tasks.
 *
 * A scene is a scope that also owns the enemies, sprites and lines spawned by the code running in it: its tasks, the
 * tasks of its enemies, sprites, bullets, shots and lasers, and its enemies' own handlers. Ending a scene removes these
 * entities, and none can be added to it afterwards.
 */
#ifndef SCRIPT_TASKS_H
#define SCRIPT_TASKS_H

#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../machine/machine.h"

/* Initializes an empty task list, at power-on. */
void tasks_init(struct tasks *t);

/* tasks_start starts a task from the function and its n arguments on top of L's stack (popped). tasks_new_scope creates
 * a scope or, with `is_scene`, a scene. Both return the handle, which is dead if the pool is full; that of a scope is
 * also dead if its owner is. */
int64_t tasks_start(struct board *b, lua_State *L, int64_t owner, int n);
int64_t tasks_new_scope(struct board *b, int64_t owner, bool is_scene);

/* Gives every task its turn. Called through vm_call: a task's error becomes a fault. */
int tasks_run(lua_State *L);

/* Gives a task a turn at once, within the running task's turn, which continues afterwards. */
void tasks_run_turn(struct board *b, lua_State *L, uint32_t slot);

/* Stops a task or scope: it is dead from now on and is closed at its next turn. If it is a scene, removes its entities
 * immediately. */
void tasks_stop(struct board *b, uint32_t slot);

/* Returns whether the task gets no turn because the game is paused and the task does not belong to the pause's
 * scope. */
bool tasks_is_frozen(const struct board *b, uint32_t slot);

#endif
