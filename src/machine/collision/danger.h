/*
 * danger.h - the shapes that could hit a player in the current frame, with their moves, exactly as hit_run tests them,
 * and the state of a player's ship. For code that searches for a safe path.
 *
 * Call these functions at the end of PHASE_MOTION (board_set_phase_callback), when all entities have moved and no hit
 * has been detected yet. Only danger_set_invincible changes the board.
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
    /* a laser segment: all points within a of the line from (x, y) to (b, c). This frame's move of (b, c) is (d, e) */
    DANGER_LASER_SEGMENT
};

enum danger_source { DANGER_BULLET, DANGER_ENEMY, DANGER_LASER };

/* A shape at the end of its move by (mx, my) in this frame. Lengths in px. */
struct danger {
    uint8_t shape, source;
    bool swept;    /* tested along its whole path; otherwise only at its final position */
    uint16_t age;  /* frames since the first move of a bullet or laser, at most 65535 */
    uint32_t slot; /* of the entity; several shapes may belong to one entity */
    fx x, y, mx, my, a, b, c, d, e;
};

/* The path of a ship in a frame. */
struct danger_path {
    fx prev_x, prev_y, x, y, radius;
};

/* The state and abilities of a player's ship. */
struct danger_ship {
    bool in_game;   /* the ship is in the game; if not, only `area` is set */
    bool can_steer; /* the player can steer: the ship was not hit, no dialogue runs and the game is not frozen */
    bool is_hit;    /* the ship was hit, and a bomb can still save it */
    bool is_safe;   /* nothing can hit the ship */
    int32_t lives;
    struct danger_path path; /* path in this frame */
    fx speed, focused_speed; /* normal and focused speed, px/frame */
    struct box area;         /* where the ship can be, edges included */
};

/* Calls `each` for every shape that could hit a player in this frame. */
void danger_visit_shapes(const struct board *b, void (*each)(void *context, const struct danger *d), void *context);

/* Returns whether this shape would hit a ship on this path, by the test that hit_run uses. */
bool danger_would_hit(const struct danger *d, const struct danger_path *path);

/* Stores the state of the ship of player p, 0 or 1. */
void danger_get_ship(const struct board *b, int p, struct danger_ship *out);

/* Sets whether players are invincible, as practice.invincible does. A restore resets the setting. Scripts cannot read
 * it. */
void danger_set_invincible(struct board *b, bool invincible);

#endif
