/*
 * task_table.h - the columns of tasks (script/tasks.h says what they are).
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
    TASK_STOP = 2 /* flags: to be closed at its turn */,
    TASK_BEGUN = 4,
    TASK_SKIPS = 8 /* waits for nothing: on its way to a practice mark */,
    TASK_SCENE = 16
};

enum {
    MAX_OWNER_DEPTH = 64,
    MAX_SKIPS = 100000 /* waits a task may pass over in one turn */
};

struct tasks {
    struct slots s;
    uint32_t *serial; /* counts up with every start: the order of turns */
    int64_t *owner;   /* handle, 0: the board */
    int64_t *scene;   /* handle of the one it runs in, 0: none; of a scene the one round it */
    int64_t *wait;    /* turns to let pass */
    uint8_t *flags;
    uint32_t *born;
    struct lua_State **thread; /* NULL: a scope */
    const char **from; /* "FILE:LINE: " of the author's line that started a task of @std's; NULL: of a script's own */
    uint32_t *next, *prev; /* slots in order of serial */
    uint32_t first, last;
    uint32_t serials; /* given out so far */
    int32_t current;  /* slot that has its turn, NO_SLOT: none */
    uint32_t skipped; /* waits it has passed over in this turn */
    int64_t now_owner,
        now_scene; /* the owner of tasks the running script starts; the scene of what it spawns and puts */
};

extern const struct chip tasks_chip;

/* Is this owner (0: the board) still there, it and all it is owned by? */
bool tasks_owner_alive(const struct board *b, int64_t owner);
bool tasks_alive(const struct board *b, uint32_t slot, uint32_t gen);

/* The owner and scene a script acts for. */
struct tasks_now {
    int64_t owner, scene;
};

/* The owner for things the running script starts. */
int64_t tasks_owner(const struct board *b);

/* The owner of an enemy or a sprite that the running script makes: its scene; with stay none, so that it outlives the
 * scene. False: that scene has ended, and nothing more is made in it. */
bool tasks_owner_of_new(const struct board *b, bool stay, int64_t *owner);

/* An enemy's own handler runs in the enemy's scene. That of an enemy without a scene runs in none, with the owner of
 * what caused it; but with no owner if that runs in a scene, for what it makes must not end with that scene.
 * Returns what tasks_act_for puts back afterwards. */
struct tasks_now tasks_act_for_scene(struct board *b, int64_t scene);
void tasks_act_for(struct board *b, struct tasks_now was);

/* What the scripts of this task do is on behalf of its owner, its end included. */
void tasks_act_for_task(struct board *b, uint32_t slot);

/* Back to the running task's own owner and scene: for an error out of an enemy's handler that a task caught. */
void tasks_act_for_turn(struct board *b);

/* Where the author's line stands that led to the task of @std's that has its turn in L; NULL: no such task. */
const char *tasks_from(const struct board *b, const struct lua_State *L);

/* Serial of the running task, 0: none. */
uint32_t tasks_serial(const struct board *b);

#endif
