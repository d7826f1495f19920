/*
 * danger.h - what could hit a player in the present frame, for who looks for a way through: each thing with its move of
 * the frame, as hit_run sees it, and what a ship needs to know of itself.
 *
 * To be called at the end of PHASE_MOTION (board_on_phase): everything has moved, and nothing has been hit yet. Nothing
 * here changes a byte of RAM, but for danger_spare.
 */
#ifndef MACHINE_DANGER_H
#define MACHINE_DANGER_H

#include "../../base/fx.h"
#include "../../entities/motion.h"
#include "../board_types.h"

struct board;

enum danger_shape {
    DANGER_CIRCLE,  /* a: radius */
    DANGER_BOX,     /* a, b: half extents */
    DANGER_CAPSULE, /* all within a of a bar from (x - b, y - c) to (x + b, y + c) */
    DANGER_BAR      /* a piece of a laser: all within a of the line from (x, y) to (b, c), which moved by (d, e) */
};

enum danger_of { DANGER_BULLET, DANGER_ENEMY, DANGER_LASER };

/* A shape, where it is at the end of its move by (mx, my) in this frame. Lengths in px. */
struct danger {
    uint8_t shape, of;
    bool swept;    /* it touches on its whole way; else where it ends */
    uint16_t age;  /* of a bullet or laser: frames since its first move, at most 65535 */
    uint32_t slot; /* of the thing; a thing may have several shapes */
    fx x, y, mx, my, a, b, c, d, e;
};

/* A ship's way in a frame. */
struct danger_way {
    fx was_x, was_y, x, y, radius;
};

/* What a player's ship is, and can do. */
struct danger_ship {
    bool in;     /* the game */
    bool steers; /* its buttons move it: nobody talks, and the game does not stand still */
    bool hit;    /* it was hit, and a bomb could save it */
    bool safe;   /* nothing can hit it */
    int32_t lives;
    struct danger_way way; /* of this frame */
    fx speed, focus;       /* px/frame */
    struct box area;       /* where it can be, its edges included */
};

/* Calls `each` for every shape that could hit a player in this frame. */
void danger_each(const struct board *b, void (*each)(void *context, const struct danger *d), void *context);

/* Would it have hit a ship on that way? As hit_run decides. */
bool danger_touches(const struct danger *d, const struct danger_way *way);

/* Of player p, 0 or 1. */
void danger_ship(const struct board *b, int p, struct danger_ship *out);

/* From now on, until a restore, nothing hits a player, as in a practice start that says so; or it does again. Scripts
 * cannot see it. */
void danger_spare(struct board *b, bool spared);

#endif
