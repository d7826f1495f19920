/*
 * bullets.h - bullets and player shots: pools kept as columns. Both are the same chip; a board has one of each.
 *
 * Every live bullet does x += vx, y += vy once a frame; that is all a straight one costs. A bullet with a motion
 * program also runs it (motion.h), which costs nothing while it only waits. Dead slots below top are parked: standing
 * still in the field's corner, so that loops need not test them.
 *
 * A fine bullet (its program says so) has 16 more fraction bits: of its place in x_more, y_more (x and y being the
 * nearest fx), of its speed in speed_q32. Each frame it moves by speed_q32 along dir. vx and vy are that move in whole
 * units of fx, so that the common loop moves it and hits see it as any other.
 */
#ifndef ENTITIES_BULLETS_H
#define ENTITIES_BULLETS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "../base/trig.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    KIND_GRAZE = 1 << 0, /* passing close counts */
    KIND_TURNS = 1 << 1, /* the picture points along dir */

    KIND_SWEPT = 1 << 2, /* hits look at the whole path of a frame, not at its end alone */
    KIND_BLEND = 3 << 3, /* how it is drawn, in units of KIND_BLEND_ONE: 0 opaque, else blend + 1 */
    KIND_BLEND_ONE = 1 << 3,
    KIND_CLOUDED = 1 << 5,  /* it has a ROW_CLOUD */
    KIND_CLOUD = 1 << 6,    /* it is one */
    KIND_FIXED = 1 << 7,    /* a clear passes it over, unless it takes all */
    KIND_CANCELS = 1 << 8,  /* of a shot: it takes clearable bullets away */
    KIND_HARMLESS = 1 << 9, /* it neither hits nor grazes players */

    HP_FOREVER = -1, /* shots hit it and do it no harm */

    BULLET_GRAZED = 1 << 0, /* by player 1; << 1: by player 2 */
    BULLET_FINE = 1 << 2,
    BULLET_DELAYED = 1 << 3, /* still and harmless until the clock is `step_end`; its program begins then */

    /* in the column `step_flags` */
    OVERRIDE_DIR = 1 << 0, /* a script wrote dir (or vx, vy) while this step drives it: the write wins */
    OVERRIDE_SPEED = 1 << 1,
    OVERRIDE_PLACE = 1 << 2, /* the place, while this step leads it */
    STEP_SIGNALLED = 1 << 6, /* what the step at pc waits for has come */
    STEP_BEGUN = 1 << 7,     /* the step at pc has begun */

    /* of a pair of tags: what goes when two bullets meet */
    MEET_FIRST = 1 << 0,
    MEET_SECOND = 1 << 1,
    MEET_ALL = 1 << 2, /* also what is not clearable */
    MAX_MEETS = 16,

    PIERCE_FOREVER = -1,
    PIERCED = 8, /* things that a shot keeps in mind */

    MAX_KINDS = 1024
};

/* What bullet.def and shot.def declare. */
struct bullet_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *shape;
    fx *a, *b, *x, *y; /* of the shape */
    uint16_t *flags;
    uint8_t *bank;
    int32_t *damage;  /* of a shot */
    ang *spin;        /* what the picture turns a frame */
    int8_t *order;    /* higher ones are drawn over lower ones */
    uint16_t *vanish; /* spark kind + 1 that a clear leaves, 0: none */
    int32_t *hp;      /* of a bullet when it is fired; this and what follows: NULL if the game has no hp for bullets */
    int64_t *score;   /* for a player's shot that takes the last of it */
    uint16_t *spark;  /* kind + 1 that it leaves then, 0: none */
    int32_t *pierce;  /* of a shot: hits that do not use it up, or PIERCE_FOREVER; NULL, with the next: not asked for */
    int32_t *every;   /* frames from one hit of a thing to the next, or PIERCE_FOREVER: there is no next */
    uint32_t *live;   /* how many live bullets there are whose column `kind` is this one */
};

