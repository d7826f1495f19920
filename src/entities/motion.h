/*
 * motion.h - the world things move in, and motion programs: small steps as data, shared by every bullet that names the
 * program, run in C.
 *
 * A program is a run of steps in the `steps` list. What stands in one step happens together, in the order of struct
 * motion_step's bits, and lasts `over` frames (0: at once). After the last step the bullet flies straight on.
 */
#ifndef ENTITIES_MOTION_H
#define ENTITIES_MOTION_H

#include "../base/fx.h"
#include "../base/slots.h"

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
    SHAPE_CIRCLES = 8, /* a circle of radius a at (x, y), and b more, which are the kind's ROW_CIRCLES */
    SHAPE_PLAIN = 3,   /* neither of those two is in any | of the others */
    SHAPE_PARTS = 4    /* most circles */
};

/* The columns of kinds that say what touches. */
struct shape_columns {
    uint8_t *shape;
    fx *a, *b, *x, *y;
};

/* The rows that one kind takes, by their distance from the one that its name means. */
enum kind_row {
    ROW_CLOUD = -1, /* of a bullet: what it looks like while it is delayed; no name, no shape */
    ROW_KIND = 0,
    ROW_CIRCLES = 1 /* the first of up to three more circles of its shape, which use shape, a, b, x and y alone */
};

/* Groups of columns (slots.h) that a manifest switches on for bullets, shots and enemies. */
enum {
    GROUP_VALUE = 1, /* and the next: a number each that the game declares */
    MAX_VALUES = 4,
    GROUP_HP = GROUP_VALUE + MAX_VALUES,
    GROUP_AROUND,
    GROUP_FROZEN,
    GROUP_MEET,
    GROUP_ITEMS,  /* of players: what attracts items */
    GROUP_BODIES, /* of enemies: parts, rates, orbits */
    GROUP_PIERCE  /* of shots: what goes through enemies */
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
    DOES_GO_TO =
        1 << 13, /* the bullet is led: in each frame it is at a place that a formula gives (motion_lead_place) */
    DOES_POLAR = 1 << 14,
    DOES_WAVE = 1 << 15,
    DOES_ORBIT = 1 << 16,
    DOES_LEAD = DOES_GO_TO | DOES_POLAR | DOES_WAVE | DOES_ORBIT,
    DOES_BOUNCE = 1 << 17, /* with DOES_LOOP: opens a loop of bounces; without: flies to the next one */
    DOES_EMIT = 1 << 18,   /* fires; it takes EMIT_ROWS steps (motion_emit_at) */
    DOES_AWAIT = 1 << 19,  /* flies on until what `how` says, but for at most `over` frames */
    DOES_ALL = (1 << 20) - 1,
    MOTION_DEPTH = 4, /* loops inside loops */
    MOTION_FOREVER = 0xffff,
    MOTION_STEPS = 16 /* RAM for steps, a program on average */
};

enum ease { EASE_LINEAR, EASE_IN, EASE_OUT, EASE_BOTH };

/* In `how`. */
enum {
    HOW_EASE = 3,    /* enum ease */
    HOW_AT = 1 << 2, /* round (x, y); else polar goes round where it began, orbit round the bullet's `orbit_target` */
    HOW_TO = 1 << 3, /* an orbit's radius goes to size_to */
    HOW_SPEED = 1 << 4, /* go_to flies at `speed`, for as many frames as that takes */
    HOW_BY = 1 << 5,    /* of go_to: (x, y) counts from where the bullet was when the step began */
    HOW_LEFT = 1 << 0,  /* of DOES_BOUNCE: the edges of the field that are walls */
    HOW_RIGHT = 1 << 1,
    HOW_TOP = 1 << 2,
    HOW_BOTTOM = 1 << 3,
    HOW_WALLS = 15,
    HOW_X = 1 << 0, /* of DOES_AWAIT: it is at x, or beyond it as seen from where the step began */
    HOW_Y = 1 << 1,
    HOW_NEAR = 1 << 2,  /* a target is nearer than size */
    HOW_SIGNAL = 1 << 3 /* the group of the tag `count` was signalled (bullets_signal) */
};

