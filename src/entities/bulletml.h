/*
 * bulletml.h - state of the BulletML interpreter: running documents, and their unfinished actions.
 *
 * Four pools. A root is a running document. A runner executes actions. A root has one runner for each of its top-level
 * actions (its tops), and one for each bullet it fired that has actions. A frame is an open repeat, or the return
 * address of an actionRef. A parameter list holds $1 to $9 for a part of the document; lists never change, so they are
 * shared. src/script/bulletml_run.c runs the documents.
 *
 * A bullet's runner is dropped when its actions have ended and no gradual change is in progress.
 */
#ifndef ENTITIES_BULLETML_H
#define ENTITIES_BULLETML_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    ML_MAX_ROOTS = 4096,     /* documents running at once */
    ML_MAX_KINDS = 64,       /* labels per document that can be given a kind */
    ML_MAX_VALUES = 9,       /* values of a parameter list */
    ML_FRAMES_PER_RUNNER = 4 /* capacity in frames per runner */
};

/* Flags of a root. */
enum {
    ROOT_LOOPS = 1 << 0,
    ROOT_STEERS = 1 << 1, /* moves the entity it follows */
    ROOT_MIRRORED = 1 << 2,
    ROOT_HAS_HANDLER = 1 << 3, /* has an on_fire handler */
    ROOT_HAS_BANK = 1 << 4,    /* its bullets use the root's bank instead of their kind's */
    ROOT_TOP_ENDED = 1 << 5,   /* one of its tops has ended */
    ROOT_VANISHES = 1 << 6,
    ROOT_DESPAWNED = 1 << 7 /* despawned as far as scripts can see; the slot stays until the runners of its bullets have
                        * ended */
};

struct ml_roots {
    struct slots s;
    int64_t *owner;         /* handle; 0: the board */
    int64_t *follow_target; /* handle of the entity it follows; 0: none */
    fx *x, *y, *dx, *dy;    /* dx, dy: offset from the followed entity */
    int16_t *x_low, *y_low; /* the next 16 bits of the position, added to x, y: units of 2^-32 px */
    uint16_t *program;      /* index in the ROM */
    uint32_t *body_runner;  /* slot of the first runner of its tops */
    uint16_t *kind, *tag;
    uint16_t *label_kind; /* ML_MAX_KINDS per root: the kind of bullets with that label */
    uint8_t *bank, *flags;
    uint32_t *n_runners;  /* number of its runners: top-level ones and those of its bullets */
    uint32_t *owner_task; /* serial of the task that started it */
    uint32_t *stream;     /* its random stream */
    uint32_t *params;     /* 1 + index of the parameter list of its top-level runners; 0: none */
    int64_t *rank;        /* Q31.32 */
    int64_t *speed_scale; /* Q31.32 px/frame per unit of document speed */
    ang *up_dir;          /* board angle of the document's direction 0, up */
};

/* Gradual changes of a runner, in the order in which they are applied. */
enum { CHANGE_DIRECTION, CHANGE_SPEED, CHANGE_X, CHANGE_Y, CHANGE_COUNT };

/* Flags of a runner. */
enum {
    RUNNER_CHANGES = (1 << CHANGE_COUNT) - 1, /* one bit per change in progress */
    RUNNER_ACTIONS_ENDED = 1 << 4,            /* its actions have ended */
    RUNNER_HAS_LAST_DIRECTION = 1 << 5,       /* `last_direction` is set */
    RUNNER_HAS_LAST_SPEED = 1 << 6,           /* `last_speed` is set */
    RUNNER_ENDED = 1 << 7,                    /* top-level runner: all its actions and changes have ended */
    RUNNER_TOP = 1 << 8
};

struct ml_runners {
    struct slots s;
    int64_t *bullet;          /* handle of its bullet; 0: it runs for the root */
    uint32_t *serial;         /* creation order */
    uint32_t *root;           /* slot of its root */
    uint32_t *body_runner;    /* slot of the runner that has direction, speed and velocity: itself, or the first of
                              * the root's runners */
    uint32_t *order;          /* live runners, oldest first; two entries per slot */
    uint32_t *pc;             /* position in the program */
    uint32_t *wake_clock;     /* clock at which its next command is due */
    uint32_t *frame, *params; /* innermost frame + 1, and parameter list + 1; 0: none */
    uint16_t *depth;          /* number of its frames */
    uint16_t *flags;
    int64_t *last_direction, *last_speed; /* base values for `sequence` */
    int64_t *direction, *speed;           /* of a bullet, Q31.32: degrees, and speed in units of the document */
    int64_t *vx, *vy;                     /* of a bullet: velocity from accel, on top of direction and speed */
    int64_t *change_from, *change_to,
        *change_step;                    /* CHANGES per runner; step per frame: Q11.52, for directions Q19.44; 0: out
                                           * of range or no change, computed from `change_from` and `change_to`
                                           * instead */
    uint32_t *change_start, *change_end; /* CHANGES per runner: start and end clock */
    int32_t *cosine, *sine;              /* of the board direction of `direction`, Q30 */
    ang *written_dir; /* board angle of `direction`. written_*: the values last written to the bullet;
                                           * if the bullet has another value, a script has set it */
    fx *written_speed, *written_vx, *written_vy;
    uint32_t last_serial; /* serial numbers given out so far */
    uint32_t n;           /* number of runners in `order` */
    uint64_t work_done;   /* commands and expression steps executed in this frame */
};

struct ml_frames {
    struct slots s;
    uint32_t *parent;     /* enclosing frame + 1; 0: none */
    uint32_t *return_pc;  /* of a call: return address */
    uint32_t *params;     /* of a call: the caller's parameter list + 1 */
    int32_t *rounds_left; /* of a repeat: rounds left; 0: it is a call */
};

struct ml_params {
    struct slots s;
    uint32_t *refs; /* number of runners, frames and roots that use it */
    uint8_t *n;     /* number of values given */
    int64_t *value; /* ML_MAX_VALUES per list */
};

/* A bullet fired in this frame, to be spawned after the hit tests. Not in snapshots, because the list is empty between
 * frames. */
struct ml_fired_bullet {
    fx x, y, vx, vy, speed;
    ang dir;
    uint16_t kind;
    uint32_t root, label, runner; /* slot of its root; label + 1 and runner + 1, 0: none */
};

struct ml_fired_list {
    uint32_t n, cap;
    struct ml_fired_bullet *entries;
};

extern const struct chip ml_roots_chip, ml_runners_chip, ml_frames_chip, ml_params_chip;

#endif
