/*
 * vm_reserve.c - lists that grow in the Lua heap: kinds and motion programs.
 */
#include <string.h>
#include "../machine/machine.h"
#include "vm.h"

enum { MIN_RESERVED = 16 /* entries of a growing list when the first is added */ };

void vm_reserve(lua_State *L, struct slots *list, uint32_t n)
{
    struct board *b = vm_board(L);
    uint32_t reserved = list->reserved ? list->reserved : MIN_RESERVED;
    int part = 0;

    while (reserved < list->live + n)
        reserved *= 2;
    reserved = reserved < list->cap ? reserved : list->cap;
    if (reserved == list->reserved)
        return;
    while (part_of(b, part) != (void *)list)
        part++;
    const size_t size = (size_t)slots_size(machine_parts[part].chip, reserved, list->groups);
    luaL_checkstack(L, 2, NULL);
    slots_move(machine_parts[part].chip, list, reserved, memset(lua_newuserdatauv(L, size, 0), 0, size));
    lua_rawsetp(L, LUA_REGISTRYINDEX, &machine_parts[part]); /* keeps the memory alive */
    b->bullets.kind_counts = b->bullet_kinds.live_count;
    b->shots.kind_counts = b->shot_kinds.live_count;
}
