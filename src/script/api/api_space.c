/*
 * api_space.c - the registry of the API's tables ("bullet", "sys"), and creating all functions of a table.
 */
#include "api_parts.h"

/* Registry: the metatable of the API's tables; and table -> name. */
static const char metatable_key = 0, namespaces_key = 0;

/* Returns NULL in a Lua state without the API, as in some tests. */
const char *api_push_namespace_name(lua_State *L, int at)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &namespaces_key) != LUA_TTABLE)
        return NULL;
    lua_pushvalue(L, at);
    lua_rawget(L, -2);
    lua_remove(L, -2);
    return lua_tostring(L, -1);
}

void api_fill_table(lua_State *L, int at)
{
    int top = lua_gettop(L);
    const char *table_name = api_push_namespace_name(L, at), *member;

    for (int i = 0; table_name && i < api_count_entries(api_get_table(L)); i++)
        if ((member = api_member_name(api_get_entry(api_get_table(L), i), table_name, '.')) != NULL &&
            !api_disabled_reason(&vm_board(L)->cart.manifest, api_get_entry(api_get_table(L), i)->name)) {
            lua_getfield(L, at, member);
            lua_pop(L, 1);
        }
    lua_settop(L, top);
}

void api_add_namespace(lua_State *L, const char *name)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &namespaces_key);
    lua_pushvalue(L, -2);
    lua_pushstring(L, name);
    lua_rawset(L, -3);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &metatable_key);
    lua_setmetatable(L, -3);
    lua_pop(L, 1);
}

void api_create_namespace_metatable(lua_State *L, lua_CFunction on_missing)
{
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &namespaces_key);
    lua_createtable(L, 0, 2);
    lua_pushcfunction(L, on_missing);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_rawsetp(L, LUA_REGISTRYINDEX, &metatable_key);
}
