/*
 * luatext.c - converts values to strings: tostring, string.format, string.rep.
 *
 * The stock functions do the work. Arguments whose text would differ between hosts (addresses, and the spelling of NaN
 * and the infinities) are replaced first. string.format checks each conversion itself, because releases of Lua 5.4
 * accept different flags, and passes on a format string that all of them treat alike.
 */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "lualib.h"
#include "luaparts.h"
#include "../vm.h"

enum {
    MAX_CONVERSION = 21,        /* bytes after the %, as in Lua 5.4.4 */
    MAX_REP = 256 * 1024 * 1024 /* bytes, the longest result of string.rep; no Lua heap is larger */
};

/* NaN is written without its sign, which has no meaning and differs between processors. */
void luatext_push_number(lua_State *L, int idx)
{
    lua_Number v = lua_tonumber(L, idx);

    if (v != v) {
        lua_pushliteral(L, "nan");
        return;
    }
    lua_pushvalue(L, idx);
    lua_tolstring(L, -1, NULL);
}

/* Pushes the text of a value without __tostring: its __name or type, without its address. */
static void push_type_name(lua_State *L, int idx)
{
    int type = luaL_getmetafield(L, idx, "__name");

    if (type == LUA_TSTRING)
        return;
    if (type != LUA_TNIL)
        lua_pop(L, 1);
    lua_pushstring(L, luaL_typename(L, idx));
}

const char *lualib_tolstring(lua_State *L, int idx, size_t *size)
{
    int type = lua_type(L, idx);

    idx = lua_absindex(L, idx);
    if (luaL_callmeta(L, idx, "__tostring")) {
        if (!lua_isstring(L, -1))
            luaL_error(L, "'__tostring' must return a string");
        if (lua_type(L, -1) == LUA_TNUMBER)
            luatext_push_number(L, -1);
    } else if (type == LUA_TNUMBER) {
        luatext_push_number(L, idx);
    } else if (type == LUA_TNIL || type == LUA_TBOOLEAN || type == LUA_TSTRING) {
        luaL_tolstring(L, idx, NULL);
    } else {
        push_type_name(L, idx);
    }
    return lua_tolstring(L, -1, size);
}

int luatext_tostring(lua_State *L)
{
    luaL_checkany(L, 1);
    lualib_tolstring(L, 1, NULL);
    return 1;
}

/* Refuses results that are too long for any host, and skips the stock function, which would loop `count` times, for
 * empty strings. */
static int string_rep(lua_State *L)
{
    size_t n, sep_n;

    luaL_checklstring(L, 1, &n);
    lua_Integer count = luaL_checkinteger(L, 2);
    luaL_optlstring(L, 3, "", &sep_n);
    if (count <= 0 || n + sep_n == 0)
        return lua_pushliteral(L, ""), 1;
    if (n + sep_n > MAX_REP || count > (lua_Integer)(MAX_REP / (n + sep_n)))
        return luaL_error(L, "resulting string too large");
    vm_charge(L, (uint64_t)count * (1 + (n + sep_n) / 8));
    return luaparts_call_stock(L);
}

/* ---- string.format ---- */

/* A conversion: pointers to its flags, its width, the dot of its precision, and its letter. Without a precision, dot
 * equals letter. */
struct spec {
    const char *flags, *width, *dot, *letter;
};

/* Returns the flags that a conversion accepts, and '.' if it accepts a precision; or NULL if there is no such
 * conversion. */
static const char *accepted_flags(char letter)
{
    static const char *const conversions[][2] = { { "c", "-" },      { "di", "-+ 0." }, { "u", "-0." },
                                                  { "oxX", "-#0." }, { "s", "-." },     { "eEfgG", "-+ #0." },
                                                  { "q", "" } };

    for (size_t i = 0; letter && i < sizeof conversions / sizeof *conversions; i++)
        if (strchr(conversions[i][0], letter))
            return conversions[i][1];
    return NULL;
}

/* Returns the position after at most two digits. */
static const char *skip_number(const char *p)
{
    for (int i = 0; i < 2 && *p >= '0' && *p <= '9'; i++)
        p++;
    return p;
}

static bool has_flag(const struct spec *f, char flag)
{
    return memchr(f->flags, flag, (size_t)(f->width - f->flags)) != NULL;
}

/* Parses the conversion after a %. Raises an error if it is invalid. */
static struct spec read_spec(lua_State *L, const char *p)
{
    struct spec f = { .flags = p, .width = p + strspn(p, "-+ #0") };

