/*
 * task_table.h - the columns of tasks (script/tasks.h says what they are).
 */
#ifndef BOARD_TASK_TABLE_H
#define BOARD_TASK_TABLE_H

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

#endif
