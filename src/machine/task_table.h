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
    TASK_STOP = 2 /* flag: close the task at its turn */,
    TASK_BEGUN = 4,
    TASK_SKIPS = 8 /* skips all waits, to reach a practice mark */,
    TASK_SCENE = 16
};

enum {
    MAX_OWNER_DEPTH = 64,
    MAX_SKIPS = 100000 /* most waits a task may skip in one turn */
};

struct tasks {
    struct slots s;
    uint32_t *serial; /* increases with every start; tasks run in this order */
    int64_t *owner;   /* handle, 0: the board */
    int64_t *scene;   /* handle of the scene it runs in, 0: none; for a scene, the enclosing one */
    int64_t *wait;    /* turns left to wait */
    uint8_t *flags;
    uint32_t *born;
    struct lua_State **thread; /* NULL: a scope */
    const char **from;     /* "FILE:LINE: " of the author's line that started an @std task; NULL: a script's own task */
    uint32_t *next, *prev; /* slots in order of serial */
    uint32_t first, last;
    uint32_t serials; /* given out so far */
    int32_t current;  /* slot of the running task, NO_SLOT: none */
    uint32_t skipped; /* waits the running task has skipped in this turn */
    int64_t now_owner,
        now_scene; /* owner of the tasks that the running script starts; scene of the entities it makes */
};

extern const struct chip tasks_chip;

/* Returns whether this owner (0: the board) and all its own owners are alive. */
bool tasks_owner_alive(const struct board *b, int64_t owner);
bool tasks_alive(const struct board *b, uint32_t slot, uint32_t gen);

/* The owner and scene on whose behalf a script runs. */
struct tasks_now {
    int64_t owner, scene;
};

/* Returns the owner of what the running script starts. */
int64_t tasks_owner(const struct board *b);

/* Stores the owner of an enemy or sprite that the running script makes: the script's scene or, with `stay`, none, so
 * that it outlives the scene. Returns false if that scene has ended, in which nothing more may be made. */
bool tasks_owner_of_new(const struct board *b, bool stay, int64_t *owner);

/* Sets the owner and scene for an enemy's handler, which runs in the enemy's scene. If the enemy has none, the handler
 * runs in no scene, on behalf of the owner of the script that caused the event; if that script runs in a scene, it has
 * no owner, because what it makes must not end with that scene. Returns the previous values, for tasks_act_for to
 * restore. */
struct tasks_now tasks_act_for_scene(struct board *b, int64_t scene);
void tasks_act_for(struct board *b, struct tasks_now was);

/* Sets the owner and scene to those of the task, for its scripts, including those that run when it ends. */
void tasks_act_for_task(struct board *b, uint32_t slot);

/* Restores the running task's own owner and scene, after it caught an error raised in an enemy's handler. */
void tasks_act_for_turn(struct board *b);

/* Returns "FILE:LINE: " of the author's line that started the @std task running in L, or NULL if none is. */
const char *tasks_from(const struct board *b, const struct lua_State *L);

/* Returns the serial of the running task, or 0. */
uint32_t tasks_serial(const struct board *b);

#endif