/* The numbers of a step in whose place a value's name may stand. Of each, `named` has NAMED_BITS: the value's column
 * + 1 for bullets, and NAMED_SHOTS times that for shots; 0: the number is the step's own. */
enum step_number {
    NUMBER_OVER, /* cut to whole frames, at least 1 */
    NUMBER_BANK, /* its low 4 bits */
    NUMBER_DIR,
    NUMBER_TURN,
    NUMBER_HOME, /* from 0 to 180 */
    NUMBER_SPEED,
    NUMBER_ACCEL,
    NUMBER_X,
    NUMBER_Y,
    NUMBER_SIZE,    /* from 0 to MAX_SPEED, but of a wave */
    NUMBER_SIZE_TO, /* the same */
    NUMBER_COUNT,   /* of a wave: cut to whole frames, at least 1 */
    STEP_NUMBERS,
    NAMED_BITS = 5,
    NAMED_SHOTS = MAX_VALUES + 1
};
_Static_assert(STEP_NUMBERS *NAMED_BITS <= 64, "a step's `named` has no room for another number");

/* The steps of all programs, one behind the other. */
struct steps {
    struct slots s;
    uint32_t *does;
    uint32_t *over; /* frames */
    uint16_t *kind;
    uint8_t *bank;
    ang *dir;
    int32_t *turn;   /* ang a frame, or once */
    ang *home;       /* at most so much a frame */
    int64_t *speed;  /* px/frame in Q32; whole fx unless the program is fine */
    int64_t *accel;  /* px/frame in Q32, a frame or once */
    uint16_t *count; /* rounds of a loop, MOTION_FOREVER for no end; a tag */
    uint16_t *jump;  /* of a loop, and the step after the bounces; counted from the program's first step */
    uint8_t *depth;  /* of a loop, 0 .. MOTION_DEPTH-1 */
    fx *x, *y;       /* of go_to, with HOW_AT what polar and orbit go round, of DOES_AWAIT a line */
    fx *size;        /* px to each side of a wave, radius of an orbit, how near a target is to come */
    fx *size_to;     /* radius at the end of an orbit, with HOW_TO */
    uint8_t *how;    /* enum ease, and HOW_ */
    uint64_t *named; /* NAMED_BITS for each of enum step_number */
};

struct motions {
    struct slots s;
    uint32_t *first; /* index into steps */
    uint16_t *length;
    uint8_t *fine; /* its bullets keep 32 fraction bits */
};

struct motion_step {
    uint32_t does, over;
    uint16_t kind, count, jump;
    uint8_t bank, depth, how;
    fx x, y, size, size_to;
    ang dir, home;
    int32_t turn;
    int64_t speed, accel;
    uint64_t named;
};

enum emit_pattern { EMIT_ONE, EMIT_RING, EMIT_FAN, EMIT_ARC, EMIT_STACK, EMIT_LINE, EMIT_PATTERNS };

enum {
    EMIT_SHOTS = 1 << 0, /* fires shots */
    EMIT_AIM = 1 << 1,   /* dir counts from the nearest target */
    EMIT_DIR = 1 << 2,   /* dir is given; else it is 0 with EMIT_AIM, and the bullet's own without */
    EMIT_BANK = 1 << 3,  /* bank is given */
    EMIT_VALUES = 1 << 4 /* the first of MAX_VALUES flags: that value is given */
};

/* The numbers of an emit in whose place a value's name may stand. */
enum emit_number {
    EMIT_NUMBER_N,    /* cut to a whole number, at least 0 */
    EMIT_NUMBER_BANK, /* its low 4 bits */
    EMIT_NUMBER_DELAY,
    EMIT_NUMBER_DIR,
    EMIT_NUMBER_SPEED, /* from -MAX_SPEED to MAX_SPEED, as speed_to */
    EMIT_NUMBER_SIZE,
    EMIT_NUMBER_VALUE, /* and the next */
    EMIT_NUMBERS = EMIT_NUMBER_VALUE + MAX_VALUES
};

/* What an emit fires: a pattern's arguments, and those of bullet.fire. Its numbers are those that Lua calculates with,
 * so that what is fired is, to the bit, what the pattern in Lua fires. */
