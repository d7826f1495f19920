/*
 * api_open.c - the globals of the API: its tables, whose functions are created when a script first reads their
 * names.
 */
#include <stdio.h>
#include <string.h>
#include "api_parts.h"

/* The __index of the API's tables; not called for fields that the game has set. */
static int read_missing_field(lua_State *L)
{
    const char *table_name = api_push_namespace_name(L, 1);

    if (!table_name || lua_type(L, 2) != LUA_TSTRING)
        return 0;
    if (!api_push_member(L, table_name, '.', lua_tostring(L, 2))) {
        api_fault_missing_field(L, table_name, lua_tostring(L, 2));
        return 0;
    }
    lua_pushvalue(L, 2);
    lua_pushvalue(L, -2);
    lua_rawset(L, 1);
    return 1;
}

/* Returns whether the API table is created on first use, because few games use it. */
static bool is_lazy_table(const char *table_name)
{
    return !strcmp(table_name, "bomb");
}

static void make_namespace(lua_State *L, const char *table_name)
{
    lua_newtable(L);
    api_add_namespace(L, table_name);
    lua_pushglobaltable(L);
    lua_pushvalue(L, -2);
    lua_pushstring(L, table_name);
    lua_insert(L, -2);
    lua_rawset(L, -3);
    lua_pop(L, 1);
}

bool api_push_lazy_table(lua_State *L, const char *name)
{
    if (!is_lazy_table(name))
        return false;
    make_namespace(L, name);
    return true;
}

/* Makes an entry available to scripts: "wait" becomes a global; for "bullet.fire", creates the global table bullet,
 * unless that table is disabled or created on first use. */
static void install_entry(lua_State *L, const struct api_entry *e)
{
    const char *separator = strpbrk(e->name, ".:");
    char table_name[32];
    const int top = lua_gettop(L);

    if (!vm_board(L)->lasers.s.cap && !strncmp(e->name, "laser", 5))
        return;
    if (!separator) {
        api_push_function(L, e);
        lua_setglobal(L, e->name);
    } else if (*separator == '.' && !(e->flags & API_SYS)) {
        snprintf(table_name, sizeof table_name, "%.*s", (int)(separator - e->name), e->name);
        if (api_disabled_reason(&vm_board(L)->cart.manifest, table_name) || is_lazy_table(table_name))
            return;
        if (lua_getglobal(L, table_name) != LUA_TTABLE)
            make_namespace(L, table_name);
        lua_settop(L, top);
    }
}

void api_open_globals(lua_State *L)
{
    api_open_names(L);
    api_open_handles(L);
    api_create_namespace_metatable(L, read_missing_field);
    lua_pushinteger(L, LUA_MAXINTEGER);
    lua_setglobal(L, "forever");
    lua_newtable(L);
    api_add_namespace(L, "sys");
    int sys = lua_gettop(L);
    for (int m = 0; m < api_get_table(L)->n; m++)
        for (int i = 0; i < api_get_table(L)->modules[m]->n; i++)
            if (!(api_get_table(L)->modules[m]->entries[i].flags & API_LUA))
                install_entry(L, &api_get_table(L)->modules[m]->entries[i]);
    lua_pushcfunction(L, api_sys_check);
    lua_setfield(L, sys, "check");
    if (vm_board(L)->camera.s.live) {
        lua_pushinteger(L, handle_make(H_CAMERA, 1, 0));
        lua_setglobal(L, "camera");
    }
    api_open_rom(L);
    lua_settop(L, sys);
}
