/*
 * enemies.h - enemies and bosses: one pool, with the one move each may be making.
 */
#ifndef ENTITIES_ENEMIES_H
#define ENTITIES_ENEMIES_H

#include "../base/fx.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    ENEMY_TOUCH = 1 << 0, /* of a kind: touching it kills a player */
    ENEMY_SWEPT = 1 << 1, /* of a kind: hits on players look at the whole path of its frame, not at its end alone */
    ENEMY_BLEND = 3 << 2, /* of a kind: how it is drawn, in units of ENEMY_BLEND_ONE: 0 opaque, else blend + 1 */
    ENEMY_BLEND_ONE = 1 << 2,
    ENEMY_BLOCKS = 1 << 4, /* of a kind: bullets that touch it are gone */
    ENEMY_HURT = 1 << 5,   /* of a kind: its picture 1 stands in place of 0 while it blinks */
    ENEMY_SOFT = 1 << 6,   /* of a kind: where it blinks white, only a rim round it is */

    ENEMY_UNDYING = 1 << 0, /* of an enemy: at hp 0 it waits instead of dying (a boss between phases) */
    ENEMY_DYING = 1 << 1,   /* it died, and goes after its handlers have run */
    ENEMY_LEAVING = 1 << 2, /* it left in this frame's move, can still be hit, and goes as the dying do */
    ENEMY_FLIP = 1 << 3,    /* left and right exchanged */
    ENEMY_HIDDEN = 1 << 4,  /* not drawn */
    ENEMY_PICTURE = 7 << 5, /* which of its kind's pictures, in units of ENEMY_PICTURE_ONE: 0 the kind's sprite, else
                               that of the row so many before the kind's */
    ENEMY_PICTURE_ONE = 1 << 5,
    ENEMY_PICTURES = 7,
    ENEMY_GONE = ENEMY_DYING | ENEMY_LEAVING, /* either: not alive for scripts */

    ENEMY_BANK = 15,       /* of `bank`: banks to add */
    ENEMY_BLINK = 15 << 4, /* of `bank`, in units of ENEMY_BLINK_ONE: frames it blinks when hurt (a kind), and still
                              will */
    ENEMY_BLINK_ONE = 1 << 4,

    SAFE_FOREVER = -1,

    LEAD_ORBIT = 1, /* in `lead`: it goes round, or about; 0: neither */
    LEAD_WANDER = 2,

    PARTS_DEEP = 8,              /* most parts of parts, the first body not counted */
    ENEMY_WHOLE = 1 << 16,       /* a rate or share of 1 */
    ENEMY_MOST_RATE = 100 << 16, /* of damage */

    MAX_ENEMIES = 4096
};

/* What enemy.def declares; its functions and drops stay with the scripts. */
struct enemy_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *shape;
    fx *a, *b, *x, *y; /* of the shape; several circles take a row each */
    int32_t *hp;
    int64_t *score;
    uint8_t *bank; /* and how long it blinks: ENEMY_ */
    uint8_t *flags;
    uint16_t *spark; /* kind + 1, 0: none */
    int32_t *rate;   /* of the damage it takes, ENEMY_WHOLE: all; NULL: not asked for */
};

struct enemies {
    struct slots s;
    fx *x, *y;
    fx *was_x, *was_y; /* before this frame's move; where it is now when it jumped, faster than MAX_SPEED */
    int32_t *hp;
    uint16_t *kind;
    uint8_t *bank; /* and how long it will blink: ENEMY_ */
    uint16_t *tag;
    int32_t *safe;  /* frames it takes no damage, or SAFE_FOREVER */
    uint32_t *born; /* clock */
    uint32_t *owner_task;
    int64_t *owner; /* it goes when that one ends, 0: none; the board gives it a meaning */
    uint8_t *flags;
    fx *x0, *y0, *x1, *y1; /* the move it makes: from, to */
    uint32_t *made, *over; /* frames made of it, frames in all; over 0: none */
    uint8_t *ease;
    fx *value1, *value2, *value3, *value4; /* numbers that the game declares; NULL: not asked for */
    fx value_start[MAX_VALUES];            /* what they are in a new enemy */
    int32_t *frozen;   /* frames it will stand, or FROZEN_FOREVER; NULL, with the next: not asked for */
    uint8_t *stands;   /* STOOD */
    uint32_t standing; /* how many stood in the last move */
    uint32_t leaving;  /* how many this frame's move took outside of keep */

    /* Bodies; all NULL: not asked for. A part stays at its body's place plus (dx, dy), which x0 to y1 then lead. */
    int32_t *rate;   /* of the damage it takes */
    uint32_t *wound; /* what it has less than hp says, in 2^-32 hp */
    uint16_t *body;  /* of a part: its body's slot + 1; 0: it is none */
    uint16_t *parts; /* how many are parts of it, and not of these */
    fx *dx, *dy;
    int32_t *share;              /* of a part: of what it takes, so much goes on to its body */
    uint8_t *lead;               /* LEAD_ */
    fx *cx, *cy;                 /* the middle of its orbit, or of the ground it wanders about */
    fx *reach_x, *reach_y;       /* the radius at the orbit's begin and end; half the ground's width and height */
    int64_t *around;             /* the thing whose place is the middle, 0: none; the board gives it a meaning */
    ang *angle;                  /* of an orbit, at its begin */
    int32_t *spin;               /* ang a frame */
    uint32_t *every, *due, *leg; /* frames from one leg of a wanderer to the next; until the next; of a leg */
    uint8_t *settled;            /* its move of this frame is made, or has begun */
};

