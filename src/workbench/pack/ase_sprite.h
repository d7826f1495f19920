/*
 * ase_sprite.h - makes sprites from Aseprite files: frames from tags, hit shapes and origin from slices.
 *
 * Slices are used as they are in the sprite's first frame. The first word of a slice's name is its meaning:
 *
 *  hit       the largest circle in the rectangle; up to four of them together
 *  box       the whole rectangle
 *  capsule   the longest capsule in the rectangle
 *
 * A box or a capsule must be centred on the origin, to half a pixel, because bullets and enemies have no others. If
 * rom.lua has no origin, it is the first pivot of any slice. Other slices are ignored.
 */
#ifndef WORKBENCH_ASE_SPRITE_H
#define WORKBENCH_ASE_SPRITE_H

#include "../../rom/cart.h"
#include "ase.h"
#include "art.h"

/* The input of art_make_sprite: a strip of frames, and a sprite with all settings filled in. */
struct ase_sprite {
    struct art_picture picture;
    struct art_sprite sprite;
    struct cart_hitbox hit; /* rows 0: none */
    uint16_t frames[CART_MAX_FRAMES];
};

/* Makes the strip for a sprite of rom.lua; free out->picture with art_picture_free. A frame lasts its milliseconds * 60
 * / 1000 ticks, rounded, at least 1. If frames have different durations and rom.lua has no `every`, frames are repeated
 * in the strip. */
bool ase_make_sprite(const struct ase *a, const struct art_sprite *asked, bool by_index, struct ase_sprite *out,
                     char *err, size_t err_size);

#endif
