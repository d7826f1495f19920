/*
 * value.c - see value.h.
 */
#include "value.h"

#include <lauxlib.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../script/api/api_table.h"
#include "../../script/luakeys.h"

enum { MAX_KEYS = 64 /* that a table accepts */ };

_Noreturn void value_fail(const struct manifest_value *v, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    lua_pushfstring(v->lua, "%s: ", v->path[0] != '\0' ? v->path : "manifest");
    lua_pushvfstring(v->lua, format, args);
    va_end(args);
    lua_concat(v->lua, 2);
    lua_error(v->lua);
    abort(); /* lua_error does not return */
}

const char *value_describe(const struct manifest_value *v)
{
    switch (lua_type(v->lua, v->index)) {
    case LUA_TNIL:
        return "nil";
    case LUA_TNUMBER:
        return lua_isinteger(v->lua, v->index) ? lua_pushfstring(v->lua, "%I", lua_tointeger(v->lua, v->index))
                                               : lua_pushfstring(v->lua, "%f", lua_tonumber(v->lua, v->index));
    case LUA_TSTRING: {
        char cut[48];
        snprintf(cut, sizeof cut, "\"%.40s\"", lua_tostring(v->lua, v->index));
        return lua_pushstring(v->lua, cut);
    }
    default:
        return lua_pushfstring(v->lua, "a %s", luaL_typename(v->lua, v->index));
    }
}

bool value_get(const struct manifest_value *table, const char *key, struct manifest_value *v)
{
    *v = (struct manifest_value){ table->lua, table->index + 1, "" };
    snprintf(v->path, MAX_PATH, "%.80s%s%.40s", table->path, table->path[0] != '\0' ? "." : "", key);
    lua_settop(v->lua, table->index);
    lua_pushstring(v->lua, key);
    return lua_rawget(v->lua, table->index) != LUA_TNIL;
}

void value_check_table(const struct manifest_value *v)
{
    if (!lua_istable(v->lua, v->index))
        value_fail(v, "expected a table, got %s", value_describe(v));
}

bool value_get_table(const struct manifest_value *table, const char *key, struct manifest_value *v)
{
    const bool is_given = value_get(table, key, v);

    if (is_given)
        value_check_table(v);
    return is_given;
}

void value_get_item(const struct manifest_value *list, int i, struct manifest_value *v)
{
    *v = (struct manifest_value){ list->lua, list->index + 1, "" };
    snprintf(v->path, MAX_PATH, "%.100s[%d]", list->path, i);
    lua_settop(v->lua, list->index);
    lua_rawgeti(v->lua, list->index, i);
}

int64_t value_to_whole(const struct manifest_value *v, int64_t lo, int64_t hi)
{
    int is_whole = 0;
    int64_t whole = lua_type(v->lua, v->index) == LUA_TNUMBER ? lua_tointegerx(v->lua, v->index, &is_whole) : 0;

    if (!is_whole || whole < lo || whole > hi)
        value_fail(v, "expected a whole number from %I to %I, got %s", (LUAI_UACINT)lo, (LUAI_UACINT)hi,
                   value_describe(v));
    return whole;
}

int32_t value_get_whole(const struct manifest_value *table, const char *key, int32_t lo, int32_t hi)
{
    struct manifest_value v;

    value_get(table, key, &v);
    return (int32_t)value_to_whole(&v, lo, hi);
}

double value_to_real(const struct manifest_value *v, double lo, double hi)
{
    const lua_Number real = lua_type(v->lua, v->index) == LUA_TNUMBER ? lua_tonumber(v->lua, v->index) : lo - 1;

    if (!(real >= lo && real <= hi))
        value_fail(v, "expected a number from %d to %d, got %s", (int)lo, (int)hi, value_describe(v));
    return real;
}

void value_to_text(const struct manifest_value *v, const char *noun, char *out, size_t size)
{
    size_t n = 0;
    const char *s = lua_type(v->lua, v->index) == LUA_TSTRING ? lua_tolstring(v->lua, v->index, &n) : NULL;

    if (s == NULL)
        value_fail(v, "expected %s, got %s", noun, value_describe(v));
    if (n >= size || strlen(s) != n)
        value_fail(v, "expected %s of at most %d bytes, got %s", noun, (int)size - 1, value_describe(v));
    memset(out, 0, size);
    memcpy(out, s, n);
}

void value_to_file(const struct manifest_value *v, char out[ART_FILE_SIZE])
{
    value_to_text(v, "a file", out, ART_FILE_SIZE);
    if (!manifest_path_ok(out))
        value_fail(v, "expected a file inside the folder (letters, digits, _ - . /), got \"%s\"", out);
}

int value_to_choice(const struct manifest_value *v, const char *const *words, int n, const char *form)
{
    for (int i = 0; i < n; i++)
        if (lua_type(v->lua, v->index) == LUA_TSTRING && strcmp(lua_tostring(v->lua, v->index), words[i]) == 0)
            return i;
    value_fail(v, "expected %s, got %s", form, value_describe(v));
}

int value_to_length(const struct manifest_value *list, int max)
{
    lua_State *lua = list->lua;
    lua_Unsigned n = lua_rawlen(lua, list->index), keys = 0;

    for (lua_pushnil(lua); lua_next(lua, list->index) != 0; keys++)
        lua_pop(lua, 1);
    if (keys != n)
        value_fail(list, "expected a list");
    if (n > (lua_Unsigned)max)
        value_fail(list, "expected at most %d entries, got %d", max, (int)n);
    return (int)n;
}