/* What the moves of bodies ask of the board: where that thing is, after its move of this frame if it is an enemy
 * (enemies_settle); false: it is gone. And a number of the game's chance. */
struct enemies_world {
    void *context;
    bool (*where)(struct enemies_world *w, int64_t thing, fx *x, fx *y);
    uint64_t (*draw)(void *context, uint64_t below);
    int deep; /* enemies that wait for another's place */
};

struct enemies_orbit {
    int64_t around; /* 0: (x, y) */
    fx x, y, radius, radius_to;
    ang angle;
    int32_t spin;  /* ang a frame */
    uint32_t over; /* 0: for ever */
};

struct enemies_ground {
    fx x, y, reach_x, reach_y;
    uint32_t every, leg; /* 1 <= leg <= every */
    enum ease ease;
};

/* Column k of the values, 0 to MAX_VALUES - 1, or NULL. */
static inline fx *enemies_value(const struct enemies *e, int k)
{
    fx *const value[MAX_VALUES] = { e->value1, e->value2, e->value3, e->value4 };

    return value[k];
}

extern const struct chip enemies_chip, enemy_kinds_chip;

/* Puts an enemy of that kind at (x, y), with the kind's hp and bank. */
int32_t enemies_spawn(struct enemies *e, const struct enemy_kinds *kinds, uint16_t kind, fx x, fx y, uint32_t clock);

/* It goes, and its parts go with it; but those that are dying, which then are parts no more. */
void enemies_drop(struct enemies *e, uint32_t i);

/* Makes i a part. The body is another, and not among i's own parts. */
void enemies_attach(struct enemies *e, uint32_t i, uint32_t body, fx dx, fx dy, int32_t share);

/* How many bodies it is a part of, one of the other. */
int enemies_depth(const struct enemies *e, uint32_t i);

/* Takes damage away from it, in 2^-32 hp, times its rate, rounded down to such; returns what it took, at most what it
 * had. hp says what is left, rounded up. */
uint64_t enemies_damage(struct enemies *e, uint32_t i, uint64_t amount);

/* A share of an amount, rounded down; share <= ENEMY_WHOLE. */
uint64_t enemies_share(uint64_t amount, int32_t share);

/* Removes all that have that owner, but for the dying, which go after their handlers have run. */
void enemies_drop_of(struct enemies *e, int64_t owner);

/* Moves enemy i to (x, y) in the next `over` calls of enemies_move, 1 <= over < 2^31; it arrives exactly. After k of n
 * it is at the place nearest to that share of its way (motion_eased) on either axis, ties to the even one. A part moves
 * to where that is of its body now. */
void enemies_go(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease);

/* The same by (dx, dy) from where it is; a part's dx and dy to these. */
void enemies_go_by(struct enemies *e, uint32_t i, fx dx, fx dy, uint32_t over, enum ease ease);

/* Puts it there, a part so far from its body, and ends its move. */
void enemies_put(struct enemies *e, uint32_t i, fx x, fx y);

/* Sends it round, or about: from the next move on. A wanderer's places are drawn in slot order, at the begin of the
 * frame's move, before any enemy's; each leg is a move that enemies_go would make, to a place of the ground. */
void enemies_circle(struct enemies *e, uint32_t i, const struct enemies_orbit *o);
void enemies_wander(struct enemies *e, uint32_t i, const struct enemies_ground *g);

/* It stays where it is: no move, orbit or legs any more. */
void enemies_halt(struct enemies *e, uint32_t i);

/* Moves enemy i on by (dx, dy) at once, and with it the move it makes; both stay within the world. */
void enemies_shift(struct enemies *e, uint32_t i, fx dx, fx dy);

/* At the end of a frame in which the clock goes on: what stood in it grows no older. */
void enemies_stay(struct enemies *e);

/* It was hurt, and blinks if its kind does and it does not yet. */
void enemies_blink(struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Is it white now? In the first quarter of its blinking, so that one that is hit all the time is seen as well. */
bool enemies_white(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* The sprite it shows. */
uint16_t enemies_picture(const struct enemies *e, const struct enemy_kinds *kinds, uint32_t i);

/* Counts safe and blinking frames down, at the start of a frame: so `safe = n` lasts n frames, the present one
 * included. */
void enemies_count_down(struct enemies *e);

/* Goes on with the moves, and marks those that are outside keep as leaving, but no parts. w: NULL without bodies. In
 * slot order; but a part after its body, and what orbits an enemy after that one, unless that waits for it. */
void enemies_move(struct enemies *e, const struct box *keep, struct enemies_world *w);

/* Makes this frame's move of one, unless it is made or has begun. */
void enemies_settle(struct enemies *e, uint32_t i, struct enemies_world *w);

#endif
