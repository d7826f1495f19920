/*
 * api_handle.c - the metatable of the number type: properties and methods of handles.
 */
#include <string.h>
#include "../../base/trig.h"
#include "../events_run.h"
#include "../lua/lualib.h"
#include "api_parts.h"

/* Registry, by kind of handle: a table that maps every name looked up so far to the method, or to false if there is no
 * method of that name. */
static const char methods_key[HANDLE_KINDS] = { 0 };

bool api_push_method(lua_State *L, int kind, const char *name)
{
    vm_push_registry_table(L, &methods_key[kind]);
    if (lua_getfield(L, -1, name) == LUA_TNIL) {
        lua_pop(L, 1);
        if (!api_push_member(L, api_get_table(L)->things[kind]->name, ':', name))
            lua_pushboolean(L, 0);
        lua_pushvalue(L, -1);
        lua_setfield(L, -3, name);
    }
    lua_remove(L, -2);
    return lua_isfunction(L, -1);
}

/* Returns the index of the property of that name, or -1. */
static int search_prop(const struct api_thing *t, const char *name)
{
    int i = t->n - 1;

    while (i >= 0 && strcmp(t->props[i].name, name) != 0)
        i--;
    return i;
}

bool api_has_property(const struct api_thing *t, const char *name)
{
    return search_prop(t, name) >= 0;
}

/* Returns whether a guess is the index of the property of that name. If it is, no method can have the name, because no
 * verb has the name of a property. */
static bool is_guess_right(const struct api_thing *t, const uint8_t *guess, const char *name)
{
    return *guess < t->n && !strcmp(t->props[*guess].name, name);
}

/* Returns the guess (api_guess_index) for a property of that kind of thing. Reads and writes have separate guesses, so
 * that a write cannot change which path the first read of a name takes. */
static uint8_t *get_prop_guess(struct board *b, enum handle_kind kind, bool is_write, const char *name, size_t n)
{
    return &b->vm.guesses.props[api_guess_index(name, n, (unsigned)kind + (is_write ? HANDLE_KINDS : 0))];
}

/* Returns the index of the property of that name, or -1. */
static int find_prop(const struct api_thing *t, uint8_t *guess, const char *name)
{
    if (is_guess_right(t, guess, name))
        return *guess;
    const int p = search_prop(t, name);
    if (p >= 0)
        *guess = (uint8_t)p;
    return p;
}

static int raise_unknown_property(lua_State *L, const struct api_thing *t, int kind, const char *name)
{
    struct api_suggestion s = { .word = name };

    for (int i = 0; i < t->n; i++)
        api_consider(&s, t->props[i].name);
    if (api_can_die((enum handle_kind)kind))
        api_consider(&s, "alive");
    enum name_kind value_names = api_kind_value_names((enum handle_kind)kind);
    for (int k = 0; k < api_value_count(vm_board(L), value_names); k++)
        api_consider(&s, board_name(vm_board(L), value_names, k));
    for (int i = 0; i < api_count_entries(api_get_table(L)); i++) {
        const char *verb = api_member_name(api_get_entry(api_get_table(L), i), t->name, ':');
        if (verb)
            api_consider(&s, verb);
    }
    return vm_fault(L, FAULT_SCRIPT, "%s has no property \"%s\"%s", api_thing_names[kind], name,
                    api_push_did_you_mean(L, &s, ""));
}

/* Raises the error for writing a name that can only be read or called: a property, a verb, `alive`. */
static int raise_read_only(lua_State *L, const struct api_thing *t, int kind, const char *name)
{
    if (api_push_method(L, kind, name))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s is a method; call it with a colon, thing:%s(...)", t->name, name,
                        name);
    lua_pop(L, 1);
    if (api_has_property(t, name) || (api_can_die((enum handle_kind)kind) && !strcmp(name, "alive")))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s is read-only", t->name, name);
    return raise_unknown_property(L, t, kind, name);
}

/* Returns the index of a declared value of that kind of thing, or NO_SLOT. */
static int find_declared_value(lua_State *L, const struct board *b, enum handle_kind kind, const char *name)
{
    enum name_kind names = api_kind_value_names(kind);

    return api_value_count(b, names) ? api_names_find(L, names, name) : NO_SLOT;
}

/* Returns the pool of a kind of thing, or of a group's members. */
static const struct slots *get_pool(const struct board *b, const struct api_thing *t)
{
    return (const struct slots *)(const void *)((const char *)b + t->slots_offset);
}

/* Returns the column at that offset in struct board. */
static void *get_column(const struct board *b, size_t offset)
{
    void *column;

    memcpy(&column, (const char *)b + offset, sizeof column);
    return column;
}

