/*
 * motion.h - the limits of the world, and motion programs: steps stored as data, run in C, and shared by all bullets
 * with the same program. A program is a range of consecutive entries in the `steps` list. All actions of one step run
 * together, in the order of the DOES_ bits, for `duration` frames (0: at once, without taking a frame). After the last
 * step the bullet flies straight on.
 */
#ifndef ENTITIES_MOTION_H
#define ENTITIES_MOTION_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    PARK_COORDINATE =
        -(16384 << 16), /* x and y of dead slots: one pixel past the edge of the world (bullets: see bullets.h) */
    WORLD_EDGE = 16383, /* positions are from -WORLD_EDGE to WORLD_EDGE px */
    MAX_SPEED = 8191,   /* px/frame; also the limit of radii, in px */
    Q32_EXTRA_BITS = 16 /* number of fraction bits that Q32 has in addition to those of fx */
};

/* Clamps a coordinate, in fx, to the world. */
static inline fx motion_clamp_to_world(int64_t v)
{
    const int64_t edge = (int64_t)WORLD_EDGE << 16;

    return (fx)int64_clamp(v, -edge, edge);
}

/* Returns a coordinate moved by `delta`, clamped to the world. */
static inline fx motion_shift(fx coordinate, fx delta)
{
    return motion_clamp_to_world((int64_t)coordinate + delta);
}

/* The hit shape of a kind. */
enum {
    SHAPE_NONE,
    SHAPE_CIRCLE,         /* a: radius */
    SHAPE_BOX,            /* a, b: half width and half height */
    SHAPE_CAPSULE = 4,    /* all points at most a from a line: from (x, y) to (-x, -y); for bullets: along dir, from -b
                        * to b */
    SHAPE_CIRCLES = 8,    /* a circle of radius a at (x, y), and b more circles in the rows from ROW_CIRCLES on */
    SHAPE_SCALED = 16,    /* enemies: a flag of any shape but SHAPE_NONE: each enemy's `scale` applies to its lengths */
    SHAPE_MAX_SIMPLE = 3, /* shapes without a capsule or circles, ORed together, are at most this */
    SHAPE_MAX_CIRCLES = 4 /* most circles of a shape */
};

/* The columns of kinds that describe the hitbox. */
struct shape_columns {
    uint8_t *shape;
    fx *a, *b, *x, *y;
};

/* The rows of one kind, as offsets from the row that the kind's name refers to. */
enum kind_row {
    ROW_CLOUD = -1, /* bullets: how a delayed bullet is drawn; this row has no name and no shape */
    ROW_KIND = 0,
    ROW_CIRCLES = 1 /* first of up to three rows for the shape's other circles; only shape, a, b, x, y are used */
};

/* Groups of columns (slots.h) that a manifest enables. */
enum {
    GROUP_VALUE = 1, /* first of MAX_VALUES groups, one per number declared by the game */
    MAX_VALUES = 4,
    GROUP_HP = GROUP_VALUE + MAX_VALUES,
    GROUP_ORBIT,
    GROUP_FROZEN,
    GROUP_MEET,
    GROUP_ITEMS,     /* players: attraction of items */
    GROUP_BODIES,    /* enemies: parts, rates, orbits */
    GROUP_PIERCE,    /* shots: piercing */
    GROUP_TRANSFORMS /* pictures that turn, are scaled or are translucent */
};

/* How a picture is drawn (GROUP_TRANSFORMS): scale and alpha are in eighths. */
enum { SCALE_ONE = 8, SCALE_MIN = 2, SCALE_MAX = 32, ALPHA_OPAQUE = 8 };

/* Returns a length of a hit shape times scale / SCALE_ONE, rounded to the nearest fx, ties to even. */
static inline fx motion_scale_length(fx length, int32_t scale)
{
    return fx_mul(length, scale * (FX_ONE / SCALE_ONE));
}

