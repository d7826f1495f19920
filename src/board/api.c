/*
 * api.c - see api.h. Every API function is one C closure, `call`, which knows its entry: it checks, folds, and runs.
 */
#include "api.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/hash.h"
#include "../base/trig.h"
#include "events_run.h"

enum { MAX_PARAMS = 40 };

static const char names_key[NAMES] = { 0 }, back_key[NAMES] = { 0 }, methods_key[HANDLES] = { 0 };

int api_error(lua_State *L, const char *entry, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const char *message = lua_pushvfstring(L, format, args);
    va_end(args);
    return vm_fault(L, FAULT_SCRIPT, "%s: %s", entry, message);
}

/* ---- words ---- */

int words_apart(const char *a, const char *b)
{
    enum { LONGEST = 32 };
    size_t n = strlen(a), m = strlen(b);
    int d[LONGEST + 1][LONGEST + 1];

    if (n > LONGEST || m > LONGEST)
        return 99;
    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= m; j++) {
            if (!i || !j) {
                d[i][j] = (int)(i + j);
                continue;
            }
            int best = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            best = d[i - 1][j] + 1 < best ? d[i - 1][j] + 1 : best;
            best = d[i][j - 1] + 1 < best ? d[i][j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && d[i - 2][j - 2] + 1 < best)
                best = d[i - 2][j - 2] + 1;
            d[i][j] = best;
        }
    return d[n][m] <= 1 || (d[n][m] <= 2 && n > 3) || (d[n][m] <= 3 && n > 7) ? d[n][m] : 99;
}

/* ---- declared names ---- */

void names_declare(lua_State *L, enum api_names what, const char *entry, const char *name, int index)
{
    static const char *const nouns[NAMES] = { "bullet", "shot", "enemy", "player", "spark", "motion", "tag" };

    if (names_find(L, what, name) != NO_SLOT)
        api_error(L, entry, "%s kind \"%s\" is declared already", nouns[what], name);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]);
    lua_pushinteger(L, index);
    lua_setfield(L, -2, name);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &back_key[what]);
    lua_pushstring(L, name);
    lua_rawseti(L, -2, index);
    lua_pop(L, 2);
}

int names_find(lua_State *L, enum api_names what, const char *name)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]);
    int index = lua_getfield(L, -1, name) == LUA_TNUMBER ? (int)lua_tointeger(L, -1) : NO_SLOT;
    lua_pop(L, 2);
    return index;
}

void names_push(lua_State *L, enum api_names what, int index)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &back_key[what]);
    lua_rawgeti(L, -1, index);
    lua_remove(L, -2);
}

/* Keeps the better of two suggestions: the nearer, then the one that comes first in byte order. */
static void consider(const char *word, const char *candidate, int *best, const char **found)
{
    int d = words_apart(word, candidate);

    if (d < *best || (d == *best && *found && d < 99 && strcmp(candidate, *found) < 0)) {
        *best = d;
        *found = candidate;
    }
}

void names_near(lua_State *L, enum api_names what, const char *name)
{
    const char *found = NULL;
    int best = 99;

    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]);
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        consider(name, lua_tostring(L, -1), &best, &found);
    }
    lua_pop(L, 1);
    if (found)
        lua_pushstring(L, found);
    else
        lua_pushnil(L);
}

uint16_t api_tag(lua_State *L, const char *entry, int at)
{
    size_t n;
    const char *tag = lua_tolstring(L, at, &n);

    if (n > 31 || n == 0 || strlen(tag) != n)
        api_error(L, entry, "tag: expected a string of 1 to 31 bytes, got %d", (int)n);
    int i = names_find(L, N_TAG, tag);
    if (i != NO_SLOT)
        return (uint16_t)i;
    lua_rawgetp(L, LUA_REGISTRYINDEX, &back_key[N_TAG]);
    i = (int)lua_rawlen(L, -1) + 1;
    lua_pop(L, 1);
    if (i > 4095)
        api_error(L, entry, "tag: \"%s\" is one tag too many: a run has at most 4095 different ones", tag);
    names_declare(L, N_TAG, entry, tag, i);
    return (uint16_t)i;
}

