/*
 * danger.h - everything that could hit a player in the current frame, for code that searches for a safe path: the
 * shapes with their moves of the frame, as hit_run sees them, and the state of a player's ship.
 *
 * Call these functions at the end of PHASE_MOTION (board_on_phase), when everything has moved and nothing has been hit
 * yet. Only danger_spare changes the board.
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
    DANGER_CAPSULE, /* all points within a of the segment from (x - b, y - c) to (x + b, y + c) */
    DANGER_BAR      /* a laser segment: all points within a of the line from (x, y) to (b, c); (b, c) moved by (d, e) */
};

enum danger_of { DANGER_BULLET, DANGER_ENEMY, DANGER_LASER };

/* A shape at the end of its move by (mx, my) in this frame. Lengths in px. */
struct danger {
    uint8_t shape, of;
    bool swept;    /* tested along its whole path; otherwise only where it ends */
    uint16_t age;  /* frames since the first move of a bullet or laser, at most 65535 */
    uint32_t slot; /* of the entity, which may have several shapes */
    fx x, y, mx, my, a, b, c, d, e;
};

/* The path of a ship in a frame. */
struct danger_way {
    fx was_x, was_y, x, y, radius;
};

/* The state and abilities of a player's ship. */
struct danger_ship {
    bool in;     /* it is in the game; if not, only `area` is set */
    bool steers; /* its buttons move it: it was not hit, no dialogue runs and the game is not frozen */
    bool hit;    /* it was hit, and a bomb can still save it */
    bool safe;   /* nothing can hit it */
    int32_t lives;
    struct danger_way way; /* in this frame */
    fx speed, focus;       /* px/frame */
    struct box area;       /* where it can be, edges included */
};

/* Calls `each` for every shape that could hit a player in this frame. */
void danger_each(const struct board *b, void (*each)(void *context, const struct danger *d), void *context);

/* Returns whether this shape would hit a ship on this path, as hit_run decides it. */
bool danger_touches(const struct danger *d, const struct danger_way *way);

/* Stores the state of the ship of player p, 0 or 1. */
void danger_ship(const struct board *b, int p, struct danger_ship *out);

/* Makes players invincible, as practice.invincible does, or vulnerable again; a restore also resets it. Scripts cannot
 * see it. */
void danger_spare(struct board *b, bool spared);

#endif
