/*
 * api_handle.c - the metatable of the number type: properties and methods of handles.
 */
#include <string.h>
#include "../../base/edit.h"
#include "../lua/lualib.h"
#include "api_parts.h"

/* Registry, by kind of handle: a table that maps every name looked up so far to the method, or to false if there is no
 * method of that name. */
static const char methods_key[HANDLES] = { 0 };

bool api_push_method(lua_State *L, int kind, const char *name)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &methods_key[kind]) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &methods_key[kind]);
    }
    if (lua_getfield(L, -1, name) == LUA_TNIL) {
        lua_pop(L, 1);
        if (!api_push_member(L, api_of(L)->things[kind]->name, ':', name))
            lua_pushboolean(L, 0);
        lua_pushvalue(L, -1);
        lua_setfield(L, -3, name);
    }
    lua_remove(L, -2);
    return lua_isfunction(L, -1);
}

static const struct api_prop *search_prop(const struct api_thing *t, const char *name, int *index)
{
    for (int i = 0; i < t->n; i++)
        if (!strcmp(t->props[i].value.name, name)) {
            *index = i;
            return &t->props[i];
        }
    return NULL;
}

bool api_property(const struct api_thing *t, const char *name)
{
    int unused;

    return search_prop(t, name, &unused) != NULL;
}

/* Returns the property of that name if the guess is right, otherwise NULL. A property cannot hide a method, because no
 * verb has the name of a property. */
static const struct api_prop *prop_guessed(const struct api_thing *t, const uint8_t *guess, const char *name)
{
    return *guess < t->n && !strcmp(t->props[*guess].value.name, name) ? &t->props[*guess] : NULL;
}

/* Returns the guess (api_guess) for a property of that kind of thing. Reads and writes have separate guesses, so that a
 * write cannot change which path the first read of a name takes. */
static uint8_t *prop_guess(struct board *b, enum handle_kind kind, bool write, const char *name, size_t n)
{
    return &b->vm.guesses.props[api_guess(name, n, (unsigned)kind + (write ? HANDLES : 0))];
}

static const struct api_prop *prop_named(const struct api_thing *t, uint8_t *guess, const char *name, int *index)
{
    const struct api_prop *prop = prop_guessed(t, guess, name);

    if (prop) {
        *index = *guess;
        return prop;
    }
    prop = search_prop(t, name, index);
    if (prop)
        *guess = (uint8_t)*index;
    return prop;
}

static int raise_unknown_property(lua_State *L, const struct api_thing *t, int kind, const char *name)
{
    const char *found = NULL;
    int best = EDIT_FAR;

    if (api_reserved(t->name, ':', name) && !(kind == H_PLAYER && api_register_declared(L, name)))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s %s", t->name, name, NOT_YET);
    for (int i = 0; i < t->n; i++)
        api_suggest_nearer(name, t->props[i].value.name, &best, &found);
    if (api_ends((enum handle_kind)kind))
        api_suggest_nearer(name, "alive", &best, &found);
    enum name_kind values = api_value_names_of((enum handle_kind)kind);
    for (int k = 0; k < api_values(vm_board(L), values); k++)
        api_suggest_nearer(name, board_name(vm_board(L), values, k), &best, &found);
    for (int i = 0; i < api_count(api_of(L)); i++) {
        const char *verb = api_member(api_entry(api_of(L), i), t->name, ':');
        if (verb)
            api_suggest_nearer(name, verb, &best, &found);
    }
    if (found)
        return vm_fault(L, FAULT_SCRIPT, "%s has no property \"%s\" (did you mean \"%s\"?)", api_thing_names[kind],
                        name, found);
    return vm_fault(L, FAULT_SCRIPT, "%s has no property \"%s\"", api_thing_names[kind], name);
}

/* Raises the error for writing a name that can only be read or called: a property, a verb, `alive`. */
static int read_only(lua_State *L, const struct api_thing *t, int kind, const char *name)
{
    if (api_push_method(L, kind, name))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s is a method; call it with a colon, thing:%s(...)", t->name, name,
                        name);
    lua_pop(L, 1);
    if (api_property(t, name) || (api_ends((enum handle_kind)kind) && !strcmp(name, "alive")))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s is read-only", t->name, name);
    return raise_unknown_property(L, t, kind, name);
}