/* Returns whether slot i is in the group of members with the tag, for a read or a write of property p. */
static bool is_member(const struct board *b, const struct api_thing *t, uint32_t tag, uint32_t i, int p)
{
    return api_has_tag(get_column(b, t->tags_offset), i, tag) && (!t->has_member || t->has_member(b, i, p));
}

/* Pushes a userdata with the handles of all live members of a group, in slot order, and returns the list. *n receives
 * their number. */
static const int64_t *push_member_list(lua_State *L, const struct board *b, const struct api_thing *t, uint32_t tag,
                                       uint32_t *n)
{
    const struct slots *s = get_pool(b, t);
    int64_t *list = lua_newuserdatauv(L, s->live * sizeof *list, 0);

    *n = 0;
    EACH_LIVE (i, s)
        if (is_member(b, t, tag, i, 0))
            list[(*n)++] = board_handle(b, t->member, (int32_t)i);
    return list;
}

/* A verb of an enemy may kill it, and on_death may then remove enemies and spawn others in their slots. Therefore the
 * enemies of a group are listed first, and the verb is run only for those still alive when their turn comes. */
int api_run_each(lua_State *L, struct board *b, struct api_value *v, api_function *run)
{
    const int64_t h = v[0].i;
    const struct api_thing *t = api_get_table(L)->things[handle_kind(h)];
    const int64_t *list;
    uint32_t n;

    if (!t->member) {
        if (board_is_alive(b, h))
            run(L, b, v);
        return 0;
    }
    vm_charge(L, t->write_work * get_pool(b, t)->live);
    if (t->member != H_ENEMY) {
        EACH_LIVE (i, get_pool(b, t))
            if (is_member(b, t, handle_slot(h), i, 0)) {
                v[0].i = board_handle(b, t->member, (int32_t)i);
                run(L, b, v);
            }
        return 0;
    }
    luaL_checkstack(L, 1, NULL);
    list = push_member_list(L, b, t, handle_slot(h), &n);
    for (uint32_t k = 0; k < n; k++)
        if (board_is_alive(b, list[k])) {
            v[0].i = list[k];
            run(L, b, v);
        }
    lua_pop(L, 1);
    return 0;
}

/* ---- the functions group, each and count ---- */

const struct api_param api_tag_params[TAG_PARAM_COUNT] = { PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL,
                                                                 "tag to select by; if omitted, all are included") };
const struct api_param api_each_params[EACH_PARAM_COUNT] = {
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "tag to select by; nil selects all"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "function to call; it cannot wait")
};

/* Returns the group kind of the things after which the running entry is named: H_GROUP for "bullet.each". */
static enum handle_kind find_group_kind(lua_State *L, const char *entry)
{
    const struct api_thing *const *things = api_get_table(L)->things;
    const size_t n = (size_t)(strchr(entry, '.') - entry);

    for (int kind = 1;; kind++) {
        const struct api_thing *member = things[things[kind]->member];
        if (member && !strncmp(member->name, entry, n) && !member->name[n])
            return (enum handle_kind)kind;
    }
}

int api_push_group(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;

    (void)b;
    lua_pushinteger(L, handle_make(find_group_kind(L, entry), 1, api_read_tag(L, entry, &v[EACH_TAG])));
    return 1;
}

enum { VISIT_WORK = 4 /* VM instructions charged per visit, in addition to the function's own */ };

/* Entities spawned during the calls are not visited. */
int api_call_each(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    const struct api_thing *t = api_get_table(L)->things[find_group_kind(L, entry)];
    uint32_t n;
    const int64_t *list = push_member_list(L, b, t, api_read_tag(L, entry, &v[EACH_TAG]), &n);

    vm_charge(L, VISIT_WORK * (uint64_t)n);
    for (uint32_t k = 0; k < n; k++) {
        if (!board_is_alive(b, list[k]))
            continue;
        lua_pushvalue(L, v[EACH_F].at);
        lua_pushinteger(L, list[k]);
        lua_call(L, 1, 0);
    }
    return 0;
}

/* Pushes the number of live members of a group. */
static void push_member_count(lua_State *L, const struct board *b, const struct api_thing *t, uint32_t tag)
{
    lua_Integer n = 0;

    vm_charge(L, get_pool(b, t)->live);
    EACH_LIVE (i, get_pool(b, t))
        n += is_member(b, t, tag, i, 0);
    lua_pushinteger(L, n);
}

int api_push_count_of_kind(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;

    push_member_count(L, b, api_get_table(L)->things[find_group_kind(L, entry)], api_read_tag(L, entry, &v[EACH_TAG]));
    return 1;
}

