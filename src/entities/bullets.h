/*
 * bullets.h - bullets and player shots: pools stored as columns. A board has one pool of each, with the same columns.
 * Every live bullet does x += vx, y += vy once a frame; a bullet flying straight costs nothing more. If a bullet has a
 * motion program (motion.h), the program runs too; a program that only waits costs nothing. Dead slots below top are
 * parked at (0, 0), inside the field, with velocity 0, so loops need not test for dead slots.
 * A fine bullet runs a program marked fine and has 16 more fraction bits: x_low and y_low extend its position (x and
 * y are the nearest fx), and speed_q32 is its exact speed. Each frame the bullet moves by speed_q32 along dir. Its vx
 * and vy are that move in whole units of fx, so the common loop and the hit tests treat fine bullets like all others.
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

    KIND_SWEPT = 1 << 2, /* uses swept collision: hit tests cover the whole path of a frame */
    KIND_BLEND = 3 << 3, /* blend mode + 1, or 0: drawn opaque; in units of KIND_BLEND_ONE */
    KIND_BLEND_ONE = 1 << 3,
    KIND_HAS_CLOUD = 1 << 5,    /* the kind has a ROW_CLOUD */
    KIND_IS_CLOUD_ROW = 1 << 6, /* this row is a ROW_CLOUD */
    KIND_FIXED = 1 << 7,        /* immune to clears, unless `all` */
    KIND_CANCELS = 1 << 8,      /* shots only: the shot removes clearable bullets that it touches */
    KIND_HARMLESS = 1 << 9,     /* neither hits players nor can be grazed */

    HP_FOREVER = -1, /* absorbs shots without losing hp */

    BULLET_GRAZED = 1 << 0, /* grazed by player 1; BULLET_GRAZED << 1: by player 2 */
    BULLET_FINE = 1 << 2,
    BULLET_DELAYED = 1 << 3, /* motionless and harmless until the clock reaches `step_end`, then starts its program */

    /* flags of the column `step_flags` */
    OVERRIDE_DIR = 1 << 0,   /* a script wrote dir (or vx, vy) during this step: the step no longer changes dir */
    OVERRIDE_SPEED = 1 << 1, /* a script wrote speed (or vx, vy) during this step: the step no longer changes speed */
    OVERRIDE_POSITION = 1 << 2, /* a script wrote the position during this step: the step no longer leads the bullet */
    STEP_SIGNALLED = 1 << 6,    /* the signal that the step at pc waits for has arrived */
    STEP_BEGUN = 1 << 7,        /* the step at pc has begun */

    /* flags of a pair of tags: which bullets despawn when two with these tags collide */
    MEET_FIRST = 1 << 0,
    MEET_SECOND = 1 << 1,
    MEET_ALL = 1 << 2, /* KIND_FIXED bullets too */
    MAX_MEET_PAIRS = 16,

    PIERCE_FOREVER = -1,
    MAX_PIERCED_TARGETS = 8, /* most targets that a piercing shot remembers as hit */

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
    int32_t *damage;        /* shots only */
    ang *spin;              /* rotation of the sprite, ang per frame */
    int8_t *draw_order;     /* drawing order: higher values are drawn over lower ones */
    uint16_t *vanish_spark; /* kind + 1 of the spark left by a clear, 0: none */
    int32_t *hp;            /* hp of a new bullet; hp, score and spark are NULL if the game has no hp for bullets */
    int64_t *score;         /* awarded when a player's shot takes the last hp */
    uint16_t *spark;        /* kind + 1 of the spark left when hp runs out, 0: none */
    /* Shots only, NULL if the game doesn't enable piercing: hits that don't use the shot up, and frames between two
     * hits on the same target. PIERCE_FOREVER: no limit, and each target is hit only once. */
    int32_t *pierce_hits, *rehit_interval;
    uint8_t *scale;       /* of the picture, SCALE_MIN to SCALE_MAX; the shape is already scaled; NULL: not enabled */
    uint32_t *live_count; /* number of live bullets whose column `kind` is this row */
};

