/*
 * api.c - see api.h. Every API function is the C function `call_entry` as a closure bound to an entry. `call_entry`
 * checks the arguments, folds them into the digest, and runs the entry. A function is created when a script first reads
 * its name, so unused functions take no memory. The API tables share a metatable for this; pairs first creates the
 * remaining functions of a table, so scripts cannot see the difference.
 */
#include "api.h"
#include <string.h>
#include "../../base/hash.h"
#include "api_parts.h"

/* The body of every API function. The digest uses the hash of the entry's name instead of its index, so that new
 * entries do not invalidate old demos. */
static int call_entry(lua_State *L)
{
    struct api_binding *f = api_current_binding(L);
    const struct api_entry *e = f->entry;
    struct board *b = vm_board(L);
    struct api_value v[MAX_PARAMS];

    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD_ONLY && !b->vm.loading)
        return api_error(L, e->name, "can only be called while scripts load");
    if (e->flags & API_METHOD && !(lua_isinteger(L, 1) && handle_is_well_formed(lua_tointeger(L, 1))))
        return api_error(L, e->name, "call it on a thing with a colon, as in thing:name()");
    const struct api_entry *fired_entry;
    int n = api_read_planned_arguments(L, f, v, &fired_entry);
    if (e->flags & API_CHANGES) {
        api_fold_call(L, b, f->hash, v, n);
        for (int i = e->positional_count + 1; e->flags & API_VARARGS && i <= lua_gettop(L); i++)
            api_fold_stack_value(L, b, i);
    }
    int results = e->flags & API_EACH ? api_run_each(L, b, v, e->run) : e->run(L, b, v);
    if (e->flags & API_CHANGES)
        for (int i = -results; i < 0; i++)
            api_fold_stack_value(L, b, i);
    return f->may_iterate ? luakeys_return(L, results) : results;
}

int api_push_checked_arguments(lua_State *L, const struct api_entry *e)
{
    struct api_value v[MAX_PARAMS];

    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD_ONLY && !vm_board(L)->vm.loading)
        return api_error(L, e->name, "can only be called while scripts load");
    const struct api_entry *fired_entry;
    int n_values = api_read_arguments(L, e, v, &fired_entry), n_params = api_param_count(e, fired_entry), n_fields = 0;
    for (int i = 0; i < n_values; i++)
        n_fields += v[i].given || (i < e->count && e->params[i].def);
    lua_createtable(L, 0, n_fields); /* exact size, because patterns iterate over the table for each bullet */
    for (int i = n_params; i < n_values; i++)
        if (v[i].given) {
            lua_pushvalue(L, v[i].at);
            lua_setfield(L, -2,
                         board_name(vm_board(L), api_entry_value_names(fired_entry ? fired_entry : e), i - n_params));
        }
    for (int i = n_params; i-- > 0;) {
        const struct api_param *p = api_param_at(e, fired_entry, i);
        bool is_own = i < e->count;
        if (v[i].given)
            lua_pushvalue(L, v[i].at);
        else if (!is_own || !p->def || p->type == A_FIRE) /* omit: older library modules pass on every argument */
            continue;
        else if (p->type == A_BOOL)
            lua_pushboolean(L, (int)v[i].i);
        else if (p->type == A_INT || p->type == A_COUNT || p->type == A_PLAYER)
            lua_pushinteger(L, v[i].i);
        else if (p->type == A_STR || p->type >= A_BULLET_KIND)
            lua_pushstring(L, p->def);
        else
            lua_pushnumber(L, v[i].n);
        lua_setfield(L, -2, p->name);
    }
    return 1;
}

/* sys.check(name, ...): checks the arguments of an entry written in Lua, as `call_entry` does for C entries. */
int api_sys_check(lua_State *L)
{
    const struct api_entry *e = api_find_entry(api_get_table(L), luaL_checkstring(L, 1));

    if (!e)
        return vm_fault(L, FAULT_SCRIPT, "sys.check: unknown entry \"%s\"", lua_tostring(L, 1));
    lua_remove(L, 1);
    return luakeys_return(L, api_push_checked_arguments(L, e));
}

void api_push_bound_function(lua_State *L, const struct api_entry *e, lua_CFunction f)
{
    struct api_binding *bound = lua_newuserdatauv(L, sizeof *bound, 1);

    *bound = (struct api_binding){ .entry = e, .hash = hash_bytes(HASH_START, e->name, strlen(e->name)) };
    bound->may_iterate = e->positional_count < e->count || e->flags & (API_PATTERN | API_VARARGS | API_TAKES_VALUES);
    for (int i = 0; i < e->count; i++)
        bound->may_iterate |= e->params[i].type == A_TABLE;
    lua_pushcclosure(L, f, 1);
}

enum { SEARCH_WORK = 100 /* VM instructions charged for searching an entry */ };

void api_push_function(lua_State *L, const struct api_entry *e)
{
    api_push_bound_function(L, e, call_entry);
}

bool api_push_member(lua_State *L, const char *owner, char separator, const char *name)
{
    vm_charge(L, SEARCH_WORK);
    for (int m = 0; m < api_get_table(L)->n; m++)
        for (int i = 0; i < api_get_table(L)->modules[m]->n; i++) {
            const struct api_entry *e = &api_get_table(L)->modules[m]->entries[i];
            const char *member = api_member_name(e, owner, separator);
            if (member && !strcmp(member, name) && !api_disabled_reason(&vm_board(L)->cart.manifest, e->name)) {
                api_push_function(L, e);
                return true;
            }
        }
    return false;
}
