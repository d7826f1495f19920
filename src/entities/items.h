/*
 * items.h - items: they fall, fly to a player who attracts them, and are collected on contact.
 */
#ifndef ENTITIES_ITEMS_H
#define ENTITIES_ITEMS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    ITEM_MAGNET = 1 << 0, /* of a kind: players attract it */
    ITEM_BLEND = 3 << 2,  /* of a kind: blend mode in units of ITEM_BLEND_ONE: 0 opaque, otherwise blend + 1 */
    ITEM_BLEND_ONE = 1 << 2,

    ITEM_MAX_REGISTERS = 16, /* different registers that a game's items can add to */
    ITEM_MAX_POINTS = 1000000000
};

/* Declared by item.def. */
struct item_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *bank;
    uint8_t *flags;
    fx *radius;                /* collection radius, px, tested against the player's hit circle */
    fx *gravity;               /* acceleration of a falling item, px/frame^2 */
    fx *max_fall_speed;        /* maximum falling speed, px/frame */
    int64_t *low_points;       /* points when taken at the bottom of the field */
    int64_t *high_points;      /* points when taken at the collect line or above */
    int32_t *lives;            /* lives it gives */
    int32_t *register_amounts; /* ITEM_MAX_REGISTERS per kind: amount added to each register that items use */
    uint16_t *full_register; /* register number + 1, 0: none; while that register is at its maximum, the item gives only
                     * points */
};

/* A player's attraction of items. */
struct item_pull {
    fx x, y;        /* position of the player */
    fx radius;      /* items within this distance are attracted */
    bool pulls_all; /* all items are attracted */
    bool active;    /* false: the player attracts nothing, and items flying to it fall again */
    fx speed;
};

struct items {
    struct slots s;
    fx *x, *y;
    fx *vx, *vy;
    fx *prev_x, *prev_y; /* position before this frame's move */
    uint16_t *kind;
    uint16_t *tag;
    uint32_t *born;        /* clock at spawn */
    uint8_t *pulled_by;    /* index of the player it flies to + 1; 0: it falls */
    int32_t *frozen_left;  /* frames left frozen, or FROZEN_FOREVER; this and `freeze_flags`: NULL if not enabled */
    uint8_t *freeze_flags; /* FREEZE_LAST_MOVE flag */
    uint64_t *collected;   /* one bit per slot: the item is collected, and stays until the event handlers have run */
    uint32_t n_frozen;     /* number of items frozen in the last move */
};

extern const struct chip items_chip, item_kinds_chip;

/* Spawns an item at rest at (x, y); returns its slot, or NO_SLOT when the pool is full. */
int32_t items_spawn(struct items *s, uint16_t kind, fx x, fx y, uint32_t clock);

/* Returns the direction of item k of n, spread evenly over `spread` (2^32: full circle) around dir: the middle of the
 * k-th of n equal sectors. */
ang items_spread_direction(ang dir, uint64_t spread, uint32_t k, uint32_t n);

/* Makes item i fly to player p (0 or 1) from the next move on. */
void items_pull(struct items *s, uint32_t i, uint32_t p);

/* Makes all items that fly to player p fall again, from rest. */
void items_release(struct items *s, uint32_t p);

/*
 * Moves all items by one frame. An item pulled by a player flies straight towards the player's position at `speed`
 * px/frame and stops there. A falling item that is attracted starts flying to the nearest player that attracts it.
 * Otherwise gravity brings its vertical speed towards `max_fall_speed`; once it no longer rises, gravity also slows its
 * horizontal speed to 0.
 */
void items_move(struct items *s, const struct item_kinds *kinds, const struct item_pull pull[MAX_PLAYERS]);

/* Keeps items that were frozen in this frame from ageing. Call it at the end of every frame in which the clock
 * advances. */
void items_postpone_frozen(struct items *s);

/* Returns the points for an item of that kind taken at y: `high_points` at the collect line and above, `low_points` at
 * the bottom and below, interpolated linearly in between and truncated. */
int64_t items_points(const struct item_kinds *kinds, uint16_t kind, fx y, fx line, fx bottom);

#endif
