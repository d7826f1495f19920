/*
 * luakeys.c - see luakeys.h.
 */
#include "luakeys.h"
#include <lauxlib.h>
#include <string.h>

const char *luakeys_text(lua_State *L, int at)
{
    size_t n;

    if (lua_type(L, at) != LUA_TSTRING)
        return NULL;
    const char *key = lua_tolstring(L, at, &n);
    return strlen(key) == n ? key : NULL;
}

static int rank_of(lua_State *L, int at)
{
    const int type = lua_type(L, at);

    switch (type) {
    case LUA_TNUMBER:
        return 0;
    case LUA_TBOOLEAN:
        return 1 + lua_toboolean(L, at);
    case LUA_TSTRING:
        return 3 + LUA_NUMTYPES;
    default:
        return 3 + type;
    }
}

/* Compares the keys at a and b. Returns less than 0 if a comes first, 0 if they are equal or have no defined order. */
static int compare(lua_State *L, int a, int b)
{
    const int rank = rank_of(L, a), order = rank - rank_of(L, b);
    size_t n, m;

    if (order || (rank && lua_type(L, a) != LUA_TSTRING))
        return order;
    if (!rank)
        return lua_compare(L, b, a, LUA_OPLT) - lua_compare(L, a, b, LUA_OPLT);
    const char *s = lua_tolstring(L, a, &n), *t = lua_tolstring(L, b, &m);
    const int difference = memcmp(s, t, n < m ? n : m);
    return difference ? difference : (n > m) - (n < m);
}

int luakeys_next(lua_State *L, int at)
{
    const int last = lua_gettop(L), next = last + 1;
    int ties = 0;

    luaL_checkstack(L, 8, NULL);
    lua_pushnil(L);
    for (lua_pushnil(L); lua_next(L, at);) {
        lua_pop(L, 1);
        if (!lua_isnil(L, last) && compare(L, next + 1, last) <= 0)
            continue;
        const int order = ties ? compare(L, next + 1, next) : -1;
        if (order < 0) {
            lua_pushvalue(L, -1);
            lua_replace(L, next);
        }
        ties = order < 0 ? 1 : ties + (order == 0);
    }
    lua_replace(L, last);
    if (!ties)
        lua_pop(L, 1);
    return ties;
}

int luakeys_return(lua_State *L, int n)
{
    enum { WALK_SLOTS = 4 /* slots that a walk uses above the top */ };
    const int top = lua_gettop(L), used = top + WALK_SLOTS > LUA_MINSTACK ? top + WALK_SLOTS : LUA_MINSTACK;

    lua_checkstack(L, WALK_SLOTS);
    for (int i = 1; top > n && i <= n; i++)
        lua_copy(L, top - n + i, i);
    lua_settop(L, n);
    lua_settop(L, used);
    lua_settop(L, n);
    return n;
}

void luakeys_push_value(lua_State *L, int at, int ties)
{
    lua_pushvalue(L, -1);
    lua_rawget(L, at);
    if (ties > 1) {
        lua_pop(L, 1);
        lua_pushliteral(L, "...");
    }
}

bool luakeys_push_unknown(lua_State *L, int at, luakeys_is_known *is_known, const void *context)
{
    const int unknown = lua_gettop(L) + 1;
    bool found = false;

    luaL_checkstack(L, 8, NULL);
    lua_pushnil(L);
    for (lua_pushnil(L); lua_next(L, at);) {
        lua_pop(L, 1);
        if (is_known(L, luakeys_text(L, -1), context) || (found && compare(L, unknown + 1, unknown) >= 0))
            continue;
        lua_pushvalue(L, -1);
        lua_replace(L, unknown);
        found = true;
    }
    if (!found)
        lua_pop(L, 1);
    return found;
}
