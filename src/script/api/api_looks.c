/*
 * api_looks.c - the named pictures of a kind of enemy or player.
 *
 * Each picture is a row without a name in the list of kinds: picture n of kind k is row k - n, and the kind's own row
 * is picture 0, so a kind without pictures costs nothing. The names are stored in Lua, in a table per kind.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"
#include "api_parts.h"

static const char names_key[NAME_LISTS] = { 0 }; /* registry: kind -> { name -> number, number -> name } */

static void add(lua_State *L, const char *entry, struct api_pictures *p, const char *name, int at, uint16_t own)
{
    char argument[64];
    struct api_value v = { .given = false };

    snprintf(argument, sizeof argument, "pictures.%s", name);
    const struct api_param sprite = { argument, A_SPRITE, OPT, 0, 0, NULL, NULL, NULL };
    api_check(L, entry, &sprite, at, &v);
    p->name[p->n] = name;
    p->sprite[p->n++] = v.given ? (uint16_t)v.i : own;
}

static bool is_first(const struct api_pictures *p, int first, const char *name)
{
    for (int i = 0; i < first; i++)
        if (!strcmp(p->name[i], name))
            return true;
    return false;
}

void api_pictures_read(lua_State *L, const char *entry, const struct api_value *table, uint16_t own,
                       const char *const *first, int most, struct api_pictures *p)
{
    const char *names[MOST_PICTURES];
    int fixed = 0;

    p->n = 0;
    if (!table->given)
        return;
    for (; first[fixed]; fixed++) {
        lua_getfield(L, table->at, first[fixed]);
        add(L, entry, p, first[fixed], lua_gettop(L), own);
        lua_pop(L, 1);
    }
    const int n = api_sorted_names(L, entry, "pictures", "{ NAME = sprite }, such as { hurt = \"moth_hurt\" }",
                                   table->at, names, most);
    for (int i = 0; i < n; i++) {
        if (is_first(p, fixed, names[i]))
            continue;
        if (p->n == most)
            api_error(L, entry, "pictures: too many (at most %d)", most);
        lua_getfield(L, table->at, names[i]);
        add(L, entry, p, names[i], lua_gettop(L), own); /* the table keeps the string alive */
        lua_pop(L, 1);
    }
}

void api_pictures_rows(lua_State *L, const char *entry, struct slots *kinds, uint16_t *sprite,
                       const struct api_pictures *p)
{
    for (int n = p->n; n > 0; n--) {
        int32_t row = slots_append(kinds);
        if (row == NO_SLOT)
            api_error(L, entry, "too many kinds (at most %d; each picture of a kind counts as one)", (int)kinds->cap);
        sprite[row] = p->sprite[n - 1];
    }
}

void api_pictures_keep(lua_State *L, enum name_kind of, int32_t kind, const struct api_pictures *p)
{
    if (!p->n)
        return;
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[of]) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &names_key[of]);
    }
    lua_newtable(L);
    for (int n = 1; n <= p->n; n++) {
        lua_pushstring(L, p->name[n - 1]);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, n);
        lua_pushinteger(L, n);
        lua_rawset(L, -3);
    }
    lua_rawseti(L, -2, kind);
    lua_pop(L, 1);
}

/* Pushes the table of a kind's picture names; returns false if the kind has none. */
static bool push_names(lua_State *L, enum name_kind of, int32_t kind)
{
    return lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[of]) == LUA_TTABLE && lua_rawgeti(L, -1, kind) == LUA_TTABLE;
}

static int unknown(lua_State *L, const char *thing, const char *name)
{
    const char *found = NULL;
    int best = EDIT_FAR, list = lua_gettop(L);

    for (int n = 1; lua_rawgeti(L, list, n) == LUA_TSTRING; n++)
        api_suggest_nearer(name, lua_tostring(L, -1), &best, &found);
    if (found)
        return api_error(L, thing, "its kind has no picture \"%s\" (did you mean \"%s\"?)", name, found);
    return api_error(L, thing, "its kind has no picture \"%s\"", name);
}

unsigned api_picture_named(lua_State *L, enum name_kind of, int32_t kind, const char *thing,
                           const struct api_value *name)
{
    int top = lua_gettop(L);
    unsigned n = 0;

    if (!name->given)
        return 0;
    if (!push_names(L, of, kind))
        api_error(L, thing, "its kind has no pictures (add `pictures` to its %s.def)", thing);
    lua_getfield(L, -1, lua_tostring(L, name->at));
    if (lua_isinteger(L, -1))
        n = (unsigned)lua_tointeger(L, -1);
    else {
        lua_pop(L, 1);
        unknown(L, thing, lua_tostring(L, name->at));
    }
    lua_settop(L, top);
    return n;
}

void api_picture_push(lua_State *L, enum name_kind of, int32_t kind, unsigned n)
{
    int top = lua_gettop(L);

    if (n && push_names(L, of, kind))
        lua_rawgeti(L, -1, n);
    else
        lua_pushnil(L);
    lua_replace(L, top + 1);
    lua_settop(L, top + 1);
}
