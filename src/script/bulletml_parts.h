/*
 * bulletml_parts.h - declarations shared by the two halves of the BulletML interpreter: bulletml_run.c, which manages
 * roots, runners and bullets, and bulletml_do.c, which executes the commands.
 */
#ifndef SCRIPT_BULLETML_PARTS_H
#define SCRIPT_BULLETML_PARTS_H

#include "bulletml_run.h"
#include "tasks.h"
#include "vm.h"

enum {
    MAX_COMMANDS = 100000, /* per runner and frame */
    MAX_CALL_DEPTH = 4096, /* nested repeats and calls */
    MAX_DURATION = 1 << 30 /* frames, for a wait or a term */
};

/* The number of fraction bits that the per-frame step of a change has in addition to the value's 32, so that rounding
 * errors stay small when many steps are added. A step too large for them is stored as 0; the value is then interpolated
 * each frame. */
enum { DIRECTION_STEP_BITS = 12, STEP_BITS = 20 };

/* The turn of one runner in one frame. */
struct turn {
    struct board *b;
    const struct ml *ml;
    uint32_t runner, root, body;
    uint32_t now; /* the board's clock, in frames */
    fx x, y;      /* position of the runner's bullet or, for a top-level runner, of the root */
    bool vanishes;
    bool steered; /* direction, speed or velocity changed */
};

/* The values of $1, $2, ... in an action, fire or bullet. They may not be in the parameter pool yet. */
struct param_values {
    int n;
    const int64_t *value;
    uint32_t list; /* slot + 1; 0: not in the pool */
};

/* A bullet about to be fired. */
struct new_bullet {
    int64_t direction, speed;  /* degrees in [0, 360), and document speed; both Q31.32 */
    uint32_t label;            /* label + 1; 0: none */
    uint32_t actions_position; /* program position of the bullet's actions; 0: none */
};

/* Executes the runner's due commands. */
void bulletml_execute(struct turn *t);

/* Fires f from the runner's position. */
void bulletml_fire(const struct turn *t, const struct new_bullet *f, struct param_values *params);

/* Reference counting of parameter lists. A list is identified by slot + 1; 0 means no list and is ignored.
 * bulletml_retain_list adds a reference. bulletml_release_list drops a reference, and frees the list if it was the last
 * one. bulletml_new_list returns a new list of n values with one reference, or 0 if the pool is full. */
void bulletml_retain_list(struct board *b, uint32_t list);
void bulletml_release_list(struct board *b, uint32_t list);
uint32_t bulletml_new_list(struct board *b, const int64_t *value, int n);

/* Returns the direction from the runner to the nearest player, in the document's degrees, Q31.32. */
int64_t bulletml_aim_direction(const struct turn *t);

/* Raises a script fault that names the runner's document and the line of command w. */
void bulletml_fault(const struct turn *t, uint32_t w, const char *message);

/* Raises the fault for exceeding the frame's work limit, with the number of runners and of commands executed in all
 * documents. w: the current command. */
void bulletml_raise_overload(const struct turn *t, uint32_t w);

#endif
