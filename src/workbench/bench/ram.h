/*
 * ram.h - the RAM that a game needs, by entry of rom.lua.
 */
#ifndef WORKBENCH_RAM_H
#define WORKBENCH_RAM_H

#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

enum { RAM_MAX_PARTS = 24, RAM_TEXT_SIZE = 512 };

/* The RAM for a capacity in `board` of rom.lua ("bullets"); for the picture, for drawing it, for the sound tables; or
 * for everything else ("other"). */
struct ram_part {
    const char *name;
    uint64_t bytes;
};

/* Stores the parts, the largest first and without empty ones, and returns how many. *sum: the RAM of the game: its
 * board, picture and sound. The memory for the events that an entity may raise belongs to the entity's capacity. */
int ram_parts(const struct cart *cart, struct ram_part out[RAM_MAX_PARTS], uint64_t *sum);

/* Writes "RAM 2466 KiB: lua_kib 1024, bullets 927, ...": the sum, and the parts of at least a KiB. */
void ram_describe(const struct cart *cart, char text[RAM_TEXT_SIZE]);

/* Returns the board.lua_kib that is enough for runs that used at most `peak` bytes of Lua memory at a time. It is
 * three quarters more, because Lua collects garbage later when it has more memory, and cannot use every gap between
 * blocks. */
int32_t ram_enough_lua_kib(size_t peak);

#endif
