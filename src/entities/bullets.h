/*
 * bullets.h - bullets and player shots: pools stored as columns. Both are the same chip; a board has one of each.
 * Every live bullet does x += vx, y += vy once a frame; a bullet flying straight costs nothing more. A bullet with a
 * motion program (motion.h) also runs it; a program that only waits costs nothing. Dead slots below top are parked at
 * rest at (0, 0), inside the field, so loops need not test them.
 * A fine bullet runs a program marked fine and has 16 more fraction bits: x_more and y_more extend its position (x and
 * y are the nearest fx), and speed_q32 is its exact speed. Each frame it moves by speed_q32 along dir. vx and vy are
 * that move in whole units of fx, so the common loop moves fine bullets and hit tests treat them like all others.
 */
#ifndef ENTITIES_BULLETS_H
#define ENTITIES_BULLETS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "../base/trig.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    KIND_GRAZE = 1 << 0, /* can be grazed */
    KIND_TURNS = 1 << 1, /* the sprite is rotated to dir */

    KIND_SWEPT = 1 << 2, /* uses swept collision: hits test the whole path of a frame */
    KIND_BLEND = 3 << 3, /* in units of KIND_BLEND_ONE: 0: drawn opaque, otherwise blend mode + 1 */
    KIND_BLEND_ONE = 1 << 3,
    KIND_CLOUDED = 1 << 5,  /* the kind has a ROW_CLOUD */
    KIND_CLOUD = 1 << 6,    /* this row is a ROW_CLOUD */
    KIND_FIXED = 1 << 7,    /* immune to clears, unless `all` */
    KIND_CANCELS = 1 << 8,  /* shots only: removes the clearable bullets it touches */
    KIND_HARMLESS = 1 << 9, /* neither hits players nor can be grazed */

    HP_FOREVER = -1, /* absorbs shots without losing hp */

    BULLET_GRAZED = 1 << 0, /* grazed by player 1; << 1: by player 2 */
    BULLET_FINE = 1 << 2,
    BULLET_DELAYED = 1 << 3, /* motionless and harmless until the clock reaches `step_end`, then starts its program */

    /* flags of the column `step_flags` */
    OVERRIDE_DIR = 1 << 0,   /* a script wrote dir (or vx, vy) during this step: the step no longer changes dir */
    OVERRIDE_SPEED = 1 << 1, /* the same for speed */
    OVERRIDE_PLACE = 1 << 2, /* the same for the position, during a step that leads the bullet */
    STEP_SIGNALLED = 1 << 6, /* the signal that the step at pc waits for has arrived */
    STEP_BEGUN = 1 << 7,     /* the step at pc has begun */

    /* flags of a pair of tags: which bullet despawns when two meet */
    MEET_FIRST = 1 << 0,
    MEET_SECOND = 1 << 1,
    MEET_ALL = 1 << 2, /* even bullets that are KIND_FIXED */
    MAX_MEETS = 16,

    PIERCE_FOREVER = -1,
    PIERCED = 8, /* most targets a piercing shot remembers having hit */

    MAX_KINDS = 1024
};

/* The kinds declared by bullet.def or shot.def. */
struct bullet_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *shape;
    fx *a, *b, *x, *y; /* parameters of `shape` (motion.h) */
    uint16_t *flags;
    uint8_t *bank;
    int32_t *damage;  /* shots only */
    ang *spin;        /* rotation of the sprite a frame */
    int8_t *order;    /* drawing order: higher over lower */
    uint16_t *vanish; /* kind + 1 of the spark left by a clear, 0: none */
    int32_t *hp;      /* hp of a newly fired bullet; hp, score, spark: NULL if the game has no hp for bullets */
    int64_t *score;   /* awarded for the player's shot that takes the last hp */
    uint16_t *spark;  /* kind + 1 of the spark left when hp runs out, 0: none */
    int32_t *pierce;  /* shots only: hits that don't use the shot up, or PIERCE_FOREVER; pierce, every: NULL if the game
                       * doesn't enable them */
    int32_t *every;   /* frames between two hits of the same target, or PIERCE_FOREVER: each target is hit once */
    uint32_t *live;   /* number of live bullets whose column `kind` is this row */
};

