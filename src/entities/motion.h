/*
 * motion.h - the limits of the world, and motion programs: steps stored as data, run in C, and shared by all bullets
 * with the same program.
 * A program is a run of entries in the `steps` list. The actions of one step happen together, in the order of the DOES_
 * bits, and last `over` frames (0: at once). After the last step the bullet flies straight on.
 */
#ifndef ENTITIES_MOTION_H
#define ENTITIES_MOTION_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    PARK = -(16384 << 16), /* x and y of dead slots: one pixel past the edge of the world (bullets: see bullets.h) */
    WORLD = 16383,         /* positions reach from -WORLD to WORLD px */
    MAX_SPEED = 8191,      /* px/frame; also the limit of radii, in px */
    PACE_BITS = 16         /* fraction bits that Q32 has more than fx */
};

/* The hit shape of a kind. */
enum {
    SHAPE_NONE,
    SHAPE_CIRCLE,      /* a: radius */
    SHAPE_BOX,         /* a, b: half width and half height */
    SHAPE_CAPSULE = 4, /* all points within a of a line: from (x, y) to (-x, -y), or, for bullets, along dir and b to
                        * either side */
    SHAPE_CIRCLES = 8, /* a circle of radius a at (x, y), and b more in the kind's ROW_CIRCLES */
    SHAPE_PLAIN = 3,   /* any | of shapes without a capsule or circles is at most this */
    SHAPE_PARTS = 4    /* most circles of a shape */
};

/* The columns of kinds that describe the hitbox. */
struct shape_columns {
    uint8_t *shape;
    fx *a, *b, *x, *y;
};

/* The rows that one kind takes, as offsets from the row that its name refers to. */
enum kind_row {
    ROW_CLOUD = -1, /* bullets: the looks of a delayed bullet; no name, no shape */
    ROW_KIND = 0,
    ROW_CIRCLES = 1 /* the first of up to three more circles of the shape; only shape, a, b, x and y are used */
};

/* Groups of columns (slots.h) that a manifest enables for bullets, shots and enemies. */
enum {
    GROUP_VALUE = 1, /* the first of MAX_VALUES groups: a number declared by the game */
    MAX_VALUES = 4,
    GROUP_HP = GROUP_VALUE + MAX_VALUES,
    GROUP_AROUND,
    GROUP_FROZEN,
    GROUP_MEET,
    GROUP_ITEMS,  /* players: attraction of items */
    GROUP_BODIES, /* enemies: parts, rates, orbits */
    GROUP_PIERCE  /* shots: piercing */
};

/* Frozen entities: `frozen` is the frames left, or FROZEN_FOREVER, and `stands` has these flags. */
enum {
    FROZEN_FOREVER = -1,
    STANDS = 1 << 0, /* from the freeze to the first move that finds no frames left */
    STOOD = 1 << 1   /* frozen in the last move: the entity's tasks don't run before the next */
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
    DOES_LOOP = 1 << 10,  /* opens a loop of `count` rounds; `jump`: the step after the loop */
    DOES_NEXT = 1 << 11,  /* closes a loop; `jump`: its first step */
    DOES_NAMED = 1 << 12, /* takes some numbers from values of the bullet: `named` */
    DOES_GO_TO =
        1 << 13, /* this and the next three lead the bullet: motion_lead_place computes its position in each frame */
    DOES_POLAR = 1 << 14,
    DOES_WAVE = 1 << 15,
    DOES_ORBIT = 1 << 16,
    DOES_LEAD = DOES_GO_TO | DOES_POLAR | DOES_WAVE | DOES_ORBIT,
    DOES_BOUNCE = 1 << 17, /* with DOES_LOOP: opens a loop of bounces; alone: flies to the next bounce */
    DOES_EMIT = 1 << 18,   /* fires bullets; takes EMIT_ROWS steps (motion_emit_at) */
    DOES_AWAIT = 1 << 19,  /* flies on until the condition in `how` holds, for at most `over` frames */
    DOES_ALL = (1 << 20) - 1,
    MOTION_DEPTH = 4, /* most nested loops */
    MOTION_FOREVER = 0xffff,
    MOTION_STEPS = 16 /* steps of RAM reserved per program */
};

enum ease { EASE_LINEAR, EASE_IN, EASE_OUT, EASE_BOTH };

