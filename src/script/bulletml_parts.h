/*
 * bulletml_parts.h - what the two halves of BulletML's run share: bulletml_run.c, which keeps the books of roots,
 * runners and bullets, and bulletml_do.c, which does the commands.
 */
#ifndef SCRIPT_BULLETML_PARTS_H
#define SCRIPT_BULLETML_PARTS_H

#include "bulletml_run.h"
#include "tasks.h"
#include "vm.h"

enum {
    MOST_COMMANDS = 100000, /* of a runner in a frame */
    MOST_DEPTH = 4096,      /* repeats and calls in one another */
    LONGEST = 1 << 30       /* frames, of a wait or a term */
};

/* The step of a change of that kind is kept in units of 2^-32 / bulletml_fine, so that all of them together are as the
 * straight line says; one that is too large for that is 0, and worked out anew. */
static inline int64_t bulletml_fine(int change)
{
    return change == CHANGE_DIRECTION ? 1 << 12 : 1 << 20;
}

/* A runner that has its turn. */
struct turn {
    struct board *b;
    const struct ml *ml;
    uint32_t runner, root, body;
    uint32_t now; /* the clock */
    fx x, y;      /* of its bullet, or root */
    bool vanishes;
    bool steers; /* direction, speed or velocity are others */
};

/* What $1.. are in a part of a document: of a list of the pool, or not of one yet. */
struct given {
    int n;
    const int64_t *value;
    uint32_t list; /* + 1, 0: of none */
};

/* A bullet as it is fired. */
struct fired {
    int64_t direction, speed; /* degrees from 0 up to 360; Q31.32 */
    uint32_t label;           /* + 1, 0: none */
    uint32_t at;              /* where its actions begin, 0: it has none */
};

/* Does the commands that are due. */
void bulletml_do(struct turn *t);

/* Fires it from where the runner is. */
void bulletml_fire(const struct turn *t, const struct fired *f, struct given *given);

/* A list of parameters is used once more, once less; a new one, used once, its slot + 1, or 0: there is no room. */
void bulletml_keep(struct board *b, uint32_t list);
void bulletml_let_list(struct board *b, uint32_t list);
uint32_t bulletml_list(struct board *b, const int64_t *value, int n);

/* The direction from the runner to the nearest player. */
int64_t bulletml_aim(const struct turn *t);

/* Raises the fault that names the runner's document, and the line of the command w. */
void bulletml_fault(const struct turn *t, uint32_t w, const char *what);

/* The same where all documents together have more to do than a frame may. */
void bulletml_too_much(const struct turn *t, uint32_t w);

#endif