/* Returns the index of a declared value of that kind of thing, or NO_SLOT. */
static int value_named(lua_State *L, const struct board *b, enum handle_kind kind, const char *name)
{
    enum name_kind names = api_value_names_of(kind);

    return api_values(b, names) ? api_names_find(L, names, name) : NO_SLOT;
}

/* Returns the pool of that kind of thing, or of a group's members. */
static const struct slots *pool(const struct board *b, enum handle_kind kind)
{
    switch (kind) {
    case H_BULLET:
    case H_GROUP:
        return &b->bullets.s;
    case H_SHOT:
    case H_SHOTS:
        return &b->shots.s;
    case H_ITEM:
    case H_ITEMS:
        return &b->items.s;
    case H_LASER:
    case H_LASERS:
        return &b->laser_heads.s;
    default:
        return &b->enemies.s;
    }
}

/* Returns the tags of the members of a group. */
static const uint16_t *tags_of(const struct board *b, enum handle_kind group)
{
    return group == H_GROUP   ? b->bullets.tag
           : group == H_SHOTS ? b->shots.tag
           : group == H_ITEMS ? b->items.tag
                              : b->enemies.tag;
}

static int push_dead(lua_State *L, const char *name)
{
    vm_note_dead(L, name);
    lua_pushnil(L);
    return 1;
}

static int get_value(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, const char *name)
{
    enum handle_kind kind = handle_kind(h);
    int k = value_named(L, b, kind, name);

    if (k == NO_SLOT)
        return raise_unknown_property(L, t, (int)kind, name);
    if (handle_kind_group(kind))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s cannot be read from a group (only `count` can)", t->name, name);
    if (board_there(b, h))
        lua_pushnumber(L, fx_to_double(api_value_column(b, api_value_names_of(kind), k)[handle_slot(h)]));
    else
        push_dead(L, name);
    return 1;
}

static int set_value(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, int k, const char *name)
{
    enum handle_kind kind = handle_kind(h);
    struct api_param p = api_value_param(name);
    fx *column = api_value_column(b, api_value_names_of(kind), k);
    struct api_value v = { 0 };

    api_check(L, t->name, &p, 3, &v);
    if (!handle_kind_group(kind)) {
        if (board_alive(b, h))
            column[handle_slot(h)] = v.f;
        return 0;
    }
    const struct slots *s = pool(b, kind);
    vm_charge(L, s->live);
    EACH_LIVE (i, s)
        if (api_has_tag(tags_of(b, kind), i, handle_slot(h)))
            column[i] = v.f;
    return 0;
}

/* Properties that must be enabled in rom.lua. */
enum { ENEMIES = 1 << H_ENEMY | 1 << H_ENEMIES };
static const struct {
    const char *name;
    unsigned of;      /* mask of handle kinds */
    int group;        /* column group (GROUP_) */
    const char *word; /* the setting in rom.lua */
} switched[] = {
    { "frozen",
      1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_ITEM | 1 << H_LASER | 1 << H_GROUP | 1 << H_SHOTS |
          1 << H_ENEMIES | 1 << H_ITEMS | 1 << H_LASERS,
      GROUP_FROZEN, "frozen" },
    { "rate", ENEMIES, GROUP_BODIES, "bodies" },
    { "share", ENEMIES, GROUP_BODIES, "bodies" },
    { "follow", ENEMIES, GROUP_BODIES, "bodies" },
    { "dx", ENEMIES, GROUP_BODIES, "bodies" },
    { "dy", ENEMIES, GROUP_BODIES, "bodies" },
};

/* Raises a fault if the property is disabled in rom.lua, even if the thing does not exist. */
static void check_on(lua_State *L, const struct board *b, const struct api_thing *t, enum handle_kind kind,
                     const char *name)
{
    for (size_t i = 0; i < sizeof switched / sizeof *switched; i++)
        if (switched[i].name[0] == name[0] && switched[i].of >> kind & 1 && !strcmp(switched[i].name, name) &&
            !(pool(b, kind)->groups & SLOTS_GROUP(switched[i].group)))
            vm_fault(L, FAULT_SCRIPT, "%s: %s is disabled; add `%s = true` to `board` in rom.lua", t->name, name,
                     switched[i].word);
}