struct bullets {
    struct slots s;
    fx *x, *y, *vx, *vy; /* px, px/frame */
    ang *dir;            /* unchanged when the speed becomes 0 */
    fx *speed;
    uint16_t *kind;
    uint8_t *bank;
    uint16_t *tag; /* 0: none */
    uint8_t *flags;
    uint32_t *born;         /* clock of the bullet's first move; while delayed: clock when it was fired */
    uint32_t *owner_task;   /* serial of the task that fired the bullet, 0: none */
    uint8_t *player;        /* shots only: player 1 or 2, 0: none */
    uint16_t *motion;       /* program + 1, 0: none */
    uint16_t *pc;           /* current step, relative to the program's first */
    uint32_t *step_end;     /* clock at which the timed step, or the delay, ends */
    int64_t *step_start;    /* Q32 speed when the step began; for a step that leads or awaits, x << 32 | y instead: the
                           * bullet's position when the step began, or the centre of its path */
    uint8_t *step_flags;    /* OVERRIDE_ and STEP_ flags of the step at pc */
    uint16_t *rounds_left;  /* MOTION_MAX_DEPTH values per bullet: rounds left in each open loop */
    int64_t *speed_q32;     /* fine bullets: exact speed (`speed` is the nearest fx); others: 1 + the clock when the
                           * program's latest `bounce` began, 0: none */
    int64_t *travel_q32;    /* fine bullets: distance flown since becoming fine, modulo 2^48, from -2^47 to 2^47 - 1;
                           * others: state of a step that leads or bounces, 0: none */
    int16_t *x_low, *y_low; /* fine bullets: exact position minus x, y, in Q32 */
    fx *value1, *value2, *value3, *value4; /* numbers declared by the game; NULL: not declared */
    fx *step_value1, *step_value2, *step_value3,
        *step_value4;             /* the values when the step at pc began; valid if it is DOES_USE_VALUES */
    int64_t *orbit_target;        /* the board's handle of the orbit centre, 0: none; NULL: not enabled */
    fx initial_value[MAX_VALUES]; /* initial values of a new bullet */
    int32_t *hp;                  /* or HP_FOREVER; 0: shots pass through; NULL: not enabled */
    int32_t *frozen_left;    /* frames left frozen, or FROZEN_FOREVER; this and the next three: NULL if not enabled */
    uint8_t *freeze_flags;   /* FREEZE_ACTIVE and FREEZE_LAST_MOVE flags */
    fx *saved_vx, *saved_vy; /* velocity saved while the bullet is frozen and its vx, vy are 0 */

    /* Shots only, NULL if not enabled. pierce_left: hits left that don't use the shot up, or PIERCE_FOREVER;
     * pierced_targets, MAX_PIERCED_TARGETS per shot: handles of the targets hit, 0: none; rehit_clock, as many: clock
     * when each can be hit again, UINT32_MAX: never. */
    int32_t *pierce_left;
    int64_t *pierced_targets;
    uint32_t *rehit_clock;

    /* Bit sets: one word per block of 64 slots, one bit per slot. The last move set `near_player`. */
    uint64_t *busy; /* runs its program in the next move, or is fine */
    uint64_t *idle; /* delayed, or its program waits, until the clock reaches `step_end` */
    /* MAX_PLAYERS words per block, one per player: may touch or graze the player; after hit_run: hit or graze it. */
    uint64_t *near_player;
    uint64_t *leaving; /* storage of s.held: left the field in this move, but may have touched an entity on the way */
    uint64_t *solid;   /* can be hit by shots this frame; NULL if `hp` is NULL */
    uint8_t *step_end_low; /* idle bullets: the low byte of `step_end` */

    /* The pairs of tags whose bullets collide; next, met and meet_removed are NULL if the game doesn't enable them. */
    uint32_t n_meet_pairs;                                            /* number of pairs */
    uint16_t meet_first[MAX_MEET_PAIRS], meet_second[MAX_MEET_PAIRS]; /* tags */
    uint16_t meet_spark[MAX_MEET_PAIRS]; /* kind + 1 of the spark left; 0: the bullet kind's spark */
    uint8_t meet_flags[MAX_MEET_PAIRS];  /* MEET_ flags */
    uint32_t *meet_next;                 /* next slot in the same list (hit_meets.c) */
    uint64_t *meet_collided;             /* bit set: collided this frame as first of a pair */
    uint64_t *meet_removed;              /* bit set: bullets that a pair removes this frame */
    fx speed_bound;                      /* upper bound of all |vx| and |vy| */
    uint32_t n_frozen;                   /* number of bullets whose `freeze_flags` is not 0 */
    uint32_t n_moved;                    /* bullets moved this frame */
    bool holds_all;     /* whether the last move held every bullet that left the field, near a player or not */
    uint64_t work_done; /* work of this frame, in motion steps: the steps run, and the cost of searching for targets */
    uint32_t *kind_counts; /* the kinds' column `live_count`, updated as bullets spawn and despawn; NULL: laser heads,
                            * which are not counted */
};