/* Bits of `how`. */
enum {
    HOW_EASE = 3,       /* enum ease */
    HOW_AT = 1 << 2,    /* centre (x, y); without: polar's is where the bullet was, orbit's its `orbit_target` */
    HOW_TO = 1 << 3,    /* an orbit's radius changes to size_to */
    HOW_SPEED = 1 << 4, /* go_to flies at `speed`, for as many frames as needed */
    HOW_BY = 1 << 5,    /* go_to: (x, y) is relative to the bullet's position when the step began */
    HOW_LEFT = 1 << 0,  /* DOES_BOUNCE: the edges of the field that are walls */
    HOW_RIGHT = 1 << 1,
    HOW_TOP = 1 << 2,
    HOW_BOTTOM = 1 << 3,
    HOW_WALLS = 15,
    HOW_X = 1 << 0, /* DOES_AWAIT: the bullet is at x, or beyond it as seen from where the step began */
    HOW_Y = 1 << 1,
    HOW_NEAR = 1 << 2,  /* the nearest target is closer than size */
    HOW_SIGNAL = 1 << 3 /* the group of the tag `count` was signalled (bullets_signal) */
};

/* The numbers of a step that a named value can replace. `named` has NAMED_BITS for each: the value's column + 1 for
 * bullets, plus NAMED_SHOTS times the column + 1 for shots; 0: the step's own number is used. */
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
    NUMBER_SIZE,    /* from 0 to MAX_SPEED; of a wave from -MAX_SPEED */
    NUMBER_SIZE_TO, /* from 0 to MAX_SPEED */
    NUMBER_COUNT,   /* period of a wave: cut to whole frames, at least 1 */
    STEP_NUMBERS,
    NAMED_BITS = 5,
    NAMED_SHOTS = MAX_VALUES + 1
};
_Static_assert(STEP_NUMBERS *NAMED_BITS <= 64, "a step's `named` has no room for another number");

/* The steps of all programs, one program after the other. */
struct steps {
    struct slots s;
    uint32_t *does;
    uint32_t *over; /* frames */
    uint16_t *kind;
    uint8_t *bank;
    ang *dir;
    int32_t *turn;   /* ang a frame, or once if over is 0 */
    ang *home;       /* most ang a frame */
    int64_t *speed;  /* px/frame in Q32; a whole number of fx unless the program is fine */
    int64_t *accel;  /* px/frame in Q32, added in each frame, or once if over is 0 */
    uint16_t *count; /* rounds of a loop, MOTION_FOREVER: endless; frames of a wave's period; a signal's tag */
    uint16_t *jump;  /* of a loop, or the step after a loop of bounces; relative to the program's first step */
    uint8_t *depth;  /* of a loop, 0 to MOTION_DEPTH - 1 */
    fx *x, *y;       /* goal of go_to; centre of polar and orbit, with HOW_AT; line of DOES_AWAIT */
    fx *size;        /* px to each side of a wave; radius of an orbit; distance of a target for HOW_NEAR */
    fx *size_to;     /* radius at the orbit's end, with HOW_TO */
    uint8_t *how;    /* enum ease and HOW_ bits */
    uint64_t *named; /* NAMED_BITS for each of enum step_number */
};

struct motions {
    struct slots s;
    uint32_t *first; /* index into steps */
    uint16_t *length;
    uint8_t *fine; /* whether its bullets have 32 fraction bits */
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
    EMIT_AIM = 1 << 1,   /* dir is relative to the direction of the nearest target */
    EMIT_DIR = 1 << 2,   /* dir is given; otherwise it is 0 with EMIT_AIM, and the bullet's own without */
    EMIT_BANK = 1 << 3,  /* bank is given */
    EMIT_VALUES = 1 << 4 /* the first of MAX_VALUES flags: value k is given */
};

/* The numbers of an emit that a named value can replace. */
enum emit_number {
    EMIT_NUMBER_N,    /* cut to a whole number, at least 0 */
    EMIT_NUMBER_BANK, /* its low 4 bits */
    EMIT_NUMBER_DELAY,
    EMIT_NUMBER_DIR,
    EMIT_NUMBER_SPEED, /* from -MAX_SPEED to MAX_SPEED; the same for speed_to */
    EMIT_NUMBER_SIZE,
    EMIT_NUMBER_VALUE, /* the first of MAX_VALUES */
    EMIT_NUMBERS = EMIT_NUMBER_VALUE + MAX_VALUES
};

/* The arguments of an emit: those of a pattern, and of bullet.fire. Numbers that Lua calculates with are doubles, so an
 * emit fires exactly, to the bit, what the pattern in Lua fires. */