/* Pushes property p of the thing of handle h if it can be read (board_there), or if h is a player who is out and p is
 * PROP_LASTS. Otherwise pushes nil. */
static int push_property(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, int p)
{
    const struct api_prop *prop = &t->props[p];

    check_on(L, b, t, handle_kind(h), prop->value.name);
    if (!board_there(b, h) && !(prop->write == PROP_LASTS && handle_gen(h) && handle_slot(h) < PADS))
        return push_dead(L, prop->value.name);
    t->get(L, b, handle_slot(h), p);
    return 1;
}

enum { A_READ = 4, A_WRITE = 6 /* work added to that of the VM instruction; a guard checks the sum later */ };

static int get_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    size_t bytes;
    int p;

    b->vm.work += A_READ;
    if (!handle_is(h))
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    if (lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "%s: expected a property name, got a %s",
                        api_of(L)->things[handle_kind(h)]->name, luaL_typename(L, 2));
    const char *name = lua_tolstring(L, 2, &bytes);
    const struct api_thing *t = api_of(L)->things[handle_kind(h)];
    uint8_t *guess = prop_guess(b, handle_kind(h), false, name, bytes);
    if (prop_guessed(t, guess, name))
        return push_property(L, b, t, h, *guess);
    if (api_push_method(L, (int)handle_kind(h), name))
        return 1;
    bool alive = board_alive(b, h);
    if (!strcmp(name, "alive") && api_ends(handle_kind(h)))
        return lua_pushboolean(L, alive), 1;
    const struct api_prop *prop = prop_named(t, guess, name, &p);
    if (handle_kind(h) == H_PLAYER && !prop) {
        int reg = api_player_register(L, b, handle_slot(h), name);
        if (reg >= 0) {
            if (!alive)
                return push_dead(L, name);
            return lua_pushinteger(L, board_register(b, handle_slot(h), (uint32_t)reg)), 1;
        }
    }
    if (!prop)
        return get_value(L, b, t, h, name);
    return push_property(L, b, t, h, p);
}

/* Sets a register and clamps the value to the register's min and max. */
static int set_register(lua_State *L, struct board *b, uint32_t slot, int reg, const char *name)
{
    const uint32_t row = board_register_row(b, slot, (uint32_t)reg);

    registers_set(&b->registers, row, slot, api_register_value(L, "player", name, row, 3));
    return 0;
}

static int set_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    struct api_value v = { 0 };
    size_t bytes;
    int p;

    b->vm.work += A_WRITE;
    if (!handle_is(h) || lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    const char *name = lua_tolstring(L, 2, &bytes);
    const struct api_thing *t = api_of(L)->things[handle_kind(h)];
    const struct api_prop *prop = prop_named(t, prop_guess(b, handle_kind(h), true, name, bytes), name, &p);
    bool alive = board_alive(b, h);
    script_fold(b, 0x2000);
    script_fold(b, (uint64_t)h);
    api_fold_text(L, b, name, bytes);
    api_look(L, 3, 3, &v);
    api_fold_looked(L, b, &v);
    if (handle_kind(h) == H_PLAYER && !prop) {
        int reg = api_player_register(L, b, handle_slot(h), name);
        if (reg >= 0)
            return alive ? set_register(L, b, handle_slot(h), reg, name) : 0;
    }
    int value = prop ? NO_SLOT : value_named(L, b, handle_kind(h), name);
    if (value != NO_SLOT)
        return set_value(L, b, t, h, value, name);
    if (!prop || prop->write != PROP_WRITE)
        return read_only(L, t, (int)handle_kind(h), name);
    check_on(L, b, t, handle_kind(h), name);
    if (v.given || !prop->value.optional)
        api_check_value(L, t->name, &prop->value, &v);
    if (alive)
        t->set(L, b, handle_slot(h), p, &v);
    return 0;
}

void api_open_handles(lua_State *L)
{
    lua_pushinteger(L, 0);
    lua_pushcfunction(L, get_property);
    lua_pushcfunction(L, set_property);
    lualib_seal(L); /* the metatable of the number type */
    lua_pop(L, 1);
}