struct bullets {
    struct slots s;
    fx *x, *y, *vx, *vy; /* px, px/frame */
    ang *dir;            /* kept at speed 0 */
    fx *speed;
    uint16_t *kind;
    uint8_t *bank;
    uint16_t *tag; /* 0: none */
    uint8_t *flags;
    uint32_t *born;       /* clock of its first move; of a delayed one, at which it was fired */
    uint32_t *owner_task; /* serial of the task that fired it, 0: none */
    uint8_t *player;      /* of a shot: 1 or 2, 0: none */
    uint16_t *motion;     /* program + 1, 0: none */
    uint16_t *pc;         /* the step it is at */
    uint32_t *step_end;   /* clock at which a timed step, or the delay, is over */
    int64_t *step_start;  /* speed_q32 when the step began; of steps that lead or await, the place: x << 32 | y */
    uint8_t *step_flags;  /* of the step at pc: OVERRIDE_, STEP_BEGUN */
    uint16_t *rounds;     /* MOTION_DEPTH a bullet: rounds left of each open loop */
    int64_t *speed_q32;   /* of a fine bullet, `speed` being the nearest fx; of another the clock after its last bounce,
                           * or after the step `bounce` began, 0: there was none */
    int64_t *travel_q32;  /* of a fine bullet: how far it flew since it became one, modulo 2^48, from -2^47 on */
    int16_t *x_more, *y_more;
    fx *value1, *value2, *value3, *value4; /* numbers that the game declares; NULL: not asked for */
    fx *begun1, *begun2, *begun3, *begun4; /* what they were when the step at pc began, if that one names values */
    int64_t *orbit_target;                 /* the thing that orbits go round, 0: none; the board gives it a meaning */
    fx value_start[MAX_VALUES];            /* what the values are in a new bullet */
    int32_t *hp;                           /* 0: shots pass it; HP_FOREVER; NULL: not asked for */
    int32_t *frozen;       /* frames it will stand, or FROZEN_FOREVER; NULL, with the next three: not asked for */
    uint8_t *stands;       /* STANDS, STOOD */
    fx *kept_vx, *kept_vy; /* vx, vy of one that stands, which are 0 meanwhile */

    int32_t *pierce;       /* of a shot: hits left that do not use it up, or PIERCE_FOREVER; NULL, with the next two:
                            * not asked for */
    int64_t *pierced;      /* PIERCED a shot: the things it hit, 0: none */
    uint32_t *rehit_clock; /* the clock at which it can hit each again, UINT32_MAX: never */

    /* Of each block of 64, a bit a slot; near is of the last move. */
    uint64_t *busy;    /* has a program to run this frame, or is fine */
    uint64_t *idle;    /* its program does nothing until the clock is `step_end` */
    uint64_t *near;    /* PADS words: may be near that player; after hit_run, hit or graze that player */
    uint64_t *leaving; /* of s.held: left the field in this frame's move, but may have touched something on its path */
    uint64_t *solid;   /* can be hit by any shot this frame; NULL where hp is */
    uint8_t *due;      /* of an idle bullet: the low byte of `step_end` */

    /* The pairs of tags whose bullets meet; used, and there, where the game asks for it. */
    uint32_t meets;                                         /* how many */
    uint16_t meet_first[MAX_MEETS], meet_second[MAX_MEETS]; /* tags */
    uint16_t meet_spark[MAX_MEETS];                         /* kind + 1 that what goes leaves; 0: its own kind's */
    uint8_t meet_flags[MAX_MEETS];                          /* MEET_ */
    uint32_t *next;                                         /* slot of the next one in its list (hit_meets.c) */
    uint64_t *met;                                          /* a bit a slot: a first of a pair that met in this frame */
    uint64_t *taken;                                        /* a bit a slot: a pair takes it away in this frame */
    fx fastest;                                             /* no |vx| or |vy| is above it */
    uint32_t standing;                                      /* how many stand */
    uint32_t moved;                                         /* bullets moved this frame */
    bool holds_all;    /* the move held all that left the field, near a player or not */
    uint64_t ran;      /* motion steps run this frame, and targets they looked at */
    uint32_t *of_kind; /* the column `live` of their kinds, kept up to date; NULL: of laser heads, which have none */
};

/* The broad phase for one player: a move finds the bullets that end it within `reach` and their own speed of (x, y), on
 * both axes. reach < 0: none. */
struct bullets_query {
    fx x, y;
    int64_t reach;
};

/* What can be aimed at: the things of a pool or list; with `in`, those alone where it is not 0. */
struct targets {
    const struct slots *s;
    const fx *x, *y;
    const uint8_t *in;
};

/* All a motion step may read. */
struct motion_world {
    const struct motions *motions;
    const struct steps *steps;
    const struct bullet_kinds *kinds; /* those that steps name; NULL: a step's kind is passed over, as shots do */
    struct targets targets;
    uint32_t clock;
    bool shots; /* they run the programs: names of values are theirs */
    /* Where an orbit's target is, or where it was in the frame before; false: it is not there. The slots of the pool
     * that moves now have done so below `moved`; what is of that pool is always where it was. */
    bool (*where)(const struct motion_world *w, int64_t around, uint32_t moved, bool before, fx *x, fx *y);
    const void *context; /* of where and emit */
    struct box field;    /* its edges are walls */
    uint64_t most;       /* motion steps that may run in this move; with more it ends where it is */
    /* Queues what the emit that begins with step st fires from bullet i as it is now. */
    void (*emit)(const struct motion_world *w, const struct bullets *b, uint32_t i, uint32_t st);
};

struct bullet_shape {
    fx x, y, speed;
    ang dir;
    uint16_t kind, tag, motion;
    uint8_t bank, player;
    bool fine;      /* the motion is */
    bool clouded;   /* its kind has a cloud, and there is a delay */
    uint32_t delay; /* frames */
    int32_t hp, pierce;
    int64_t around;
    uint32_t by;
};

