/*
 * options.h - options: satellites that fly with a ship, each at its own position.
 */
#ifndef ENTITIES_OPTIONS_H
#define ENTITIES_OPTIONS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    MAX_OPTIONS = 256,
    OPTION_MAX_PER_SHIP = 16, /* maximum per ship */
    OPTION_MAX_LEVELS = 16,
    OPTION_PATH_LENGTH = 256, /* positions stored per ship; a power of two */

    OPTION_HIDDEN = 1 << 0,

    OPTION_LAYER = 7,     /* in the kinds' column `layer`: the sprite layer */
    OPTION_TURNS = 1 << 3 /* in the kinds' column `layer`: `dir` follows the option's moves */
};

enum option_style { OPTION_FIXED, OPTION_TRAIL, OPTION_ORBIT };

struct option_level {
    int32_t min_value; /* value of the register from which this level applies */
    uint32_t n;
    fx unfocused_offset[OPTION_MAX_PER_SHIP][2],
        focused_offset[OPTION_MAX_PER_SHIP][2]; /* OPTION_FIXED: px from the ship, unfocused and focused */
};

/* The options of a kind of ship, from player.def. */
struct option_plan {
    uint16_t kind;
    enum option_style style;
    int32_t level_register;              /* register that selects the level; -1: none, always the last level */
    uint32_t move_duration;              /* frames to reach a new position */
    uint32_t spacing;                    /* OPTION_TRAIL: frames of flight between two options */
    fx unfocused_offset, focused_offset; /* OPTION_ORBIT: radius, unfocused and focused */
    ang spin;                            /* rotation per frame */
    uint32_t n_levels;                   /* number of levels; they are sorted by `min_value`, ascending */
    struct option_level level[];
};

/* Declared by option.def. */
struct option_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *bank, *layer; /* layer: OPTION_LAYER and OPTION_TURNS */
};

struct options {
    struct slots s;
    fx *x, *y;
    fx *prev_x, *prev_y; /* position before this frame's move */
    uint16_t *kind;
    uint8_t *player, *index; /* 0-based */
    uint8_t *bank, *flags;   /* flags: OPTION_ */
    uint32_t *born;          /* clock at spawn */
    /* Position relative to the ship: current, target, and frames left to reach the target. In px; with OPTION_ORBIT, a
     * radius and an angle. */
    int32_t *offset, *target_offset; /* 2 per slot */
    uint32_t *frames_left;
    ang *dir; /* the picture's direction; NULL: not enabled */
};

/* The paths of the ships: one entry per player. */
struct option_paths {
    struct slots s;
    uint32_t *head; /* index of the newest position in x and y */
    fx *x, *y;      /* OPTION_PATH_LENGTH per player */
    ang *phase;
};

/* A ship's position, and what its options need to follow it. */
struct option_ship {
    const struct option_plan *plan;
    const struct option_level *level;
    fx x, y, prev_x, prev_y;
    bool is_focused;
};

extern const struct chip options_chip, option_kinds_chip, option_paths_chip;

/* Returns the level that applies at a register value, or NULL when the value is below the first level's. */
const struct option_level *options_level(const struct option_plan *plan, int64_t value);

/* Spawns option `index` of player p at the ship; returns its slot, or NO_SLOT when the pool is full. */
int32_t options_add(struct options *o, const struct option_kinds *kinds, uint16_t kind, uint32_t p, uint32_t index,
                    fx x, fx y, uint32_t clock);

/* Despawns player p's options whose index is `index` or higher. */
void options_drop_from(struct options *o, uint32_t p, uint32_t index);

/* Moves player p's options by one frame, after the ship has moved. */
void options_move(struct options *o, struct option_paths *w, uint32_t p, const struct option_ship *ship);

/* Turns the options of kinds with OPTION_TURNS into the direction of the last move, unless they stood still. Requires
 * GROUP_TRANSFORMS. */
void options_turn(struct options *o, const struct option_kinds *kinds);

#endif
