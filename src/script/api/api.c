/*
 * api.c - see api.h. Every API function is one C closure, `call`, which knows its entry: it checks, folds, and runs. It
 * is made when a script first reads its name, so a game has those that it uses. The tables of the API share a metatable
 * for this; pairs makes the rest of a table, so that no script can tell.
 */
#include "api.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../base/hash.h"
#include "api_parts.h"
#include "../events_run.h"

int api_error(lua_State *L, const char *entry, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const char *message = lua_pushvfstring(L, format, args);
    va_end(args);
    return vm_fault(L, FAULT_SCRIPT, "%s: %s", entry, message);
}

/* ---- places, for errors that are found later than they were made ---- */

static const char places_key = 0; /* registry: "ENTRY NAME" -> "FILE:LINE: " */

void api_note_place(lua_State *L, const char *entry, const char *name)
{
    const int top = lua_gettop(L);
    char place[VM_PLACE];

    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &places_key) != LUA_TTABLE) {
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &places_key);
    }
    vm_where(L, place, sizeof place);
    lua_pushfstring(L, "%s %s", entry, name);
    lua_pushstring(L, place);
    lua_rawset(L, -3);
    lua_settop(L, top);
}

int api_error_at(lua_State *L, const char *entry, const char *name, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const char *message = lua_pushvfstring(L, format, args), *place = NULL;
    va_end(args);
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &places_key) == LUA_TTABLE) {
        lua_pushfstring(L, "%s %s", entry, name);
        lua_rawget(L, -2);
        place = lua_tostring(L, -1);
    }
    return place ? vm_fault_at(L, place, "%s: %s", entry, message) : api_error(L, entry, "%s", message);
}

/* ---- the script digest ---- */

enum { FOLDED = 8 /* bytes of a text that count as a VM instruction */ };

void api_fold_text(lua_State *L, struct board *b, const char *s, size_t n)
{
    if (n >= FOLDED)
        vm_charge(L, n / FOLDED);
    b->script.digest = hash_bytes(b->script.digest, s, n);
}

void api_fold(lua_State *L, struct board *b, int at)
{
    size_t n;
    double d;
    uint64_t bits;

    switch (lua_type(L, at)) {
    case LUA_TNUMBER:
        if (lua_isinteger(L, at)) {
            script_fold(b, (uint64_t)lua_tointeger(L, at));
            break;
        }
        d = lua_tonumber(L, at);
        memcpy(&bits, &d, sizeof bits);
        script_fold(b, isnan(d) ? 0x7ff8000000000000u : bits);
        break;
    case LUA_TSTRING: {
        const char *s = lua_tolstring(L, at, &n);
        api_fold_text(L, b, s, n);
        break;
    }
    case LUA_TBOOLEAN:
        script_fold(b, lua_toboolean(L, at) ? 3 : 2);
        break;
    default:
        script_fold(b, 16 + (uint64_t)lua_type(L, at));
    }
}

void api_fold_looked(lua_State *L, struct board *b, const struct api_value *v)
{
    double d;

    if (v->type != LUA_TNUMBER) {
        api_fold(L, b, v->at);
        return;
    }
    memcpy(&d, &v->bits, sizeof d);
    script_fold(b, !v->whole && isnan(d) ? 0x7ff8000000000000u : (uint64_t)v->bits);
}

void api_fold_call(lua_State *L, struct board *b, uint64_t entry, const struct api_value *v, int n)
{
    b->script.calls++;
    script_fold(b, entry);
    for (int i = 0; i < n; i++)
        if (v[i].given) {
            script_fold(b, (uint64_t)i);
            api_fold_looked(L, b, &v[i]);
        }
}

/* ---- the table of entries ---- */

int api_count(void)
{
    int n = 0;

    for (int m = 0; m < api_module_count; m++)
        n += api_modules[m]->n;
    return n;
}

const struct api_entry *api_entry(int i)
{
    for (int m = 0; m < api_module_count; i -= api_modules[m++]->n)
        if (i < api_modules[m]->n)
            return &api_modules[m]->entries[i];
    return NULL;
}

const struct api_entry *api_find(const char *name)
{
    for (int m = 0; m < api_module_count; m++)
        for (int i = 0; i < api_modules[m]->n; i++) {
            const struct api_entry *e = &api_modules[m]->entries[i];
            if (e->name[0] == name[0] && !strcmp(e->name, name))
                return e;
        }
    return NULL;
}

