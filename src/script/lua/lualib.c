/*
 * lualib.c - see lualib.h. Contains the base functions and the list of names retained from the stock libraries; the
 * other functions are in the lua*.c files.
 */
#include "lualib.h"

#include <lualib.h>
#include <stdint.h>
#include <string.h>
#include "luaparts.h"
#include "../../base/int.h"
#include "../../machine/machine.h"
#include "../script.h"
#include "../vm.h"

static const char metatables_key; /* registry: metatables set with setmetatable, as weak keys */

/* ---- metatables ---- */

/* Raises an error, which begins with `prefix`, if the metatable has a field that is not allowed. Only a function is
 * allowed as __call, because Lua follows a chain of __call tables within one instruction, forever if the chain is a
 * loop. */
static void check_metatable(lua_State *L, int metatable, const char *prefix)
{
    static const char *const refused[] = { "__gc", "__mode" };

    for (int i = 0; i < 2; i++) {
        lua_pushstring(L, refused[i]);
        if (lua_rawget(L, metatable) != LUA_TNIL)
            luaL_error(L, "%s%s is not allowed in a metatable", prefix, refused[i]);
    }
    lua_pushliteral(L, "__call");
    int type = lua_rawget(L, metatable);
    if (type != LUA_TNIL && type != LUA_TFUNCTION)
        luaL_error(L, "%s__call: expected a function, got a %s", prefix, lua_typename(L, type));
    lua_pop(L, 3);
}

/* Adds the metatable at stack index 2 to the set that lualib_check_metatables checks. */
static void remember_metatable(lua_State *L)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &metatables_key);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) == LUA_TNIL) {
        lua_pushvalue(L, 2);
        lua_pushboolean(L, 1);
        lua_rawset(L, -4);
    }
    lua_pop(L, 2);
}

static int base_setmetatable(lua_State *L)
{
    int type = lua_type(L, 2);

    luaL_checktype(L, 1, LUA_TTABLE);
    luaL_argexpected(L, type == LUA_TNIL || type == LUA_TTABLE, 2, "nil or table");
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
        return luaL_error(L, "cannot change a protected metatable");
    lua_settop(L, 2);
    if (type == LUA_TTABLE) {
        check_metatable(L, 2, "setmetatable: ");
        remember_metatable(L);
    }
    lua_setmetatable(L, 1);
    return 1;
}

void lualib_check_metatables(lua_State *L)
{
    luaL_checkstack(L, 8, NULL);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &metatables_key);
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        check_metatable(L, lua_gettop(L), "");
    }
    lua_pop(L, 1);
}

