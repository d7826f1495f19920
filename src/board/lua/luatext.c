/*
 * luatext.c - values as text: tostring, string.format, string.rep.
 *
 * Of the C library only snprintf of whole numbers and of finite doubles is used, which rounds correctly on every host
 * the board runs on; NaN and the infinities, padding and %q are written here. Nothing prints an address.
 */
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "../lualib.h"
#include "luaparts.h"
#include "../vm.h"

enum {
    MAX_ITEM = 512,              /* "%99.99f" of the largest double has 410 bytes */
    MAX_TEXT = 256 * 1024 * 1024 /* no Lua heap can hold a longer one */
};

/* "nan", "inf" or "-inf"; NULL for a finite number. A NaN's sign says nothing and differs between processors. */
static const char *odd_number(lua_Number v)
{
    if (v != v)
        return "nan";
    if (v > DBL_MAX)
        return "inf";
    return v < -DBL_MAX ? "-inf" : NULL;
}

/* A finite number that would read as a whole one gets ".0". */
static void push_float(lua_State *L, lua_Number v)
{
    char text[64];
    const char *odd = odd_number(v);

    if (odd) {
        lua_pushstring(L, odd);
        return;
    }
    int n = snprintf(text, sizeof text - 2, "%.14g", v);
    if (text[strspn(text, "-0123456789")] == '\0') {
        text[n++] = '.';
        text[n++] = '0';
    }
    lua_pushlstring(L, text, (size_t)n);
}

void luatext_push_number(lua_State *L, int idx)
{
    if (lua_isinteger(L, idx))
        lua_pushfstring(L, "%I", (LUAI_UACINT)lua_tointeger(L, idx));
    else
        push_float(L, lua_tonumber(L, idx));
}

/* The text of a value that says nothing of itself: what it is, never where it is. */
static void push_kind(lua_State *L, int idx)
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
    idx = lua_absindex(L, idx);
    if (luaL_callmeta(L, idx, "__tostring")) {
        if (!lua_isstring(L, -1))
            luaL_error(L, "'__tostring' must return a string");
        return lua_tolstring(L, -1, size);
    }
    switch (lua_type(L, idx)) {
    case LUA_TNUMBER:
        luatext_push_number(L, idx);
        break;
    case LUA_TSTRING:
        lua_pushvalue(L, idx);
        break;
    case LUA_TBOOLEAN:
        lua_pushstring(L, lua_toboolean(L, idx) ? "true" : "false");
        break;
    case LUA_TNIL:
        lua_pushliteral(L, "nil");
        break;
    default:
        push_kind(L, idx);
    }
    return lua_tolstring(L, -1, size);
}

int luatext_tostring(lua_State *L)
{
    luaL_checkany(L, 1);
    lualib_tolstring(L, 1, NULL);
    return 1;
}

/* ---- string.rep ---- */

/* Fills to + done .. to + total with copies of what stands before, as a repeating pattern of `done` bytes. */
static void repeat_bytes(char *to, size_t done, size_t total)
{
    for (size_t n; done < total; done += n) {
        n = done < total - done ? done : total - done;
        memcpy(to + done, to, n);
    }
}

static int string_rep(lua_State *L)
{
    size_t n, sep_n;
    const char *s = luaL_checklstring(L, 1, &n);
    lua_Integer count = luaL_checkinteger(L, 2);
    const char *sep = luaL_optlstring(L, 3, "", &sep_n);
    luaL_Buffer out;

    if (count <= 0 || n + sep_n == 0)
        return lua_pushliteral(L, ""), 1;
    if (n + sep_n > MAX_TEXT || count > (lua_Integer)(MAX_TEXT / (n + sep_n)))
        return luaL_error(L, "resulting string too large");
    size_t total = (size_t)count * (n + sep_n) - sep_n, unit = n + (count > 1 ? sep_n : 0);
    vm_charge(L, total / 8);
    char *to = luaL_buffinitsize(L, &out, total);
    memcpy(to, s, n);
    memcpy(to + n, sep, unit - n);
    repeat_bytes(to, unit, total);
    luaL_pushresultsize(&out, total);
    return 1;
}

/* ---- string.format ---- */

struct spec {
    char conversion;
    bool minus, plus, space, sharp, zero;
    int width, precision; /* precision -1: none */
};

static void malformed(lua_State *L, const char *from, const char *to)
{
    lua_pushlstring(L, from, (size_t)(to - from));
    luaL_error(L, "invalid conversion '%%%s' to 'format'", lua_tostring(L, -1));
}