void api_push_tag(lua_State *L, uint16_t tag)
{
    if (tag)
        names_push(L, N_TAG, tag);
    else
        lua_pushnil(L);
}

/* ---- checking arguments ---- */

static const char *const thing_names[HANDLES] = { NULL,       "a bullet", "a shot",   "an enemy", "a player",
                                                  "a sprite", "a task",   "a motion", "a group" };

/* Pushes how a value looks in an error. */
static const char *push_got(lua_State *L, int at)
{
    switch (lua_type(L, at)) {
    case LUA_TNIL:
    case LUA_TNONE:
        return lua_pushliteral(L, "nil");
    case LUA_TNUMBER:
        if (lua_isinteger(L, at) && handle_is(lua_tointeger(L, at)))
            return lua_pushstring(L, thing_names[handle_kind(lua_tointeger(L, at))]);
        if (lua_isinteger(L, at))
            return lua_pushfstring(L, "%I", (LUAI_UACINT)lua_tointeger(L, at));
        if (isnan(lua_tonumber(L, at)))
            return lua_pushliteral(L, "nan");
        return lua_pushfstring(L, "%f", lua_tonumber(L, at));
    case LUA_TSTRING:
        return lua_pushfstring(L, "\"%s\"", lua_tostring(L, at));
    case LUA_TBOOLEAN:
        return lua_pushstring(L, lua_toboolean(L, at) ? "true" : "false");
    default:
        return lua_pushfstring(L, "a %s", luaL_typename(L, at));
    }
}

static void format_number(char *out, size_t size, double v)
{
    snprintf(out, size, "%.14g", v);
}

static void expected(lua_State *L, const char *entry, const struct api_param *p, int at, const char *what)
{
    const char *got = push_got(L, at);

    api_error(L, entry, "%s: expected %s, got %s", p->name, what, got);
}

static void expected_number(lua_State *L, const char *entry, const struct api_param *p, int at, const char *noun)
{
    char lo[32], hi[32], what[160];

    format_number(lo, sizeof lo, p->lo);
    format_number(hi, sizeof hi, p->hi);
    snprintf(what, sizeof what, "%s from %s to %s%s%s", noun, lo, hi, p->unit ? " " : "", p->unit ? p->unit : "");
    expected(L, entry, p, at, what);
}

static void check_int(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    int whole = 0;

    v->i = lua_type(L, at) == LUA_TNUMBER ? lua_tointegerx(L, at, &whole) : 0;
    if (p->type == A_COUNT && whole && v->i == LUA_MAXINTEGER)
        return;
    if (!whole || (double)v->i < p->lo || (double)v->i > p->hi)
        expected_number(L, entry, p, at, p->type == A_COUNT ? "forever or a whole number" : "a whole number");
}

static void check_number(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    bool is = lua_type(L, at) == LUA_TNUMBER;

    v->n = is ? lua_tonumber(L, at) : 0;
    if (!is || !(v->n >= p->lo && v->n <= p->hi))
        expected_number(L, entry, p, at, "a number");
    if (p->type == A_FX && !fx_from_double(v->n, &v->f))
        expected_number(L, entry, p, at, "a number");
}

static void check_dir(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    bool is = lua_type(L, at) == LUA_TNUMBER;

    v->n = is ? lua_tonumber(L, at) : 0;
    if (!is || !trig_from_degrees(v->n, &v->a))
        expected(L, entry, p, at, "a number of degrees");
}

static void check_type(lua_State *L, const char *entry, const struct api_param *p, int at, int type, const char *what)
{
    if (lua_type(L, at) != type)
        expected(L, entry, p, at, what);
}