static int push_nil_for_dead(lua_State *L, const char *name)
{
    vm_note_dead_read(L, name);
    lua_pushnil(L);
    return 1;
}

static int get_declared_value(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, const char *name)
{
    enum handle_kind kind = handle_kind(h);
    int k = find_declared_value(L, b, kind, name);

    if (k == NO_SLOT)
        return raise_unknown_property(L, t, (int)kind, name);
    if (handle_kind_is_group(kind))
        return vm_fault(L, FAULT_SCRIPT, "%s: %s cannot be read from a group (only `count` can)", t->name, name);
    if (board_is_readable(b, h))
        lua_pushnumber(L, fx_to_double(api_value_column(b, api_kind_value_names(kind), k)[handle_slot(h)]));
    else
        push_nil_for_dead(L, name);
    return 1;
}

static int set_declared_value(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, int k,
                              const char *name)
{
    enum handle_kind kind = handle_kind(h);
    struct api_param p = api_value_param(name);
    fx *column = api_value_column(b, api_kind_value_names(kind), k);
    struct api_value v = { 0 };

    api_check(L, t->name, &p, 3, &v);
    if (!handle_kind_is_group(kind)) {
        if (board_is_alive(b, h))
            column[handle_slot(h)] = v.f;
        return 0;
    }
    const struct slots *s = get_pool(b, t);
    vm_charge(L, s->live);
    EACH_LIVE (i, s)
        if (api_has_tag(get_column(b, t->tags_offset), i, handle_slot(h)))
            column[i] = v.f;
    return 0;
}

/* Properties that must be enabled in rom.lua. */
enum {
    ENEMY_HANDLE_KINDS = 1 << H_ENEMY | 1 << H_ENEMIES,
    TRANSFORM_HANDLE_KINDS = ENEMY_HANDLE_KINDS | 1 << H_SPRITE
};
#define BODIES_SETTING    "`bodies = true` to `board`"
#define TRANSFORM_SETTING "`transforms = true` to `board`"
static const struct {
    const char *name;
    unsigned handle_kinds; /* mask of handle kinds */
    int column_group;      /* column group (GROUP_) */
    const char *setting;   /* what to add to rom.lua */
} optional_props[] = {
    { "frozen",
      1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_ITEM | 1 << H_LASER | 1 << H_GROUP | 1 << H_SHOTS |
          1 << H_ENEMIES | 1 << H_ITEMS | 1 << H_LASERS,
      GROUP_FROZEN, "`frozen = true` to `board`" },
    { "rate", ENEMY_HANDLE_KINDS, GROUP_BODIES, BODIES_SETTING },
    { "share", ENEMY_HANDLE_KINDS, GROUP_BODIES, BODIES_SETTING },
    { "follow", ENEMY_HANDLE_KINDS, GROUP_BODIES, BODIES_SETTING },
    { "dx", ENEMY_HANDLE_KINDS, GROUP_BODIES, BODIES_SETTING },
    { "dy", ENEMY_HANDLE_KINDS, GROUP_BODIES, BODIES_SETTING },
    { "follow", 1 << H_LAYER, BG_GROUP_CAMERA, "`view = { w = 240, h = 320 }` to `field`" },
    { "dir", TRANSFORM_HANDLE_KINDS | 1 << H_OPTION, GROUP_TRANSFORMS, TRANSFORM_SETTING },
    { "scale", TRANSFORM_HANDLE_KINDS, GROUP_TRANSFORMS, TRANSFORM_SETTING },
    { "alpha", TRANSFORM_HANDLE_KINDS, GROUP_TRANSFORMS, TRANSFORM_SETTING },
};

/* Raises a fault if the property is disabled in rom.lua, even if the thing does not exist. */
static void check_enabled(lua_State *L, const struct board *b, const struct api_thing *t, enum handle_kind kind,
                          const char *name)
{
    for (size_t i = 0; i < sizeof optional_props / sizeof *optional_props; i++)
        if (optional_props[i].name[0] == name[0] && optional_props[i].handle_kinds >> kind & 1 &&
            !strcmp(optional_props[i].name, name) &&
            !(get_pool(b, t)->groups & SLOTS_GROUP(optional_props[i].column_group)))
            vm_fault(L, FAULT_SCRIPT, "%s: %s is disabled; add %s in rom.lua", t->name, name,
                     optional_props[i].setting);
}

static uint64_t read_element(const void *column, uint8_t size, uint32_t i)
{
    return size == 1   ? ((const uint8_t *)column)[i]
           : size == 2 ? ((const uint16_t *)column)[i]
           : size == 4 ? ((const uint32_t *)column)[i]
                       : ((const uint64_t *)column)[i];
}