/* Column k of the values, 0 to MAX_VALUES - 1, or NULL. */
static inline fx *bullets_value(const struct bullets *b, int k)
{
    fx *const value[MAX_VALUES] = { b->value1, b->value2, b->value3, b->value4 };

    return value[k];
}

/* Column k of what the values were when the step began, or NULL. */
static inline fx *bullets_begun(const struct bullets *b, int k)
{
    fx *const begun[MAX_VALUES] = { b->begun1, b->begun2, b->begun3, b->begun4 };

    return begun[k];
}

extern const struct chip bullets_chip, bullet_kinds_chip, shots_chip, shot_kinds_chip, laser_heads_chip;

/* The kind that bullet i was declared to have: not its cloud, which `kind` names while a delay lasts. */
static inline uint16_t bullets_kind(const struct bullets *b, const struct bullet_kinds *kinds, uint32_t i)
{
    return (uint16_t)(b->kind[i] - (kinds->flags[b->kind[i]] & KIND_CLOUD ? ROW_CLOUD : ROW_KIND));
}

/* Frames since the column born says; 0 before that frame. */
static inline uint32_t bullets_stood(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->born[i] == clock + 1 ? 0 : clock - b->born[i];
}

/* Frames since it was fired, or since its delay was over; 0 while that lasts. */
static inline uint32_t bullets_age(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->flags[i] & BULLET_DELAYED ? 0 : bullets_stood(b, i, clock);
}

/* Shot i hits a thing. True: it goes on, and keeps in mind that it hit it; false: it is used up. */
bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t thing, uint32_t clock);

/* Puts a bullet in the lowest free slot; NO_SLOT when the pool is full. */
int32_t bullets_fire(struct bullets *b, const struct bullet_shape *shape, uint32_t clock);

/* Removes a live bullet. */
void bullets_drop(struct bullets *b, uint32_t i);

/* A live bullet is live no more, but held. */
void bullets_hold(struct bullets *b, uint32_t i);

/* Removes a held bullet; all of them. */
void bullets_release(struct bullets *b, uint32_t i);
void bullets_release_all(struct bullets *b);

/* Runs the motion programs in slot order, moves every bullet, and sets `near`: of every live bullet that the query asks
 * for, and some others. query NULL: of none. Those that end outside keep are dropped, but held (slots.h) if they are
 * `near` or with hold_all; the caller releases them in the same frame. */
void bullets_move(struct bullets *b, const struct motion_world *w, const struct box *keep,
                  const struct bullets_query query[PADS], bool hold_all);

/* The same one by one, and nothing leaves: bullets_begin once, then bullets_go_on of each that is live. False: its
 * program has removed it. */
void bullets_begin(struct bullets *b);
bool bullets_go_on(struct bullets *b, const struct motion_world *w, uint32_t i);

/* Sets `solid`. False: no bullet is. */
bool bullets_find_solid(struct bullets *b);

/* Those of a block, live or held, that ended the last move within reach and their own speed of (x, y), on both axes;
 * and maybe some others. */
uint64_t bullets_near(const struct bullets *b, uint32_t block, fx x, fx y, int64_t reach);

/* Recomputes vx, vy from dir and speed. */
void bullets_steer(struct bullets *b, uint32_t i);

/* Sets vx, vy alone. */
void bullets_set_flight(struct bullets *b, uint32_t i, fx vx, fx vy);

/* Gives live bullet i another kind; its cloud, if it is delayed and that kind has one. */
void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind);
/* Bullet i stands in the next `frames` moves (FROZEN_FOREVER: in all, 0: in none of them) and then goes on as it was.
 * Of a chip with GROUP_FROZEN. */
void bullets_freeze(struct bullets *b, uint32_t i, int32_t frames);

/* At the end of a frame in which the clock goes on: what stood in it grows no older. */
void bullets_stay(struct bullets *b);

/* Gives bullet i a program (motion: index + 1, 0: none) from its first step; `fine` is what the program says. */
void bullets_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine);

/* The group of that tag (0: any) is signalled: bullet i goes on if it has that tag's signal to wait for. */
void bullets_signal(struct bullets *b, const struct motion_world *w, uint32_t i, uint16_t tag);

/*
 * Speed, velocity and place as scripts read and write them: in Q32, of which ordinary bullets use whole fx. Setting the
 * velocity sets dir and speed, but at speed 0 dir stays.
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

/* The direction from (x, y) to the nearest target; `none` when there is no target or it is right there. */
ang targets_aim(const struct targets *t, fx x, fx y, ang none);

/* The nearest target's slot, or NO_SLOT. The lower slot wins a tie. */
int32_t targets_nearest(const struct targets *t, fx x, fx y);

#endif
