/*
 * luautf8.c - utf8.char, codepoint, len and offset: the stock functions with their work charged. utf8.codes is
 * reimplemented, because releases of Lua 5.4 differ in what it accepts; it reads each code with the stock codepoint.
 */
#include <stdbool.h>
#include "luaparts.h"
#include "../vm.h"

static int utf8_char(lua_State *L)
{
    vm_charge(L, (uint64_t)lua_gettop(L));
    return luaparts_call_stock(L);
}

static int utf8_codepoint(lua_State *L)
{
    int n = luaparts_call_stock(L);

    vm_charge(L, (uint64_t)n);
    return n;
}

/* The stock function leaves the number of characters on top, or the position of the first invalid byte. */
static int utf8_len(lua_State *L)
{
    int n = luaparts_call_stock(L);

    vm_charge(L, (uint64_t)lua_tointeger(L, -1));
    return n;
}

static int utf8_offset(lua_State *L)
{
    size_t n;
    luaL_checklstring(L, 1, &n);
    lua_Integer count = luaL_checkinteger(L, 2), from = luaL_optinteger(L, 3, count >= 0 ? 1 : (lua_Integer)n + 1);

    lua_settop(L, 2);
    lua_pushinteger(L, from);
    luaparts_call_stock(L);
    /* A nil result becomes 0, the position before the string. */
    size_t at = (size_t)lua_tointeger(L, -1), start = luaparts_position(from, n);
    vm_charge(L, at > start ? at - start : start - at);
    return 1;
}

static bool is_continuation(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* The iterator: returns the position and code of the character after the one at the control position. Upvalues: the
 * stock codepoint, lax. */
static int next_code(lua_State *L)
{
    size_t n;
    const char *s = luaL_checklstring(L, 1, &n);
    lua_Unsigned previous = (lua_Unsigned)lua_tointeger(L, 2), at = previous, last;

    while (at < n && is_continuation(s[at]))
        at++;
    for (last = at + 1; last < n && is_continuation(s[last]); last++)
        ;
    vm_charge(L, last - previous);
    if (at >= n)
        return 0;
    lua_settop(L, 1);
    lua_pushinteger(L, (lua_Integer)at + 1);
    lua_pushinteger(L, (lua_Integer)last);
    lua_pushvalue(L, lua_upvalueindex(2));
    luaparts_call_stock(L); /* decodes [at, last]: more than one code, i.e. a surplus continuation byte, is an error */
    lua_replace(L, 3);
    lua_settop(L, 3);
    return 2;
}

/* Upvalues: the iterators, strict and lax. */
static int utf8_codes(lua_State *L)
{
    luaL_argcheck(L, !is_continuation(*luaL_checkstring(L, 1)), 1, "invalid UTF-8 code");
    lua_pushvalue(L, lua_upvalueindex(lua_toboolean(L, 2) ? 2 : 1));
    lua_pushvalue(L, 1);
    lua_pushinteger(L, 0);
    return 3;
}

void luautf8_open(lua_State *L)
{
    for (int lax = 0; lax < 2; lax++) {
        lua_getfield(L, lax ? -2 : -1, "codepoint");
        lua_pushboolean(L, lax);
        lua_pushcclosure(L, next_code, 2);
    }
    lua_pushcclosure(L, utf8_codes, 2);
    lua_setfield(L, -2, "codes");
    luaparts_wrap(L, "char", utf8_char);
    luaparts_wrap(L, "codepoint", utf8_codepoint);
    luaparts_wrap(L, "len", utf8_len);
    luaparts_wrap(L, "offset", utf8_offset);
}