struct bullets {
    struct slots s;
    fx *x, *y, *vx, *vy; /* px, px/frame */
    ang *dir;            /* keeps its value at speed 0 */
    fx *speed;
    uint16_t *kind;
    uint8_t *bank;
    uint16_t *tag; /* 0: none */
    uint8_t *flags;
    uint32_t *born;       /* clock of its first move; while delayed: clock at which it was fired */
    uint32_t *owner_task; /* serial of the task that fired the bullet, 0: none */
    uint8_t *player;      /* shots only: player 1 or 2, 0: none */
    uint16_t *motion;     /* program + 1, 0: none */
    uint16_t *pc;         /* current step, relative to the program's first */
    uint32_t *step_end;   /* clock at which the timed step, or the delay, ends */
    int64_t *step_start;  /* Q32 speed when the step began; of steps that lead or await: x << 32 | y, the bullet's
                           * position then or the centre */
    uint8_t *step_flags;  /* of the step at pc: OVERRIDE_, STEP_ */
    uint16_t *rounds;     /* MOTION_DEPTH values a bullet: rounds left in each open loop */
    int64_t *speed_q32;   /* fine bullets: exact speed, `speed` is the nearest fx; others: 1 + the clock at which the
                           * program's latest `bounce` began, 0: none */
    int64_t *travel_q32;  /* fine bullets: distance flown since becoming fine, modulo 2^48, from -2^47 to 2^47 - 1;
                           * others: state of steps that lead or bounce, 0: none */
    int16_t *x_more, *y_more;              /* fine bullets: what the exact position adds to x, y, in Q32 */
    fx *value1, *value2, *value3, *value4; /* numbers declared by the game; NULL: not declared */
    fx *begun1, *begun2, *begun3, *begun4; /* the values when the step at pc began, if that step names values */
    int64_t *orbit_target;                 /* the board's handle of the orbit centre, 0: none; NULL: not enabled */
    fx value_start[MAX_VALUES];            /* initial values of a new bullet */
    int32_t *hp;                           /* 0: shots pass through; HP_FOREVER; NULL: not enabled */
    int32_t *frozen;       /* frames left frozen, or FROZEN_FOREVER; this and the next three: NULL if not enabled */
    uint8_t *stands;       /* STANDS, STOOD */
    fx *kept_vx, *kept_vy; /* the saved vx, vy of a frozen bullet, whose vx, vy are 0 */

    int32_t *pierce;       /* shots only: hits left that don't use the shot up, or PIERCE_FOREVER; this and the next
                            * two: NULL if not enabled */
    int64_t *pierced;      /* PIERCED values a shot: handles of the targets hit, 0: none */
    uint32_t *rehit_clock; /* the clock at which each of these can be hit again, UINT32_MAX: never */

    /* Bit sets: a word per block of 64, a bit per slot. near is from the last move. */
    uint64_t *busy;    /* runs its program in the next move, or is fine */
    uint64_t *idle;    /* delayed, or its program waits, until the clock is `step_end` */
    uint64_t *near;    /* PADS words, one per player: may be near the player; after hit_run: hit or graze the player */
    uint64_t *leaving; /* storage of s.held: left the field in this move, but may have touched something on the way */
    uint64_t *solid;   /* can be hit by any shot this frame; NULL if hp is */
    uint8_t *due;      /* idle bullets: the low byte of `step_end` */

    /* The pairs of tags whose bullets collide; next, met and taken are NULL if the game doesn't enable them. */
    uint32_t meets;                                         /* number of pairs */
    uint16_t meet_first[MAX_MEETS], meet_second[MAX_MEETS]; /* tags */
    uint16_t meet_spark[MAX_MEETS];                         /* kind + 1 of the spark left; 0: the bullet kind's own */
    uint8_t meet_flags[MAX_MEETS];                          /* MEET_ */
    uint32_t *next;                                         /* slot of the next bullet in its list (hit_meets.c) */
    uint64_t *met;                                          /* bit set: the first of a pair that met this frame */
    uint64_t *taken;                                        /* bit set: bullets that a pair removes this frame */
    fx fastest;                                             /* upper bound of all |vx| and |vy| */
    uint32_t standing;                                      /* number of bullets whose `stands` is not 0 */
    uint32_t moved;                                         /* bullets moved this frame */
    bool holds_all;    /* the last move held every bullet that left the field, near a player or not */
    uint64_t ran;      /* work of this frame: motion steps run, and the cost of searching for targets, in steps */
    uint32_t *of_kind; /* the kinds' column `live`, updated as bullets spawn and despawn; NULL: laser heads, which are
                        * not counted */
};