/* The columns of frozen entities: `frozen_left`, frames left or FROZEN_FOREVER; `freeze_flags`, with these flags. */
enum {
    FROZEN_FOREVER = -1,
    FREEZE_ACTIVE = 1 << 0,   /* set by the freeze, cleared by the first move that finds no frames left */
    FREEZE_LAST_MOVE = 1 << 1 /* frozen in the last move: the entity's tasks don't run before the next move */
};

/* Counts down entity i's frozen frames at the start of its move. frozen_left, freeze_flags: columns; NULL if the game
 * freezes nothing. Returns whether the entity is frozen in this move, and adds it to *frozen_count. */
static inline bool motion_step_freeze(int32_t *frozen_left, uint8_t *freeze_flags, uint32_t i, uint32_t *frozen_count)
{
    if (!frozen_left)
        return false;
    const bool is_frozen = frozen_left[i] != 0;
    frozen_left[i] -= frozen_left[i] > 0;
    freeze_flags[i] = is_frozen ? FREEZE_LAST_MOVE : 0;
    *frozen_count += is_frozen;
    return is_frozen;
}

/* A rectangle of field positions, including its edges. */
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
    DOES_LOOP = 1 << 10,       /* opens a loop of `count` rounds; `jump`: the step after the loop */
    DOES_LOOP_END = 1 << 11,   /* closes a loop; `jump`: the loop's first step */
    DOES_USE_VALUES = 1 << 12, /* takes some of its numbers from the bullet's values, as `named_values` specifies */
    DOES_GO_TO = 1 << 13,      /* this and the next four lead the bullet along positions from motion_lead_position */
    DOES_POLAR = 1 << 14,
    DOES_WAVE = 1 << 15,
    DOES_ORBIT = 1 << 16,
    DOES_ACCEL_XY = 1 << 20, /* accelerates by (speed, accel); on an axis with MODE_TO_: to that velocity */
    DOES_LEAD = DOES_GO_TO | DOES_POLAR | DOES_WAVE | DOES_ORBIT | DOES_ACCEL_XY,
    DOES_BOUNCE = 1 << 17,  /* with DOES_LOOP: opens a loop of bounces; alone: flies to the next bounce */
    DOES_EMIT = 1 << 18,    /* fires bullets; takes EMIT_STEPS steps (motion_unpack_emit) */
    DOES_AWAIT = 1 << 19,   /* waits in flight until the condition in `mode` holds, for at most `duration` frames */
    DOES_TURN_TO = 1 << 21, /* turns by `turn` in the first frame, by `dir` in the last, in equal steps between them */
    DOES_ALL = (1 << 22) - 1,
    MOTION_MAX_DEPTH = 4, /* limit of nested loops */
    MOTION_FOREVER = 0xffff,
    MOTION_STEPS_PER_PROGRAM = 16 /* RAM reserved per program, in steps */
};

enum ease { EASE_LINEAR, EASE_IN, EASE_OUT, EASE_BOTH };

/* Bits of `mode`, whose meaning depends on the step's action. */
enum {
    MODE_EASE = 3, /* enum ease */
    MODE_HAS_CENTRE =
        1 << 2, /* the centre is (x, y); if unset: polar: the bullet's position; orbit: its `orbit_target` */
    MODE_HAS_SIZE_TO = 1 << 3, /* orbit: the radius changes to size_to */
    MODE_SPEED = 1 << 4,       /* go_to: flies at `speed`, for as many frames as needed */
    MODE_RELATIVE = 1 << 5,    /* go_to: (x, y) is relative to the bullet's position when the step began */
    MODE_HAS_LIMIT = 1 << 0,   /* DOES_ACCEL_XY: accelerates up to `size` on x and `size_to` on y */
    MODE_TO_VX = 1 << 6,       /* DOES_ACCEL_XY: `speed` is the velocity to reach on x, not the acceleration */
    MODE_TO_VY = 1 << 7,       /* likewise `accel` on y */
    MODE_LEFT = 1 << 0,        /* DOES_BOUNCE: the edges of the field that are walls */
    MODE_RIGHT = 1 << 1,
    MODE_TOP = 1 << 2,
    MODE_BOTTOM = 1 << 3,
    MODE_WALLS = 15,
    MODE_X = 1 << 0, /* DOES_AWAIT: the bullet has reached or passed x since the step began */
    MODE_Y = 1 << 1,
    MODE_TARGET_NEAR = 1 << 2, /* DOES_AWAIT: the nearest target is closer than size */
    MODE_SIGNAL = 1 << 3       /* DOES_AWAIT: a signal for the tag `count` has arrived (bullets_signal) */
};