/* lo and hi bound the length in bytes; hi 0: any. */
static void check_string(lua_State *L, const char *entry, const struct api_param *p, int at)
{
    char what[64];

    check_type(L, entry, p, at, LUA_TSTRING, "a string");
    double n = (double)lua_rawlen(L, at);
    if (strlen(lua_tostring(L, at)) != lua_rawlen(L, at))
        expected(L, entry, p, at, "a string without \\0");
    if (p->hi > 0 && (n < p->lo || n > p->hi)) {
        snprintf(what, sizeof what, "a string of %d to %d bytes", (int)p->lo, (int)p->hi);
        expected(L, entry, p, at, what);
    }
}

static void check_thing(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    unsigned mask = (unsigned)p->lo;

    v->i = lua_isinteger(L, at) ? lua_tointeger(L, at) : 0;
    if (handle_is(v->i) && mask >> handle_kind(v->i) & 1)
        return;
    for (int k = 1; k < HANDLES; k++)
        if (mask == 1u << k)
            expected(L, entry, p, at, thing_names[k]);
    expected(L, entry, p, at, mask & 1 << H_TASK ? "a thing, a task or a scope" : "a thing that is somewhere");
}

/* A name that was declared: its index, or an error with the nearest one. */
static void check_name(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v,
                       enum api_names what, const char *noun)
{
    check_type(L, entry, p, at, LUA_TSTRING, "a name");
    v->i = names_find(L, what, lua_tostring(L, at));
    if (v->i != NO_SLOT)
        return;
    names_near(L, what, lua_tostring(L, at));
    if (lua_isnil(L, -1))
        api_error(L, entry, "%s \"%s\" is not declared", noun, lua_tostring(L, at));
    api_error(L, entry, "%s \"%s\" is not declared (did you mean \"%s\"?)", noun, lua_tostring(L, at),
              lua_tostring(L, -1));
}

static void check_sprite(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    const struct cart *cart = &vm_board(L)->cart;
    const char *found = NULL;
    int best = 99;

    check_type(L, entry, p, at, LUA_TSTRING, "a sprite's name");
    v->i = cart_find_sprite(cart, lua_tostring(L, at));
    if (v->i >= 0)
        return;
    for (int i = 0; i < cart->sprites; i++)
        consider(lua_tostring(L, at), cart_sprite_name(cart, i), &best, &found);
    if (!found)
        api_error(L, entry, "sprite \"%s\" is not in rom.lua", lua_tostring(L, at));
    api_error(L, entry, "sprite \"%s\" is not in rom.lua (did you mean \"%s\"?)", lua_tostring(L, at), found);
}

/* One word of a fixed list. */
static void check_word(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v,
                       const char *const *words, int n)
{
    luaL_Buffer list;

    for (v->i = 0; v->i < n; v->i++)
        if (lua_type(L, at) == LUA_TSTRING && !strcmp(lua_tostring(L, at), words[v->i]))
            return;
    luaL_buffinit(L, &list);
    for (int i = 0; i < n; i++) {
        luaL_addstring(&list, i ? (i == n - 1 ? " or " : ", ") : "");
        luaL_addstring(&list, words[i]);
    }
    luaL_pushresult(&list);
    expected(L, entry, p, at, lua_tostring(L, -1));
}

static void check_pad(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    v->i = lua_isinteger(L, at) ? lua_tointeger(L, at) : 0;
    if (handle_is(v->i) && handle_kind(v->i) == H_PLAYER) {
        if (!handle_gen(v->i)) {
            v->i = 0;
            return;
        }
        v->i = handle_slot(v->i) + 1;
    }
    if (v->i < 1 || v->i > PADS)
        expected(L, entry, p, at, "1, 2 or a player");
}

static void check_motion(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    int64_t h = lua_isinteger(L, at) ? lua_tointeger(L, at) : 0;

    if (handle_is(h) && handle_kind(h) == H_MOTION) {
        v->i = handle_gen(h) ? handle_slot(h) + 1 : 0;
        if (v->i > vm_board(L)->motions.s.live)
            expected(L, entry, p, at, "a motion that motion.def returned");
        return;
    }
    if (lua_type(L, at) != LUA_TSTRING)
        expected(L, entry, p, at, "a motion or a motion's name");
    check_name(L, entry, p, at, v, N_MOTION, "motion");
    v->i++;
}

