/*
 * values.c - see values.h. Each value is a tag byte and its data; a table is its keys and values alternately, up to
 * TAG_END.
 */
#include "values.h"

#include <lauxlib.h>
#include <stdbool.h>
#include <string.h>
#include "api/api.h"
#include "lua/lualib.h"
#include "vm.h"

enum tag { TAG_NIL, TAG_FALSE, TAG_TRUE, TAG_INTEGER, TAG_FLOAT, TAG_TEXT, TAG_TABLE, TAG_END };

static void put_bytes(lua_State *L, struct values *v, const void *bytes, size_t n)
{
    if (n > v->capacity - v->n)
        luaL_error(L, "values too large for a test (at most %d bytes)", (int)v->capacity);
    if (n)
        memcpy(v->bytes + v->n, bytes, n);
    v->n += n;
}

static void put_tag(lua_State *L, struct values *v, enum tag tag)
{
    const uint8_t byte = (uint8_t)tag;

    put_bytes(L, v, &byte, 1);
}

static void put_text(lua_State *L, struct values *v, int idx)
{
    size_t n;
    const char *text = lualib_tolstring(L, idx, &n);

    put_tag(L, v, TAG_TEXT);
    put_bytes(L, v, &n, sizeof n);
    put_bytes(L, v, text, n);
    lua_pop(L, 1);
}

static void put_number(lua_State *L, struct values *v, int idx)
{
    const lua_Integer integer = lua_tointeger(L, idx);
    const lua_Number number = lua_tonumber(L, idx);

    if (lua_isinteger(L, idx)) {
        put_tag(L, v, TAG_INTEGER);
        put_bytes(L, v, &integer, sizeof integer);
    } else {
        put_tag(L, v, TAG_FLOAT);
        put_bytes(L, v, &number, sizeof number);
    }
}

bool values_have_text_form(lua_State *L, int idx)
{
    const int top = lua_gettop(L);
    const bool found =
        luaL_getmetafield(L, idx, "__tostring") != LUA_TNIL || luaL_getmetafield(L, idx, "__name") != LUA_TNIL;

    lua_settop(L, top);
    return found;
}

static void put_value(lua_State *L, struct values *v, int idx, int depth);

static void put_table(lua_State *L, struct values *v, int idx, int depth)
{
    if (depth == VALUES_MAX_DEPTH)
        luaL_error(L, "tables nested more than %d deep", VALUES_MAX_DEPTH);
    luaL_checkstack(L, 8, NULL);
    api_fill_table(L, idx);
    put_tag(L, v, TAG_TABLE);
    lua_pushnil(L);
    while (lua_next(L, idx)) {
        vm_charge(L, WORK_CALL);
        put_value(L, v, lua_gettop(L) - 1, depth + 1);
        put_value(L, v, lua_gettop(L), depth + 1);
        lua_pop(L, 1);
    }
    put_tag(L, v, TAG_END);
}

static void put_value(lua_State *L, struct values *v, int idx, int depth)
{
    switch (lua_type(L, idx)) {
    case LUA_TNIL:
        put_tag(L, v, TAG_NIL);
        break;
    case LUA_TBOOLEAN:
        put_tag(L, v, lua_toboolean(L, idx) ? TAG_TRUE : TAG_FALSE);
        break;
    case LUA_TNUMBER:
        put_number(L, v, idx);
        break;
    default:
        if (lua_istable(L, idx) && !values_have_text_form(L, idx))
            put_table(L, v, idx, depth);
        else
            put_text(L, v, idx);
    }
}

void values_put(lua_State *L, struct values *v)
{
    const int n = lua_gettop(L);

    v->n = 0;
    v->count = n;
    luaL_checkstack(L, 8, NULL);
    for (int i = 1; i <= n; i++)
        put_value(L, v, i, 0);
}

static const uint8_t *read_bytes(const uint8_t *p, void *to, size_t n)
{
    memcpy(to, p, n);
    return p + n;
}

static const uint8_t *push_value(lua_State *L, const uint8_t *p)
{
    lua_Integer integer;
    lua_Number number;
    size_t n;

    switch ((enum tag) * p++) {
    case TAG_FALSE:
    case TAG_TRUE:
        lua_pushboolean(L, p[-1] == TAG_TRUE);
        return p;
    case TAG_INTEGER:
        p = read_bytes(p, &integer, sizeof integer);
        lua_pushinteger(L, integer);
        return p;
    case TAG_FLOAT:
        p = read_bytes(p, &number, sizeof number);
        lua_pushnumber(L, number);
        return p;
    case TAG_TEXT:
        p = read_bytes(p, &n, sizeof n);
        lua_pushlstring(L, (const char *)p, n);
        return p + n;
    case TAG_TABLE:
        luaL_checkstack(L, 4, NULL);
        lua_newtable(L);
        while (*p != TAG_END) {
            p = push_value(L, push_value(L, p));
            lua_rawset(L, -3);
        }
        return p + 1;
    default:
        lua_pushnil(L);
        return p;
    }
}

int values_push(lua_State *L, const struct values *v)
{
    const uint8_t *p = v->bytes;

    luaL_checkstack(L, v->count + 4, NULL);
    for (int i = 0; i < v->count; i++)
        p = push_value(L, p);
    return v->count;
}