/* Returns the value that element i stores. */
static int64_t read_value(const struct board *b, const struct api_column *c, uint32_t i)
{
    const uint64_t element = read_element(get_column(b, c->offset), c->size, i);
    const int unused_bits = 64 - 8 * c->size;

    if (c->is_birth)
        return b->core.clock - (uint32_t)element;
    if (c->bits)
        return (int64_t)(element & c->bits) / (c->bits & -c->bits);
    return c->is_signed ? (int64_t)(element << unused_bits) >> unused_bits : (int64_t)element;
}

static void write_value(const struct board *b, const struct api_column *c, uint32_t i, int64_t v)
{
    void *const column = get_column(b, c->offset);

    if (c->bits)
        v = (int64_t)(read_element(column, c->size, i) & ~(uint64_t)c->bits) | v * (c->bits & -c->bits);
    if (c->size == 1)
        ((uint8_t *)column)[i] = (uint8_t)v;
    else if (c->size == 2)
        ((uint16_t *)column)[i] = (uint16_t)v;
    else if (c->size == 4)
        ((uint32_t *)column)[i] = (uint32_t)v;
    else
        ((int64_t *)column)[i] = v;
}

static void push_stored_value(lua_State *L, const struct board *b, const struct api_param *p, uint32_t i)
{
    const int64_t value = read_value(b, &p->column, i);
    int n_words;

    switch (p->type) {
    case A_FX:
        lua_pushnumber(L, (double)value / 65536);
        break;
    case A_DIR:
        lua_pushnumber(L, trig_to_degrees((ang)value));
        break;
    case A_SCALE:
        lua_pushnumber(L, (double)value / SCALE_ONE);
        break;
    case A_INT:
        lua_pushinteger(L, value);
        break;
    case A_COUNT:
        api_push_count(L, (int32_t)value);
        break;
    case A_BOOL:
        lua_pushboolean(L, value != 0);
        break;
    case A_STR:
        api_push_tag(L, (uint16_t)value);
        break;
    case A_MAP:
        lua_pushstring(L, value ? cart_name(&b->cart, CART_MAPS, (int)value - 1) : NULL);
        break;
    case A_BLEND:
        lua_pushstring(L, value ? cart_name(&b->cart, CART_BLENDS, (int)value - 1) : NULL);
        break;
    case A_DEPTH:
        lua_pushstring(L, api_get_type_words(p->type, &n_words)[value]);
        break;
    default:
        api_names_push(L, (enum name_kind)(p->type - A_BULLET_KIND), (int)value);
    }
}

/* Returns the value to store for v. A kind or sprite that may be omitted is stored as its index + 1. */
static int64_t encode_value(lua_State *L, const struct api_param *p, const struct api_value *v)
{
    switch (p->type) {
    case A_FX:
        return v->f;
    case A_DIR:
        return v->a;
    case A_COUNT:
        return api_to_count(v);
    case A_STR:
        return api_read_tag(L, "tag", v);
    case A_SPARK_KIND:
    case A_SPRITE:
        return v->i + (p->optional && v->given);
    default:
        return v->i;
    }
}

void api_store_value(lua_State *L, const struct board *b, const struct api_param *p, uint32_t i,
                     const struct api_value *v)
{
    write_value(b, &p->column, i, encode_value(L, p, v));
}

void api_store_arguments(lua_State *L, struct board *b, int32_t i, const struct api_value *v)
{
    const struct api_entry *e = api_current_binding(L)->entry;

    for (int k = 0; k < e->count; k++) {
        const struct api_column *c = &e->params[k].column;
        if (c->property && v[k].given) {
            lua_pushvalue(L, v[k].at);
            events_set_property(L, (uint16_t)i, c->property);
        } else if (c->size && get_column(b, c->offset)) /* NULL: disabled in rom.lua */
            api_store_value(L, b, &e->params[k], (uint32_t)i, &v[k]);
    }
}

static void write_property(lua_State *L, struct board *b, const struct api_thing *t, uint32_t i, int p,
                           const struct api_value *v)
{
    if (t->props[p].access == PROP_SET)
        t->set(L, b, i, p, v);
    else
        api_store_value(L, b, &t->props[p], i, v);
}

static void write_group_property(lua_State *L, struct board *b, const struct api_thing *t, uint32_t tag, int p,
                                 const struct api_value *v)
{
    const struct api_thing *member = api_get_table(L)->things[t->member];
    const struct slots *s = get_pool(b, t);

    vm_charge(L, t->write_work * s->live);
    EACH_LIVE (i, s)
        if (is_member(b, t, tag, i, p))
            write_property(L, b, member, i, p, v);
}