void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    static const char *const kind_nouns[] = { "bullet kind", "shot kind", "enemy kind", "player kind", "spark kind" };
    static const char *const buttons[] = PAD_NAMES, *const eases[] = { "linear", "in", "out", "both" },
                             *const layers[] = { "back", "middle", "front" },
                             *const aligns[] = { "left", "center", "right" };

    v->at = at;
    v->given = !lua_isnoneornil(L, at);
    if (!v->given && p->optional)
        return;
    switch (p->type) {
    case A_INT:
    case A_COUNT:
        check_int(L, entry, p, at, v);
        break;
    case A_NUM:
    case A_FX:
        check_number(L, entry, p, at, v);
        break;
    case A_DIR:
        check_dir(L, entry, p, at, v);
        break;
    case A_STR:
        check_string(L, entry, p, at);
        break;
    case A_BOOL:
        check_type(L, entry, p, at, LUA_TBOOLEAN, "true or false");
        v->i = lua_toboolean(L, at);
        break;
    case A_FUNC:
        check_type(L, entry, p, at, LUA_TFUNCTION, "a function");
        break;
    case A_TABLE:
        check_type(L, entry, p, at, LUA_TTABLE, "a table");
        break;
    case A_ROUTE:
        check_type(L, entry, p, at, LUA_TTABLE, "a route (what path.def returned)");
        break;
    case A_HIT:
        if (lua_type(L, at) != LUA_TTABLE && lua_type(L, at) != LUA_TSTRING)
            expected(L, entry, p, at, "{ circle = r }, { box = { w, h } } or \"none\"");
        break;
    case A_ANY:
        if (!v->given)
            expected(L, entry, p, at, "a value");
        break;
    case A_THING:
        check_thing(L, entry, p, at, v);
        break;
    case A_MOTION:
        check_motion(L, entry, p, at, v);
        break;
    case A_BULLET_KIND:
    case A_SHOT_KIND:
    case A_ENEMY_KIND:
    case A_PLAYER_KIND:
    case A_SPARK_KIND:
        check_name(L, entry, p, at, v, (enum api_names)(p->type - A_BULLET_KIND), kind_nouns[p->type - A_BULLET_KIND]);
        break;
    case A_SPRITE:
        check_sprite(L, entry, p, at, v);
        break;
    case A_BUTTON:
        check_word(L, entry, p, at, v, buttons, PAD_BUTTONS);
        break;
    case A_PAD:
        check_pad(L, entry, p, at, v);
        break;
    case A_EASE:
        check_word(L, entry, p, at, v, eases, 4);
        break;
    case A_LAYER:
        check_word(L, entry, p, at, v, layers, LAYERS);
        break;
    case A_ALIGN:
        check_word(L, entry, p, at, v, aligns, 3);
        break;
    }
}

double api_default(const struct api_param *p)
{
    return p->def ? strtod(p->def, NULL) : 0;
}

/* Numbers keep their default as text, as Lua spells it. */
static void fill_default(const struct api_param *p, struct api_value *v)
{
    if (!p->def)
        return;
    v->n = api_default(p);
    v->i = (int64_t)v->n;
    if (p->type == A_FX)
        fx_from_double(v->n, &v->f);
    else if (p->type == A_DIR)
        trig_from_degrees(v->n, &v->a);
    else if (p->type == A_BOOL)
        v->i = !strcmp(p->def, "true");
    else if (p->type == A_LAYER)
        v->i = LAYER_FRONT;
    else if (p->type == A_COUNT && !strcmp(p->def, "forever"))
        v->i = LUA_MAXINTEGER;
}

