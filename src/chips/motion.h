/*
 * motion.h - the world things move in, and motion programs: small steps as data, shared by every bullet that names the
 * program, run in C.
 * floor: chips
 *
 * A program is a run of steps in the `steps` list. What stands in one step happens together, in the order of struct
 * motion_step's bits, and lasts `over` frames (0: at once). After the last step the bullet flies straight on.
 */
#ifndef CHIPS_MOTION_H
#define CHIPS_MOTION_H

#include "../base/fx.h"
#include "slots.h"

enum {
    PARK = -(16384 << 16), /* where dead slots stand: one pixel past the end of the world (bullets: see bullets.h) */
    WORLD = 16383,         /* positions reach from -WORLD to WORLD px */
    MAX_SPEED = 8191,      /* px/frame; radii too */
    PACE_BITS = 16         /* Q32 has so many fraction bits more than fx */
};

/* The hit shape of a kind. */
enum {
    SHAPE_NONE,
    SHAPE_CIRCLE,      /* a: radius */
    SHAPE_BOX,         /* a, b: half width and half height */
    SHAPE_CAPSULE = 4, /* all within a of a bar, of which one end is at (x, y) and the other at (-x, -y), or, of
                          bullets, which lies along dir and reaches b to either side */
    SHAPE_CIRCLES = 8, /* a circle of radius a at (x, y), and b more, which are the next rows of the kinds */
    SHAPE_PLAIN = 3,   /* neither of those two is in any | of the others */
    SHAPE_PARTS = 4    /* most circles */
};

/* The columns of kinds that say what touches. */
struct shape_columns {
    uint8_t *shape;
    fx *a, *b, *x, *y;
};

/* Groups of columns (slots.h) that a manifest switches on for bullets, shots and enemies. */
enum {
    GROUP_VALUE = 1, /* and the next: a number each that the game declares */
    MAX_VALUES = 4,
    GROUP_HP = GROUP_VALUE + MAX_VALUES,
    GROUP_AROUND,
    GROUP_FROZEN
};

/* Of what stands still: a column of frames left, or FROZEN_FOREVER, and one of these flags. */
enum {
    FROZEN_FOREVER = -1,
    STANDS = 1 << 0, /* until the first move that finds no frames left */
    STOOD = 1 << 1   /* in the last move: its own tasks get no turn before the next */
};

/* A rectangle of field positions, ends included. */
struct box {
    fx x0, y0, x1, y1;
};

enum {
    DOES_WAIT = 1 << 0,
    DOES_KIND = 1 << 1,
    DOES_BANK = 1 << 2,
    DOES_DIR = 1 << 3,
    DOES_AIM = 1 << 4,
    DOES_TURN = 1 << 5,
    DOES_HOME = 1 << 6,
    DOES_SPEED = 1 << 7,
    DOES_ACCEL = 1 << 8,
    DOES_DIE = 1 << 9,
    DOES_LOOP = 1 << 10,  /* opens a loop of `count` rounds; `jump`: the step after its end */
    DOES_NEXT = 1 << 11,  /* closes it; `jump`: its first step */
    DOES_NAMED = 1 << 12, /* some of its numbers are values of the bullet: `named` */
    DOES_ALL = (1 << 13) - 1,
    MOTION_DEPTH = 4, /* loops inside loops */
    MOTION_FOREVER = 0xffff,
    MOTION_STEPS = 16 /* RAM for steps, a program on average */
};

/* The numbers of a step in whose place a value's name may stand. Of each, `named` has NAMED_BITS: the value's column + 1
 * for bullets, then for shots; 0: the number is the step's own. */
enum step_number {
    NUMBER_OVER, /* cut to whole frames, at least 1 */
    NUMBER_BANK, /* its low 4 bits */
    NUMBER_DIR,
    NUMBER_TURN,
    NUMBER_HOME, /* from 0 to 180 */
    NUMBER_SPEED,
    NUMBER_ACCEL,
    STEP_NUMBERS,
    NAMED_POOL = 3, /* bits for bullets, and as many for shots */
    NAMED_BITS = 2 * NAMED_POOL
};

/* The steps of all programs, one behind the other. */
struct steps {
    struct slots s;
    uint16_t *does;
    uint32_t *over; /* frames */
    uint16_t *kind;
    uint8_t *bank;
    ang *dir;
    int32_t *turn;   /* ang a frame, or once */
    ang *home;       /* at most so much a frame */
    int64_t *speed;  /* px/frame in Q32; whole fx unless the program is fine */
    int64_t *accel;  /* px/frame in Q32, a frame or once */
    uint16_t *count; /* rounds of a loop, MOTION_FOREVER for no end */
    uint16_t *jump;  /* counted from the program's first step */
    uint8_t *depth;  /* of a loop, 0 .. MOTION_DEPTH-1 */
    uint64_t *named; /* NAMED_BITS for each of enum step_number */
};

struct motions {
    struct slots s;
    uint32_t *first; /* index into steps */
    uint16_t *length;
    uint8_t *fine; /* its bullets keep 32 fraction bits */
};

struct motion_step {
    uint16_t does, kind, count, jump;
    uint32_t over;
    uint8_t bank, depth;
    ang dir, home;
    int32_t turn;
    int64_t speed, accel;
    uint64_t named;
};

/* Degrees as an angle: the nearest. */
ang motion_angle(fx degrees);

extern const struct chip steps_chip, motions_chip;

/* The program equal to these steps, made if there is none; NO_SLOT when there is no room for it. */
int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine);

/* Step i of the list. */
void motion_step_at(const struct steps *s, uint32_t i, struct motion_step *out);

#endif
