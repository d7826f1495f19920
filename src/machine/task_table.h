/*
 * task_table.h - the columns of tasks (see script/tasks.h).
 */
#ifndef MACHINE_TASK_TABLE_H
#define MACHINE_TASK_TABLE_H

#include <stdbool.h>
#include <stdint.h>
#include "../base/slots.h"

struct board;

enum {
    TASK_RUNS = 0,
    TASK_SCOPE = 1,
    TASK_STOP = 2 /* close the task at its next turn */,
    TASK_BEGUN = 4,
    TASK_SKIPS = 8 /* the task skips all waits, to reach a practice mark */,
    TASK_SCENE = 16
};

enum {
    MAX_OWNER_DEPTH = 64,
    MAX_SKIPS = 100000,      /* most waits a task may skip in one turn */
    MAX_SEARCH_SKIPS = 10000 /* the same while the fight of a boss is searched; a stage that never ends costs time */
};

struct tasks {
    struct slots s;
    uint32_t *serial; /* increases with every start; tasks run in this order */
    int64_t *owner;   /* handle of the task's owner, 0: the board */
    int64_t *scene;   /* handle of the scene the task runs in, 0: none; of a scene: the enclosing scene */
    int64_t *wait;    /* turns left to wait */
    uint8_t *flags;
    uint32_t *born;
    struct lua_State **thread; /* NULL: a scope */
    const char **origin;   /* "FILE:LINE: " of the author's line that started an @std task; NULL: a script's own task */
    uint32_t *next, *prev; /* slots in order of serial */
    uint32_t first, last;
    uint32_t serial_count;  /* number of serials given out so far */
    int32_t current;        /* slot of the running task, NO_SLOT: none */
    uint32_t skipped_waits; /* waits the running task has skipped in this turn */
    int64_t current_owner,
        current_scene; /* owner of the tasks that the running script starts; scene of the entities that it spawns */
};

extern const struct chip tasks_chip;

/* Returns whether this owner (0: the board) is alive. A task is alive if it has not been stopped and its owner is
 * alive, up the whole chain of owners. */
bool tasks_is_owner_alive(const struct board *b, int64_t owner);
bool tasks_is_alive(const struct board *b, uint32_t slot, uint32_t gen);

/* The owner and scene on whose behalf a script runs. */
struct tasks_context {
    int64_t owner, scene;
};

/* Stores the owner of an enemy or sprite that the running script spawns: the script's scene or, with `outlives_scene`,
 * none, so that the enemy or sprite outlives the scene. Returns false if the owner is a scene that has ended: scripts
 * cannot spawn entities in it. */
bool tasks_get_spawn_owner(const struct board *b, bool outlives_scene, int64_t *owner);

/* Sets the owner and scene for an enemy's handler. If the enemy has a scene, the handler runs in that scene, which is
 * also the owner. Otherwise the handler runs in no scene, and the owner stays that of the script that caused the event,
 * unless that script runs in a scene: then the owner is the board, because the tasks and entities of the handler must
 * not end with the scene of another script. Returns the previous values, for tasks_set_context to restore. */
struct tasks_context tasks_enter_scene(struct board *b, int64_t scene);
void tasks_set_context(struct board *b, struct tasks_context context);

/* Sets the owner and scene to those of the task, for its code, including the code that runs when the task ends. */
void tasks_set_task_context(struct board *b, uint32_t slot);

/* Restores the owner and scene of the running task, after the task caught an error raised in an enemy's handler. */
void tasks_restore_context(struct board *b);

/* Returns the "FILE:LINE: " in the game's scripts that started the @std task running in L, or NULL if L is not running
 * an @std task. */
const char *tasks_origin(const struct board *b, const struct lua_State *L);

/* Returns the serial of the running task, or 0. */
uint32_t tasks_current_serial(const struct board *b);

/* Returns whether the running task is skipping ahead to a practice mark. */
static inline bool tasks_is_skipping(const struct tasks *t)
{
    return t->current != NO_SLOT && t->flags[t->current] & TASK_SKIPS;
}

#endif
