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
 * A plan is in Lua's heap. The plan's function keeps the plan alive, and the plan keeps the strings alive. A plan
 * changes no result, because the order of parameters only decides where a search starts.
 */
#include "../../base/bits.h"
#include "api_parts.h"

enum {
    WARM = 16,                /* number of calls before a plan is made */
    ROOMY = LUA_MINSTACK - 3, /* stack slots a C function has above its arguments; odd, as the offsets of values are */
    FURTHER = 16,             /* stack slots an API function may need in addition */
    KEYS = MAX_PARAMS
};

struct api_plan {
    const struct api_entry *fire; /* the entry whose parameters are taken in addition */
    enum name_kind names;         /* list of the declared values, which follow the parameters */
    int n, values;
    uint64_t required;        /* mask of required parameters */
    uint8_t follow[KEYS + 1]; /* by parameter: the one that followed it; last element: the first */
    const void *key[KEYS];    /* the Lua string of each name; the plan's address if not yet known */
    struct api_value start[]; /* values of omitted arguments */
};

static void fill(struct api_plan *p, const struct api_entry *e, const struct api_entry *fire)
{
    for (int i = 0; i < p->n + p->values; i++) {
        p->key[i] = p;
        p->start[i] = (struct api_value){ .at = e->plain + 2 }; /* the nil above the table */
        if (i >= p->n)
            continue;
        const struct api_param *param = api_param_at(e, fire, i);
        api_fill_default(param, &p->start[i]);
        p->required |= (uint64_t)!param->optional << i;
    }
}

/* Makes the plan of f. f keeps the plan alive, and the plan's user values keep the strings of the names alive. */
static struct api_plan *make(lua_State *L, struct api_bound *f, const struct api_entry *fire)
{
    const struct api_entry *e = f->entry;
    const enum name_kind names = api_value_names(fire ? fire : e);
    const int n = api_param_count(e, fire), values = api_values(vm_board(L), names);
    struct api_plan *p = lua_newuserdatauv(L, sizeof *p + (size_t)(n + values) * sizeof *p->start, n + values);

    *p = (struct api_plan){ .fire = fire, .names = names, .n = n, .values = values };
    fill(p, e, fire);
    lua_setiuservalue(L, lua_upvalueindex(1), 1);
    f->plan = p;
    return p;
}

/* Returns the plan for this call, or NULL if there is none. A call has a plan only if its last argument is the table of
 * named arguments. */
static struct api_plan *plan_for(lua_State *L, struct api_bound *f, const struct api_entry **fire)
{
    const struct api_entry *e = f->entry;
    const int at = e->plain + 1;

    if (e->flags & API_MORE || lua_gettop(L) != at || lua_type(L, at) != LUA_TTABLE || vm_board(L)->vm.plain)
        return NULL;
    *fire = api_fires(L, e, at);
    struct api_plan *p = f->plan;
    if (p && p->fire == *fire && p->values == api_values(vm_board(L), p->names))
        return p;
    if ((p && p->fire != *fire) || ++f->tables < WARM)
        return NULL;
    return make(L, f, *fire);
}

/* Returns the index of the parameter or declared value named by the key below the top of the stack, and stores the key
 * in the plan; -1: unknown. */
static int learn(lua_State *L, const struct api_entry *e, struct api_plan *p)
{
    const void *key = lua_topointer(L, -2);
    int i = 0;

    while (i < p->n + p->values && p->key[i] != key)
        i++;
    if (i < p->n + p->values)
        return i;
    const char *name = luakeys_text(L, -2);
    if (!name || (e->flags & API_FIRE && !strcmp(name, "each"))) /* `each` makes fewer arguments required */
        return -1;
    i = api_search_param(e, p->fire, name);
    if (i < 0 && p->values > 0) {
        const int k = api_names_find(L, p->names, name);
        i = k == NO_SLOT ? -1 : p->n + k;
    }
    if (i < 0)
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
static bool walk(lua_State *L, const struct api_entry *e, struct api_plan *p, int at, struct api_value *v,
                 uint64_t *given)
{
    int last = KEYS, slot = at + 3;

    lua_pushnil(L);
    lua_pushnil(L);
    while (lua_next(L, at)) {
        if (slot == at + ROOMY)
            luaL_checkstack(L, 2 * (p->n + p->values), NULL);
        int i = p->follow[last];
        if (lua_topointer(L, -2) != p->key[i]) {
            if ((i = learn(L, e, p)) < 0)
                return false;
            p->follow[last] = (uint8_t)i;
        }
        api_look(L, slot, -1, &v[i]);
        slot += 2;
        lua_pushvalue(L, -2);
        *given |= 1ull << i;
        last = i;
    }
    return true;
}

static void check(lua_State *L, const struct api_entry *e, const struct api_plan *p, struct api_value *v, int i)
{
    if (i < p->n) {
        api_check_value(L, e->name, api_param_at(e, p->fire, i), &v[i]);
        return;
    }
    const struct api_param param = api_value_param(board_name(vm_board(L), p->names, i - p->n));
    api_check_value(L, e->name, &param, &v[i]);
}

/* Checks a call whose arguments are all positional and all on the stack. */
static int check_plain(lua_State *L, const struct api_entry *e, struct api_value *v)
{
    for (int i = 0; i < e->count; i++) {
        api_look(L, i + 1, i + 1, &v[i]);
        if (v[i].given || !e->params[i].optional)
            api_check_value(L, e->name, &e->params[i], &v[i]);
        else
            api_fill_default(&e->params[i], &v[i]);
    }
    return e->count;
}

int api_read_planned_arguments(lua_State *L, struct api_bound *f, struct api_value *v, const struct api_entry **fire)
{
    const struct api_entry *e = f->entry;
    uint64_t given = 0;
    const int at = e->plain + 1;

    if (e->plain == e->count && !(e->flags & (API_FIRE | API_MORE | API_VALUES)) && lua_gettop(L) == e->count) {
        *fire = NULL;
        memset(v, 0, e->count * sizeof *v);
        return check_plain(L, e, v);
    }
    struct api_plan *p = plan_for(L, f, fire);
    if (!p)
        return api_read_arguments(L, e, v, fire);
    memcpy(v, p->start, (size_t)(p->n + p->values) * sizeof *v);
    if (!walk(L, e, p, at, v, &given)) {
        lua_settop(L, at);
        return api_read_arguments(L, e, v, fire);
    }
    luaL_checkstack(L, FURTHER, NULL);
    vm_board(L)->vm.planned++;
    for (int i = 0; i < e->plain; i++) {
        api_look(L, i + 1, i + 1, &v[i]);
        given |= (uint64_t)v[i].given << i;
    }
    for (uint64_t asked = given | p->required; asked; asked &= asked - 1)
        check(L, e, p, v, (int)bits_lowest(asked));
    return p->n + p->values;
}