/* Every API function. The hash of its name is folded into the digest in place of its index, so that new entries do not
 * change old demos. */
static int call(lua_State *L)
{
    struct api_bound *f = api_bound(L);
    const struct api_entry *e = f->entry;
    struct board *b = vm_board(L);
    struct api_value v[MAX_PARAMS];

    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD && !b->vm.loading)
        return api_error(L, e->name, "can only be called while scripts load");
    if (e->flags & API_METHOD && !(lua_isinteger(L, 1) && handle_is(lua_tointeger(L, 1))))
        return api_error(L, e->name, "call it on a thing with a colon, as in thing:name()");
    const struct api_entry *fire;
    int n = api_arguments_planned(L, f, v, &fire);
    if (e->flags & API_CHANGES) {
        api_fold_call(L, b, f->hash, v, n);
        for (int i = e->plain + 1; e->flags & API_MORE && i <= lua_gettop(L); i++)
            api_fold(L, b, i);
    }
    int results = e->run(L, b, v);
    if (e->flags & API_CHANGES)
        for (int i = -results; i < 0; i++)
            api_fold(L, b, i);
    return f->walks ? luakeys_return(L, results) : results;
}

int api_checked(lua_State *L, const struct api_entry *e)
{
    struct api_value v[MAX_PARAMS];

    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD && !vm_board(L)->vm.loading)
        return api_error(L, e->name, "can only be called while scripts load");
    const struct api_entry *fire;
    int all = api_arguments(L, e, v, &fire), n = api_param_count(e, fire), fields = 0;
    for (int i = 0; i < all; i++)
        fields += v[i].given || (i < e->count && e->params[i].def);
    lua_createtable(L, 0, fields); /* it is walked over for each bullet of a figure: no empty places */
    for (int i = n; i < all; i++)
        if (v[i].given) {
            lua_pushvalue(L, v[i].at);
            lua_setfield(L, -2, board_name(vm_board(L), api_value_names(fire ? fire : e), i - n));
        }
    for (int i = n; i-- > 0;) {
        const struct api_param *p = api_param_at(e, fire, i);
        bool own = i < e->count;
        if (v[i].given)
            lua_pushvalue(L, v[i].at);
        else if (!own || !p->def || p->type == A_FIRE) /* older library modules hand on all that they get */
            continue;
        else if (p->type == A_BOOL)
            lua_pushboolean(L, (int)v[i].i);
        else if (p->type == A_INT || p->type == A_COUNT || p->type == A_PAD)
            lua_pushinteger(L, v[i].i);
        else if (p->type == A_STR || p->type >= A_BULLET_KIND)
            lua_pushstring(L, p->def);
        else
            lua_pushnumber(L, v[i].n);
        lua_setfield(L, -2, p->name);
    }
    return 1;
}

/* sys.check(name, ...): what `call` does for C entries, for those written in Lua. */
int api_sys_check(lua_State *L)
{
    const struct api_entry *e = api_find(luaL_checkstring(L, 1));

    if (!e)
        return vm_fault(L, FAULT_SCRIPT, "sys.check: unknown entry \"%s\"", lua_tostring(L, 1));
    lua_remove(L, 1);
    return luakeys_return(L, api_checked(L, e));
}

/* ---- opening ---- */

void api_push_bound(lua_State *L, const struct api_entry *e, lua_CFunction f)
{
    struct api_bound *bound = lua_newuserdatauv(L, sizeof *bound, 1);

    *bound = (struct api_bound){ .entry = e, .hash = hash_bytes(HASH_START, e->name, strlen(e->name)) };
    bound->walks = e->plain < e->count || e->flags & (API_FIRE | API_MORE | API_VALUES);
    for (int i = 0; i < e->count; i++)
        bound->walks |= e->params[i].type == A_TABLE;
    lua_pushcclosure(L, f, 1);
}

enum { SEARCH = 100 /* VM instructions that a search for an entry counts for */ };

/* Registry: the metatable of the API's tables; and the names of those, by table. */
static const char shared_key = 0, spaces_key = 0;

const char *api_member(const struct api_entry *e, const char *of, char split)
{
    size_t n = strlen(of);

    return !(e->flags & API_LUA) && !strncmp(e->name, of, n) && e->name[n] == split ? e->name + n + 1 : NULL;
}

