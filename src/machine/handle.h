/*
 * handle.h - handles: the integers by which scripts refer to entities, tasks, groups and other objects. Bits 63..62 are
 * 01, followed by 30 bits of generation, 8 bits of kind and 24 bits of slot. A handle is dead when its generation
 * differs from its slot's.
 */
#ifndef MACHINE_HANDLE_H
#define MACHINE_HANDLE_H

#include <stdbool.h>
#include <stdint.h>
#include "../base/slots.h"

/* H_GROUP (bullets), H_SHOTS, H_ENEMIES, H_ITEMS and H_LASERS are groups; their slot field holds the tag of the
 * group's members, 0: all entities of the pool. */
enum handle_kind {
    H_BULLET = 1,
    H_SHOT,
    H_ENEMY,
    H_PLAYER,
    H_SPRITE,
    H_TASK,
    H_MOTION,
    H_GROUP,
    H_SHOTS,
    H_ENEMIES,
    H_ITEM,
    H_ITEMS,
    H_LINE,
    H_LAYER, /* a background layer; the slot is a slot of struct bg */
    H_PLANE,
    H_LASER,
    H_LASERS,
    H_OPTION,
    H_BULLETML,
    H_MOVE,   /* a movement of an enemy; the generation is the enemy's `move_serial` */
    H_CAMERA, /* the board's camera; the slot is 0 */
    HANDLE_KINDS
};

static inline int64_t handle_make(enum handle_kind kind, uint32_t gen, uint32_t slot)
{
    return (int64_t)(1ull << 62 | (uint64_t)gen << 32 | (uint64_t)kind << 24 | slot);
}

static inline bool handle_is_well_formed(int64_t h)
{
    return (uint64_t)h >> 62 == 1 && (h >> 24 & 255) >= 1 && (h >> 24 & 255) < HANDLE_KINDS;
}

static inline enum handle_kind handle_kind(int64_t h)
{
    return (enum handle_kind)(h >> 24 & 255);
}

static inline bool handle_kind_is_group(enum handle_kind kind)
{
    const unsigned groups = 1u << H_GROUP | 1u << H_SHOTS | 1u << H_ENEMIES | 1u << H_ITEMS | 1u << H_LASERS;

    return groups >> kind & 1;
}

static inline uint32_t handle_gen(int64_t h)
{
    return (uint32_t)(h >> 32) & RETIRED_GENERATION;
}

static inline uint32_t handle_slot(int64_t h)
{
    return (uint32_t)h & 0xffffff;
}

#endif
