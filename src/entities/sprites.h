/*
 * sprites.h - free sprites: pictures a script places by hand.
 */
#ifndef ENTITIES_SPRITES_H
#define ENTITIES_SPRITES_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    LAYER_BACK,   /* under everything */
    LAYER_MIDDLE, /* over enemies and shots, under players and bullets */
    LAYER_FRONT,  /* over everything but the text */
    LAYER_OVER,   /* over a dimmed picture and the plates on it, under the text */
    LAYERS,
    LAYER_PLATE = LAYERS, /* a plate, which has no picture: under the layer over */
    LAYER_PLATE_FRONT,    /* over that */

    SPRITE_FLIP_X = 1 << 0, /* as BLIT_FLIP_X */
    SPRITE_FLIP_Y = 1 << 1,
    SPRITE_HIDDEN = 1 << 2,
    SPRITE_SCREEN = 1 << 3, /* placed on the screen instead of the field */
    SPRITE_BLEND = 3 << 4,  /* how it is drawn, in units of SPRITE_BLEND_ONE: 0 opaque, else blend + 1 */
    SPRITE_BLEND_ONE = 1 << 4,
    SPRITE_FOLLOW = 3 << 6, /* what it follows, in units of SPRITE_FOLLOW_ONE: 0 nothing, else x and y are the distance
                               from its owner (1), or from player 1 (2) or 2 (3) */
    SPRITE_FOLLOW_ONE = 1 << 6,
    FOLLOW_OWNER = 1,
    FOLLOW_PLAYER = 2 /* + the player's index */
};

struct sprites {
    struct slots s;
    fx *x, *y;
    uint16_t *sprite; /* of a plate: its width, px */
    uint8_t *bank;
    uint8_t *layer;
    uint8_t *flags;
    uint32_t *born;     /* clock; of a plate: its height, px */
    int64_t *owner;     /* it goes when that one ends, 0: none; the board gives it a meaning */
    uint32_t following; /* 0: none follows anything */
};

extern const struct chip sprites_chip;

/* Removes what has that owner. */
void sprites_drop_of(struct sprites *s, int64_t owner);

#endif
