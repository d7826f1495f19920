/*
 * bulletml.h - what runs BulletML documents: those that run, and what of them has something left to do.
 *
 * Four chips. A document that runs is a root. A runner goes through actions: of the root itself, one for each action
 * that begins by itself (a top), or of a bullet that it fired. A frame is an open repeat, or where an actionRef leads
 * back to. A parameter list is what $1 to $9 are in a part of the document; it never changes, so those that have the
 * same share it. What they do stands in src/script/bulletml_run.c.
 *
 * A bullet that has no actions has no runner. One whose actions are over, and no change of which is going on, has none
 * any more.
 */
#ifndef ENTITIES_BULLETML_H
#define ENTITIES_BULLETML_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    ML_ROOTS = 4096, /* documents at once */
    ML_KINDS = 64,   /* labels of a document for which a kind can be given */
    ML_VALUES = 9,   /* of a parameter list */
    ML_FRAMES = 4    /* frames there is room for, a runner */
};

/* Flags of a root. */
enum {
    ROOT_LOOPS = 1 << 0,
    ROOT_STEERS = 1 << 1, /* moves the thing it follows */
    ROOT_MIRRORED = 1 << 2,
    ROOT_TELLS = 1 << 3, /* it has an on_fire */
    ROOT_BANK = 1 << 4,  /* bullets have its bank, not their kind's */
    ROOT_ENDED = 1 << 5, /* one of its tops has ended */
    ROOT_VANISHES = 1 << 6,
    ROOT_OVER = 1 << 7 /* for scripts it is gone; it stays until its bullets' runners have ended */
};

struct ml_roots {
    struct slots s;
    int64_t *owner;           /* handle, 0: the board */
    int64_t *follow;          /* the thing where it is, 0: none */
    fx *x, *y, *dx, *dy;      /* dx, dy: from what it follows */
    int16_t *x_more, *y_more; /* 16 more bits of x and y, which are the nearest fx */
    uint16_t *program;        /* of the ROM's */
    uint32_t *body;           /* the first of its own runners */
    uint16_t *kind, *tag;
    uint16_t *kinds; /* ML_KINDS a root: the kind of bullets with that label */
    uint8_t *bank, *flags;
    uint32_t *runners; /* its own and its bullets' */
    uint32_t *by;      /* serial of the task that started it */
    uint32_t *stream;  /* of its random numbers */
    uint32_t *given;   /* parameter list of its tops, + 1 */
    int64_t *rank;     /* Q31.32 */
    int64_t *pace;     /* Q31.32 px a frame of speed 1 */
    ang *turned;       /* where it has up; of the board's angles */
};

/* Timed changes of a runner, in the order in which they are applied. */
enum { CHANGE_DIRECTION, CHANGE_SPEED, CHANGE_X, CHANGE_Y, CHANGES };

/* Flags of a runner. */
enum {
    RUNNER_CHANGES = (1 << CHANGES) - 1, /* a bit a change that goes on */
    RUNNER_OVER = 1 << 4,                /* its actions are */
    RUNNER_TURNED = 1 << 5,              /* `last_direction` is set */
    RUNNER_SPED = 1 << 6,                /* `last_speed` is */
    RUNNER_ENDED = 1 << 7,               /* of a top: neither actions nor changes are left */
    RUNNER_TOP = 1 << 8
};

struct ml_runners {
    struct slots s;
    int64_t *bullet;         /* 0: it is of the root */
    uint32_t *serial;        /* in the order in which they were made */
    uint32_t *root;          /* slots */
    uint32_t *body;          /* the runner that has direction, speed and velocity: itself, or the first of the root's */
    uint32_t *order;         /* two columns' worth: the live runners, oldest first */
    uint32_t *at;            /* place in the program */
    uint32_t *wake;          /* the clock at which its next command is due */
    uint32_t *frame, *given; /* the innermost frame, and the parameter list, + 1; 0: none */
    uint16_t *depth;         /* frames it has */
    uint16_t *flags;
    int64_t *last_direction, *last_speed; /* what `sequence` adds to */
    int64_t *direction, *speed;           /* of a body: degrees as documents have them and speed, Q31.32 */
    int64_t *vx, *vy;                     /* of a body: what accel has made, beside it */
    int64_t *from, *to, *step;            /* CHANGES a runner; step: Q11.52 a frame, where it fits */
    uint32_t *begun, *over;               /* CHANGES a runner: the clock */
    int32_t *cosine, *sine;               /* of `direction` on the board, Q30 */
    ang *put_dir;                         /* `direction` on the board; with the next what was put into its bullet's
                                           * columns last: what stands there else a script wrote */
    fx *put_speed, *put_vx, *put_vy;
    uint32_t serials; /* given out so far */
    uint32_t n;       /* in `order` */
    uint64_t ran;     /* commands done in this frame, and steps of the values that they worked out */
};

struct ml_frames {
    struct slots s;
    uint32_t *up;    /* the frame round it, + 1 */
    uint32_t *back;  /* of a call: where it leads back to */
    uint32_t *given; /* of a call: the parameter list there, + 1 */
    int32_t *left;   /* of a repeat: rounds; 0: it is a call */
};

struct ml_params {
    struct slots s;
    uint32_t *users; /* runners, frames and roots that have it */
    uint8_t *n;      /* of its values, that were given */
    int64_t *value;  /* ML_VALUES a list */
};

/* What was fired in this frame, which appears when the hits are done. Outside the snapshot: between frames it is empty.
 */
struct ml_fired {
    fx x, y, vx, vy, speed;
    ang dir;
    uint16_t kind;
    uint32_t root, label, runner; /* label + 1, runner + 1; 0: none */
};

struct ml_fresh {
    uint32_t n, cap;
    struct ml_fired *at;
};

extern const struct chip ml_roots_chip, ml_runners_chip, ml_frames_chip, ml_params_chip;

#endif
