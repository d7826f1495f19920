/*
 * lasers.h - lasers: beams, which stay in place; bolts, which fly; and curves, whose bodies follow the path of a head.
 *
 * A laser has a head: a bullet with position, speed and program, in the same slot of a separate pool. A beam starts at
 * its head; bolts and curves follow theirs. A curve stores the head's position after each of the last frames in a ring
 * of points. Rings are made of chunks from a pool, because curves have different lengths.
 */
#ifndef ENTITIES_LASERS_H
#define ENTITIES_LASERS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "../base/trig.h"
#include "motion.h"
#include "../base/slots.h"

enum laser_form { LASER_BEAM, LASER_BOLT, LASER_CURVE };

/* The states as scripts see them. Lasers are harmless in LASER_WARN and LASER_FADE. */
enum laser_state { LASER_WARN, LASER_GROW, LASER_ON, LASER_FADE, LASER_STATES };

enum {
    LASER_FIXED = 1 << 0,        /* of a kind: immune to clears, unless a clear has `all` */
    LASER_HITS_ENEMIES = 1 << 1, /* of a kind: a player's laser, which hits enemies, not players */
    LASER_BLEND = 3 << 2,        /* of a kind: blend mode in units of LASER_BLEND_ONE: 0 opaque, otherwise blend + 1 */
    LASER_BLEND_ONE = 1 << 2,

    /* in the column `flags` of lasers */
    LASER_HEAD_OUTSIDE = 1 << 0, /* the curve's head has left the keep box and stopped; the body catches up */
    LASER_DESPAWNING = 1 << 1,   /* despawns at the end of this frame */
    LASER_UNSWEPT = 1 << 2,      /* not swept this frame: the laser is frozen, jumped, or is a beam that has just become
                            * dangerous */
    LASER_TURNS = 1 << 3,        /* rotates with the entity it follows */
    LASER_HAS_TARGET_DIR = 1 << 4, /* `target_dir` is set */

    LASER_CHUNK_POINTS = 32, /* points per chunk */
    LASER_MAX_CHUNKS = 8,    /* maximum chunks of a curve */
    LASER_MAX_POINTS = LASER_CHUNK_POINTS * LASER_MAX_CHUNKS,
    LASER_MAX_SIZE = 4096, /* px; maximum length and width */
    LASER_FOREVER = -1,
    MAX_LASERS = 4096,
    MAX_LASER_KINDS = 256
};

/* Declared by laser.def. */
struct laser_kinds {
    struct slots s;
    uint16_t *strip;
    uint16_t *head_sprite, *tail_sprite; /* sprite + 1; 0: none */
    fx *width;                           /* px */
    fx *hit_share;                       /* share of the width that hits, 0 to 1; negative: it never hits */
    uint8_t *bank;
    uint8_t *flags;
    uint16_t *graze_interval; /* frames between two grazes; 0: no grazing */
    uint16_t *hit_interval;   /* frames between two hits of a player's laser */
    int32_t *damage;
    uint16_t *vanish_spark; /* spark kind + 1 that a clear leaves; 0: none */
};

struct lasers {
    struct slots s;
    uint8_t *form, *flags;
    fx *x0, *y0;           /* beams and bolts: the end opposite the head; curves: the tail before this frame's move */
    fx *prev_x, *prev_y;   /* the head before this frame's move */
    fx *prev_x0, *prev_y0; /* beams and bolts: the other end before this frame's move */
    fx *length;            /* px; beams and bolts */
    fx *grown_length;      /* bolts: px that have emerged */
    fx *width;             /* px */
    ang *spin;             /* rotation per frame, once the laser is dangerous */
    int32_t *warn_frames, *grow_frames, *fade_frames; /* frames */
    int32_t *fade_age;                                /* age at which it starts to fade, or LASER_FOREVER */
    int64_t *follow_target;                           /* entity it follows, defined by the board; 0: none */
    fx *dx, *dy;                                      /* offset from that entity */
    ang *target_dir;                                  /* direction in which that entity last faced */
    uint32_t *rehit_clock;  /* MAX_PLAYERS per laser: clock from which that player can graze it again; in a player's
                                  * laser, the first entry is the clock from which it can hit again */
    uint16_t *max_points;   /* curves: capacity of the ring, in points */
    uint16_t *n_points;     /* number of points in the ring */
    uint16_t *newest_point; /* ring index of the newest point */
    uint16_t *chunk;        /* LASER_MAX_CHUNKS per laser: slots of its chunks */
};

/* The chunks that hold the curves' points. */
struct laser_points {
    struct slots s;
    fx *x, *y; /* LASER_CHUNK_POINTS per chunk */
};

extern const struct chip lasers_chip, laser_kinds_chip, laser_points_chip;

/* Everything about a new laser except its ends. */
struct laser_spec {
    enum laser_form form;
    uint8_t flags;
    uint16_t max_points;
    fx length, width, dx, dy;
    ang spin;
    int32_t warn_frames, grow_frames, hold_frames, fade_frames; /* frames; hold may be LASER_FOREVER */
    int64_t follow_target;
};

/* Spawns a laser in the lowest free slot, with both ends, or all points of a curve, at (x, y). Returns the slot, or
 * NO_SLOT when a pool is full; *full_pool then points to the slots of that pool (lasers or points). */
int32_t lasers_add(struct lasers *l, struct laser_points *p, const struct laser_spec *spec, fx x, fx y,
                   struct slots **full_pool);
void lasers_drop(struct lasers *l, struct laser_points *p, uint32_t i);

/* Gets point k of curve i, 0 <= k < n_points; point 0 is the newest. */
static inline void lasers_get_point(const struct lasers *l, const struct laser_points *p, uint32_t i, uint32_t k, fx *x,
                                    fx *y)
{
    uint32_t at = l->newest_point[i] >= k ? l->newest_point[i] - k : l->newest_point[i] + l->max_points[i] - k;
    uint32_t entry = l->chunk[i * LASER_MAX_CHUNKS + at / LASER_CHUNK_POINTS] * (uint32_t)LASER_CHUNK_POINTS +
                     at % LASER_CHUNK_POINTS;

    *x = p->x[entry];
    *y = p->y[entry];
}

/* Gets the smallest box around a curve's points and the position of its tail before this frame's move. */
void lasers_get_box(const struct lasers *l, const struct laser_points *p, uint32_t i, struct box *box);

/* Adds the head's new position (x, y) to a curve. */
void lasers_advance(struct lasers *l, struct laser_points *p, uint32_t i, fx x, fx y);

/* Moves a curve's points by (dx, dy), clamped to the world. */
void lasers_shift(struct lasers *l, struct laser_points *p, uint32_t i, fx dx, fx dy);

/* Returns the state of laser i at the given age in frames. */
enum laser_state lasers_state(const struct lasers *l, uint32_t i, uint32_t age);

/* Returns the width of laser i at the given age as drawn, in px. */
fx lasers_width(const struct lasers *l, uint32_t i, uint32_t age);

/* Returns whether laser i has faded out at the given age. */
bool lasers_has_faded(const struct lasers *l, uint32_t i, uint32_t age);

/* Makes laser i fade from the given age on, unless it is fading already. */
void lasers_fade(struct lasers *l, uint32_t i, uint32_t age);

#endif