/* The numbers of a step that a named value can replace. `named_values` has NAMED_VALUE_BITS bits per number, which
 * store b + NAMED_SHOT_STRIDE * s. b is 1 + the value's column for bullets, s is 1 + the value's column for shots; 0:
 * no value. If all bits are 0, the step's own number is used. */
enum step_number {
    NUMBER_DURATION, /* truncated to whole frames, at least 1 */
    NUMBER_BANK,     /* the low 4 bits of the whole number */
    NUMBER_DIR,
    NUMBER_TURN,
    NUMBER_HOME, /* clamped to 0 to 180 degrees */
    NUMBER_SPEED,
    NUMBER_ACCEL,
    NUMBER_X,
    NUMBER_Y,
    NUMBER_SIZE,    /* clamped to 0 to MAX_SPEED; for a wave to -MAX_SPEED to MAX_SPEED */
    NUMBER_SIZE_TO, /* clamped to 0 to MAX_SPEED */
    NUMBER_COUNT,   /* period of a wave, truncated to whole frames, at least 1 */
    STEP_NUMBER_COUNT,
    NAMED_VALUE_BITS = 5,
    NAMED_SHOT_STRIDE = MAX_VALUES + 1
};
_Static_assert(STEP_NUMBER_COUNT *NAMED_VALUE_BITS <= 64, "a step's `named` has no room for another number");

/* What a step has, in the order of the columns: the type, the name. */
#define STEP_FIELDS(FIELD)                                                                                             \
    FIELD(uint32_t, actions)      /* DOES_ */                                                                          \
    FIELD(uint32_t, duration)     /* frames */                                                                         \
    FIELD(uint16_t, kind)         /* of bullets */                                                                     \
    FIELD(uint8_t, bank)          /* of colours */                                                                     \
    FIELD(ang, dir)               /* the direction to take; DOES_TURN_TO */                                            \
    FIELD(int32_t, turn)          /* ang per frame; applied once if duration is 0 */                                   \
    FIELD(ang, home)              /* limit of the turn, ang per frame */                                               \
    FIELD(int64_t, speed)         /* px/frame in Q32; a whole number of fx unless the program is fine */               \
    FIELD(int64_t, accel)         /* px/frame in Q32, added in each frame, or only once if duration is 0 */            \
    FIELD(uint16_t, count)        /* rounds of a loop, or MOTION_FOREVER; a wave's period; a signal's tag */           \
    FIELD(uint16_t, jump)         /* target of a jump: see DOES_LOOP and DOES_LOOP_END; for DOES_BOUNCE the step */    \
                                  /* after the loop; relative to the program's first step */                           \
    FIELD(uint8_t, depth)         /* nesting depth of a loop, 0 to MOTION_MAX_DEPTH - 1 */                             \
    FIELD(fx, x)                  /* x, y: goal of go_to; centre of polar and orbit with MODE_HAS_CENTRE; the x or */  \
    FIELD(fx, y)                  /* y awaited by DOES_AWAIT */                                                        \
    FIELD(fx, size)               /* px: amplitude of a wave; radius of an orbit; distance for MODE_TARGET_NEAR; */    \
                                  /* px/frame: with MODE_HAS_LIMIT */                                                  \
    FIELD(fx, size_to)            /* px: radius at the end of an orbit with MODE_HAS_SIZE_TO; px/frame: see size */    \
    FIELD(uint8_t, mode)          /* enum ease and MODE_ bits */                                                       \
    FIELD(uint64_t, named_values) /* NAMED_VALUE_BITS bits for each enum step_number */