/* bullet.fire's parameters, which patterns take too. */
static const struct api_entry *fire_entry(void);

static int param_count(const struct api_entry *e)
{
    return e->count + (e->flags & API_FIRE ? fire_entry()->count : 0);
}

static const struct api_param *param_at(const struct api_entry *e, int i)
{
    return i < e->count ? &e->params[i] : &fire_entry()->params[i - e->count];
}

/* An entry's own parameter hides bullet.fire's of the same name, because it comes first. */
static int param_named(const struct api_entry *e, const char *name)
{
    int n = param_count(e);

    for (int i = e->plain; i < n; i++) {
        const char *p = param_at(e, i)->name;
        if (p[0] == name[0] && !strcmp(p, name))
            return i;
    }
    return -1;
}

static void unknown(lua_State *L, const struct api_entry *e, const char *name)
{
    const char *found = NULL;
    int best = 99;

    for (int i = e->plain; i < param_count(e); i++)
        consider(name, param_at(e, i)->name, &best, &found);
    if (found)
        api_error(L, e->name, "unknown argument \"%s\" (did you mean \"%s\"?)", name, found);
    api_error(L, e->name, "unknown argument \"%s\"", name);
}

/* Spreads the table of named arguments at `at` over the stack from `first` on, a slot a parameter. */
static void spread(lua_State *L, const struct api_entry *e, int at, int first)
{
    const char *wrong = NULL;

    lua_pushnil(L);
    while (lua_next(L, at)) {
        if (lua_type(L, -2) != LUA_TSTRING) {
            const char *got = push_got(L, -2);
            api_error(L, e->name, "expected named arguments ({ name = value }), got one at %s", got);
        }
        int i = param_named(e, lua_tostring(L, -2));
        if (i >= 0)
            lua_replace(L, first + i - e->plain);
        else {
            const char *name = lua_tostring(L, -2);
            if (!wrong || strcmp(name, wrong) < 0)
                wrong = name;
            lua_pop(L, 1);
        }
    }
    if (wrong)
        unknown(L, e, wrong);
}

/* Checks the call's arguments (stack 1 to top) and fills v, one a parameter. */
static void arguments(lua_State *L, const struct api_entry *e, struct api_value *v)
{
    int n = param_count(e), top = lua_gettop(L), named = n - e->plain;

    if (!(e->flags & API_MORE) && top > e->plain + (named > 0)) {
        const char *usual = e->plain + (named > 0) == 1 ? "" : "s";
        api_error(L, e->name, "expected at most %d argument%s, got %d", e->plain + (named > 0), usual, top);
    }
    luaL_checkstack(L, n + 16, NULL);
    if (named > 0) {
        int at = e->plain + 1;
        lua_settop(L, at + named);
        if (lua_type(L, at) == LUA_TTABLE)
            spread(L, e, at, at + 1);
        else if (!lua_isnil(L, at)) {
            const char *got = push_got(L, at);
            api_error(L, e->name, "expected a table of named arguments, got %s", got);
        }
    } else if (top < e->plain)
        lua_settop(L, e->plain);
    bool lenient = false; /* with `each`, bullet.fire need not be the one that is called */
    for (int i = 0; i < n; i++) {
        struct api_param loose = *param_at(e, i);
        const struct api_param *p = &loose;
        if (i < e->count && e->flags & API_FIRE && !strcmp(p->name, "each"))
            lenient = !lua_isnil(L, i + 2);
        if (i >= e->count && lenient)
            loose.optional = OPT;
        v[i] = (struct api_value){ 0 };
        fill_default(p, &v[i]);
        api_check(L, e->name, p, i < e->plain ? i + 1 : i + 2, &v[i]);
    }
}

/* ---- the script digest ---- */

static void fold_value(lua_State *L, struct board *b, int at)
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
            fold_value(L, b, v[i].at);
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

static const struct api_entry *entry_named(const char *name)
{
    for (int i = 0; i < api_count(); i++)
        if (!strcmp(api_entry(i)->name, name))
            return api_entry(i);
    return NULL;
}

