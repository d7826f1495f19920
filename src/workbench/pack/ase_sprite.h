/*
 * ase_sprite.h - what a game's sprite is in a file of Aseprite's: a tag its frames, slices its hit shape and origin.
 *
 * Slices are looked at as they are in the sprite's first frame. The first word of a slice's name says what it is:
 *
 *     hit       the largest circle in the rectangle; up to four of them together
 *     box       the whole rectangle
 *     capsule   the longest bar in it, with round ends
 *
 * A box and a capsule lie about the origin, to half a pixel: bullets and enemies have no others. The first pivot of any
 * slice is the origin, if rom.lua gives none. Slices of other names are somebody else's.
 */
#ifndef WORKBENCH_ASE_SPRITE_H
#define WORKBENCH_ASE_SPRITE_H

#include "../../rom/cart.h"
#include "ase.h"
#include "art.h"

/* A sprite as art_make_sprite takes it: its frames as a strip, and nothing in it left to be looked up. */
struct ase_sprite {
    struct art_picture picture;
    struct art_sprite sprite;
    struct cart_hitbox hit; /* rows 0: none was drawn */
    uint16_t frames[CART_MAX_FRAMES];
};

/* Makes it (free picture with art_picture_free) for a sprite of rom.lua. A frame's time is counted in ticks, its
 * milliseconds * 60 / 1000 to the nearest and at least 1; frames of different times stand several times in the strip,
 * unless `every` is said in rom.lua. False and one sentence. */
bool ase_make_sprite(const struct ase *a, const struct art_sprite *asked, bool by_index, struct ase_sprite *out,
                     char *err, size_t err_size);

#endif
