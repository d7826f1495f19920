/*
 * api_plan.c - faster argument passing for calls whose tables have the same keys as the tables of earlier calls.
 *
 * api_read_arguments (api_check.c) defines the arguments of a call and raises every error about them. A function that
 * is called repeatedly with a table gets a plan: the order of parameters in the last table that was iterated, the Lua
 * strings of the parameters' names, and the values of omitted arguments. Lua interns short strings, so a key that is
 * the plan's own string is that name, and no characters are compared. A key unknown to the plan is looked up and
 * learnt; if it is not a parameter, or not a string, api_read_arguments processes the call from the start, which is
 * safe because reading the table has had no other effects.
 *
 * Kept because scripts fire bullets one by one: `bullet.fire` takes 0.75 to 0.85 of the time (rows "price kept" and
 * "price valued" of `make compare`). tests/machine/test_plans.c compares it with api_read_arguments.
 *
 * A plan is in Lua's heap. The plan's function keeps the plan alive, and the plan keeps the strings alive. A plan
 * changes no result, because the order of parameters only decides where a search starts.
 */
#include "../../base/bits.h"
#include "api_parts.h"

enum {
    CALLS_BEFORE_PLAN = 16, /* number of calls before a plan is made */
    FREE_STACK_SLOTS =
        LUA_MINSTACK - 3,   /* stack slots a C function has above its arguments; odd, as the offsets of values are */
    EXTRA_STACK_SLOTS = 16, /* stack slots an API function may need in addition */
    MAX_KEYS = MAX_PARAMS
};

struct api_plan {
    const struct api_entry *fired_entry; /* the entry whose parameters are taken in addition */
    enum name_kind names;                /* list of the declared values, which follow the parameters */
    int n, n_values;
    uint64_t required;                /* mask of required parameters */
    uint8_t next_param[MAX_KEYS + 1]; /* by parameter: the one that followed it; last element: the first */
    const void *key[MAX_KEYS];        /* the Lua string of each name; the plan's address if not yet known */
    struct api_value defaults[];      /* values of omitted arguments */
};

static void fill_plan(struct api_plan *p, const struct api_entry *e, const struct api_entry *fired_entry)
{
    for (int i = 0; i < p->n + p->n_values; i++) {
        p->key[i] = p;
        p->defaults[i] = (struct api_value){ .at = e->positional_count + 2 }; /* the nil above the table */
        if (i >= p->n)
            continue;
        const struct api_param *param = api_param_at(e, fired_entry, i);
        api_fill_default(param, &p->defaults[i]);
        p->required |= (uint64_t)(param->optional == REQ || param->optional == UNLESS_VXY) << i;
    }
}

/* Makes the plan of f. f keeps the plan alive, and the plan's user values keep the strings of the names alive. */
static struct api_plan *make_plan(lua_State *L, struct api_binding *f, const struct api_entry *fired_entry)
{
    const struct api_entry *e = f->entry;
    const enum name_kind names = api_entry_value_names(fired_entry ? fired_entry : e);
    const int n = api_param_count(e, fired_entry), n_values = api_value_count(vm_board(L), names);
    struct api_plan *p = lua_newuserdatauv(L, sizeof *p + (size_t)(n + n_values) * sizeof *p->defaults, n + n_values);

    *p = (struct api_plan){ .fired_entry = fired_entry, .names = names, .n = n, .n_values = n_values };
    fill_plan(p, e, fired_entry);
    lua_setiuservalue(L, lua_upvalueindex(1), 1);
    f->plan = p;
    return p;
}

/* Returns the plan for this call, or NULL if there is none. A call has a plan only if its last argument is the table of
 * named arguments. */
static struct api_plan *get_plan(lua_State *L, struct api_binding *f, const struct api_entry **fired_entry)
{
    const struct api_entry *e = f->entry;
    const int at = e->positional_count + 1;

    if (e->flags & API_VARARGS || lua_gettop(L) != at || lua_type(L, at) != LUA_TTABLE || vm_board(L)->vm.skips_plans)
        return NULL;
    *fired_entry = api_find_fired_entry(L, e, at);
    struct api_plan *p = f->plan;
    if (p && p->fired_entry == *fired_entry && p->n_values == api_value_count(vm_board(L), p->names))
        return p;
    if ((p && p->fired_entry != *fired_entry) || ++f->table_call_count < CALLS_BEFORE_PLAN)
        return NULL;
    return make_plan(L, f, *fired_entry);
}

/* Returns the index of the parameter or declared value named by the key below the top of the stack, and stores the key
 * in the plan; -1: unknown. */