struct motion_emit {
    uint8_t pattern, flags; /* enum emit_pattern; EMIT_ */
    uint8_t bank;
    uint16_t kind, tag, motion; /* motion: program + 1, 0: none */
    uint16_t n;
    int32_t first, last; /* the range of skipped bullets, counted from 1 */
    uint32_t delay;      /* frames */
    double dir, speed;   /* degrees, px/frame */
    double size;         /* spread of a fan, sweep of an arc, speed_to of a stack, width of a line */
    fx value[MAX_VALUES];
    int64_t around;
    uint64_t named; /* NAMED_BITS for each of enum emit_number */
};

/* The state that a leading step saves when it begins. */
struct motion_lead {
    fx x, y;   /* the bullet's position; polar and orbit: the centre */
    fx radius; /* polar: the distance from the centre */
    ang angle; /* polar and orbit: the direction from the centre; wave: the direction of flight */
    fx speed;  /* wave: the speed of flight */
};

/* Computes the position to which step st of s leads in the k-th of its n frames: on either axis the fx nearest to the
 * formula, unless its value is within 2^-30 px of halfway between two. With a = angle + k turn:
 *   go_to  (x, y) and an eased share of the way from there to the step's goal, as enemies_go; with HOW_BY the goal is
 *          relative to (x, y), and clamped to the world
 *   polar  (x, y) + (radius + k speed) (cos a, sin a)
 *   orbit  (x, y) + r (cos a, sin a), r changing from size to size_to in n equal parts
 *   wave   (x, y) + k speed along angle, and size (sin b - sin dir) along angle + 90 degrees, b being dir and
 *          k / count turns, to the nearest ang
 */
void motion_lead_place(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n, fx *x,
                       fx *y);

/* Computes the fx nearest to (x, y) + r (cos a, sin a), clamped to the world; r in Q32, |r| <= 2^48. */
void motion_round(fx x, fx y, int64_t r, ang a, fx *to_x, fx *to_y);

/* Returns `from` plus k/n of the way to `to`, rounded to nearest, ties to an even distance; exactly `to` at k == n. The
 * rounding errors of frames k and n - k cancel, and ties round to alternate sides, so the sum over n frames is also
 * right to half a unit: a change of speed ends where the closed form does. */
int64_t motion_part_way(int64_t from, int64_t to, uint32_t k, uint32_t n);

/* A share of a move: part / whole, exactly; part <= whole < 2^62. */
struct motion_share {
    uint64_t part, whole;
};

/* Returns the share of a move done after k of n frames, n < 2^31: k/n (linear), (k/n)^2 (in), 1 - (1 - k/n)^2 (out);
 * both: 2 (k/n)^2 in the first half, then 1 - 2 (1 - k/n)^2. */
struct motion_share motion_eased(enum ease ease, uint64_t k, uint64_t n);

/* Returns a plus a share of the way to b, rounded to the nearest fx, ties to even. */
fx motion_between(fx a, fx b, struct motion_share s);

/* Converts degrees to the nearest angle. */
ang motion_angle(fx degrees);

extern const struct chip steps_chip, motions_chip;

/* Returns the index of the program equal to these n steps, adding it if there is none, or NO_SLOT if the lists are
 * full. */
int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine);

/* Copies step i of the list to *out. */
void motion_step_at(const struct steps *s, uint32_t i, struct motion_step *out);

/* Convert an emit to steps of a program, and back from the steps at i of the list. Stored as steps, emits are interned
 * with their programs and need no memory of their own. */
enum { EMIT_ROWS = 2 };
void motion_emit_steps(const struct motion_emit *e, struct motion_step out[EMIT_ROWS]);
void motion_emit_at(const struct steps *s, uint32_t i, struct motion_emit *out);

/* Returns the column of the value that `named` has for a number, or -1 if it has none for this pool. Sets *is to
 * whether the number is named for either pool. */
static inline int motion_named(uint64_t named, int number, bool shots, bool *is)
{
    const uint64_t code = named >> number * NAMED_BITS & ((1 << NAMED_BITS) - 1);

    *is = code != 0;
    return (int)(shots ? code / NAMED_SHOTS : code % NAMED_SHOTS) - 1;
}

/* Sets that number of the step to v, clamped to the range that motion.def accepts. */
void motion_set_number(struct motion_step *p, enum step_number number, fx v);

#endif
