/*
 * ram.h - the RAM that a game needs, by entry of rom.lua.
 */
#ifndef WORKBENCH_RAM_H
#define WORKBENCH_RAM_H

#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

enum { RAM_MAX_PARTS = 24, RAM_TEXT_SIZE = 512 };

/* The RAM for a capacity in `board` of rom.lua ("bullets"), for the picture, for drawing it, for the sound tables, or
 * for everything else ("other"). */
struct ram_part {
    const char *name;
    uint64_t bytes;
};

/* Stores the parts that are not empty, the largest first, and returns how many. *sum: the RAM of the game's board,
 * picture and sound. Memory for the events of an entity is counted for the entity's capacity. */
int ram_parts(const struct cart *cart, struct ram_part out[RAM_MAX_PARTS], uint64_t *sum);

/* Writes "RAM 2466 KiB: lua_kib 1024, bullets 927, ...": the sum and all parts of at least a KiB. */
void ram_describe(const struct cart *cart, char text[RAM_TEXT_SIZE]);

/* Returns a board.lua_kib for runs that used at most `peak` bytes of Lua memory at a time: three quarters more, because
 * Lua collects garbage later when it has more memory, and cannot use every gap between blocks. */
int32_t ram_enough_lua_kib(size_t peak);

#endif