static const struct api_entry *fire_entry(void)
{
    return entry_named("bullet.fire");
}

/* Every API function. Upvalue 1: the entry's address as light userdata; 2: a hash of its name, which stands for it in the
 * digest, so that further entries do not change old demos. */
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
    arguments(L, e, v);
    if (e->flags & API_CHANGES)
        fold_arguments(L, b, (uint64_t)lua_tointeger(L, lua_upvalueindex(2)), v, e->count);
    int results = e->run(L, b, v);
    if (e->flags & API_CHANGES)
        for (int i = -results; i < 0; i++)
            fold_value(L, b, i);
    return results;
}

/* sys.check(name, ...): what `call` does for C entries, for those written in Lua. */
static int sys_check(lua_State *L)
{
    const struct api_entry *e = entry_named(luaL_checkstring(L, 1));
    struct api_value v[MAX_PARAMS];

    if (!e)
        return vm_fault(L, FAULT_SCRIPT, "sys.check: no entry \"%s\"", lua_tostring(L, 1));
    vm_charge(L, WORK_CALL);
    if (e->flags & API_LOAD && !vm_board(L)->vm.loading)
        return api_error(L, e->name, "only while scripts load");
    lua_remove(L, 1);
    arguments(L, e, v);
    int n = param_count(e);
    lua_createtable(L, 0, n);
    for (int i = n; i-- > 0;) {
        const struct api_param *p = param_at(e, i);
        bool own = i < e->count;
        if (v[i].given)
            lua_pushvalue(L, v[i].at);
        else if (!own || !p->def)
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

/* ---- handles ---- */

static const struct api_prop *prop_named(const struct api_thing *t, const char *name, int *index)
{
    for (int i = 0; i < t->n; i++)
        if (!strcmp(t->props[i].value.name, name)) {
            *index = i;
            return &t->props[i];
        }
    return NULL;
}

static int no_property(lua_State *L, const struct api_thing *t, int kind, const char *name)
{
    const char *found = NULL;
    int best = 99;

    for (int i = 0; i < t->n; i++)
        consider(name, t->props[i].value.name, &best, &found);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &methods_key[kind]);
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        consider(name, lua_tostring(L, -1), &best, &found);
    }
    if (found)
        return vm_fault(L, FAULT_SCRIPT, "%s has no property \"%s\" (did you mean \"%s\"?)", thing_names[kind], name,
                        found);
    return vm_fault(L, FAULT_SCRIPT, "%s has no property \"%s\"", thing_names[kind], name);
}

/* Register properties of a player: a name of its kind, which comes after the fixed ones. */
int player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name);

static int get_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    int p;

    if (!handle_is(h))
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    if (lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "%s has no property of type %s", thing_names[handle_kind(h)],
                        luaL_typename(L, 2));
    const char *name = lua_tostring(L, 2);
    const struct api_thing *t = api_things[handle_kind(h)];
    lua_rawgetp(L, LUA_REGISTRYINDEX, &methods_key[handle_kind(h)]);
    if (lua_getfield(L, -1, name) == LUA_TFUNCTION)
        return 1;
    bool alive = board_alive(b, h);
    if (!strcmp(name, "alive") && handle_kind(h) != H_GROUP && handle_kind(h) != H_MOTION)
        return lua_pushboolean(L, alive), 1;
    const struct api_prop *prop = prop_named(t, name, &p);
    if (handle_kind(h) == H_PLAYER && !prop) {
        int reg = player_register(L, b, handle_slot(h), name);
        if (reg >= 0) {
            if (!alive)
                return lua_pushnil(L), 1;
            return lua_pushinteger(L, b->player.regs[handle_slot(h) * REGISTERS + (uint32_t)reg]), 1;
        }
    }
    if (!prop)
        return no_property(L, t, (int)handle_kind(h), name);
    if (!alive && !(prop->write == PROP_LASTS && handle_gen(h) && handle_slot(h) < PADS))
        return lua_pushnil(L), 1;
    t->get(L, b, handle_slot(h), p);
    return 1;
}