static int learn_key(lua_State *L, const struct api_entry *e, struct api_plan *p)
{
    const void *key = lua_topointer(L, -2);
    int i = 0;

    while (i < p->n + p->n_values && p->key[i] != key)
        i++;
    if (i < p->n + p->n_values)
        return i;
    const char *name = luakeys_text(L, -2);
    if (!name || (e->flags & API_PATTERN && !strcmp(name, "each"))) /* `each` makes fewer arguments required */
        return -1;
    i = api_search_param(e, p->fired_entry, name);
    if (i < 0 && p->n_values > 0) {
        const int k = api_names_find(L, p->names, name);
        i = k == NO_SLOT ? -1 : p->n + k;
    }
    if (i < 0 || (i < p->n && api_param_at(e, p->fired_entry, i)->optional == VXY)) /* `vx` replaces `speed` */
        return -1;
    p->key[i] = key;
    lua_getiuservalue(L, lua_upvalueindex(1), 1);
    lua_pushvalue(L, -3);
    lua_setiuservalue(L, -2, i + 1);
    lua_pop(L, 1);
    return i;
}

/* Iterates over the table at `at`. Leaves the keys and values on the stack, above a nil. Returns false if a key is not
 * an argument. */
static bool read_table(lua_State *L, const struct api_entry *e, struct api_plan *p, int at, struct api_value *v,
                       uint64_t *given_mask)
{
    int previous = MAX_KEYS, slot = at + 3;

    lua_pushnil(L);
    lua_pushnil(L);
    while (lua_next(L, at)) {
        if (slot == at + FREE_STACK_SLOTS)
            luaL_checkstack(L, 2 * (p->n + p->n_values), NULL);
        int i = p->next_param[previous];
        if (lua_topointer(L, -2) != p->key[i]) {
            if ((i = learn_key(L, e, p)) < 0)
                return false;
            p->next_param[previous] = (uint8_t)i;
        }
        api_read_value(L, slot, -1, &v[i]);
        slot += 2;
        lua_pushvalue(L, -2);
        *given_mask |= 1ull << i;
        previous = i;
    }
    return true;
}

static void check_argument(lua_State *L, const struct api_entry *e, const struct api_plan *p, struct api_value *v,
                           int i)
{
    if (i < p->n) {
        api_check_value(L, e->name, api_param_at(e, p->fired_entry, i), &v[i]);
        return;
    }
    const struct api_param param = api_value_param(board_name(vm_board(L), p->names, i - p->n));
    api_check_value(L, e->name, &param, &v[i]);
}

/* Checks a call whose arguments are all positional and all on the stack. */
static int check_positional(lua_State *L, const struct api_entry *e, struct api_value *v)
{
    for (int i = 0; i < e->count; i++) {
        api_read_value(L, i + 1, i + 1, &v[i]);
        if (v[i].given || !e->params[i].optional)
            api_check_value(L, e->name, &e->params[i], &v[i]);
        else
            api_fill_default(&e->params[i], &v[i]);
    }
    return e->count;
}

int api_read_planned_arguments(lua_State *L, struct api_binding *f, struct api_value *v,
                               const struct api_entry **fired_entry)
{
    const struct api_entry *e = f->entry;
    uint64_t given_mask = 0;
    const int at = e->positional_count + 1;

    if (e->positional_count == e->count && !(e->flags & (API_PATTERN | API_VARARGS | API_TAKES_VALUES)) &&
        lua_gettop(L) == e->count) {
        *fired_entry = NULL;
        memset(v, 0, e->count * sizeof *v);
        return check_positional(L, e, v);
    }
    struct api_plan *p = get_plan(L, f, fired_entry);
    if (!p)
        return api_read_arguments(L, e, v, fired_entry);
    memcpy(v, p->defaults, (size_t)(p->n + p->n_values) * sizeof *v);
    if (!read_table(L, e, p, at, v, &given_mask)) {
        lua_settop(L, at);
        return api_read_arguments(L, e, v, fired_entry);
    }
    luaL_checkstack(L, EXTRA_STACK_SLOTS, NULL);
    vm_board(L)->vm.plan_count++;
    for (int i = 0; i < e->positional_count; i++) {
        api_read_value(L, i + 1, i + 1, &v[i]);
        given_mask |= (uint64_t)v[i].given << i;
    }
    for (uint64_t to_check = given_mask | p->required; to_check; to_check &= to_check - 1)
        check_argument(L, e, p, v, (int)bits_lowest(to_check));
    return p->n + p->n_values;
}