/* The flags a conversion takes, then '.' if it takes a precision; NULL: there is no such conversion. */
static const char *allowed(char conversion)
{
    switch (conversion) {
    case 'c':
        return "-";
    case 'd':
    case 'i':
        return "-+ 0.";
    case 'u':
        return "-0.";
    case 'o':
    case 'x':
    case 'X':
        return "-#0.";
    case 'e':
    case 'E':
    case 'f':
    case 'g':
    case 'G':
        return "-+ #0.";
    case 's':
        return "-.";
    case 'q':
        return "";
    default:
        return NULL;
    }
}

static bool *flag_of(struct spec *f, char c)
{
    switch (c) {
    case '-':
        return &f->minus;
    case '+':
        return &f->plus;
    case ' ':
        return &f->space;
    case '#':
        return &f->sharp;
    case '0':
        return &f->zero;
    default:
        return NULL;
    }
}

/* At most two digits. */
static const char *read_number(const char *p, const char *end, int *out)
{
    *out = 0;
    for (int i = 0; i < 2 && p < end && *p >= '0' && *p <= '9'; i++)
        *out = *out * 10 + (*p++ - '0');
    return p;
}

/* Reads what follows a %; returns the place behind the conversion. */
static const char *read_spec(lua_State *L, const char *p, const char *end, struct spec *f)
{
    const char *from = p, *takes;
    bool *flag;

    *f = (struct spec){ .precision = -1 };
    for (; p < end && (flag = flag_of(f, *p)) != NULL; p++)
        *flag = true;
    p = read_number(p, end, &f->width);
    if (p < end && *p == '.')
        p = read_number(p + 1, end, &f->precision);
    f->conversion = '\0';
    if (p < end)
        f->conversion = *p++;
    takes = allowed(f->conversion);
    if (!takes)
        malformed(L, from, p);
    if (!*takes && p != from + 1)
        luaL_error(L, "specifier '%%q' cannot have modifiers");
    if ((f->minus && !strchr(takes, '-')) || (f->plus && !strchr(takes, '+')) || (f->space && !strchr(takes, ' ')) ||
        (f->sharp && !strchr(takes, '#')) || (f->zero && !strchr(takes, '0')) ||
        (f->precision >= 0 && !strchr(takes, '.')))
        malformed(L, from, p);
    return p;
}

/* Adds text, padded with spaces to the width. */
static void add_padded(luaL_Buffer *out, const struct spec *f, const char *text, size_t n)
{
    size_t pad = n < (size_t)f->width ? (size_t)f->width - n : 0;

    for (size_t i = f->minus ? pad : 0; i < pad; i++)
        luaL_addchar(out, ' ');
    luaL_addlstring(out, text, n);
    for (size_t i = f->minus ? 0 : pad; i < pad; i++)
        luaL_addchar(out, ' ');
}

/* The conversion as snprintf takes it, width and precision as arguments. */
static void c_format(char to[16], const struct spec *f, const char *length)
{
    snprintf(to, 16, "%%%s%s%s%s%s*.*%s%c", f->minus ? "-" : "", f->plus ? "+" : "", f->space ? " " : "",
             f->sharp ? "#" : "", f->zero ? "0" : "", length, f->conversion);
}

static void add_integer(luaL_Buffer *out, const struct spec *f, lua_Integer v)
{
    char format[16], text[MAX_ITEM];

    c_format(format, f, "ll");
    int n = snprintf(text, sizeof text, format, f->width, f->precision, (long long)v);
    luaL_addlstring(out, text, (size_t)n);
}