static int set_register(lua_State *L, struct board *b, uint32_t slot, int reg, const char *name)
{
    struct api_param p = { name, A_INT, REQ, INT32_MIN, INT32_MAX, NULL, NULL };
    struct api_value v = { 0 };

    api_check(L, "player", &p, 3, &v);
    b->player.regs[slot * REGISTERS + (uint32_t)reg] = (int32_t)v.i;
    return 0;
}

static int set_property(lua_State *L)
{
    struct board *b = vm_board(L);
    int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;
    struct api_value v = { 0 };
    int p;

    if (!handle_is(h) || lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "attempt to index a number value (it is not a thing)");
    const char *name = lua_tostring(L, 2);
    const struct api_thing *t = api_things[handle_kind(h)];
    const struct api_prop *prop = prop_named(t, name, &p);
    bool alive = board_alive(b, h);
    script_fold(b, 0x2000);
    fold_value(L, b, 1);
    fold_value(L, b, 2);
    fold_value(L, b, 3);
    if (handle_kind(h) == H_PLAYER && !prop) {
        int reg = player_register(L, b, handle_slot(h), name);
        if (reg >= 0)
            return alive ? set_register(L, b, handle_slot(h), reg, name) : 0;
    }
    if (!prop)
        return no_property(L, t, (int)handle_kind(h), name);
    if (prop->write != PROP_WRITE)
        return vm_fault(L, FAULT_SCRIPT, "%s: %s is read only", t->name, name);
    api_check(L, t->name, &prop->value, 3, &v);
    if (alive)
        t->set(L, b, handle_slot(h), p, &v);
    return 0;
}

static void open_handles(lua_State *L)
{
    lua_pushinteger(L, 0);
    lua_createtable(L, 0, 2);
    lua_pushcfunction(L, get_property);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, set_property);
    lua_setfield(L, -2, "__newindex");
    lua_setmetatable(L, -2); /* of the number type */
    lua_pop(L, 1);
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

    if (!split) {
        push_function(L, e);
        lua_setglobal(L, e->name);
        return;
    }
    snprintf(space, sizeof space, "%.*s", (int)(split - e->name), e->name);
    if (*split == ':') {
        for (int k = 1; k < HANDLES; k++)
            if (api_things[k] && !strcmp(api_things[k]->name, space))
                lua_rawgetp(L, LUA_REGISTRYINDEX, &methods_key[k]);
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
    for (int i = 0; i < NAMES; i++) {
        lua_newtable(L);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &names_key[i]);
        lua_newtable(L);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &back_key[i]);
    }
    for (int i = 0; i < HANDLES; i++) {
        lua_newtable(L);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &methods_key[i]);
    }
    events_open(L);
    open_handles(L);
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

/* ---- help ---- */

static const char *type_words(const struct api_param *p)
{
    static const char *const words[] = {
        [A_INT] = "whole number",
        [A_COUNT] = "whole number or forever",
        [A_NUM] = "number",
        [A_FX] = "number",
        [A_DIR] = "degrees",
        [A_STR] = "string",
        [A_BOOL] = "true or false",
        [A_FUNC] = "function",
        [A_TABLE] = "table",
        [A_ANY] = "any value",
        [A_ROUTE] = "route",
        [A_THING] = "thing",
        [A_HIT] = "{ circle = r }, { box = { w, h } } or \"none\"",
        [A_MOTION] = "motion or its name",
        [A_BULLET_KIND] = "name of a bullet kind",
        [A_SHOT_KIND] = "name of a shot kind",
        [A_ENEMY_KIND] = "name of an enemy kind",
        [A_PLAYER_KIND] = "name of a player kind",
        [A_SPARK_KIND] = "name of a spark kind",
        [A_SPRITE] = "name of a sprite",
        [A_BUTTON] = "up down left right fire bomb focus special start select",
        [A_PAD] = "1, 2 or a player",
        [A_EASE] = "linear, in, out or both",
        [A_LAYER] = "back, middle or front",
        [A_ALIGN] = "left, center or right",
    };

    return words[p->type];
}

