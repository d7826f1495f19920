/*
 * ase_sprite.h - makes sprites from Aseprite files: frames from tags, hit shapes and origin from slices.
 *
 * Slices count as they are in the sprite's first frame. The first word of a slice's name is its meaning:
 *
 *     hit       the largest circle in the rectangle; up to four of them together
 *     box       the whole rectangle
 *     capsule   the longest bar in it, with round ends
 *
 * A box and a capsule are centred on the origin, to half a pixel, because bullets and enemies have no others. The first
 * pivot of any slice is the origin, if rom.lua gives none. Other slices are ignored.
 */
#ifndef WORKBENCH_ASE_SPRITE_H
#define WORKBENCH_ASE_SPRITE_H

#include "../../rom/cart.h"
#include "ase.h"
#include "art.h"

/* The input of art_make_sprite: frames as a strip, all settings complete. */
struct ase_sprite {
    struct art_picture picture;
    struct art_sprite sprite;
    struct cart_hitbox hit; /* rows 0: none */
    uint16_t frames[CART_MAX_FRAMES];
};

/* Makes it (free picture with art_picture_free) for a sprite of rom.lua. A frame's time is counted in ticks, its
 * milliseconds * 60 / 1000 to the nearest and at least 1; frames of different times stand several times in the strip,
 * unless `every` is said in rom.lua. False and one sentence. */
bool ase_make_sprite(const struct ase *a, const struct art_sprite *asked, bool by_index, struct ase_sprite *out,
                     char *err, size_t err_size);

#endif
