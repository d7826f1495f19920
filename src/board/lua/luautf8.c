/*
 * luautf8.c - utf8.char, codepoint, codes, len and offset. Written out because releases of Lua 5.4 differ in what they
 * accept. Sequences of up to six bytes exist (values to 2^31 - 1); without `lax`, only those of Unicode.
 */
#include <stdbool.h>
#include <stdint.h>
#include "luaparts.h"
#include "../vm.h"

enum { MAX_UNICODE = 0x10ffff, MAX_CODE = 0x7fffffff };

static bool is_continuation(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* Bytes of the sequence that a lead byte starts; 0: it starts none. */
static int sequence(unsigned char lead)
{
    if (lead < 0x80)
        return 1;
    if (lead < 0xc0 || lead >= 0xfe)
        return 0;
    return lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : lead < 0xfc ? 5 : 6;
}

/* The least code that needs n bytes. */
static uint32_t least(int n)
{
    return n < 2 ? 0 : n == 2 ? 0x80 : (uint32_t)1 << (5 * n - 4);
}

/* Reads a code at s < end; NULL when there is no valid one. */
static const char *decode(const char *s, const char *end, uint32_t *code, bool lax)
{
    int n = sequence((unsigned char)*s);

    if (n == 0 || end - s < n)
        return NULL;
    uint32_t v = (unsigned char)*s & (n == 1 ? 0x7fu : 0x7fu >> n);
    for (int i = 1; i < n; i++) {
        if (!is_continuation(s[i]))
            return NULL;
        v = v << 6 | ((unsigned char)s[i] & 0x3fu);
    }
    if (v < least(n) || (!lax && (v > MAX_UNICODE || (v >= 0xd800 && v <= 0xdfff))))
        return NULL;
    *code = v;
    return s + n;
}

static int encode(char to[6], uint32_t v)
{
    int n = 1;

    if (v < 0x80) {
        to[0] = (char)v;
        return 1;
    }
    while (n < 6 && v >= least(n + 1))
        n++;
    for (int i = n - 1; i > 0; i--, v >>= 6)
        to[i] = (char)(0x80 | (v & 0x3f));
    to[0] = (char)((0xff00u >> n & 0xff) | v);
    return n;
}

static int utf8_len(lua_State *L)
{
    size_t n;
    const char *s = luaL_checklstring(L, 1, &n), *end = s + n;
    size_t from = luatext_position(luaL_optinteger(L, 2, 1), n), to = luatext_position(luaL_optinteger(L, 3, -1), n);
    bool lax = lua_toboolean(L, 4);
    lua_Integer count = 0;
    uint32_t code;

    luaL_argcheck(L, from >= 1 && from - 1 <= n, 2, "initial position out of bounds");
    luaL_argcheck(L, to <= n, 3, "final position out of bounds");
    vm_charge(L, to > from ? to - from : 0);
    for (const char *p = s + from - 1, *next; p < s + to; p = next, count++) {
        next = decode(p, end, &code, lax);
        if (!next) {
            lua_pushnil(L);
            lua_pushinteger(L, p - s + 1);
            return 2;
        }
    }
    lua_pushinteger(L, count);
    return 1;
}

static int utf8_codepoint(lua_State *L)
{
    size_t n;
    const char *s = luaL_checklstring(L, 1, &n), *end = s + n;
    lua_Integer i = luaL_optinteger(L, 2, 1);
    size_t from = luatext_position(i, n), to = luatext_position(luaL_optinteger(L, 3, (lua_Integer)from), n);
    bool lax = lua_toboolean(L, 4);
    int pushed = 0;
    uint32_t code;

    luaL_argcheck(L, from >= 1, 2, "out of bounds");
    luaL_argcheck(L, to <= n, 3, "out of bounds");
    if (from > to)
        return 0;
    vm_charge(L, to - from + 1);
    if (to - from >= INT32_MAX)
        return luaL_error(L, "string slice too long");
    luaL_checkstack(L, (int)(to - from) + 1, "string slice too long");
    for (const char *p = s + from - 1; p < s + to; pushed++) {
        p = decode(p, end, &code, lax);
        if (!p)
            return luaL_error(L, "invalid UTF-8 code");
        lua_pushinteger(L, code);
    }
    return pushed;
}

static int utf8_char(lua_State *L)
{
    int n = lua_gettop(L);
    char bytes[6];
    luaL_Buffer out;

    vm_charge(L, (uint64_t)n);
    luaL_buffinit(L, &out);
    for (int i = 1; i <= n; i++) {
        lua_Unsigned code = (lua_Unsigned)luaL_checkinteger(L, i);
        luaL_argcheck(L, code <= MAX_CODE, i, "value out of range");
        luaL_addlstring(&out, bytes, (size_t)encode(bytes, (uint32_t)code));
    }
    luaL_pushresult(&out);
    return 1;
}

/* Moves p by n characters that lie in [s, end]; *n becomes what could not be done. */
static const char *walk(const char *s, const char *p, const char *end, lua_Integer *n)
{
    for (; *n < 0 && p > s; ++*n)
        do
            p--;
        while (p > s && is_continuation(*p));
    for (; *n > 0 && p < end; --*n)
        do
            p++;
        while (p < end && is_continuation(*p));
    return p;
}

static int utf8_offset(lua_State *L)
{
    size_t size;
    const char *s = luaL_checklstring(L, 1, &size), *end = s + size, *p;
    lua_Integer n = luaL_checkinteger(L, 2);
    size_t from = luatext_position(luaL_optinteger(L, 3, n >= 0 ? 1 : (lua_Integer)size + 1), size);

    luaL_argcheck(L, from >= 1 && from - 1 <= size, 3, "position out of bounds");
    p = s + from - 1;
    if (n == 0) {
        while (p > s && p < end && is_continuation(*p))
            p--;
    } else {
        if (p < end && is_continuation(*p))
            return luaL_error(L, "initial position is a continuation byte");
        n -= n > 0;
        p = walk(s, p, end, &n);
    }
    vm_charge(L, (uint64_t)(p > s + from ? p - (s + from) : s + from - p));
    if (n == 0)
        lua_pushinteger(L, p - s + 1);
    else
        lua_pushnil(L);
    return 1;
}

/* The iterator: the code behind the one at the control position. */
static int next_code(lua_State *L, bool lax)
{
    size_t n;
    const char *s = luaL_checklstring(L, 1, &n), *end = s + n, *next;
    lua_Unsigned at = (lua_Unsigned)lua_tointeger(L, 2);
    uint32_t code, work = 0;

    for (; at < n && is_continuation(s[at]); at++)
        work++;
    if (work > 8)
        vm_charge(L, work);
    if (at >= n)
        return 0;
    next = decode(s + at, end, &code, lax);
    if (!next || (next < end && is_continuation(*next)))
        return luaL_error(L, "invalid UTF-8 code");
    lua_pushinteger(L, (lua_Integer)at + 1);
    lua_pushinteger(L, code);
    return 2;
}

static int next_strict(lua_State *L)
{
    return next_code(L, false);
}

static int next_lax(lua_State *L)
{
    return next_code(L, true);
}

static int utf8_codes(lua_State *L)
{
    size_t n;
    const char *s = luaL_checklstring(L, 1, &n);
    bool lax = lua_toboolean(L, 2);

    luaL_argcheck(L, n == 0 || !is_continuation(*s), 1, "invalid UTF-8 code");
    lua_pushcfunction(L, lax ? next_lax : next_strict);
    lua_pushvalue(L, 1);
    lua_pushinteger(L, 0);
    return 3;
}

void luautf8_open(lua_State *L)
{
    static const luaL_Reg functions[] = { { "char", utf8_char },     { "codepoint", utf8_codepoint },
                                          { "codes", utf8_codes },   { "len", utf8_len },
                                          { "offset", utf8_offset }, { NULL, NULL } };

    luaL_setfuncs(L, functions, 0);
}
