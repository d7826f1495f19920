/*
 * manifest_at.c - see manifest_at.h.
 */
#include "manifest_at.h"

#include <lauxlib.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../script/luakeys.h"

_Noreturn void at_bad(lua_State *lua, const char *path, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    lua_pushfstring(lua, "%s: ", path);
    lua_pushvfstring(lua, format, args);
    va_end(args);
    lua_concat(lua, 2);
    lua_error(lua);
    abort(); /* lua_error does not return */
}

void at_path(const struct at *a, const char *key, char out[MAX_PATH])
{
    snprintf(out, MAX_PATH, "%.80s%s%.40s", a->path, a->path[0] != '\0' ? "." : "", key);
}

/* Describes the value on top of the stack: nil, 2.5, "text", a table. */
const char *at_got(lua_State *lua)
{
    switch (lua_type(lua, -1)) {
    case LUA_TNIL:
        return "nil";
    case LUA_TNUMBER:
        return lua_isinteger(lua, -1) ? lua_pushfstring(lua, "%I", lua_tointeger(lua, -1))
                                      : lua_pushfstring(lua, "%f", lua_tonumber(lua, -1));
    case LUA_TSTRING: {
        char cut[48];
        snprintf(cut, sizeof cut, "\"%.40s\"", lua_tostring(lua, -1));
        return lua_pushstring(lua, cut);
    }
    default:
        return lua_pushfstring(lua, "a %s", luaL_typename(lua, -1));
    }
}

/* Pushes a[key]; false, and nothing pushed, when it is nil. */
bool at_get(const struct at *a, const char *key)
{
    luaL_checkstack(a->lua, 8, NULL);
    lua_pushstring(a->lua, key);
    if (lua_rawget(a->lua, a->index) != LUA_TNIL)
        return true;
    lua_pop(a->lua, 1);
    return false;
}

/* a[key] as a table, left on the stack; false when it is nil. */
bool at_table(const struct at *a, const char *key, struct at *out)
{
    if (!at_get(a, key))
        return false;
    *out = (struct at){ a->lua, lua_gettop(a->lua), "" };
    at_path(a, key, out->path);
    if (!lua_istable(a->lua, -1))
        at_bad(a->lua, out->path, "expected a table, got %s", at_got(a->lua));
    return true;
}

/* The value on top as a whole number; popped. */
int64_t at_to_whole(lua_State *lua, const char *path, int64_t lo, int64_t hi)
{
    int whole = 0;
    int64_t v = lua_type(lua, -1) == LUA_TNUMBER ? lua_tointegerx(lua, -1, &whole) : 0;

    if (!whole || v < lo || v > hi)
        at_bad(lua, path, "expected a whole number from %I to %I, got %s", (LUAI_UACINT)lo, (LUAI_UACINT)hi,
               at_got(lua));
    lua_pop(lua, 1);
    return v;
}

/* a[key] into *v, which stays when it is nil. */
void at_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v)
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (at_get(a, key))
        *v = (int32_t)at_to_whole(a->lua, path, lo, hi);
}

void at_need_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v)
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (!at_get(a, key))
        lua_pushnil(a->lua);
    *v = (int32_t)at_to_whole(a->lua, path, lo, hi);
}

/* The value on top as a string of at most size - 1 bytes into out, the rest of it zeroed; popped. what: "a file", "a
 * word". */
static void at_to_text(lua_State *lua, const char *path, const char *what, char *out, size_t size)
{
    size_t n = 0;
    const char *s = lua_type(lua, -1) == LUA_TSTRING ? lua_tolstring(lua, -1, &n) : NULL;

    if (s == NULL)
        at_bad(lua, path, "expected %s, got %s", what, at_got(lua));
    if (n >= size || strlen(s) != n)
        at_bad(lua, path, "expected %s of at most %d bytes, got %s", what, (int)size - 1, at_got(lua));
    memset(out, 0, size);
    memcpy(out, s, n);
    lua_pop(lua, 1);
}

bool at_text(const struct at *a, const char *key, const char *what, char *out, size_t size)
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (!at_get(a, key))
        return false;
    at_to_text(a->lua, path, what, out, size);
    return true;
}

/* The value on top as the path of a file in the game's folder; popped. */
void at_to_file(lua_State *lua, const char *path, char out[ART_FILE_SIZE])
{
    at_to_text(lua, path, "a file", out, ART_FILE_SIZE);
    if (!manifest_path_ok(out))
        at_bad(lua, path, "expected a file inside the folder (letters, digits, _ - . /), got \"%s\"", out);
}

bool at_file(const struct at *a, const char *key, char out[ART_FILE_SIZE])
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (!at_get(a, key))
        return false;
    at_to_file(a->lua, path, out);
    return true;
}

