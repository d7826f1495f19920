/*
 * sprites.c - free sprites (sprites.h). Sprites do not move by themselves; this chip only stores them.
 */
#include "sprites.h"
#include "motion.h"

static const struct column columns[] = {
    COLUMN(sprites, x),
    COLUMN(sprites, y),
    COLUMN(sprites, sprite),
    COLUMN(sprites, bank),
    COLUMN(sprites, layer),
    COLUMN(sprites, flags),
    COLUMN(sprites, born),
    COLUMN(sprites, owner),
    DERIVED_REGISTER(sprites, n_following,
                     "an upper bound for the number of sprites that follow a thing, computed from flags"),
    GROUP_COLUMN(sprites, dir, GROUP_TRANSFORMS),
    GROUP_COLUMN(sprites, scale, GROUP_TRANSFORMS),
    GROUP_COLUMN(sprites, alpha, GROUP_TRANSFORMS),
    GROUP_COLUMN(sprites, prev_x, GROUP_TRANSFORMS),
    GROUP_COLUMN(sprites, prev_y, GROUP_TRANSFORMS),
    DERIVED_REGISTER(sprites, n_turning, "an upper bound for the number of sprites that turn, computed from alpha"),
};

const struct chip sprites_chip = { .name = "sprites", CHIP_COLUMNS(columns) };