    f.dot = skip_number(f.width);
    f.letter = *f.dot == '.' ? skip_number(f.dot + 1) : f.dot;
    const char *accepted = accepted_flags(*f.letter);
    if (*f.letter == 'q' && f.letter > p)
        luaL_error(L, "specifier '%%q' cannot have modifiers");
    if (!accepted || f.letter - p >= MAX_CONVERSION || strspn(p, accepted) < (size_t)(f.width - p) ||
        (f.letter > f.dot && !strchr(accepted, '.'))) {
        lua_pushlstring(L, p, (size_t)(f.letter - p) + 1);
        luaL_error(L, "invalid conversion '%%%s' to 'format'", lua_tostring(L, -1));
    }
    return f;
}

/* Adds a conversion to the format string, with each flag once, because some releases accept at most five flags.
 * as_text: the argument is a number's text, to be written with %s and without a precision, which would cut it. */
static void add_spec(luaL_Buffer *out, const struct spec *f, bool as_text)
{
    luaL_addchar(out, '%');
    for (const char *flag = as_text ? "-" : "-+ #0"; *flag; flag++)
        if (has_flag(f, *flag))
            luaL_addchar(out, *flag);
    luaL_addlstring(out, f->width, (size_t)((as_text ? f->dot : f->letter) - f->width));
    luaL_addchar(out, as_text ? 's' : *f->letter);
}

/* Pushes the text of a NaN or an infinity. */
static void push_non_finite(lua_State *L, const struct spec *f, lua_Number v)
{
    const char *sign = v < 0 ? "-" : has_flag(f, '+') ? "+" : has_flag(f, ' ') ? " " : "";
    bool is_upper = *f->letter < 'a';

    lua_pushfstring(L, "%s%s", sign, v != v ? is_upper ? "NAN" : "nan" : is_upper ? "INF" : "inf");
}

/* Pushes an integral float as a decimal Lua literal; the stock function would write a hexadecimal one. */
static void push_literal(lua_State *L, int arg, lua_Number v)
{
    char text[32];

    luaL_argcheck(L, fabs(v) < 0x1p63 && v == floor(v), arg, "%q accepts whole numbers only");
    snprintf(text, sizeof text, "%.1f", v);
    lua_pushstring(L, text);
}

/* Charges for an argument, and replaces it by its text if the stock function would write a different one. Returns
 * whether the argument is now such a text, which must be written with %s instead of f's conversion. */
static bool prepare_argument(lua_State *L, const struct spec *f, int arg)
{
    bool is_text = lua_type(L, arg) == LUA_TSTRING;
    bool is_float = lua_type(L, arg) == LUA_TNUMBER && !lua_isinteger(L, arg);
    bool formats_float = strchr("eEfgG", *f->letter) != NULL;
    lua_Number v = lua_tonumber(L, arg); /* 0 if it is not a number, which the stock function refuses */
    size_t n = is_text ? (size_t)lua_rawlen(L, arg) : 0;

    vm_charge(L, formats_float ? 800 : 16 + (*f->letter == 'q' ? n / 2 : 0));
    if (*f->letter == 's') {
        if (!is_text)
            lualib_tolstring(L, arg, &n), lua_replace(L, arg);
        vm_charge(L, n / 8);
        return false;
    }
    if (formats_float && !(fabs(v) <= DBL_MAX))
        push_non_finite(L, f, v);
    else if (*f->letter == 'q' && is_float && fabs(v) <= DBL_MAX)
        push_literal(L, arg, v);
    else
        return false;
    lua_replace(L, arg);
    return true;
}

static int string_format(lua_State *L)
{
    size_t n;
    int top = lua_gettop(L), arg = 1;
    const char *p = luaL_checklstring(L, 1, &n), *end = p + n;
    luaL_Buffer out;

    vm_charge(L, n / 4);
    luaL_buffinit(L, &out);
    for (const char *q; (q = memchr(p, '%', (size_t)(end - p))) != NULL;) {
        luaL_addlstring(&out, p, (size_t)(q - p));
        p = q + 1;
        if (*p == '%') {
            luaL_addlstring(&out, p++ - 1, 2);
            continue;
        }
        if (++arg > top)
            return luaL_argerror(L, arg, "no value");
        struct spec f = read_spec(L, p);
        add_spec(&out, &f, prepare_argument(L, &f, arg));
        p = f.letter + 1;
    }
    luaL_addlstring(&out, p, (size_t)(end - p));
    luaL_pushresult(&out);
    lua_replace(L, 1);
    return luaparts_call_stock(L);
}

void luatext_open(lua_State *L)
{
    luaparts_wrap(L, "format", string_format);
    luaparts_wrap(L, "rep", string_rep);
}
