/*
 * lasers.h - lasers: beams that stand, bolts that fly, and curves, whose body follows the way of a head.
 *
 * A laser has a head: a bullet of speed, program and place, in the same slot of a pool of its own. A beam's head is
 * where it begins, a bolt's and a curve's is in front. A curve remembers where its head was after each of the last
 * frames, in a ring of points; a ring is made of pieces of a pool, for curves are of different lengths.
 */
#ifndef ENTITIES_LASERS_H
#define ENTITIES_LASERS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "../base/trig.h"
#include "motion.h"
#include "../base/slots.h"

enum laser_form { LASER_BEAM, LASER_BOLT, LASER_CURVE };

/* As scripts see them: harmless in the first and the last. */
enum laser_state { LASER_WARN, LASER_GROW, LASER_ON, LASER_FADE, LASER_STATES };

enum {
    LASER_FIXED = 1 << 0,  /* a clear passes it over, unless it takes all */
    LASER_SHOOTS = 1 << 1, /* it is a player's: it hurts enemies and no player */
    LASER_BLEND = 3 << 2,  /* how it is drawn, in units of LASER_BLEND_ONE: 0 opaque, else blend + 1 */
    LASER_BLEND_ONE = 1 << 2,

    /* in the column `flags` */
    LASER_LEFT = 1 << 0,   /* a curve's head is outside: it stands, and the body follows */
    LASER_GONE = 1 << 1,   /* it goes at the end of this frame */
    LASER_STILL = 1 << 2,  /* it stands, it jumped, or it is a beam that comes up: this frame it passes nothing */
    LASER_TURNS = 1 << 3,  /* it turns with what it follows */
    LASER_TURNED = 1 << 4, /* `followed` is where that one looked */

    LASER_PIECE = 32, /* points of a piece */
    LASER_PIECES = 8, /* most of a curve */
    LASER_POINTS = LASER_PIECE * LASER_PIECES,
    LASER_LONGEST = 4096, /* px; the widest too */
    LASER_FOREVER = -1,
    MAX_LASERS = 4096,
    MAX_LASER_KINDS = 256
};

/* What laser.def declares. */
struct laser_kinds {
    struct slots s;
    uint16_t *strip;
    uint16_t *head, *tail; /* sprite + 1, 0: none */
    fx *width;             /* px */
    fx *share;             /* of the width that hits, 0 to 1; below 0: nothing does */
    uint8_t *bank;
    uint8_t *flags;
    uint16_t *graze; /* frames between two grazes, 0: none */
    uint16_t *every; /* frames between two hits of a player's */
    int32_t *damage;
    uint16_t *vanish; /* spark kind + 1 that a clear leaves, 0: none */
};

struct lasers {
    struct slots s;
    uint8_t *form, *flags;
    fx *x0, *y0;         /* of beams and bolts: the end where the head is not; of curves: where their last point was */
    fx *was_x, *was_y;   /* the head before this frame's move */
    fx *was_x0, *was_y0; /* of beams and bolts: the other end */
    fx *length;          /* px, of beams and bolts */
    fx *grown;           /* of a bolt: px of it that have come out */
    fx *width;           /* px */
    ang *spin;           /* a frame, once it is dangerous */
    int32_t *warn, *grow, *fade; /* frames */
    int32_t *until;              /* the age at which it begins to fade, or LASER_FOREVER */
    int64_t *follow;             /* what it stays with, 0: nothing; the board gives it a meaning */
    fx *dx, *dy;                 /* from there */
    ang *followed;               /* where that one looked */
    uint32_t *again;             /* PADS a laser: the clock from which a player can graze it again; a player's: the
                                  * first of them is when it hurts again */
    uint16_t *points;            /* of a curve: the most it remembers */
    uint16_t *count;             /* so many it has */
    uint16_t *at;                /* the newest of the ring */
    uint16_t *piece;             /* LASER_PIECES a laser */
};

/* Pieces of rings. */
struct laser_points {
    struct slots s;
    fx *x, *y; /* LASER_PIECE a piece */
};

extern const struct chip lasers_chip, laser_kinds_chip, laser_points_chip;

/* All of a new laser but its ends. */
struct laser_shape {
    enum laser_form form;
    uint8_t flags;
    uint16_t points;
    fx length, width, dx, dy;
    ang spin;
    int32_t warn, grow, hold, fade; /* frames; hold: LASER_FOREVER */
    int64_t follow;
};

/* Puts a laser in the lowest free slot, its points at (x, y). NO_SLOT: there is no room for it, or, *full being the
 * points' slots, for its points. */
int32_t lasers_add(struct lasers *l, struct laser_points *p, const struct laser_shape *shape, fx x, fx y,
                   struct slots **full);
void lasers_drop(struct lasers *l, struct laser_points *p, uint32_t i);

/* Point k of a curve, of those it has: 0 is the newest. */
static inline void lasers_point(const struct lasers *l, const struct laser_points *p, uint32_t i, uint32_t k, fx *x,
                                fx *y)
{
    uint32_t at = l->at[i] >= k ? l->at[i] - k : l->at[i] + l->points[i] - k;
    uint32_t entry = l->piece[i * LASER_PIECES + at / LASER_PIECE] * (uint32_t)LASER_PIECE + at % LASER_PIECE;

    *x = p->x[entry];
    *y = p->y[entry];
}

/* The least box round a curve's points, and round the one that it had before them. */
void lasers_box(const struct lasers *l, const struct laser_points *p, uint32_t i, struct box *box);

/* Its head is at (x, y) now. */
void lasers_advance(struct lasers *l, struct laser_points *p, uint32_t i, fx x, fx y);

/* A curve's points move by (dx, dy), within the world. */
void lasers_shift(struct lasers *l, struct laser_points *p, uint32_t i, fx dx, fx dy);

/* At an age of so many frames. */
enum laser_state lasers_state(const struct lasers *l, uint32_t i, uint32_t age);

/* How wide it is drawn then, px. */
fx lasers_width(const struct lasers *l, uint32_t i, uint32_t age);

/* Has it faded away? */
bool lasers_over(const struct lasers *l, uint32_t i, uint32_t age);

/* It begins to fade, unless it has. */
void lasers_fade(struct lasers *l, uint32_t i, uint32_t age);

#endif
