/*
 * enemies.h - enemies and bosses: one pool, with the one move each may be making.
 * floor: chips
 */
#ifndef CHIPS_ENEMIES_H
#define CHIPS_ENEMIES_H

#include "../base/fx.h"
#include "motion.h"
#include "slots.h"

enum {
    ENEMY_TOUCH = 1 << 0, /* of a kind: touching it kills a player */
    ENEMY_SWEPT = 1 << 1, /* of a kind: hits on players look at the whole path of its frame, not at its end alone */
    ENEMY_BLEND = 3 << 2, /* of a kind: how it is drawn, in units of ENEMY_BLEND_ONE: 0 opaque, else blend + 1 */
    ENEMY_BLEND_ONE = 1 << 2,
    ENEMY_BLOCKS = 1 << 4, /* of a kind: bullets that touch it are gone */
    ENEMY_HURT = 1 << 5,   /* of a kind: its picture 1 stands in place of 0 while it blinks */

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
    uint32_t *by;
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
void enemies_drop(struct enemies *e, uint32_t i);

/* Removes all that have that owner, but for the dying, which go after their handlers have run. */
void enemies_drop_of(struct enemies *e, int64_t owner);

/* Moves enemy i to (x, y) in the next `over` calls of enemies_move, 1 <= over < 2^31; it arrives exactly. After k of n
 * it is at the place nearest to that share of its way (motion_eased) on either axis, ties to the even one. */
void enemies_go(struct enemies *e, uint32_t i, fx x, fx y, uint32_t over, enum ease ease);

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

/* Goes on with the moves, and marks those that are outside keep as leaving. */
void enemies_move(struct enemies *e, const struct box *keep);

#endif
