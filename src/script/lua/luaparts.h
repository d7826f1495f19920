/*
 * luaparts.h - the files lualib.c is put together from.
 *
 * Each open function sets its functions in the table on top of the stack.
 */
#ifndef SCRIPT_LUAPARTS_H
#define SCRIPT_LUAPARTS_H

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>

void luaerror_open(lua_State *L);   /* globals: assert error pcall */
void luapattern_open(lua_State *L); /* string: find gmatch gsub match */
void luatext_open(lua_State *L);    /* string: format rep */
void luautf8_open(lua_State *L);    /* utf8: char codepoint codes len offset */
void luatable_open(lua_State *L);   /* table: concat insert move remove sort unpack */
void luamath_open(lua_State *L);    /* math: acos asin atan cos sin tan */

/* The functions pairs and tostring. */
int luatable_pairs(lua_State *L);
int luatext_tostring(lua_State *L);

/* Pushes the text of the number at idx. */
void luatext_push_number(lua_State *L, int idx);

/* Puts f in the place of the stock function of this name in the table on top, which f calls with luaparts_stock. */
static inline void luaparts_wrap(lua_State *L, const char *name, lua_CFunction f)
{
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, f, 1);
    lua_setfield(L, -2, name);
}

/* Calls the stock function, which is upvalue 1, in the place of the function that runs. Returns how many results. */
static inline int luaparts_stock(lua_State *L)
{
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/* A position in a text of n bytes, as strings and utf8 count: from 1, or from -1 back. Never below 0. */
static inline size_t luaparts_position(lua_Integer i, size_t n)
{
    if (i >= 0)
        return (size_t)i;
    return (size_t) - (i + 1) >= n ? 0 : n - (size_t) - (i + 1);
}

#endif
