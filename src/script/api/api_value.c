/*
 * api_value.c - value.def: names for numbers that a game stores with each bullet, shot or enemy. The columns are a
 * group of the chip (slots.h) that rom.lua enables.
 */
#include <string.h>
#include "api_parts.h"

/* Kinds of entity that can have values, in the order of the lists from N_BULLET_VALUE. */
enum { KIND_COUNT = 3 };
static const char *const kind_names[KIND_COUNT] = { "bullet", "shot", "enemy" };
static const char *const creator_entries[KIND_COUNT] = { "bullet.fire", "shot.fire", "enemy.spawn" };
static const enum handle_kind handle_kinds[KIND_COUNT] = { H_BULLET, H_SHOT, H_ENEMY };

static bool is_identifier(const char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";

    return name[0] && !strchr("0123456789", name[0]) && strlen(name) == strspn(name, allowed);
}

/* Returns whether the name is already used: by a property or a verb of the thing, or an argument of the function that
 * creates the thing. */
static bool is_name_taken(lua_State *L, int kind, const char *name)
{
    const struct api_entry *creator = api_find_entry(api_get_table(L), creator_entries[kind]);
    const enum handle_kind group = kind == 0 ? H_GROUP : handle_kinds[kind];
    bool used = !strcmp(name, "alive");

    used |= api_has_property(api_get_table(L)->things[handle_kinds[kind]], name) ||
            api_has_property(api_get_table(L)->things[group], name);
    for (int i = 0; i < creator->count; i++)
        used |= !strcmp(creator->params[i].name, name);
    for (int i = 0; kind == 0 && i < api_count_entries(api_get_table(L));
         i++) /* patterns pass on all arguments but their own */
        for (int k = 0;
             api_get_entry(api_get_table(L), i)->flags & API_PATTERN && k < api_get_entry(api_get_table(L), i)->count;
             k++)
            used |= !strcmp(api_get_entry(api_get_table(L), i)->params[k].name, name);
    used |= api_push_method(L, (int)handle_kinds[kind], name);
    lua_pop(L, 1);
    return used;
}

enum { D_NAME, D_KIND, D_START };

static const struct api_param def_params[] = {
    LABEL("name", REQ,
          "name of the value, used as a property of the thing and as an argument of the function that creates it"),
    OPTIONAL("of", A_STR, "what the value belongs to: bullet, shot or enemy; defaults to bullet"),
    PARAM("start", A_FX, OPT, -32768, 32767, NULL, "0",
          "initial value if the call that creates the thing doesn't set one")
};

static const char def_entry[] = "value.def";

static int read_kind(lua_State *L, const struct api_value *owner)
{
    const char *kind_name = owner->given ? lua_tostring(L, owner->at) : kind_names[0];

    for (int k = 0; k < KIND_COUNT; k++)
        if (!strcmp(kind_name, kind_names[k]))
            return k;
    return api_error(L, def_entry, "of: expected \"bullet\", \"shot\" or \"enemy\", got \"%s\"", kind_name);
}

/* Raises an error if all columns enabled in rom.lua are in use. */
static void check_capacity(lua_State *L, const struct board *b, int kind, const char *name)
{
    const int32_t capacity[KIND_COUNT] = { b->cart.manifest.bullet_values, b->cart.manifest.shot_values,
                                           b->cart.manifest.enemy_values };
    const int n = api_value_count(b, (enum name_kind)(N_BULLET_VALUE + kind));

    if (n < capacity[kind])
        return;
    if (n == MAX_VALUES)
        api_error(L, def_entry, "\"%s\": too many values (at most %d for %s)", name, MAX_VALUES,
                  api_thing_names[handle_kinds[kind]]);
    api_error(L, def_entry, "\"%s\": too few value columns; set `values = { %s = %d }` in `board` in rom.lua", name,
              kind_names[kind], n + 1);
}

static int value_def(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[D_NAME].at);
    const int kind = read_kind(L, &v[D_KIND]);
    const enum name_kind value_kind = (enum name_kind)(N_BULLET_VALUE + kind);
    const int k = api_value_count(b, value_kind);

    if (!is_identifier(name))
        api_error(L, def_entry, "name: expected a word of letters, digits and _, got \"%s\"", name);
    if (is_name_taken(L, kind, name))
        api_error(L, def_entry, "\"%s\" is already a property or a method of %s, or an argument of %s%s", name,
                  api_thing_names[handle_kinds[kind]], creator_entries[kind], kind == 0 ? " or a pattern" : "");
    if (api_names_find(L, value_kind, name) != NO_SLOT)
        api_error(L, def_entry, "\"%s\" is already declared", name);
    check_capacity(L, b, kind, name);
    api_names_declare(L, value_kind, def_entry, name, k);
    if (kind == 2)
        b->enemies.initial_value[k] = v[D_START].f;
    else
        (kind == 1 ? &b->shots : &b->bullets)->initial_value[k] = v[D_START].f;
    return 0;
}

static const struct api_entry entries[] = {
    { "value.def", value_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a number to store with each bullet, shot or enemy; needs `board = { values = { .. } }`") },
};
const struct api_module api_value = { entries, sizeof entries / sizeof *entries };
