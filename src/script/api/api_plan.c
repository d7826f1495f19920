/*
 * api_plan.c - the arguments of a call whose table looks like those of the calls before.
 *
 * What a call's arguments are, and every error about them, is api_arguments (api_check.c). A function that is called
 * again and again with a table gets a plan: which parameter came behind which one when a table was last walked over,
 * the Lua strings that are the parameters' names, and the values of what is not given. Lua keeps one string of a short
 * text, so a key that is the plan's own string is that name, and no letter is looked at. A key that a plan does not
 * know is looked up and learnt; one that is no parameter, or no text, leaves the call to api_arguments, from the
 * beginning: until then nothing was done but to read.
 *
 * A plan lives in Lua's heap, held by its function, and holds its strings. It changes no result: what it says of the
 * order is only where a search begins.
 */
#include "../../base/bits.h"
#include "api_parts.h"

enum {
    WARM = 16,                /* calls before a plan is made */
    ROOMY = LUA_MINSTACK - 3, /* places for which a C function has room behind its arguments; odd, as values' are */
    FURTHER = 16,             /* that a function of the API may need */
    KEYS = MAX_PARAMS
};

struct api_plan {
    const struct api_entry *fire; /* whose parameters are taken besides */
    enum name_kind names;         /* of the declared values, which stand behind the parameters */
    int n, values;
    uint64_t required;        /* bits of parameters */
    uint8_t follow[KEYS + 1]; /* what came behind each; the last: first of all */
    const void *key[KEYS];    /* the Lua string of each, or the plan itself, which is no key */
    struct api_value start[]; /* of what is not given */
};

static void fill(struct api_plan *p, const struct api_entry *e, const struct api_entry *fire)
{
    for (int i = 0; i < p->n + p->values; i++) {
        p->key[i] = p;
        p->start[i] = (struct api_value){ .at = e->plain + 2 }; /* a nil behind the table */
        if (i >= p->n)
            continue;
        const struct api_param *param = api_param_at(e, fire, i);
        api_fill_default(param, &p->start[i]);
        p->required |= (uint64_t)!param->optional << i;
    }
}

/* Makes the plan of f, which holds it; a plan holds its names as user values. */
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

/* The plan for this call, whose table is on top of the stack, with nothing behind it; NULL: it has none. */
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

/* The number of the parameter, or declared value, that the key of the two values on top names, learnt; -1: none's. */
static int learn(lua_State *L, const struct api_entry *e, struct api_plan *p)
{
    const void *key = lua_topointer(L, -2);
    int i = 0;

    while (i < p->n + p->values && p->key[i] != key)
        i++;
    if (i < p->n + p->values)
        return i;
    const char *name = luakeys_text(L, -2);
    if (!name || (e->flags & API_FIRE && !strcmp(name, "each"))) /* with `each`, less is required */
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

/* Walks over the table at `at`: its keys and values stay on the stack, behind a nil. False: something in it is no
 * argument. */
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
        api_check_looked(L, e->name, api_param_at(e, p->fire, i), &v[i]);
        return;
    }
    const struct api_param param = api_value_param(board_name(vm_board(L), p->names, i - p->n));
    api_check_looked(L, e->name, &param, &v[i]);
}

/* All arguments are plain, and as many are given as there can be. */
static int check_plain(lua_State *L, const struct api_entry *e, struct api_value *v)
{
    for (int i = 0; i < e->count; i++) {
        api_look(L, i + 1, i + 1, &v[i]);
        if (v[i].given || !e->params[i].optional)
            api_check_looked(L, e->name, &e->params[i], &v[i]);
        else
            api_fill_default(&e->params[i], &v[i]);
    }
    return e->count;
}

int api_arguments_planned(lua_State *L, struct api_bound *f, struct api_value *v, const struct api_entry **fire)
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
        return api_arguments(L, e, v, fire);
    memcpy(v, p->start, (size_t)(p->n + p->values) * sizeof *v);
    if (!walk(L, e, p, at, v, &given)) {
        lua_settop(L, at);
        return api_arguments(L, e, v, fire);
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
