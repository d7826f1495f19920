/*
 * api_looks.c - the named pictures of a kind of enemy or player.
 *
 * Each picture is a row without a name in the list of kinds: picture n of kind k is row k - n, and the kind's own row
 * is picture 0, so a kind without pictures costs nothing. The names are stored in Lua, in a table per kind.
 */
#include <stdio.h>
#include <string.h>
#include "../events_run.h"
#include "api_parts.h"

/* Returns the property that holds the names of a kind's pictures: { name -> number, number -> name }. */
static const char *names_property(enum name_kind names)
{
    return names == N_ENEMY ? "pictures" : "ship's pictures";
}

static void add_picture(lua_State *L, const char *entry, struct api_pictures *p, const char *name, int at,
                        uint16_t default_sprite)
{
    char argument[64];
    struct api_value v = { .given = false };

    snprintf(argument, sizeof argument, "pictures.%s", name);
    const struct api_param sprite = OPTIONAL(argument, A_SPRITE, NULL);
    api_check(L, entry, &sprite, at, &v);
    p->name[p->n] = name;
    p->sprite[p->n++] = v.given ? (uint16_t)v.i : default_sprite;
}

static bool is_fixed_name(const struct api_pictures *p, int n_fixed, const char *name)
{
    for (int i = 0; i < n_fixed; i++)
        if (!strcmp(p->name[i], name))
            return true;
    return false;
}

void api_pictures_read(lua_State *L, const char *entry, const struct api_value *table, uint16_t default_sprite,
                       const char *const *fixed_names, int max, struct api_pictures *p)
{
    const char *names[MAX_PICTURES];
    int n_fixed = 0;

    p->n = 0;
    if (!table->given)
        return;
    for (; fixed_names[n_fixed]; n_fixed++) {
        lua_getfield(L, table->at, fixed_names[n_fixed]);
        add_picture(L, entry, p, fixed_names[n_fixed], lua_gettop(L), default_sprite);
        lua_pop(L, 1);
    }
    const int n = api_read_sorted_keys(L, entry, "pictures", "{ NAME = sprite }, such as { hurt = \"moth_hurt\" }",
                                       table->at, names, max);
    for (int i = 0; i < n; i++) {
        if (is_fixed_name(p, n_fixed, names[i]))
            continue;
        if (p->n == max)
            api_error(L, entry, "pictures: too many (at most %d)", max);
        lua_getfield(L, table->at, names[i]);
        add_picture(L, entry, p, names[i], lua_gettop(L), default_sprite); /* the table keeps the string alive */
        lua_pop(L, 1);
    }
}

void api_pictures_append_rows(lua_State *L, const char *entry, struct slots *kinds, uint16_t *sprite,
                              const struct api_pictures *p)
{
    for (int n = p->n; n > 0; n--) {
        int32_t row = slots_append(kinds);
        if (row == NO_SLOT)
            api_error(L, entry, "too many kinds (at most %d; each picture of a kind counts as one)", (int)kinds->cap);
        sprite[row] = p->sprite[n - 1];
    }
}

void api_pictures_store_names(lua_State *L, enum name_kind names, int32_t kind, const struct api_pictures *p)
{
    if (!p->n)
        return;
    lua_newtable(L);
    for (int n = 1; n <= p->n; n++) {
        lua_pushstring(L, p->name[n - 1]);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, n);
        lua_pushinteger(L, n);
        lua_rawset(L, -3);
    }
    events_set_property(L, (uint16_t)kind, names_property(names));
}

/* Pushes the table of a kind's picture names; returns false if the kind has none. */
static bool push_picture_names(lua_State *L, enum name_kind names, int32_t kind)
{
    events_push_property(L, (uint16_t)kind, names_property(names));
    return lua_istable(L, -1);
}

static int raise_unknown_picture(lua_State *L, const char *thing, const char *name)
{
    struct api_suggestion s = { .word = name };
    const int list = lua_gettop(L);

    for (int n = 1; lua_rawgeti(L, list, n) == LUA_TSTRING; n++)
        api_consider(&s, lua_tostring(L, -1));
    return api_error(L, thing, "its kind has no picture \"%s\"%s", name, api_push_did_you_mean(L, &s, ""));
}

unsigned api_picture_find(lua_State *L, enum name_kind names, int32_t kind, const char *thing,
                          const struct api_value *name)
{
    int top = lua_gettop(L);
    unsigned n = 0;

    if (!name->given)
        return 0;
    if (!push_picture_names(L, names, kind))
        api_error(L, thing, "its kind has no pictures (add `pictures` to its %s.def)", thing);
    lua_getfield(L, -1, lua_tostring(L, name->at));
    if (lua_isinteger(L, -1))
        n = (unsigned)lua_tointeger(L, -1);
    else {
        lua_pop(L, 1);
        raise_unknown_picture(L, thing, lua_tostring(L, name->at));
    }
    lua_settop(L, top);
    return n;
}

void api_picture_push(lua_State *L, enum name_kind names, int32_t kind, unsigned n)
{
    int top = lua_gettop(L);

    if (n && push_picture_names(L, names, kind))
        lua_rawgeti(L, -1, n);
    else
        lua_pushnil(L);
    lua_replace(L, top + 1);
    lua_settop(L, top + 1);
}
