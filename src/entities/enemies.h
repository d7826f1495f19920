/*
 * enemies.h - enemies and bosses: one pool, in which each enemy has at most one move in progress.
 */
#ifndef ENTITIES_ENEMIES_H
#define ENTITIES_ENEMIES_H

#include "../base/fx.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    ENEMY_TOUCH = 1 << 0, /* kinds: kills a player who touches it */
    ENEMY_SWEPT = 1 << 1, /* kinds: uses swept collision against players: hits test the whole path of a frame */
    ENEMY_BLEND = 3 << 2, /* kinds: in units of ENEMY_BLEND_ONE: 0: drawn opaque, otherwise blend mode + 1 */
    ENEMY_BLEND_ONE = 1 << 2,
    ENEMY_BLOCKS = 1 << 4, /* kinds: removes bullets that touch it */
    ENEMY_HURT = 1 << 5,   /* kinds: picture 1 replaces picture 0 while it blinks */
    ENEMY_SOFT = 1 << 6,   /* kinds: only a rim around the sprite blinks white */

    ENEMY_UNDYING = 1 << 0, /* enemies: waits at hp 0 instead of dying (a boss between phases) */
    ENEMY_DYING = 1 << 1,   /* enemies: died; despawns after its handlers have run */
    ENEMY_LEAVING = 1 << 2, /* enemies: left keep in this move; can still be hit; despawns as dying ones do */
    ENEMY_FLIP = 1 << 3,    /* enemies: drawn mirrored left to right */
    ENEMY_HIDDEN = 1 << 4,  /* enemies: not drawn */
    ENEMY_PICTURE = 7 << 5, /* enemies: index n of the kind's picture, in units of ENEMY_PICTURE_ONE: the sprite of the
                             * row n before the kind's */
    ENEMY_PICTURE_ONE = 1 << 5,
    ENEMY_PICTURES = 7,
    ENEMY_GONE = ENEMY_DYING | ENEMY_LEAVING, /* either flag: not alive for scripts */

    ENEMY_BANK = 15,       /* in the column `bank`: palette banks to add */
    ENEMY_BLINK = 15 << 4, /* in the column `bank`, in units of ENEMY_BLINK_ONE: frames a kind blinks when hurt; frames
                            * an enemy still blinks */
    ENEMY_BLINK_ONE = 1 << 4,

    SAFE_FOREVER = -1,

    LEAD_ORBIT = 1, /* in the column `lead`: what leads the enemy; 0: neither */
    LEAD_WANDER = 2,

    PARTS_DEEP = 8,              /* limit of nesting: parts of parts, the first body not counted */
    ENEMY_WHOLE = 1 << 16,       /* a rate or share of 1 */
    ENEMY_MOST_RATE = 100 << 16, /* limit of a rate of damage */

    MAX_ENEMIES = 4096
};

/* The kinds declared by enemy.def; its functions and drops are stored by the scripts. */
struct enemy_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *shape;
    fx *a, *b, *x, *y; /* parameters of `shape` (motion.h); several circles take a row each */
    int32_t *hp;
    int64_t *score;
    uint8_t *bank; /* ENEMY_BANK, and ENEMY_BLINK: how long it blinks when hurt */
    uint8_t *flags;
    uint16_t *spark; /* kind + 1, 0: none */
    int32_t *rate;   /* factor of the damage taken, ENEMY_WHOLE: full damage; NULL: not enabled */
};

struct enemies {
    struct slots s;
    fx *x, *y;
    fx *was_x, *was_y; /* position before this frame's move; after a jump (faster than MAX_SPEED): position now */
    int32_t *hp;
    uint16_t *kind;
    uint8_t *bank; /* ENEMY_BANK, and ENEMY_BLINK: how long it still blinks */
    uint16_t *tag;
    int32_t *safe;  /* frames left without taking damage, or SAFE_FOREVER */
    uint32_t *born; /* clock */
    uint32_t *owner_task;
    int64_t *owner; /* the enemy despawns when its owner ends, 0: none; the board defines the value */
    uint8_t *flags;
    fx *x0, *y0, *x1, *y1; /* start and end of the move in progress */
    uint32_t *made, *over; /* frames of the move done, and in all; over 0: no move */
    uint8_t *ease;
    fx *value1, *value2, *value3, *value4; /* numbers declared by the game; NULL: not declared */
    fx value_start[MAX_VALUES];            /* initial values of a new enemy */
    int32_t *frozen;   /* frames left frozen, or FROZEN_FOREVER; this and the next: NULL if not enabled */
    uint8_t *stands;   /* STOOD: frozen in the last move */
    uint32_t standing; /* number of enemies frozen in the last move */
    uint32_t leaving;  /* number of enemies that left keep in this frame's move */

    /* Bodies and their parts; all NULL if not enabled. A part stays at its body's position plus (dx, dy); its moves (x0
     * to y1) change dx and dy. */
    int32_t *rate;               /* factor of the damage taken, ENEMY_WHOLE: full damage */
    uint32_t *wound;             /* excess of hp, which is rounded up, over the exact value, in 2^-32 hp */
    uint16_t *body;              /* slot + 1 of the part's body; 0: not a part */
    uint16_t *parts;             /* number of its direct parts */
    fx *dx, *dy;                 /* a part's offset from its body */
    int32_t *share;              /* share of a part's damage that its body also takes */
    uint8_t *lead;               /* LEAD_ */
    fx *cx, *cy;                 /* centre of the orbit, or of the area it wanders in */
    fx *reach_x, *reach_y;       /* radius at the orbit's start and end; or half the area's width and height */
    int64_t *around;             /* the board's handle of the orbit centre; 0: (cx, cy) is fixed */
    ang *angle;                  /* angle at the orbit's start */
    int32_t *spin;               /* ang a frame */
    uint32_t *every, *due, *leg; /* wanderers: frames between the starts of two legs; until the next; length of a leg */
    uint8_t *settled;            /* 1: this frame's move is done or in progress */
};