/* Pushes property p of the thing of handle h if it can be read (board_is_readable), or if h is a player who is out and
 * p is PROP_PERSISTENT. Otherwise pushes nil. */
static int push_property(lua_State *L, struct board *b, const struct api_thing *t, int64_t h, int p)
{
    const struct api_param *prop = &t->props[p];

    check_enabled(L, b, t, handle_kind(h), prop->name);
    if (!board_is_readable(b, h) && !(prop->access == PROP_PERSISTENT && handle_gen(h) && handle_slot(h) < MAX_PLAYERS))
        return push_nil_for_dead(L, prop->name);
    if (t->member && strcmp(prop->name, "count") != 0)
        return vm_fault(L, FAULT_SCRIPT, "%s: %s cannot be read from a group (only `count` can)", t->name, prop->name);
    if (t->member)
        push_member_count(L, b, t, handle_slot(h));
    else if (prop->column.size)
        push_stored_value(L, b, prop, handle_slot(h));
    else
        t->get(L, b, handle_slot(h), p);
    return 1;
}

enum { READ_WORK = 4, WRITE_WORK = 6 /* added to the VM instruction's work; vm_count.c checks the sum later */ };

static int get_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    size_t bytes;

    b->vm.work += READ_WORK;
    if (!handle_is_well_formed(h))
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    if (lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "%s: expected a property name, got a %s",
                        api_get_table(L)->things[handle_kind(h)]->name, luaL_typename(L, 2));
    const char *name = lua_tolstring(L, 2, &bytes);
    const struct api_thing *t = api_get_table(L)->things[handle_kind(h)];
    uint8_t *guess = get_prop_guess(b, handle_kind(h), false, name, bytes);
    if (is_guess_right(t, guess, name))
        return push_property(L, b, t, h, *guess);
    if (api_push_method(L, (int)handle_kind(h), name))
        return 1;
    bool alive = board_is_alive(b, h);
    if (!strcmp(name, "alive") && api_can_die(handle_kind(h)))
        return lua_pushboolean(L, alive), 1;
    const int p = find_prop(t, guess, name);
    if (handle_kind(h) == H_PLAYER && p < 0) {
        int reg = api_find_player_register(L, b, handle_slot(h), name);
        if (reg >= 0) {
            if (!alive)
                return push_nil_for_dead(L, name);
            return lua_pushinteger(L, board_get_register(b, handle_slot(h), (uint32_t)reg)), 1;
        }
    }
    return p < 0 ? get_declared_value(L, b, t, h, name) : push_property(L, b, t, h, p);
}

/* Sets a register and clamps the value to the register's min and max. */
static int set_register(lua_State *L, struct board *b, uint32_t slot, int reg, const char *name)
{
    const uint32_t row = board_register_row(b, slot, (uint32_t)reg);

    registers_set(&b->registers, row, slot, api_read_register_value(L, "player", name, row, 3));
    return 0;
}

static int set_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    struct api_value v = { 0 };
    size_t bytes;

    b->vm.work += WRITE_WORK;
    if (!handle_is_well_formed(h) || lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    const char *name = lua_tolstring(L, 2, &bytes);
    const struct api_thing *t = api_get_table(L)->things[handle_kind(h)];
    const int p = find_prop(t, get_prop_guess(b, handle_kind(h), true, name, bytes), name);
    const struct api_param *prop = p < 0 ? NULL : &t->props[p];
    bool alive = board_is_alive(b, h);
    script_update_digest(b, 0x2000);
    script_update_digest(b, (uint64_t)h);
    api_fold_bytes(L, b, name, bytes);
    api_read_value(L, 3, 3, &v);
    api_fold_value(L, b, &v);
    if (handle_kind(h) == H_PLAYER && !prop) {
        int reg = api_find_player_register(L, b, handle_slot(h), name);
        if (reg >= 0)
            return alive ? set_register(L, b, handle_slot(h), reg, name) : 0;
    }
    int value_index = prop ? NO_SLOT : find_declared_value(L, b, handle_kind(h), name);
    if (value_index != NO_SLOT)
        return set_declared_value(L, b, t, h, value_index, name);
    if (!prop || !(prop->access & PROP_WRITE))
        return raise_read_only(L, t, (int)handle_kind(h), name);
    check_enabled(L, b, t, handle_kind(h), name);
    if (v.given || !prop->optional)
        api_check_value(L, t->name, prop, &v);
    if (alive)
        (t->member ? write_group_property : write_property)(L, b, t, handle_slot(h), p, &v);
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