bool api_push_member(lua_State *L, const char *of, char split, const char *name)
{
    vm_charge(L, SEARCH);
    for (int m = 0; m < api_module_count; m++)
        for (int i = 0; i < api_modules[m]->n; i++) {
            const struct api_entry *e = &api_modules[m]->entries[i];
            const char *member = api_member(e, of, split);
            if (member && !strcmp(member, name) && !api_off(&vm_board(L)->cart.m, e->name)) {
                api_push_bound(L, e, call);
                return true;
            }
        }
    return false;
}

/* Pushes the name of the API's table at `at`, or nil; returns it, or NULL. A Lua of tests has no API. */
static const char *push_space(lua_State *L, int at)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &spaces_key) != LUA_TTABLE)
        return NULL;
    lua_pushvalue(L, at);
    lua_rawget(L, -2);
    lua_remove(L, -2);
    return lua_tostring(L, -1);
}

/* The __index of the API's tables: a field that a game has put there is found before. */
static int missing_field(lua_State *L)
{
    const char *of = push_space(L, 1);

    if (!of || lua_type(L, 2) != LUA_TSTRING)
        return 0;
    if (!api_push_member(L, of, '.', lua_tostring(L, 2))) {
        api_no_field(L, of, lua_tostring(L, 2));
        return 0;
    }
    lua_pushvalue(L, 2);
    lua_pushvalue(L, -2);
    lua_rawset(L, 1);
    return 1;
}

void api_fill(lua_State *L, int at)
{
    int top = lua_gettop(L);
    const char *of = push_space(L, at), *member;

    for (int i = 0; of && i < api_count(); i++)
        if ((member = api_member(api_entry(i), of, '.')) != NULL &&
            !api_off(&vm_board(L)->cart.m, api_entry(i)->name)) {
            lua_getfield(L, at, member);
            lua_pop(L, 1);
        }
    lua_settop(L, top);
}

void api_add_space(lua_State *L, const char *name)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &spaces_key);
    lua_pushvalue(L, -2);
    lua_pushstring(L, name);
    lua_rawset(L, -3);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &shared_key);
    lua_setmetatable(L, -3);
    lua_pop(L, 1);
}

static void open_spaces(lua_State *L)
{
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &spaces_key);
    lua_createtable(L, 0, 2);
    lua_pushcfunction(L, missing_field);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_rawsetp(L, LUA_REGISTRYINDEX, &shared_key);
}

/* Tables that few games name. */
static bool is_late(const char *space)
{
    return !strcmp(space, "bomb");
}

static void make_space(lua_State *L, const char *space)
{
    lua_newtable(L);
    api_add_space(L, space);
    lua_pushglobaltable(L);
    lua_pushvalue(L, -2);
    lua_pushstring(L, space);
    lua_insert(L, -2);
    lua_rawset(L, -3);
    lua_pop(L, 1);
}

bool api_open_late(lua_State *L, const char *name)
{
    if (!is_late(name))
        return false;
    make_space(L, name);
    return true;
}

/* What an entry needs before a script can find it: "wait" stands among the globals, "bullet.fire" needs a global table
 * bullet, but for a table that is off. */
static void install(lua_State *L, const struct api_entry *e)
{
    const char *split = strpbrk(e->name, ".:");
    char space[32];
    const int top = lua_gettop(L);

    if (!vm_board(L)->lasers.s.cap && !strncmp(e->name, "laser", 5))
        return;
    if (!split) {
        api_push_bound(L, e, call);
        lua_setglobal(L, e->name);
    } else if (*split == '.' && !(e->flags & API_SYS)) {
        snprintf(space, sizeof space, "%.*s", (int)(split - e->name), e->name);
        if (api_off(&vm_board(L)->cart.m, space) || is_late(space))
            return;
        if (lua_getglobal(L, space) != LUA_TTABLE)
            make_space(L, space);
        lua_settop(L, top);
    }
}

void api_open(lua_State *L)
{
    api_open_names(L);
    events_open(L);
    api_open_handles(L);
    open_spaces(L);
    lua_pushinteger(L, LUA_MAXINTEGER);
    lua_setglobal(L, "forever");
    lua_newtable(L);
    api_add_space(L, "sys");
    int sys = lua_gettop(L);
    for (int m = 0; m < api_module_count; m++)
        for (int i = 0; i < api_modules[m]->n; i++)
            if (!(api_modules[m]->entries[i].flags & API_LUA))
                install(L, &api_modules[m]->entries[i]);
    lua_pushcfunction(L, api_sys_check);
    lua_setfield(L, sys, "check");
    api_rom_open(L);
    lua_settop(L, sys);
}
