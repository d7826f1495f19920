/*
 * enemies.h - enemies and bosses: one pool, in which each enemy has at most one move in progress.
 */
#ifndef ENTITIES_ENEMIES_H
#define ENTITIES_ENEMIES_H

#include "../base/fx.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    ENEMY_TOUCH = 1 << 0, /* kinds: the enemy kills a player who touches it */
    ENEMY_SWEPT = 1 << 1, /* kinds: uses swept collision against players: hit tests cover the whole path of a frame */
    ENEMY_BLEND = 3 << 2, /* kinds: blend mode + 1, or 0: drawn opaque; in units of ENEMY_BLEND_ONE */
    ENEMY_BLEND_ONE = 1 << 2,
    ENEMY_BLOCKS_BULLETS = 1 << 4, /* kinds: the enemy removes bullets that touch it */
    ENEMY_HURT_PICTURE = 1 << 5,   /* kinds: picture 1 replaces picture 0 while the enemy blinks */
    ENEMY_RIM_BLINK = 1 << 6,      /* kinds: only a rim around the sprite blinks white */
    ENEMY_TURNS = 1 << 7,          /* kinds: `dir` follows the enemy's moves */

    /* kinds, in the row of picture 1: pictures 2 and 3 replace picture 0 while the enemy moves left or right */
    ENEMY_SIDES = 1 << 0,

    ENEMY_UNDYING = 1 << 0, /* enemies: waits at hp 0 instead of dying (a boss between phases) */
    ENEMY_DYING = 1 << 1,   /* enemies: died; despawns after its handlers have run */
    ENEMY_LEAVING = 1 << 2, /* enemies: left the keep box in this move; can still be hit; despawns like ENEMY_DYING */
    ENEMY_FLIP = 1 << 3,    /* enemies: drawn mirrored left to right */
    ENEMY_HIDDEN = 1 << 4,  /* enemies: not drawn */
    ENEMY_PICTURE = 7 << 5, /* enemies: number n of the picture shown, in units of ENEMY_PICTURE_ONE: the sprite in
                             * the nth row before the kind's row */
    ENEMY_PICTURE_ONE = 1 << 5,
    ENEMY_MAX_PICTURES = 7,
    ENEMY_NOT_ALIVE = ENEMY_DYING | ENEMY_LEAVING, /* with either flag the enemy is not alive for scripts */

    ENEMY_BANK = 15,       /* in the column `bank`: number of palette banks to add */
    ENEMY_BLINK = 15 << 4, /* in the column `bank`, in units of ENEMY_BLINK_ONE; kinds: frames of blinking when hurt;
                            * enemies: frames of blinking left */
    ENEMY_BLINK_ONE = 1 << 4,

    SAFE_FOREVER = -1,

    LEAD_ORBIT = 1,  /* in the column `lead_mode`: the enemy orbits; 0: the enemy neither orbits nor wanders */
    LEAD_WANDER = 2, /* in the column `lead_mode`: the enemy wanders */

    MAX_PART_DEPTH = 8,         /* limit of the depth of nested parts (enemies_part_depth) */
    ENEMY_RATE_ONE = 1 << 16,   /* the value 1 in rates and shares */
    ENEMY_MAX_RATE = 100 << 16, /* limit of `rate` */

    MAX_ENEMIES = 4096
};

/* The kinds declared by enemy.def, whose functions and drops are stored with the scripts. */
struct enemy_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *shape;
    fx *a, *b, *x, *y; /* parameters of `shape` (motion.h); every further circle has its own row */
    int32_t *hp;
    int64_t *score;
    uint8_t *bank; /* ENEMY_BANK and ENEMY_BLINK */
    uint8_t *flags;
    uint16_t *spark;        /* kind + 1, 0: none */
    int32_t *rate;          /* factor of the damage taken, ENEMY_RATE_ONE: 1; NULL: not enabled */
    uint8_t *scale, *alpha; /* initial `scale` and `alpha`; NULL: not enabled */
};