int value_to_words(const struct manifest_value *list, char out[][MAX_SETTING_NAME], int max)
{
    const int n = value_to_length(list, max);
    struct manifest_value word;

    for (int i = 0; i < n; i++) {
        value_get_item(list, i + 1, &word);
        value_to_text(&word, "a word", out[i], MAX_SETTING_NAME);
        if (!manifest_setting_name_ok(out[i]))
            value_fail(&word, "expected a word of letters, digits, _ and -, got \"%s\"", out[i]);
        for (int j = 0; j < i; j++)
            if (strcmp(out[i], out[j]) == 0)
                value_fail(&word, "duplicate \"%s\"", out[i]);
    }
    return n;
}

static bool is_name(lua_State *lua, const char *key, const void *size)
{
    (void)lua;
    return key != NULL && strlen(key) < *(const size_t *)size && manifest_path_ok(key);
}

/* Returns the unknown key on top of the stack, with the path of its table. Raises an error if it is not a string. */
static struct manifest_value get_key(const struct manifest_value *table)
{
    struct manifest_value key = *table;

    key.index = lua_gettop(key.lua);
    if (luakeys_text(key.lua, key.index) == NULL)
        value_fail(&key, "expected only names as keys, got %s", value_describe(&key));
    return key;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(a, b);
}

int value_to_names(const struct manifest_value *table, void *out, int max, size_t stride, size_t name_size)
{
    lua_State *lua = table->lua;
    char *name = out;
    int n = 0;

    if (luakeys_push_unknown(lua, table->index, is_name, &name_size)) {
        const struct manifest_value key = get_key(table);
        value_to_text(&key, "a name", name, name_size);
        value_fail(&key, "\"%s\": expected a name of letters, digits, _ - . and /", name);
    }
    for (lua_pushnil(lua); lua_next(lua, table->index) != 0; n++, name += stride) {
        lua_pop(lua, 1);
        if (n == max)
            value_fail(table, "expected at most %d entries", max);
        snprintf(name, name_size, "%s", lua_tostring(lua, -1));
    }
    qsort(out, (size_t)n, stride, compare_names);
    return n;
}

static void read_pair(const struct manifest_value *v, const struct manifest_field *f, int32_t pair[2])
{
    struct manifest_value item;

    value_check_table(v);
    if (value_to_length(v, 2) != 2)
        value_fail(v, "expected %s", f->noun);
    for (int i = 0; i < 2; i++) {
        value_get_item(v, i + 1, &item);
        pair[i] = (int32_t)value_to_whole(&item, (int64_t)f->lo, (int64_t)f->hi);
    }
}

static void read_flag(const struct manifest_value *v, size_t size, void *out)
{
    if (!lua_isboolean(v->lua, v->index))
        value_fail(v, "expected true or false, got %s", value_describe(v));
    if (size == sizeof(bool))
        *(bool *)out = lua_toboolean(v->lua, v->index);
    else
        *(int32_t *)out = lua_toboolean(v->lua, v->index);
}

static void read_field(const struct manifest_value *v, const struct manifest_field *f, void *out)
{
    static const char *const matches[] = { "colour", "index" };

    switch (f->type) {
    case FIELD_WHOLE:
        *(int32_t *)out = (int32_t)value_to_whole(v, (int64_t)f->lo, (int64_t)f->hi);
        break;
    case FIELD_REAL:
        *(double *)out = value_to_real(v, f->lo, f->hi);
        break;
    case FIELD_SHARE:
        *(int32_t *)out = (int32_t)(value_to_real(v, f->lo, f->hi) * 255 + 0.5);
        break;
    case FIELD_FLAG:
        read_flag(v, f->size, out);
        break;
    case FIELD_TEXT:
        value_to_text(v, f->noun, out, f->size);
        break;
    case FIELD_FILE:
        value_to_file(v, out);
        break;
    case FIELD_PAIR:
        read_pair(v, f, out);
        break;
    case FIELD_MATCH:
        *(bool *)out = value_to_choice(v, matches, 2, "\"colour\" or \"index\"") == 1;
        break;
    }
}

void value_read_fields(const struct manifest_value *table, const struct manifest_field *fields, size_t n, void *out)
{
    struct manifest_value v;

    for (size_t i = 0; i < n; i++)
        if (value_get(table, fields[i].key, &v))
            read_field(&v, &fields[i], (char *)out + fields[i].offset);
}

/* The keys that are allowed in a table. */
struct known_keys {
    const char *names[MAX_KEYS];
    int n;
};

static bool is_known(lua_State *lua, const char *key, const void *context)
{
    const struct known_keys *known = context;
    int i = 0;

    (void)lua;
    while (key != NULL && i < known->n && strcmp(known->names[i], key) != 0)
        i++;
    return key != NULL && i < known->n;
}

void value_check_keys(const struct manifest_value *table, const struct manifest_field *fields, size_t n,
                      const char *const *others)
{
    struct known_keys known = { .n = 0 };
    struct api_suggestion s;
    struct manifest_value v;

    value_check_table(table);
    for (size_t i = 0; i < n; i++)
        known.names[known.n++] = fields[i].key;
    for (; others != NULL && *others != NULL; others++)
        known.names[known.n++] = *others;
    if (!luakeys_push_unknown(table->lua, table->index, is_known, &known))
        return;
    v = get_key(table);
    s = (struct api_suggestion){ .word = lua_tostring(v.lua, v.index) };
    for (int i = 0; i < known.n; i++)
        api_consider(&s, known.names[i]);
    value_get(table, s.word, &v);
    if (s.nearest == NULL)
        value_fail(&v, "unknown key");
    value_fail(&v, "unknown key (did you mean \"%s\"?)", s.nearest);
}