static void add_float(luaL_Buffer *out, const struct spec *f, lua_Number v)
{
    char format[16], text[MAX_ITEM];
    const char *odd = odd_number(v);

    if (!odd) {
        c_format(format, f, "");
        int n = snprintf(text, sizeof text, format, f->width, f->precision, v);
        luaL_addlstring(out, text, (size_t)n);
        return;
    }
    snprintf(text, sizeof text, "%s%s", *odd == '-' ? "" : f->plus ? "+" : f->space ? " " : "", odd);
    if (f->conversion < 'a')
        for (char *c = text; *c; c++)
            *c = (char)(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
    add_padded(out, f, text, strlen(text));
}

static void add_string(lua_State *L, luaL_Buffer *out, const struct spec *f, int arg)
{
    size_t n;
    const char *s = lualib_tolstring(L, arg, &n);

    vm_charge(L, n / 8);
    if (f->width == 0 && f->precision < 0) {
        luaL_addvalue(out);
        return;
    }
    luaL_argcheck(L, !memchr(s, '\0', n), arg, "string contains zeros");
    if (f->precision >= 0 && (size_t)f->precision < n)
        n = (size_t)f->precision;
    /* The buffer wants the text off the stack; the argument or the buffer's copy keeps no hold on it. */
    char few[100];
    if (n >= sizeof few) {
        luaL_addvalue(out);
        return;
    }
    memcpy(few, s, n);
    lua_pop(L, 1);
    add_padded(out, f, few, n);
}

static void add_quoted_byte(luaL_Buffer *out, char c, char next)
{
    char text[8];
    bool control = (unsigned char)c < 32 || c == 127, digit = next >= '0' && next <= '9';

    if (c == '"' || c == '\\' || c == '\n')
        luaL_addchar(out, '\\');
    if (control && c != '\n') {
        snprintf(text, sizeof text, digit ? "\\%03d" : "\\%d", c);
        luaL_addstring(out, text);
    } else {
        luaL_addchar(out, c);
    }
}

static void add_quoted_text(lua_State *L, luaL_Buffer *out, const char *s, size_t n)
{
    vm_charge(L, n / 2);
    luaL_addchar(out, '"');
    for (size_t i = 0; i < n; i++)
        add_quoted_byte(out, s[i], i + 1 < n ? s[i + 1] : '\0');
    luaL_addchar(out, '"');
}

static void add_quoted_number(lua_State *L, luaL_Buffer *out, int arg)
{
    char text[40];
    lua_Number v = lua_tonumber(L, arg);
    const char *odd = odd_number(v);

    if (lua_isinteger(L, arg) && lua_tointeger(L, arg) == LUA_MININTEGER)
        snprintf(text, sizeof text, "0x8000000000000000");
    else if (lua_isinteger(L, arg))
        snprintf(text, sizeof text, "%" PRId64, (int64_t)lua_tointeger(L, arg));
    else if (odd)
        snprintf(text, sizeof text, "%s", *odd == 'n' ? "(0/0)" : *odd == '-' ? "-1e9999" : "1e9999");
    else if (fabs(v) < 0x1p63 && v == floor(v))
        snprintf(text, sizeof text, "%.1f", v);
    else
        luaL_argerror(L, arg, "%q takes whole numbers only");
    luaL_addstring(out, text);
}

static void add_quoted(lua_State *L, luaL_Buffer *out, int arg)
{
    size_t n;
    const char *s;

    switch (lua_type(L, arg)) {
    case LUA_TSTRING:
        s = lua_tolstring(L, arg, &n);
        add_quoted_text(L, out, s, n);
        break;
    case LUA_TNUMBER:
        add_quoted_number(L, out, arg);
        break;
    case LUA_TNIL:
    case LUA_TBOOLEAN:
        lualib_tolstring(L, arg, NULL);
        luaL_addvalue(out);
        break;
    default:
        luaL_argerror(L, arg, "value has no literal form");
    }
}

static void add_item(lua_State *L, luaL_Buffer *out, const struct spec *f, int arg)
{
    char c;

    vm_charge(L, strchr("eEfgG", f->conversion) ? 500 : 16);
    switch (f->conversion) {
    case 'c':
        c = (char)luaL_checkinteger(L, arg);
        add_padded(out, f, &c, 1);
        break;
    case 'e':
    case 'E':
    case 'f':
    case 'g':
    case 'G':
        add_float(out, f, luaL_checknumber(L, arg));
        break;
    case 's':
        add_string(L, out, f, arg);
        break;
    case 'q':
        add_quoted(L, out, arg);
        break;
    default:
        add_integer(out, f, luaL_checkinteger(L, arg));
    }
}

static int string_format(lua_State *L)
{
    size_t n;
    int top = lua_gettop(L), arg = 1;
    const char *p = luaL_checklstring(L, 1, &n), *end = p + n;
    struct spec f;
    luaL_Buffer out;

    vm_charge(L, n / 4);
    luaL_buffinit(L, &out);
    for (const char *q; (q = memchr(p, '%', (size_t)(end - p))) != NULL;) {
        luaL_addlstring(&out, p, (size_t)(q - p));
        p = q + 1;
        if (p < end && *p == '%') {
            luaL_addchar(&out, *p++);
            continue;
        }
        if (++arg > top)
            return luaL_argerror(L, arg, "no value");
        p = read_spec(L, p, end, &f);
        add_item(L, &out, &f, arg);
    }
    luaL_addlstring(&out, p, (size_t)(end - p));
    luaL_pushresult(&out);
    return 1;
}

void luatext_open(lua_State *L)
{
    static const luaL_Reg functions[] = { { "format", string_format }, { "rep", string_rep }, { NULL, NULL } };

    luaL_setfuncs(L, functions, 0);
}