static void help_param(const struct api_param *p, void (*line)(const char *))
{
    char text[320], range[80] = "", def[80] = "";
    bool ranged = p->type == A_INT || p->type == A_COUNT || p->type == A_NUM || p->type == A_FX;

    if (ranged)
        snprintf(range, sizeof range, " from %.14g to %.14g%s%s", p->lo, p->hi, p->unit ? " " : "",
                 p->unit ? p->unit : "");
    if (p->def)
        snprintf(def, sizeof def, " = %s", p->def);
    else if (!p->optional)
        snprintf(def, sizeof def, " (required)");
    snprintf(text, sizeof text, "    %-10s %s%s%s", p->name, type_words(p), range, def);
    line(text);
}

static void help_signature(const struct api_entry *e, char *out, size_t size)
{
    int first = e->flags & API_METHOD ? 1 : 0;
    size_t n = (size_t)snprintf(out, size, "%s", e->name);
    bool table = e->count > e->plain || e->flags & API_FIRE;

    if (!table || e->plain > first)
        n += (size_t)snprintf(out + n, size - n, "(");
    for (int i = first; i < e->plain; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%s%s", i > first ? ", " : "", e->params[i].name,
                              e->params[i].optional ? "?" : "");
    if (e->flags & API_MORE)
        n += (size_t)snprintf(out + n, size - n, "%s...", e->plain > first ? ", " : "");
    if (table)
        n += (size_t)snprintf(out + n, size - n, "%s{...}", e->plain > first ? ", " : "");
    if (!table || e->plain > first)
        n += (size_t)snprintf(out + n, size - n, ")");
    if (e->returns)
        snprintf(out + n, size - n, " -> %s", e->returns);
}

static void help_entry(const struct api_entry *e, bool whole, void (*line)(const char *))
{
    char text[400], signature[200];

    help_signature(e, signature, sizeof signature);
    if (!whole) {
        snprintf(text, sizeof text, "%-46s %s", signature, e->help);
        line(text);
        return;
    }
    line(signature);
    snprintf(text, sizeof text, "  %s%s", e->help, e->flags & API_LOAD ? " (only while scripts load)" : "");
    line(text);
    for (int i = e->flags & API_METHOD ? 1 : 0; i < e->count; i++)
        help_param(&e->params[i], line);
    if (e->flags & API_FIRE)
        line("    ...        and every argument of bullet.fire");
}

static bool help_thing(int kind, void (*line)(const char *))
{
    const struct api_thing *t = api_things[kind];
    char text[400];

    snprintf(text, sizeof text, "properties of %s:", thing_names[kind]);
    line(text);
    if (kind != H_GROUP && kind != H_MOTION)
        line("    alive      read  is it there?");
    for (int i = 0; i < t->n; i++) {
        const struct api_prop *p = &t->props[i];
        snprintf(text, sizeof text, "    %-10s %-5s %s", p->value.name, p->write == PROP_WRITE ? "write" : "read",
                 p->help);
        line(text);
    }
    return true;
}

bool api_help(const char *name, void (*line)(const char *))
{
    size_t n = name ? strlen(name) : 0;
    bool exact = name && entry_named(name), any = false;

    for (int i = 0; i < api_count(); i++) {
        const struct api_entry *e = api_entry(i);
        if (e->flags & API_SYS || (exact && strcmp(e->name, name)) || (n && strncmp(e->name, name, n)))
            continue;
        help_entry(e, exact, line);
        any = true;
    }
    for (int k = 1; name && !exact && k < HANDLES; k++)
        if (api_things[k] && !strcmp(api_things[k]->name, name))
            any = help_thing(k, line);
    return any;
}