/* The broad phase for one player: a move finds the bullets that end it within `reach` plus their own speed of (x, y),
 * on both axes. reach < 0: finds none. */
struct bullets_query {
    fx x, y;
    int64_t reach;
};

/* The entities that can be aimed at: all of a pool or list, or, if `in` is not NULL, those whose `in` is not 0. */
struct targets {
    const struct slots *s;
    const fx *x, *y;
    const uint8_t *in;
};

/* Everything a motion step may read. */
struct motion_world {
    const struct motions *motions;
    const struct steps *steps;
    const struct bullet_kinds *kinds; /* the kinds that steps name; NULL: steps leave the kind unchanged (shots) */
    struct targets targets;
    uint32_t clock;
    bool shots; /* the programs run on shots: named values are columns of shots */
    /* Finds the position of an orbit's target; `before`: its position in the previous frame. Returns false if the
     * target is gone. In the pool that is moving, slots below `moved` have already moved; a target in that pool is
     * always found at its position before the move. */
    bool (*where)(const struct motion_world *w, int64_t around, uint32_t moved, bool before, fx *x, fx *y);
    const void *context; /* for where and emit */
    struct box field;    /* its edges are the walls of `bounce` */
    uint64_t most;       /* limit of `ran` in this move; a move that exceeds it stops where it is */
    /* Queues the bullets that the emit starting at step st fires from bullet i in its present state. */
    void (*emit)(const struct motion_world *w, const struct bullets *b, uint32_t i, uint32_t st);
};

struct bullet_shape {
    fx x, y, speed;
    ang dir;
    uint16_t kind, tag, motion;
    uint8_t bank, player;
    bool fine;      /* whether the motion is fine */
    bool clouded;   /* the kind has a cloud, and delay is not 0 */
    uint32_t delay; /* frames */
    int32_t hp, pierce;
    int64_t around;
    uint32_t by;
};

/* Returns column k of the values, 0 <= k < MAX_VALUES, or NULL if it is not declared. */
static inline fx *bullets_value(const struct bullets *b, int k)
{
    fx *const value[MAX_VALUES] = { b->value1, b->value2, b->value3, b->value4 };

    return value[k];
}

/* Returns column k of the values when the step began, or NULL if value k is not declared. */
static inline fx *bullets_begun(const struct bullets *b, int k)
{
    fx *const begun[MAX_VALUES] = { b->begun1, b->begun2, b->begun3, b->begun4 };

    return begun[k];
}

extern const struct chip bullets_chip, bullet_kinds_chip, shots_chip, shot_kinds_chip, laser_heads_chip;

/* Returns bullet i's kind, even during a delay, when the column `kind` may be that kind's ROW_CLOUD. */
static inline uint16_t bullets_kind(const struct bullets *b, const struct bullet_kinds *kinds, uint32_t i)
{
    return (uint16_t)(b->kind[i] - (kinds->flags[b->kind[i]] & KIND_CLOUD ? ROW_CLOUD : ROW_KIND));
}

/* Returns the frames since `born`; 0 before that frame. */
static inline uint32_t bullets_stood(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->born[i] == clock + 1 ? 0 : clock - b->born[i];
}

/* Returns the frames since bullet i was fired or since its delay ended; 0 during the delay. */
static inline uint32_t bullets_age(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->flags[i] & BULLET_DELAYED ? 0 : bullets_stood(b, i, clock);
}

/* Records that shot i hit the entity with handle `thing`. Returns whether the shot pierces it; false: the shot is used
 * up, and nothing was recorded. */
bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t thing, uint32_t clock);

/* Fires a bullet. Returns its slot, the lowest free one, or NO_SLOT if the pool is full. */
int32_t bullets_fire(struct bullets *b, const struct bullet_shape *shape, uint32_t clock);

