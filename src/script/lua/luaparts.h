/*
 * luaparts.h - functions that the lua*.c files provide to lualib.c, and shared helpers.
 *
 * Each open function stores its functions in the table on top of the stack.
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

/* The Lua functions pairs and tostring. */
int luatable_pairs(lua_State *L);
int luatext_tostring(lua_State *L);

/* Pushes the number at idx as a string; NaN as "nan". */
void luatext_push_number(lua_State *L, int idx);

/* Replaces the stock function `name` in the table on top by f, which calls the original with luaparts_call_stock. */
static inline void luaparts_wrap(lua_State *L, const char *name, lua_CFunction f)
{
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, f, 1);
    lua_setfield(L, -2, name);
}

/* Calls the stock function in upvalue 1 with the running function's stack. Returns its number of results. */
static inline int luaparts_call_stock(lua_State *L)
{
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/* Converts a string position (1: the first byte; -1: the last of n bytes) to a positive one. Returns 0 if the position
 * is before the first byte. */
static inline size_t luaparts_position(lua_Integer i, size_t n)
{
    if (i >= 0)
        return (size_t)i;
    return (size_t) - (i + 1) >= n ? 0 : n - (size_t) - (i + 1);
}

#endif