#define STEP_MEMBER(type, name) type name;
#define STEP_COLUMN(type, name) type *name;

struct motion_step {
    STEP_FIELDS(STEP_MEMBER)
};

/* The steps of all programs, one program after the other. */
struct steps {
    struct slots s;
    STEP_FIELDS(STEP_COLUMN)
};

struct motions {
    struct slots s;
    uint32_t *first; /* index into steps */
    uint16_t *length;
    uint8_t *is_fine; /* whether bullets that run the program have 32 fraction bits */
};

enum emit_pattern { EMIT_ONE, EMIT_RING, EMIT_FAN, EMIT_ARC, EMIT_STACK, EMIT_LINE, EMIT_PATTERNS };

enum {
    EMIT_SHOTS = 1 << 0, /* fires shots */
    EMIT_AIM = 1 << 1,   /* dir is relative to the direction to the nearest target */
    EMIT_DIR = 1 << 2,   /* dir is given; if not, dir is 0 with EMIT_AIM and the emitting bullet's dir without */
    EMIT_BANK = 1 << 3,  /* bank is given */
    EMIT_VALUE = 1 << 4  /* first of MAX_VALUES flags; EMIT_VALUE << k: value k is given */
};

/* The numbers of an emit that a named value can replace. */
enum emit_number {
    EMIT_NUMBER_N,    /* truncated to a whole number, at least 0 */
    EMIT_NUMBER_BANK, /* the low 4 bits of the whole number */
    EMIT_NUMBER_DELAY,
    EMIT_NUMBER_DIR,
    EMIT_NUMBER_SPEED, /* clamped to -MAX_SPEED to MAX_SPEED, as is the EMIT_NUMBER_SIZE of a stack */
    EMIT_NUMBER_SIZE,
    EMIT_NUMBER_VALUE, /* first of MAX_VALUES numbers */
    EMIT_NUMBER_COUNT = EMIT_NUMBER_VALUE + MAX_VALUES
};

/* The arguments of an emit: the pattern's and bullet.fire's. Numbers that the Lua patterns calculate with are doubles
 * here too, so an emit fires the same bullets as the Lua pattern, bit for bit. */
struct motion_emit {
    uint8_t pattern, flags; /* enum emit_pattern; EMIT_ */
    uint8_t bank;
    uint16_t kind, tag, motion; /* motion: program + 1, 0: none */
    uint16_t n;
    int32_t first, skip_last; /* range of bullets to skip, counted from 1 */
    uint32_t delay;           /* frames */
    double dir, speed;        /* degrees, px/frame */
    double size;              /* spread of a fan, sweep of an arc, speed_to of a stack, width of a line */
    fx value[MAX_VALUES];
    int64_t orbit_target;
    uint64_t named_values; /* NAMED_VALUE_BITS bits for each enum emit_number */
};

/* The state saved at the start of a step that leads a bullet. */
struct motion_lead {
    fx x, y; /* the bullet's position; polar and orbit: the centre instead */
    union {
        fx radius; /* polar: the distance from the centre */
        fx vx;     /* acceleration: the velocity */
    };
    union {
        ang angle; /* polar and orbit: the direction from the centre; wave: the direction of flight */
        fx vy;
    };
    fx speed; /* wave: the speed of flight */
};

/* Computes the position to which step st of s leads a bullet in the k-th of n frames. On either axis the result is the
 * fx nearest to the formula's value, unless that value is within 2^-30 px of halfway between two fx. In the formulas
 * (x, y), radius, angle and speed are from *l, except polar's speed, which is from the step; a = angle + k turn.
 *   go_to  (x, y) plus an eased share of the way to the step's goal (motion_ease); with MODE_RELATIVE the goal is
 *          relative to (x, y) and clamped to the world
 *   polar  (x, y) + (radius + k speed) (cos a, sin a)
 *   orbit  (x, y) + r (cos a, sin a), where r changes from size to size_to in n equal parts
 *   wave   (x, y), plus k speed along angle, plus size (sin b - sin dir) along angle + 90 degrees, where b is dir plus
 *          k / count turns, rounded to the nearest ang
 *   accel  (x, y) plus the sum of the velocities of frames 1 to k; also computes velocity as motion_accelerate does
 */