/* The board's callbacks for the moves of bodies. where finds an entity's position, after its move of this frame if it
 * is an enemy (enemies_settle), and returns false if the entity is gone. draw returns a random number, 0 <= n < below,
 * from the game's generator. */
struct enemies_world {
    void *context;
    bool (*where)(struct enemies_world *w, int64_t thing, fx *x, fx *y);
    uint64_t (*draw)(void *context, uint64_t below);
    int deep; /* depth of nested calls: enemies waiting for another's position */
};

struct enemies_orbit {
    int64_t around; /* handle of the centre; 0: (x, y) is the centre */
    fx x, y, radius, radius_to;
    ang angle;
    int32_t spin;  /* ang a frame */
    uint32_t over; /* frames; 0: forever */
};

struct enemies_ground {
    fx x, y, reach_x, reach_y;
    uint32_t every, leg; /* 1 <= leg <= every */
    enum ease ease;
};

/* Returns column k of the values, 0 <= k < MAX_VALUES, or NULL if it is not declared. */
static inline fx *enemies_value(const struct enemies *e, int k)
{
    fx *const value[MAX_VALUES] = { e->value1, e->value2, e->value3, e->value4 };

    return value[k];
}

extern const struct chip enemies_chip, enemy_kinds_chip;

/* Spawns an enemy of that kind at (x, y), with the kind's hp and bank. Returns its slot, or NO_SLOT if the pool is
 * full. */
int32_t enemies_spawn(struct enemies *e, const struct enemy_kinds *kinds, uint16_t kind, fx x, fx y, uint32_t clock);

/* Removes enemy i and its parts. Dying parts are detached instead. */
void enemies_drop(struct enemies *e, uint32_t i);

/* Makes enemy i a part of `body`, which must be neither i itself nor one of i's own parts. */
void enemies_attach(struct enemies *e, uint32_t i, uint32_t body, fx dx, fx dy, int32_t share);

/* Returns enemy i's depth of nesting: 0 if it is not a part, otherwise its body's depth + 1. */
int enemies_depth(const struct enemies *e, uint32_t i);

/* Subtracts amount, in 2^-32 hp, times the enemy's rate, rounded down. Returns the damage taken, in 2^-32 hp, at most
 * what was left. hp becomes the rest, rounded up. */
uint64_t enemies_damage(struct enemies *e, uint32_t i, uint64_t amount);

/* Returns amount * share / ENEMY_WHOLE, rounded down, or INT64_MAX if that is exceeded. */
uint64_t enemies_share(uint64_t amount, int32_t share);

/* Removes all enemies with that owner, except dying ones, which despawn after their handlers have run. */
void enemies_drop_of(struct enemies *e, int64_t owner);

/* Moves enemy i to (x, y) over the next `over` calls of enemies_move, 1 <= over < 2^31, arriving exactly. After k of n
 * frames it is, on either axis, at the fx nearest to that share of the distance (motion_eased), ties to even. A part
 * moves to the offset that (x, y) has from its body now. */
void enemies_go(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease);

/* Moves enemy i by (dx, dy) from its position, as enemies_go does; the offset of a part becomes (dx, dy). */
void enemies_go_by(struct enemies *e, uint32_t i, fx dx, fx dy, uint32_t over, enum ease ease);

/* Places enemy i at (x, y), which sets a part's offset, and ends its move, orbit or wandering. */
void enemies_put(struct enemies *e, uint32_t i, fx x, fx y);

/* Start an orbit or wandering with the next move. Each leg of a wanderer is a move as by enemies_go, to a random point
 * of its area. These points are drawn in slot order at the start of enemies_move, before any enemy moves. */
void enemies_circle(struct enemies *e, uint32_t i, const struct enemies_orbit *o);
void enemies_wander(struct enemies *e, uint32_t i, const struct enemies_ground *g);

/* Ends the enemy's move, orbit or wandering, and leaves it where it is. */
void enemies_halt(struct enemies *e, uint32_t i);

/* Shifts enemy i by (dx, dy) at once, together with its move, orbit or area; all stay within the world. */
void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy);

/* Stops frozen enemies from ageing: call at the end of a frame in which the clock advances. */
void enemies_stay(struct enemies *e);

/* Starts enemy i's blinking after a hit, if its kind blinks and it is not blinking already. */
void enemies_blink(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Returns whether enemy i is drawn white: in the first quarter of its blinking, so that an enemy hit all the time stays
 * visible. */
bool enemies_white(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Returns the sprite that enemy i shows. */
uint16_t enemies_picture(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Counts down the frames of `safe` and blinking. Called at the start of a frame, so `safe = n` lasts n frames, the
 * present one included. */
void enemies_count_down(struct enemies *e);

/* Advances all moves by a frame, and marks enemies outside keep as ENEMY_LEAVING, except parts and undying or dying
 * enemies. w may be NULL without bodies. Enemies move in slot order, except that a part moves after its body, and an
 * enemy that orbits another after that one, unless they wait for each other. */
void enemies_move(struct enemies *e, const struct box *keep, struct enemies_world *w);

/* Makes enemy i's move of this frame, unless it is done or in progress. */
void enemies_settle(struct enemies *e, uint32_t i, struct enemies_world *w);

#endif
