/*
 * items.h - items: they fall, come to a player who attracts them, and are taken by touch.
 */
#ifndef ENTITIES_ITEMS_H
#define ENTITIES_ITEMS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    ITEM_MAGNET = 1 << 0, /* of a kind: players attract it */
    ITEM_BLEND = 3 << 2,  /* of a kind: how it is drawn, in units of ITEM_BLEND_ONE: 0 opaque, else blend + 1 */
    ITEM_BLEND_ONE = 1 << 2,

    ITEM_REGISTERS = 16, /* different registers that the items of a game may give */
    ITEM_MOST = 1000000000
};

/* What item.def declares. */
struct item_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *bank;
    uint8_t *flags;
    fx *radius;     /* what a player's hit circle has to touch */
    fx *gravity;    /* px a frame that its speed changes in a frame */
    fx *top;        /* px a frame that it falls at most */
    int64_t *low;   /* points: at the bottom of the field */
    int64_t *high;  /* at the collect line and above */
    int32_t *lives; /* that it gives */
    int32_t *gives; /* ITEM_REGISTERS a kind: what it adds to each register that has a number among the items' */
    uint16_t *full; /* number + 1 of the register at whose most only the points are given, 0: none */
};

/* What attracts items, and at what speed they fly then. */
struct item_pull {
    fx x, y;   /* where the player is */
    fx radius; /* items at most so far away come */
    bool all;  /* all come */
    bool in;   /* false: it attracts nothing, and what was on its way falls again */
    fx speed;
};

struct items {
    struct slots s;
    fx *x, *y;
    fx *vx, *vy;
    fx *was_x, *was_y; /* before this frame's move */
    uint16_t *kind;
    uint16_t *tag;
    uint32_t *born;    /* clock */
    uint8_t *pull;     /* player + 1 it flies to, 0: it falls */
    int32_t *frozen;   /* frames it will stand, or FROZEN_FOREVER; NULL, with the next: not asked for */
    uint8_t *stands;   /* STOOD */
    uint64_t *taken;   /* a bit a slot: held, until the handlers of the event have run */
    uint32_t standing; /* how many stood in the last move */
};

extern const struct chip items_chip, item_kinds_chip;

/* Puts an item there, at rest; NO_SLOT: there was no room. */
int32_t items_put(struct items *s, uint16_t kind, fx x, fx y, uint32_t clock);

/* Where the k-th of n items goes that are laid out evenly over `spread` (2^32: all round) about dir: in the middle of
 * the k-th of n equal parts. */
ang items_direction(ang dir, uint64_t spread, uint32_t k, uint32_t n);

/* Item i flies to player p (0 or 1) from the next move on. */
void items_pull(struct items *s, uint32_t i, uint32_t p);

/* What flies to player p falls again, from rest. */
void items_let_go(struct items *s, uint32_t p);

/*
 * A frame's move. What flies to a player goes `speed` px straight towards it, and stops at its place. What falls
 * attracts itself first: it turns to the nearest of the players that attract it, then flies. Else its speed changes by
 * gravity downwards until it is `top`; and sideways, from the frame on in which it does not rise, until it is 0.
 */
void items_move(struct items *s, const struct item_kinds *kinds, const struct item_pull pull[PADS]);

/* At the end of a frame in which the clock goes on: what stood in it grows no older. */
void items_stay(struct items *s);

/* Points of an item of that kind, taken at y: `high` at the line and above, `low` at the bottom and below, and between
 * the two in equal parts, cut to whole points. */
int64_t items_points(const struct item_kinds *kinds, uint16_t kind, fx y, fx line, fx bottom);

#endif
