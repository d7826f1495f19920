/*
 * vm_load.c - loads the scripts of a ROM: the game's and the standard library's. Reserves space in the Lua heap for the
 * lists that their declarations grow: kinds and motion programs.
 */
#include <stdio.h>
#include <string.h>
#include "../machine/machine.h"
#include "api/api_table.h"
#include "lua/lualib.h"
#include "script.h"
#include "std.h"
#include "vm.h"

/* Registry keys. modules_key: the table of require's results by script name; sys_key: the sys table. */
static const char modules_key = 0, sys_key = 0;

void vm_load_text(lua_State *L, const char *name, const char *text, size_t size)
{
    const char *message;
    int line;
    char chunk[160];

    if (!script_scan(text, size, &line, &message)) {
        lua_pushfstring(L, "%s.lua:%d: %s", name, line, message);
        lua_error(L);
    }
    snprintf(chunk, sizeof chunk, "@%s.lua", name);
    if (luaL_loadbufferx(L, text, size, chunk, "t") != LUA_OK)
        lua_error(L);
}

void vm_push_registry_table(lua_State *L, const void *key)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, key) == LUA_TTABLE)
        return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, key);
}

void vm_load_script(lua_State *L, const char *name)
{
    const struct cart *cart = &vm_board(L)->cart;
    const char *text;
    size_t size;
    char converted[SCRIPT_NAME_BYTES];

    if (!cart_find_script(cart, name, &text, &size)) {
        if (script_normalize_name(name, converted) && cart_find_script(cart, converted, &text, &size))
            vm_fault(L, FAULT_SCRIPT, "require: no script \"%s.lua\" in the game (did you mean require \"%s\"?)", name,
                     converted);
        vm_fault(L, FAULT_SCRIPT, "require: no script \"%s.lua\" in the game", name);
    }
    vm_load_text(L, name, text, size);
}

int vm_finish_require(lua_State *L, const char *name, int args)
{
    lua_call(L, args, 1);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    lua_pushvalue(L, -1);
    lua_setfield(L, 2, name);
    return 1;
}

int vm_require(lua_State *L)
{
    struct board *b = vm_board(L);
    const char *name = luaL_checkstring(L, 1);

    lua_settop(L, 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
    if (lua_getfield(L, 2, name) != LUA_TNIL) {
        if (lua_type(L, -1) == LUA_TLIGHTUSERDATA)
            return vm_fault(L, FAULT_SCRIPT, "require: \"%s\" requires itself", name);
        return 1;
    }
    if (!b->vm.loading)
        return vm_fault(L, FAULT_SCRIPT, "require: \"%s\" is not loaded; scripts can only be loaded at startup", name);
    lua_pushlightuserdata(L, b);
    lua_setfield(L, 2, name);
    vm_load_script(L, name);
    lua_pushvalue(L, 1);
    return vm_finish_require(L, name, 1);
}

void vm_run_library_file(lua_State *L, const char *name)
{
    char path[64];
    const char *text;
    size_t size;

    snprintf(path, sizeof path, "@std/%s", name);
    if (!cart_find_script(&vm_board(L)->cart, path, &text, &size))
        vm_fault(L, FAULT_SCRIPT, "sys.read: no library file \"%s\" in this ROM", name);
    vm_charge(L, size);
    vm_load_script(L, path);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &sys_key);
    lua_call(L, 1, 1);
}

void vm_load_std(lua_State *L, int i, int sys)
{
    const char *name = std_modules[i].name;
    char path[64];
    const char *text;
    size_t size;

    snprintf(path, sizeof path, "@std/%s", name);
    if (!cart_find_script(&vm_board(L)->cart, path, &text, &size))
        return;
    if (std_modules[i].extended_table &&
        api_disabled_reason(&vm_board(L)->cart.manifest, std_modules[i].extended_table))
        return;
    vm_load_script(L, path);
    snprintf(path, sizeof path, "@@std/%s.lua", name);
    lualib_strip_locals(L, path);
    lua_pushvalue(L, sys);
    lua_call(L, 1, 1);
    lua_pushglobaltable(L);
    if (!strcmp(name, "prelude")) {
        if (!lua_istable(L, -2))
            vm_fault(L, FAULT_SCRIPT, "%s.lua: expected the script to return a table of functions", path);
        lua_pushnil(L);
        while (lua_next(L, -3)) {
            lua_pushvalue(L, -2);
            lua_insert(L, -2);
            lua_rawset(L, -4);
        }
    } else {
        lua_pushvalue(L, -2);
        lua_setfield(L, -2, name);
    }
    lua_pop(L, 2);
}

void vm_open_scripts(lua_State *L, int sys)
{
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
    lua_pushvalue(L, sys);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &sys_key);
}

/* ---- lists that grow ---- */

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