struct enemies {
    struct slots s;
    fx *x, *y;
    fx *prev_x, *prev_y; /* position before this frame's move; after a jump (more than MAX_SPEED): present position */
    int32_t *hp;
    uint16_t *kind;
    uint8_t *bank; /* ENEMY_BANK and ENEMY_BLINK */
    uint16_t *tag;
    int32_t *safe_left; /* frames left in which the enemy takes no damage, or SAFE_FOREVER */
    uint32_t *born;     /* clock when the enemy was spawned */
    uint32_t *owner_task;
    int64_t *owner; /* the enemy despawns when this owner ends, 0: none; the board defines the value */
    uint8_t *flags;
    fx *x0, *y0, *x1, *y1;                  /* start and end of the move in progress */
    uint32_t *move_elapsed, *move_duration; /* the move's frames done, and its total frames; duration 0: no move */
    uint32_t *move_serial; /* number of the latest movement that a script started, counted over all enemies */
    uint32_t move_count;   /* number of movements started so far; like the serials below RETIRED_GENERATION */
    uint8_t *ease;
    fx *value1, *value2, *value3, *value4; /* numbers declared by the game; NULL: not declared */
    fx initial_value[MAX_VALUES];          /* initial values of a new enemy */
    int32_t *frozen_left;  /* frames left frozen, or FROZEN_FOREVER; this and `freeze_flags`: NULL if not enabled */
    uint8_t *freeze_flags; /* FREEZE_LAST_MOVE: frozen in the last move */
    uint32_t n_frozen;     /* number of enemies frozen in the last move */
    uint32_t n_leaving;    /* number of enemies that left the keep box in this frame's move */

    /* Bodies and their parts; all NULL if not enabled. A part stays at its body's position plus (dx, dy). Moves of a
     * part, and their ends (x0 to y1), are in terms of dx and dy. */
    int32_t *rate;         /* factor of the damage taken, ENEMY_RATE_ONE: 1 */
    uint32_t *hp_deficit;  /* hp, which is rounded up, minus the exact hp, in 2^-32 hp */
    uint16_t *body;        /* slot + 1 of the part's body; 0: not a part */
    uint16_t *n_parts;     /* number of the enemy's direct parts */
    fx *dx, *dy;           /* a part's offset from its body */
    int32_t *damage_share; /* share of the damage to a part that its body takes too */
    uint8_t *lead_mode;    /* LEAD_ORBIT, LEAD_WANDER or 0 */
    fx *cx, *cy;           /* centre of the orbit, or of the area to wander in */
    fx *reach_x, *reach_y; /* radii at the start and end of the orbit; or half the area's width and height */
    int64_t *orbit_target; /* the board's handle of the orbit centre; 0: (cx, cy) is fixed */
    ang *angle;            /* angle at the orbit's start */
    int32_t *spin;         /* ang per frame */
    uint32_t *leg_interval, *leg_wait,
        *leg_duration;   /* wanderers: frames between the starts of two legs; until the next start; per leg */
    uint8_t *move_begun; /* 1: the enemy's move of this frame is done or in progress */

    ang *dir;               /* the picture's direction; this and the next two: NULL if not enabled */
    uint8_t *scale, *alpha; /* SCALE_MIN to SCALE_MAX; 0 to ALPHA_OPAQUE */
};

/* The board's callbacks for the moves of bodies. get_position sets (*x, *y) to the position of an entity, for an enemy
 * after its move of this frame (enemies_ensure_moved), and returns false if the entity has despawned. random_below
 * returns a random number, 0 <= n < below, from the game's generator. */
struct enemies_world {
    void *context;
    bool (*get_position)(struct enemies_world *w, int64_t entity, fx *x, fx *y);
    uint64_t (*random_below)(void *context, uint64_t below);
    int depth; /* depth of nested calls: number of enemies that wait for another one's position */
};

struct enemies_orbit {
    int64_t orbit_target; /* handle of the centre; 0: (x, y) is the centre */
    fx x, y, radius, radius_to;
    ang angle;
    int32_t spin;      /* ang per frame */
    uint32_t duration; /* frames; 0: forever */
};

struct enemies_wander_area {
    fx x, y, reach_x, reach_y;
    uint32_t leg_interval,
        leg_duration; /* frames from one leg to the next, and frames a leg takes; 1 <= leg_duration <= leg_interval */
    enum ease ease;
};

/* Returns the column that stores value k, 0 <= k < MAX_VALUES, or NULL if value k is not declared. */
static inline fx *enemies_value_column(const struct enemies *e, int k)
{
    fx *const value[MAX_VALUES] = { e->value1, e->value2, e->value3, e->value4 };

    return value[k];
}

extern const struct chip enemies_chip, enemy_kinds_chip;

/* Spawns an enemy of the given kind at (x, y), with the kind's hp and bank. Returns its slot, or NO_SLOT if the pool is
 * full. */