/* A broad-phase query for one player. A move finds each bullet that ends the move at most `reach` plus the bullet's own
 * speed away from (x, y), on both axes. reach < 0: finds none. */
struct bullets_query {
    fx x, y;
    int64_t reach;
};

/* The entities that can be aimed at: all entities of a pool or list. If `included` is not NULL, entities whose
 * `included` is 0 are left out. */
struct targets {
    const struct slots *s;
    const fx *x, *y;
    const uint8_t *included;
};

/* Everything a motion step may read. */
struct motion_world {
    const struct motions *motions;
    const struct steps *steps;
    const struct bullet_kinds *kinds; /* the kinds that steps change to; NULL: steps leave the kind unchanged (shots) */
    struct targets targets;
    uint32_t clock;
    bool is_shots; /* the programs run on shots: named values are columns of shots */
    /* Sets (*x, *y) to the position of the orbit target `orbit_target` in this frame or, if `previous_frame`, in the
     * previous frame. Returns false if the target has despawned. Slots below `moved` of the pool that is moving have
     * already moved; a target in that pool is always found at its position before the move. */
    bool (*get_position)(const struct motion_world *w, int64_t orbit_target, uint32_t moved, bool previous_frame, fx *x,
                         fx *y);
    const void *context; /* for get_position and emit */
    struct box field;    /* the edges are the walls of `bounce` */
    uint64_t work_limit; /* limit of `work_done` in this move; a move that exceeds it stops unfinished */
    /* Queues the bullets that the emit starting at step st fires from bullet i in its present state. */
    void (*emit)(const struct motion_world *w, const struct bullets *b, uint32_t i, uint32_t st);
};

struct bullet_spec {
    fx x, y, speed;
    ang dir;
    uint16_t kind, tag, motion;
    uint8_t bank, player;
    bool is_fine;    /* the motion runs with 32 fraction bits (BULLET_FINE) */
    bool is_clouded; /* the kind has a cloud, and delay is not 0 */
    uint32_t delay;  /* frames */
    int32_t hp, pierce_hits;
    int64_t orbit_target;
    uint32_t owner_task;
};

/* Returns the column that stores value k, 0 <= k < MAX_VALUES, or NULL if value k is not declared. */
static inline fx *bullets_value_column(const struct bullets *b, int k)
{
    fx *const value[MAX_VALUES] = { b->value1, b->value2, b->value3, b->value4 };

    return value[k];
}

/* Returns the column that stores value k as it was when the step began, or NULL if value k is not declared. */
static inline fx *bullets_step_value_column(const struct bullets *b, int k)
{
    fx *const value[MAX_VALUES] = { b->step_value1, b->step_value2, b->step_value3, b->step_value4 };

    return value[k];
}

extern const struct chip bullets_chip, bullet_kinds_chip, shots_chip, shot_kinds_chip, laser_heads_chip;

/* Returns bullet i's kind. During a delay the column `kind` may be the kind's ROW_CLOUD instead. */
static inline uint16_t bullets_kind(const struct bullets *b, const struct bullet_kinds *kinds, uint32_t i)
{
    return (uint16_t)(b->kind[i] - (kinds->flags[b->kind[i]] & KIND_IS_CLOUD_ROW ? ROW_CLOUD : ROW_KIND));
}

/* Returns the frames since `born`, or 0 if `born` is the next frame. */
static inline uint32_t bullets_frames_since_born(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->born[i] == clock + 1 ? 0 : clock - b->born[i];
}

/* Returns the frames since bullet i was fired or since its delay ended; 0 during the delay. */
static inline uint32_t bullets_age(const struct bullets *b, uint32_t i, uint32_t clock)
{
    return b->flags[i] & BULLET_DELAYED ? 0 : bullets_frames_since_born(b, i, clock);
}

/* Records that shot i hit the entity with handle `entity`. Returns whether the shot pierces the entity. If it does not,
 * the shot is used up and nothing is recorded. */
bool bullets_pierce(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, int64_t entity, uint32_t clock);

/* Fires a bullet. Returns its slot, the lowest free one, or NO_SLOT if the pool is full. */
int32_t bullets_fire(struct bullets *b, const struct bullet_spec *spec, uint32_t clock);

/* Removes a live bullet. */
void bullets_drop(struct bullets *b, uint32_t i);

/* Makes live bullet i a held one (slots.h). */
void bullets_hold(struct bullets *b, uint32_t i);