void motion_lead_position(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n,
                          fx *x, fx *y, int64_t velocity[2]);

/* Computes, for the k-th of n frames of a step with DOES_ACCEL_XY, the velocity on each axis, and the distance flown
 * since the step began: the sum of the velocities of frames 1 to k. In Q32; distances are clamped, far outside the
 * world. In frame k, the velocity on an axis is v + k a, where a is the step's acceleration, and with MODE_HAS_LIMIT at
 * most the limit in the direction of a, or v if that is more; with MODE_TO_VX or _VY it is v plus k/n of the way to the
 * step's velocity. */
void motion_accelerate(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n,
                       int64_t velocity[2], int64_t distance[2]);

/* Computes the fx nearest to (x, y) + r (cos a, sin a), clamped to the world; r in Q32, |r| <= 2^48. */
void motion_offset_polar(fx x, fx y, int64_t r, ang a, fx *to_x, fx *to_y);

/* Returns `from` plus k/n of the way to `to`, rounded to nearest, ties to an even distance; exactly `to` if k == n. The
 * rounding errors of frames k and n - k cancel, and ties round up and down alternately, so the sum over n frames is
 * right to half a unit too: a bullet whose speed changes ends at the position that the closed form gives. */
int64_t motion_lerp(int64_t from, int64_t to, uint32_t k, uint32_t n);

/* A share of a move, exactly part / whole; part <= whole < 2^62. */
struct motion_share {
    uint64_t part, whole;
};

/* Returns the share of a move that is done after k of n frames, n < 2^31.
 *   EASE_LINEAR  k/n
 *   EASE_IN      (k/n)^2
 *   EASE_OUT     1 - (1 - k/n)^2
 *   EASE_BOTH    2 (k/n)^2 in the first half, then 1 - 2 (1 - k/n)^2
 */
struct motion_share motion_ease(enum ease ease, uint64_t k, uint64_t n);

/* Returns a plus share s of the way to b, rounded to the nearest fx, ties to even. */
fx motion_lerp_share(fx a, fx b, struct motion_share s);

/* Converts degrees to the nearest angle. */
ang motion_angle_from_degrees(fx degrees);

extern const struct chip steps_chip, motions_chip;

/* Returns the index of the program with exactly these n steps and this `fine`, and adds the program if it is new.
 * Returns NO_SLOT if `m` or `s` is full. */
int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine);

/* Copies step i of the list to *out. */
void motion_get_step(const struct steps *s, uint32_t i, struct motion_step *out);

/* Convert an emit to EMIT_STEPS steps of a program, and back from the steps of s that start at i. Stored as steps,
 * emits are shared like the rest of their programs and need no separate memory. Their doubles are stored as bits. */
enum { EMIT_STEPS = 2 };
void motion_pack_emit(const struct motion_emit *e, struct motion_step out[EMIT_STEPS]);
void motion_unpack_emit(const struct steps *s, uint32_t i, struct motion_emit *out);

/* Returns the column of the value that replaces a number according to `named_values`, or -1 if no value does in this
 * pool (shots, otherwise bullets). Sets *is_named to whether a value replaces the number in either pool. */
static inline int motion_value_column(uint64_t named_values, int number, bool is_shots, bool *is_named)
{
    const uint64_t code = named_values >> number * NAMED_VALUE_BITS & ((1 << NAMED_VALUE_BITS) - 1);

    *is_named = code != 0;
    return (int)(is_shots ? code / NAMED_SHOT_STRIDE : code % NAMED_SHOT_STRIDE) - 1;
}

/* Sets the given number of the step to v, clamped to the range that motion.def accepts. */
void motion_set_number(struct motion_step *p, enum step_number number, fx v);

#endif