int32_t enemies_spawn(struct enemies *e, const struct enemy_kinds *kinds, uint16_t kind, fx x, fx y, uint32_t clock);

/* Removes enemy i and its parts. Parts that are dying are detached instead. */
void enemies_drop(struct enemies *e, uint32_t i);

/* Makes enemy i a part of `body`, which must be neither i itself nor one of i's own parts. */
void enemies_attach(struct enemies *e, uint32_t i, uint32_t body, fx dx, fx dy, int32_t share);

/* Returns enemy i's depth of nesting: 0 if it is not a part, otherwise its body's depth + 1. */
int enemies_part_depth(const struct enemies *e, uint32_t i);

/* Damages enemy i by `amount` times its rate, rounded down, but by at most its exact hp. Returns the damage taken. Both
 * are in 2^-32 hp. Sets hp to the rest, rounded up. */
uint64_t enemies_damage(struct enemies *e, uint32_t i, uint64_t amount);

/* Returns amount * share / ENEMY_RATE_ONE, rounded down, at most INT64_MAX. */
uint64_t enemies_scale_damage(uint64_t amount, int32_t share);

/* Removes all enemies of `owner`, except dying ones, which despawn after their handlers have run. */
void enemies_drop_owned(struct enemies *e, int64_t owner);

/* Moves enemy i to (x, y) over the next `duration` calls of enemies_move, 1 <= duration < 2^31, arriving exactly. After
 * k of n frames the enemy has covered motion_ease(ease, k, n) of the distance; each coordinate is rounded to the
 * nearest fx, ties to even. A part moves to the offset of (x, y) from its body's present position. */
void enemies_move_to(struct enemies *e, uint32_t i, fx x, fx y, uint32_t duration, enum ease ease);

/* Like enemies_move_to, but moves enemy i to its present position plus (dx, dy), or a part to the offset (dx, dy). */
void enemies_move_by(struct enemies *e, uint32_t i, fx dx, fx dy, uint32_t duration, enum ease ease);

/* Places enemy i at (x, y), for a part by setting its offset, and ends its move, orbit or wandering. */
void enemies_set_position(struct enemies *e, uint32_t i, fx x, fx y);

/* Make enemy i orbit or wander from the next call of enemies_move on. Each leg of a wanderer is a move as in
 * enemies_move_to, to a random point of the area. enemies_move draws the points in slot order, before any enemy
 * moves. */
void enemies_start_orbit(struct enemies *e, uint32_t i, const struct enemies_orbit *o);
void enemies_start_wandering(struct enemies *e, uint32_t i, const struct enemies_wander_area *g);

/* Returns whether enemy i's movement of that serial has not ended. */
bool enemies_is_moving(const struct enemies *e, uint32_t i, uint32_t serial);

/* Ends enemy i's move, orbit or wandering. The enemy stays where it is. */
void enemies_halt(struct enemies *e, uint32_t i);

/* Shifts enemy i at once by (dx, dy), and with it the move, orbit or area. All coordinates are clamped to the world. */
void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy);

/* Keeps frozen enemies from ageing. Call it at the end of each frame in which the clock advances. */
void enemies_postpone_frozen(struct enemies *e);

/* Makes enemy i blink after a hit, if its kind blinks and the enemy is not blinking already. */
void enemies_blink(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Returns whether enemy i is drawn white: only in the first quarter of its blinking, so that an enemy that is hit all
 * the time stays visible. */
bool enemies_is_flashing(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Returns the sprite that enemy i shows. */
uint16_t enemies_sprite(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Counts down the frames of `safe_left` and blinking. Call it at the start of each frame, so that `safe = n` lasts n
 * frames, including the present one. */
void enemies_step_timers(struct enemies *e);

/* Advances all moves by a frame, and marks enemies outside *keep_box as ENEMY_LEAVING, except parts and undying or
 * dying enemies. w may be NULL if bodies are not enabled. Enemies move in slot order, except that a part moves after
 * its body, and an orbiting enemy after the enemy at its centre, unless the two wait for each other. */
void enemies_move(struct enemies *e, const struct box *keep_box, struct enemies_world *w);

/* Turns the enemies of kinds with ENEMY_TURNS into the direction of the last move, unless they stood still. Requires
 * GROUP_TRANSFORMS. */
void enemies_turn(struct enemies *e, const struct enemy_kinds *kinds);

/* Makes enemy i's move of this frame, unless that move is done or in progress. */
void enemies_ensure_moved(struct enemies *e, uint32_t i, struct enemies_world *w);

#endif