/* Removes a live bullet. */
void bullets_drop(struct bullets *b, uint32_t i);

/* Takes bullet i from live to held (slots.h). */
void bullets_hold(struct bullets *b, uint32_t i);

/* Removes one held bullet, or all held bullets. */
void bullets_release(struct bullets *b, uint32_t i);
void bullets_release_all(struct bullets *b);

/* Runs the motion programs in slot order, moves every bullet, and sets `near` for every live bullet that the query asks
 * for, and maybe some others. query NULL: for none. A bullet that ends outside keep is dropped, or held (slots.h) if it
 * is `near` or hold_all is set; the caller releases held bullets in the same frame. */
void bullets_move(struct bullets *b, const struct motion_world *w, const struct box *keep,
                  const struct bullets_query query[PADS], bool hold_all);

/* Moves bullets one by one, without dropping those outside: call bullets_begin once a frame, then bullets_go_on for
 * each live bullet. bullets_go_on returns false if bullet i's program has removed it. */
void bullets_begin(struct bullets *b);
bool bullets_go_on(struct bullets *b, const struct motion_world *w, uint32_t i);

/* Sets `solid`. Returns whether any bullet is solid. */
bool bullets_find_solid(struct bullets *b);

/* Returns the bullets of a block, live or held, as bits, that ended the last move within reach plus their own speed of
 * (x, y) on both axes, and maybe some others. */
uint64_t bullets_near(const struct bullets *b, uint32_t block, fx x, fx y, int64_t reach);

/* Recomputes vx, vy from dir and speed, unless bullet i is fine or delayed. */
void bullets_steer(struct bullets *b, uint32_t i);

/* Sets vx, vy without changing dir and speed. */
void bullets_set_flight(struct bullets *b, uint32_t i, fx vx, fx vy);

/* Changes live bullet i's kind, with the kind's bank and hp. A delayed bullet shows the kind's cloud, if it has one. */
void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind);
/* Freezes bullet i for the next `frames` moves (FROZEN_FOREVER: for all, 0: for none), after which it continues as
 * before. Requires GROUP_FROZEN. */
void bullets_freeze(struct bullets *b, uint32_t i, int32_t frames);

/* Stops frozen bullets from ageing: call at the end of a frame in which the clock advances. */
void bullets_stay(struct bullets *b);

/* Starts a program (motion: index + 1, 0: none) on bullet i at its first step; `fine` is the program's flag. */
void bullets_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine);

/* Signals bullet i: if its current step waits for a signal of `tag` (0: of any tag), the program continues. */
void bullets_signal(struct bullets *b, const struct motion_world *w, uint32_t i, uint16_t tag);

/* Speed, velocity and position as scripts read and write them: in Q32; only fine bullets use the bits below a whole fx.
 * Setting the velocity sets dir and speed; a velocity of 0 keeps dir.
 */
static inline int64_t bullets_speed(const struct bullets *b, uint32_t i)
{
    return b->flags[i] & BULLET_FINE ? b->speed_q32[i] : (int64_t)b->speed[i] * (1 << PACE_BITS);
}
void bullets_velocity(const struct bullets *b, uint32_t i, int64_t *vx, int64_t *vy);
static inline void bullets_place(const struct bullets *b, uint32_t i, int64_t *x, int64_t *y)
{
    *x = (int64_t)b->x[i] * (1 << PACE_BITS) + b->x_more[i];
    *y = (int64_t)b->y[i] * (1 << PACE_BITS) + b->y_more[i];
}
void bullets_set_speed(struct bullets *b, uint32_t i, int64_t speed);
void bullets_set_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy);
void bullets_set_place(struct bullets *b, uint32_t i, int64_t x, int64_t y);

/* Returns the direction from (x, y) to the nearest target; `none` if there is no target or it is at (x, y). */
ang targets_aim(const struct targets *t, fx x, fx y, ang none);

/* Returns the slot of the target nearest to (x, y), or NO_SLOT if there is none. The lower slot wins a tie. */
int32_t targets_nearest(const struct targets *t, fx x, fx y);

#endif