static size_t min_size(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Letters to change, add or drop to make b of a. Both shorter than 32. Unlike edit.h's distance: a swap counts two. */
static size_t distance(const char *a, const char *b)
{
    size_t row[32], n = strlen(b);

    for (size_t j = 0; j <= n; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        size_t corner = row[0];
        row[0] = i;
        for (size_t j = 1; j <= n; j++) {
            size_t best = min_size(corner + (a[i - 1] != b[j - 1]), min_size(row[j], row[j - 1]) + 1);
            corner = row[j];
            row[j] = best;
        }
    }
    return row[n];
}

/* The name of the list nearest to word, or NULL: none is near. */
static const char *near(const char *word, const char *const *names)
{
    const char *best = NULL;
    size_t least = 3;

    for (; strlen(word) < 32 && *names != NULL; names++) {
        size_t d = distance(word, *names);
        if (d < least && d < strlen(word)) {
            least = d;
            best = *names;
        }
    }
    return best;
}

static _Noreturn void at_bad_name(const struct at *a, const char *key, const char *const *names)
{
    char path[MAX_PATH];
    const char *guess = near(key, names);

    at_path(a, key, path);
    if (guess == NULL)
        at_bad(a->lua, path, "unknown key");
    at_bad(a->lua, path, "unknown key (did you mean \"%s\"?)", guess);
}

static bool at_listed(const char *name, const char *const *names)
{
    while (*names != NULL && strcmp(*names, name) != 0)
        names++;
    return *names != NULL;
}

static bool is_listed(lua_State *lua, const char *key, const void *of)
{
    (void)lua;
    return key != NULL && at_listed(key, of);
}

/* Every key of a is one of names. */
void at_only(const struct at *a, const char *const *names)
{
    if (!luakeys_push_unknown(a->lua, a->index, is_listed, names))
        return;
    const char *key = luakeys_text(a->lua, -1);
    if (key == NULL)
        at_bad(a->lua, a->path[0] != '\0' ? a->path : "manifest", "expected only names as keys, got %s",
               at_got(a->lua));
    at_bad_name(a, key, names);
}

/* a is a list and nothing else; returns its length, at most max. */
int at_list(const struct at *a, int max)
{
    lua_State *lua = a->lua;
    lua_Unsigned n = lua_rawlen(lua, a->index), keys = 0;

    for (lua_pushnil(lua); lua_next(lua, a->index) != 0; keys++)
        lua_pop(lua, 1);
    if (keys != n)
        at_bad(lua, a->path, "expected a list");
    if (n > (lua_Unsigned)max)
        at_bad(lua, a->path, "expected at most %d entries, got %d", max, (int)n);
    return (int)n;
}

/* Pushes a[i], i from 1; path gets "extends[2]". */
void at_item(const struct at *a, int i, char path[MAX_PATH])
{
    snprintf(path, MAX_PATH, "%.100s[%d]", a->path, i);
    lua_rawgeti(a->lua, a->index, i);
}

/* The words of a list; returns how many. */
int at_words(const struct at *a, char out[][MAX_SETTING_NAME], int max)
{
    int n = at_list(a, max);

    for (int i = 0; i < n; i++) {
        char path[MAX_PATH];
        at_item(a, i + 1, path);
        at_to_text(a->lua, path, "a word", out[i], MAX_SETTING_NAME);
        if (!manifest_setting_name_ok(out[i]))
            at_bad(a->lua, path, "expected a word of letters, digits, _ and -, got \"%s\"", out[i]);
        for (int j = 0; j < i; j++)
            if (strcmp(out[i], out[j]) == 0)
                at_bad(a->lua, path, "duplicate \"%s\"", out[i]);
    }
    return n;
}

static bool is_name(lua_State *lua, const char *key, const void *size)
{
    (void)lua;
    return key != NULL && strlen(key) < *(const size_t *)size && manifest_path_ok(key);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* The keys of a, sorted, into the first bytes (a name) of an array of structs; returns how many. */
int at_keys(const struct at *a, void *out, int max, size_t stride, size_t name_size)
{
    lua_State *lua = a->lua;
    char *name = out;
    int n = 0;

    if (luakeys_push_unknown(lua, a->index, is_name, &name_size)) {
        if (luakeys_text(lua, -1) == NULL)
            at_bad(lua, a->path, "expected only names as keys, got %s", at_got(lua));
        at_to_text(lua, a->path, "a name", name, name_size);
        at_bad(lua, a->path, "\"%s\": expected a name of letters, digits, _ - . and /", name);
    }
    for (lua_pushnil(lua); lua_next(lua, a->index) != 0; n++, name += stride) {
        lua_pop(lua, 1);
        if (n == max)
            at_bad(lua, a->path, "expected at most %d entries", max);
        lua_pushvalue(lua, -1);
        at_to_text(lua, a->path, "a name", name, name_size);
    }
    qsort(out, (size_t)n, stride, by_name);
    return n;
}

/* A share, of 255. */
int32_t at_share(const struct at *a, const char *key, int32_t usual)
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (!at_get(a, key))
        return usual;
    const lua_Number v = lua_type(a->lua, -1) == LUA_TNUMBER ? lua_tonumber(a->lua, -1) : -1;
    if (!(v >= 0 && v <= 1))
        at_bad(a->lua, path, "expected a number from 0 to 1, got %s", at_got(a->lua));
    lua_pop(a->lua, 1);
    return (int32_t)(v * 255 + 0.5);
}

/* The value on top as a number; popped. */
static double at_to_real(lua_State *lua, const char *path, double lo, double hi)
{
    const lua_Number v = lua_type(lua, -1) == LUA_TNUMBER ? lua_tonumber(lua, -1) : lo - 1;

    if (!(v >= lo && v <= hi))
        at_bad(lua, path, "expected a number from %d to %d, got %s", (int)lo, (int)hi, at_got(lua));
    lua_pop(lua, 1);
    return v;
}

bool at_real(const struct at *a, const char *key, double lo, double hi, double *v)
{
    char path[MAX_PATH];

    at_path(a, key, path);
    if (!at_get(a, key))
        return false;
    *v = at_to_real(a->lua, path, lo, hi);
    return true;
}

bool at_flag(const struct at *a, const char *key)
{
    char path[MAX_PATH];
    bool v;

    at_path(a, key, path);
    if (!at_get(a, key))
        return false;
    if (!lua_isboolean(a->lua, -1))
        at_bad(a->lua, path, "expected true or false, got %s", at_got(a->lua));
    v = lua_toboolean(a->lua, -1);
    lua_pop(a->lua, 1);
    return v;
}
