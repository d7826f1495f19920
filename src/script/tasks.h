/*
 * tasks.h - coroutines with owners: what scripts do over time.
 *
 * Tasks get their turns in the order they were started. The Lua registry keeps a task's thread alive; all else is
 * columns here. A scope is a task without a body: it only owns others.
 *
 * A scene is a scope that also owns the enemies and sprites that come from all that runs in it: its tasks, the tasks of
 * its enemies, sprites, bullets and shots, and its enemies' own handlers. When it ends, they are removed. Afterwards no
 * new ones come into it.
 */
#ifndef SCRIPT_TASKS_H
#define SCRIPT_TASKS_H

#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../machine/machine.h"

/* No tasks: at power-on. */
void tasks_empty(struct tasks *t);

/* Starts the function and n arguments on top of L's stack (popped) as a task; returns its handle, a dead one when there
 * is no room. */
int64_t tasks_start(struct board *b, lua_State *L, int64_t owner, int n);
int64_t tasks_scope(struct board *b, int64_t owner, bool scene);

/* Every task's turn. For vm_call: errors of a task become a fault. */
int tasks_run(lua_State *L);

/* Gives a task a turn at once, within that of the running one, which goes on after it. */
void tasks_turn(struct board *b, lua_State *L, uint32_t slot);

/* Stops a task or scope: closed at its turn, dead from now on. What a scene owns goes at once. */
void tasks_stop(struct board *b, uint32_t slot);

/* Does it get no turn, because the game is paused and the task is not of the pause? */
bool tasks_frozen(const struct board *b, uint32_t slot);

/* Is the running task on its way to a practice mark? */
static inline bool tasks_skipping(const struct tasks *t)
{
    return t->current != NO_SLOT && t->flags[t->current] & TASK_SKIPS;
}

#endif
