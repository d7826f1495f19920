/*
 * options.h - options: what flies with a ship, each at its place beside it.
 */
#ifndef ENTITIES_OPTIONS_H
#define ENTITIES_OPTIONS_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum {
    MAX_OPTIONS = 256,
    OPTION_PLACES = 16, /* most of a ship */
    OPTION_LEVELS = 16,
    OPTION_WAY = 256, /* places of a ship that are kept, a power of two */

    OPTION_HIDDEN = 1 << 0
};

enum option_style { OPTION_FIXED, OPTION_TRAIL, OPTION_ORBIT };

struct option_level {
    int32_t at; /* of the register */
    uint32_t n;
    fx wide[OPTION_PLACES][2], close[OPTION_PLACES][2]; /* of OPTION_FIXED: px from the ship */
};

/* What player.def says of a kind of ship. */
struct option_plan {
    uint16_t kind;
    enum option_style style;
    int32_t by;      /* register, -1: none: the last level */
    uint32_t over;   /* frames to their places */
    uint32_t apart;  /* of OPTION_TRAIL: frames of flight between two */
    fx wide, close;  /* of OPTION_ORBIT: radius */
    ang spin;        /* a frame */
    uint32_t levels; /* ascending by `at` */
    struct option_level level[];
};

/* What option.def declares. */
struct option_kinds {
    struct slots s;
    uint16_t *sprite;
    uint8_t *bank, *layer;
};

struct options {
    struct slots s;
    fx *x, *y;
    fx *was_x, *was_y; /* before this frame's move */
    uint16_t *kind;
    uint8_t *player, *index; /* from 0 on */
    uint8_t *bank, *flags;   /* OPTION_ */
    uint32_t *born;          /* clock */
    /* Its place beside the ship: what it is, what it shall be, and in so many frames. px, or of OPTION_ORBIT radius and
     * angle. */
    int32_t *at, *to; /* 2 a slot */
    uint32_t *left;
};

/* Where the ships flew: one entry a player. */
struct option_ways {
    struct slots s;
    uint32_t *head; /* the last place, in x and y */
    fx *x, *y;      /* OPTION_WAY a player */
    ang *phase;
};

/* Where a ship is, and what its options follow. */
struct option_ship {
    const struct option_plan *plan;
    const struct option_level *level;
    fx x, y, was_x, was_y;
    bool focus;
};

extern const struct chip options_chip, option_kinds_chip, option_ways_chip;

/* The level at that value of the register; NULL: none yet. */
const struct option_level *options_level(const struct option_plan *plan, int64_t value);

/* Option `index` of player p begins, at the ship; NO_SLOT: there was no room. */
int32_t options_add(struct options *o, const struct option_kinds *kinds, uint16_t kind, uint32_t p, uint32_t index,
                    fx x, fx y, uint32_t clock);

/* Drops player p's from `index` on. */
void options_drop_of(struct options *o, uint32_t p, uint32_t index);

/* A frame's move of player p's, after the ship's. */
void options_move(struct options *o, struct option_ways *w, uint32_t p, const struct option_ship *ship);

#endif
