/*
 * api.c - see api.h. Every API function is one C closure, `call`, which knows its entry: it checks, folds, and runs.
 */
#include "../api.h"
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

/* ---- the script digest ---- */

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
        vm_charge(L, n / 16);
        b->script.digest = hash_bytes(b->script.digest, s, n);
        break;
    }
    case LUA_TBOOLEAN:
        script_fold(b, lua_toboolean(L, at) ? 3 : 2);
        break;
    default:
        script_fold(b, 16 + (uint64_t)lua_type(L, at));
    }
}

static void fold_arguments(lua_State *L, struct board *b, uint64_t entry, const struct api_value *v, int n)
{
    b->script.calls++;
    script_fold(b, entry);
    for (int i = 0; i < n; i++)
        if (v[i].given) {
            script_fold(b, (uint64_t)i);
            api_fold(L, b, v[i].at);
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
    for (int i = 0; i < api_count(); i++)
        if (!strcmp(api_entry(i)->name, name))
            return api_entry(i);
    return NULL;
}

/* Every API function. Upvalue 1: the entry's address as light userdata; 2: a hash of its name, which is folded into the
 * digest in place of its index, so that new entries do not change old demos. */
static int call(lua_State *L)
{
    const struct api_entry *e = lua_touserdata(L, lua_upvalueindex(1));
    struct board *b = vm_board(L);
    struct api_value v[MAX_PARAMS];

    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD && !b->vm.loading)
        return api_error(L, e->name, "only while scripts load");
    if (e->flags & API_METHOD && !(lua_isinteger(L, 1) && handle_is(lua_tointeger(L, 1))))
        return api_error(L, e->name, "call it with a colon, on a thing");
    const struct api_entry *fire;
    int n = api_arguments(L, e, v, &fire);
    if (e->flags & API_CHANGES) {
        fold_arguments(L, b, (uint64_t)lua_tointeger(L, lua_upvalueindex(2)), v, n);
        for (int i = e->plain + 1; e->flags & API_MORE && i <= lua_gettop(L); i++)
            api_fold(L, b, i);
    }
    int results = e->run(L, b, v);
    if (e->flags & API_CHANGES)
        for (int i = -results; i < 0; i++)
            api_fold(L, b, i);
    return results;
}

/* sys.check(name, ...): what `call` does for C entries, for those written in Lua. */
static int sys_check(lua_State *L)
{
    const struct api_entry *e = api_find(luaL_checkstring(L, 1));
    struct api_value v[MAX_PARAMS];

    if (!e)
        return vm_fault(L, FAULT_SCRIPT, "sys.check: no entry \"%s\"", lua_tostring(L, 1));
    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD && !vm_board(L)->vm.loading)
        return api_error(L, e->name, "only while scripts load");
    lua_remove(L, 1);
    const struct api_entry *fire;
    int all = api_arguments(L, e, v, &fire), n = api_param_count(e, fire);
    lua_createtable(L, 0, all);
    for (int i = n; i < all; i++)
        if (v[i].given) {
            lua_pushvalue(L, v[i].at);
            lua_setfield(L, -2, api_names_at(vm_board(L), api_value_names(fire ? fire : e), i - n));
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
        else if (p->type == A_STR || p->type >= A_BULLET_KIND)
            lua_pushstring(L, p->def);
        else if (p->type == A_INT || p->type == A_COUNT)
            lua_pushinteger(L, v[i].i);
        else
            lua_pushnumber(L, v[i].n);
        lua_setfield(L, -2, p->name);
    }
    return 1;
}

/* ---- opening ---- */

static void push_function(lua_State *L, const struct api_entry *e)
{
    lua_pushlightuserdata(L, (void *)(uintptr_t)e);
    lua_pushinteger(L, (lua_Integer)hash_bytes(HASH_START, e->name, strlen(e->name)));
    lua_pushcclosure(L, call, 2);
}

/* "bullet.fire" goes into global table bullet, "bullet:aim" among the methods of bullets, "sys.join" into sys. */
static void install(lua_State *L, const struct api_entry *e, int sys)
{
    const char *split = strpbrk(e->name, ".:");
    char space[32];

    if (!vm_board(L)->lasers.s.cap && !strncmp(e->name, "laser", 5))
        return;
    if (!split) {
        push_function(L, e);
        lua_setglobal(L, e->name);
        return;
    }
    snprintf(space, sizeof space, "%.*s", (int)(split - e->name), e->name);
    if (*split == ':') {
        for (int k = 1; k < HANDLES; k++)
            if (api_things[k] && !strcmp(api_things[k]->name, space))
                api_push_methods(L, k);
    } else if (e->flags & API_SYS)
        lua_pushvalue(L, sys);
    else if (lua_getglobal(L, space) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_setglobal(L, space);
    }
    push_function(L, e);
    lua_setfield(L, -2, split + 1);
    lua_pop(L, 1);
}

void api_open(lua_State *L)
{
    api_open_names(L);
    events_open(L);
    api_open_handles(L);
    lua_pushinteger(L, LUA_MAXINTEGER);
    lua_setglobal(L, "forever");
    lua_newtable(L);
    int sys = lua_gettop(L);
    for (int i = 0; i < api_count(); i++)
        if (!(api_entry(i)->flags & API_LUA))
            install(L, api_entry(i), sys);
    lua_pushcfunction(L, sys_check);
    lua_setfield(L, sys, "check");
    api_rom_open(L);
    lua_settop(L, sys);
}
