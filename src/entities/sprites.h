/*
 * sprites.h - free sprites: pictures that scripts place themselves.
 */
#ifndef ENTITIES_SPRITES_H
#define ENTITIES_SPRITES_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    LAYER_BACK,   /* below everything */
    LAYER_MIDDLE, /* above enemies and shots, below players and bullets */
    LAYER_FRONT,  /* above everything except text */
    LAYER_OVER,   /* above the dimmed picture and its plates, below text */
    SPRITE_LAYER_COUNT,
    LAYER_PLATE = SPRITE_LAYER_COUNT, /* a plate, which has no picture: below LAYER_OVER */
    LAYER_PLATE_FRONT,                /* above LAYER_OVER */

    SPRITE_FLIP_X = 1 << 0, /* same value as BLIT_FLIP_X */
    SPRITE_FLIP_Y = 1 << 1,
    SPRITE_HIDDEN = 1 << 2,
    SPRITE_SCREEN = 1 << 3, /* placed on the screen instead of the field */
    SPRITE_BLEND = 3 << 4,  /* blend mode in units of SPRITE_BLEND_ONE: 0 opaque, otherwise blend + 1 */
    SPRITE_BLEND_ONE = 1 << 4,
    SPRITE_FOLLOW = 3 << 6, /* what the sprite follows, in units of SPRITE_FOLLOW_ONE: 0 nothing; otherwise x and y are
                             * the offset from its owner (1), player 1 (2) or player 2 (3) */
    SPRITE_FOLLOW_ONE = 1 << 6,
    FOLLOW_OWNER = 1,
    FOLLOW_PLAYER = 2, /* + the player's index */

    SPRITE_ALPHA = 15,    /* in the column `alpha`: 0 to ALPHA_OPAQUE (motion.h) */
    SPRITE_TURNS = 1 << 4 /* in the column `alpha`: `dir` follows the sprite's moves */
};

struct sprites {
    struct slots s;
    fx *x, *y;
    uint16_t *sprite; /* of a plate: its width, px */
    uint8_t *bank;
    uint8_t *layer;
    uint8_t *flags;
    uint32_t *born;       /* clock at spawn; of a plate: its height, px */
    int64_t *owner;       /* entity or scope it despawns with, defined by the board; 0: none */
    uint32_t n_following; /* upper bound for the number of sprites that follow something; 0: none does */

    /* All NULL if not enabled. */
    ang *dir;            /* the picture's direction */
    uint8_t *scale;      /* SCALE_MIN to SCALE_MAX (motion.h) */
    uint8_t *alpha;      /* SPRITE_ALPHA and SPRITE_TURNS */
    fx *prev_x, *prev_y; /* with SPRITE_TURNS: position at the end of the previous frame, in the field or screen */
    uint32_t n_turning;  /* upper bound for the number of sprites with SPRITE_TURNS; 0: none turns */
};

extern const struct chip sprites_chip;

#endif