void lualib_seal(lua_State *L)
{
    lua_createtable(L, 0, 3);
    lua_rotate(L, -3, 1);
    lua_setfield(L, -3, "__newindex");
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

/* ---- load ---- */

/* Replaces the reader function at stack index 1 by the concatenation of all strings that the function returns. */
static void read_pieces(lua_State *L)
{
    luaL_Buffer out;
    size_t n;

    luaL_buffinit(L, &out);
    for (;;) {
        lua_pushvalue(L, 1);
        lua_call(L, 0, 1);
        if (lua_isnil(L, -1))
            break;
        if (!lua_isstring(L, -1))
            luaL_error(L, "reader function must return a string");
        lua_tolstring(L, -1, &n);
        if (n == 0)
            break;
        vm_charge(L, 1);
        luaL_addvalue(&out);
    }
    lua_pop(L, 1);
    luaL_pushresult(&out);
    lua_replace(L, 1);
}

/* Pushes nil and "CHUNK:LINE: message", as for a syntax error. Returns 2. */
static int push_syntax_error(lua_State *L, const char *chunk, int line, const char *message)
{
    lua_pushnil(L);
    if (*chunk == '@' || *chunk == '=')
        lua_pushfstring(L, "%s:%d: %s", chunk + 1, line, message);
    else
        lua_pushfstring(L, "[string]:%d: %s", line, message);
    return 2;
}

/* load(text or function, name, mode, env). Ignores mode: only source text is accepted. Propagates an error in the
 * reader function. */
static int base_load(lua_State *L)
{
    bool is_reader = !lua_isstring(L, 1), has_env = !lua_isnone(L, 4);
    const char *message;
    size_t n;
    int line;

    luaL_optstring(L, 3, NULL);
    const char *chunk = luaL_optstring(L, 2, is_reader ? "=(load)" : lua_tostring(L, 1));
    if (is_reader)
        luaL_checktype(L, 1, LUA_TFUNCTION);
    lua_settop(L, 4);
    if (is_reader)
        read_pieces(L);
    const char *text = lua_tolstring(L, 1, &n);
    vm_charge(L, 1000 + n * 16);
    if (!script_scan(text, n, &line, &message))
        return push_syntax_error(L, chunk, line, message);
    int status = luaL_loadbufferx(L, text, n, chunk, "t");
    if (status == LUA_ERRSYNTAX) {
        lua_pushnil(L);
        lua_insert(L, -2);
        return 2;
    }
    if (status != LUA_OK)
        return lua_error(L);
    if (has_env) {
        lua_pushvalue(L, 4);
        if (!lua_setupvalue(L, -2, 1))
            lua_pop(L, 1);
    }
    return 1;
}

/* ---- functions retained from the stock libraries ---- */

/* Calls a stock function whose work grows only with the length of the string in argument 1. */
static int call_charging_length(lua_State *L)
{
    if (lua_type(L, 1) == LUA_TSTRING)
        vm_charge(L, lua_rawlen(L, 1) / 4);
    return luaparts_call_stock(L);
}

/* Calls a stock function whose work grows with its number of results. */
static int call_charging_results(lua_State *L)
{
    int n = luaparts_call_stock(L);

    vm_charge(L, (unsigned)n / 4);
    return n;
}

/* Each of the next two functions replaces functions of a library, whose table is on top. */
static void replace_base(lua_State *L)
{
    static const luaL_Reg functions[] = { { "load", base_load },
                                          { "pairs", luatable_pairs },
                                          { "setmetatable", base_setmetatable },
                                          { "tostring", luatext_tostring },
                                          { NULL, NULL } };

    luaL_setfuncs(L, functions, 0);
    luaerror_open(L);
    luaparts_wrap(L, "tonumber", call_charging_length);
}

/* Also removes __pow from the metatable of strings, because "2" ^ "3" would call the C library's pow. */
static void replace_string(lua_State *L)
{
    luapattern_open(L);
    luatext_open(L);
    luaparts_wrap(L, "byte", call_charging_results);
    luaparts_wrap(L, "lower", call_charging_length);
    luaparts_wrap(L, "reverse", call_charging_length);
    luaparts_wrap(L, "upper", call_charging_length);
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushnil(L);
    lua_setfield(L, -2, "__pow");
    lua_pop(L, 2);
}

/* The libraries, each with the names retained from it; "": the globals. */
static const struct {
    const char *name, *retained;
    lua_CFunction open_stock;
    void (*replace)(lua_State *L);
} libraries[] = {
    { "",
      "_G _VERSION assert error getmetatable ipairs load math pairs pcall rawequal rawget rawlen rawset select "
      "setmetatable string table tonumber tostring type utf8 warn",
      luaopen_base, replace_base },
    { LUA_TABLIBNAME, "concat insert move pack remove sort unpack", luaopen_table, luatable_open },
    { LUA_STRLIBNAME, "byte char find format gmatch gsub len lower match rep reverse sub upper", luaopen_string,
      replace_string },
    { LUA_MATHLIBNAME,
      "abs acos asin atan ceil cos deg floor fmod huge max maxinteger min mininteger modf pi rad sin sqrt tan "
      "tointeger type ult",
      luaopen_math, luamath_open },
    { LUA_UTF8LIBNAME, "char charpattern codepoint codes len offset", luaopen_utf8, luautf8_open },
};

const char *lualib_retained_names(const char *library)
{
    for (size_t i = 0; i < COUNT(libraries); i++)
        if (strcmp(libraries[i].name, library) == 0)
            return libraries[i].retained;
    return NULL;
}

/* Removes unlisted entries from the table on top. */
static void remove_unlisted(lua_State *L, const char *list)
{
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        if (lua_type(L, -1) == LUA_TSTRING && script_list_has(list, lua_tostring(L, -1), (size_t)lua_rawlen(L, -1)))
            continue;
        lua_pushvalue(L, -1);
        lua_pushnil(L);
        lua_rawset(L, -4);
    }
}

void lualib_open(lua_State *L)
{
    luaL_checkstack(L, 8, NULL);
    lua_newtable(L);
    lua_createtable(L, 0, 1);
    lua_pushliteral(L, "k");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &metatables_key);
    for (size_t i = 0; i < COUNT(libraries); i++) {
        luaL_requiref(L, libraries[i].name[0] ? libraries[i].name : LUA_GNAME, libraries[i].open_stock, 1);
        remove_unlisted(L, libraries[i].retained);
        libraries[i].replace(L);
        lua_pop(L, 1);
    }
}