struct motion_emit {
    uint8_t pattern, flags; /* enum emit_pattern; EMIT_ */
    uint8_t bank;
    uint16_t kind, tag, motion; /* motion: program + 1, 0: none */
    uint16_t n;
    int32_t first, last; /* of those that are skipped; the first is 1 */
    uint32_t delay;      /* frames */
    double dir, speed;   /* degrees, px/frame */
    double size;         /* of a fan its spread, of an arc its sweep, of a stack speed_to, of a line its width */
    fx value[MAX_VALUES];
    int64_t around;
    uint64_t named; /* NAMED_BITS for each of enum emit_number */
};

/* What a step that leads a bullet found when it began. */
struct motion_lead {
    fx x, y;   /* where the bullet was; of polar and orbit, what they go round */
    fx radius; /* of polar: how far off it was */
    ang angle; /* of polar and orbit: in which direction; of a wave: where it flew */
    fx speed;  /* of a wave */
};

/*
 * Where step st of s leads to in the k-th of its n frames: the fx nearest to the formula on either axis, unless that is
 * within 2^-30 px of halfway. With a = angle + k turn:
 *   go_to  (x, y) and a share of the way from there to the step's place, as enemies_go eases; with HOW_BY that place
 *          counts from (x, y), and ends at the edge of the world
 *   polar  (x, y) + (radius + k speed) (cos a, sin a)
 *   orbit  (x, y) + r (cos a, sin a), r going from size to size_to in n equal parts
 *   wave   (x, y) + k speed along angle, and size (sin b - sin dir) along angle + 90 degrees, b being dir and
 *          k / count turns, to the nearest ang
 */
void motion_lead_place(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n, fx *x,
                       fx *y);

/* The fx nearest to (x, y) + r (cos a, sin a), r in Q32, |r| <= 2^48: within the world. */
void motion_round(fx x, fx y, int64_t r, ang a, fx *to_x, fx *to_y);

/* from, and k/n of the way to `to`: nearest, ties to an even part; exactly `to` at k == n. What is rounded off in frame
 * k comes back in frame n - k, and ties round to alternate sides, so the sum over n frames is right to half a unit as
 * well: a change of speed ends where the closed form says. */
int64_t motion_part_way(int64_t from, int64_t to, uint32_t k, uint32_t n);

/* A share of a move: part / whole, exactly; part <= whole < 2^62. */
struct motion_share {
    uint64_t part, whole;
};

/* After k of n frames, n < 2^31: k/n (linear), (k/n)^2 (in), 1 - (1 - k/n)^2 (out); both: 2 (k/n)^2 in the first half,
 * then 1 - 2 (1 - k/n)^2. */
struct motion_share motion_eased(enum ease ease, uint64_t k, uint64_t n);

/* a, and a share of the way to b: the place nearest to it, ties to the even one. */
fx motion_between(fx a, fx b, struct motion_share s);

/* Degrees as an angle: the nearest. */
ang motion_angle(fx degrees);

extern const struct chip steps_chip, motions_chip;

/* The program equal to these steps, made if there is none; NO_SLOT when there is no room for it. */
int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine);

/* Step i of the list. */
void motion_step_at(const struct steps *s, uint32_t i, struct motion_step *out);

/* An emit as steps of a program, and the emit that begins with step i of the list. So emits are interned with the
 * programs, and a game without them has no room for any. */
enum { EMIT_ROWS = 2 };
void motion_emit_steps(const struct motion_emit *e, struct motion_step out[EMIT_ROWS]);
void motion_emit_at(const struct steps *s, uint32_t i, struct motion_emit *out);

/* The value that the code for a number in `named` means: its column, or -1: none of the pool's. */
static inline int motion_named(uint64_t named, int number, bool shots, bool *is)
{
    const uint64_t code = named >> number * NAMED_BITS & ((1 << NAMED_BITS) - 1);

    *is = code != 0;
    return (int)(shots ? code / NAMED_SHOTS : code % NAMED_SHOTS) - 1;
}

/* Puts v in the place of that number of the step, within what motion.def takes. */
void motion_set_number(struct motion_step *p, enum step_number number, fx v);

#endif