/* Removes one held bullet, or all held bullets. */
void bullets_release(struct bullets *b, uint32_t i);
void bullets_release_all(struct bullets *b);

/* Runs the motion programs in slot order, moves every bullet, and sets the `near_player` bits of all live bullets that
 * each query must find, and maybe of some others. With query NULL, no bullet is `near_player`. A bullet that ends
 * outside *keep_box is dropped, or held (slots.h) if one of its `near_player` bits or hold_all is set; the caller must
 * release held bullets in the same frame. */
void bullets_move(struct bullets *b, const struct motion_world *w, const struct box *keep_box,
                  const struct bullets_query query[MAX_PLAYERS], bool hold_all);

/* Move bullets one by one, without dropping bullets outside the field: call bullets_begin_move once a frame, then
 * bullets_move_one for each live bullet. bullets_move_one returns false if bullet i's program has removed the
 * bullet. */
void bullets_begin_move(struct bullets *b);
bool bullets_move_one(struct bullets *b, const struct motion_world *w, uint32_t i);

/* Sets `solid`. Returns whether any bullet is solid. */
bool bullets_update_solid(struct bullets *b);

/* Returns, as bits, the live or held bullets of a block that ended the last move at most `reach` plus their own speed
 * away from (x, y), on both axes, and maybe some others. */
uint64_t bullets_find_near(const struct bullets *b, uint32_t block, fx x, fx y, int64_t reach);

/* Recomputes vx, vy from dir and speed, unless bullet i is fine or delayed. */
void bullets_update_velocity(struct bullets *b, uint32_t i);

/* Sets vx, vy without changing dir and speed. */
void bullets_set_velocity_only(struct bullets *b, uint32_t i, fx vx, fx vy);

/* Changes live bullet i's kind, and sets its bank and hp to the kind's. A delayed bullet shows the kind's cloud, if the
 * kind has one. */
void bullets_set_kind(struct bullets *b, const struct bullet_kinds *kinds, uint32_t i, uint16_t kind);
/* Freezes bullet i for the next `frames` moves; FROZEN_FOREVER: for all moves; 0: ends a freeze at the next move. The
 * bullet then continues as before the freeze. Requires GROUP_FROZEN. */
void bullets_freeze(struct bullets *b, uint32_t i, int32_t frames);

/* Keeps frozen bullets from ageing. Call it at the end of each frame in which the clock advances. */
void bullets_postpone_frozen(struct bullets *b);

/* Starts a program (motion: index + 1, 0: none) on bullet i at the program's first step; `fine` is the program's column
 * `fine`. */
void bullets_start_program(struct bullets *b, uint32_t i, uint16_t motion, bool fine);

/* Signals bullet i. If the current step of its program waits for a signal of `tag` (0: of any tag), the wait ends. */
void bullets_signal(struct bullets *b, const struct motion_world *w, uint32_t i, uint16_t tag);

/* Speed, velocity and position as scripts read and write them, in Q32. Only fine bullets use the bits below a whole fx.
 * Setting the velocity also sets dir and speed; a velocity of 0 leaves dir unchanged.
 */
static inline int64_t bullets_speed(const struct bullets *b, uint32_t i)
{
    return b->flags[i] & BULLET_FINE ? b->speed_q32[i] : (int64_t)b->speed[i] * (1 << Q32_EXTRA_BITS);
}
void bullets_get_velocity(const struct bullets *b, uint32_t i, int64_t *vx, int64_t *vy);
static inline void bullets_get_position(const struct bullets *b, uint32_t i, int64_t *x, int64_t *y)
{
    *x = (int64_t)b->x[i] * (1 << Q32_EXTRA_BITS) + b->x_low[i];
    *y = (int64_t)b->y[i] * (1 << Q32_EXTRA_BITS) + b->y_low[i];
}
void bullets_set_speed(struct bullets *b, uint32_t i, int64_t speed);
void bullets_set_velocity(struct bullets *b, uint32_t i, int64_t vx, int64_t vy);
void bullets_set_position(struct bullets *b, uint32_t i, int64_t x, int64_t y);

/* Returns the direction from (x, y) to the nearest target, or `fallback` if there is no target or it is at (x, y). */
ang targets_aim(const struct targets *t, fx x, fx y, ang fallback);

/* Returns the slot of the target nearest to (x, y), or NO_SLOT if there is none. The lower slot wins a tie. */
int32_t targets_find_nearest(const struct targets *t, fx x, fx y);

#endif
