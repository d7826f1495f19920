/*
 * luatable.c - table.concat, insert, move, remove, sort, unpack, and pairs.
 *
 * Sorting works on an array of entries: insertion sort of short runs, then merging, so it is stable and terminates for
 * any comparator. Arrays of only integers, floats or strings are compared in C; otherwise an entry is an index into a
 * copy of the values, which Lua compares. The table is written only once the order is known.
 *
 * pairs sorts the keys when it is called. A plain list, whose keys are 1..n, needs no copy of its keys.
 */
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "luaparts.h"
#include "../api/api.h"
#include "../luakeys.h"
#include "../vm.h"

enum { MAX_STACK_ENTRIES = 48, RUN_LENGTH = 6, CHARGE_EVERY = 16384 };

/* ---- sorting ---- */

enum order { BY_INTEGER, BY_FLOAT, BY_STRING, BY_KEY, BY_LUA, BY_FUNCTION };

struct entry {
    union {
        lua_Integer i;
        lua_Number f;
        const char *s;
    } v;
    size_t n;    /* bytes of the string; NUMBER_KEY: an integer key */
    uint32_t at; /* original index, from 0 */
};

static const size_t NUMBER_KEY = SIZE_MAX;

struct sorter {
    lua_State *L;
    enum order order;
    int values_index; /* BY_LUA and BY_FUNCTION: stack index of the copy of the values */
    int function_index;
    uint64_t work;
};

static bool text_precedes(struct sorter *s, const struct entry *a, const struct entry *b)
{
    size_t n = a->n < b->n ? a->n : b->n;
    int c = memcmp(a->v.s, b->v.s, n);

    s->work += n / 16;
    return c ? c < 0 : a->n < b->n;
}

static bool lua_precedes(const struct sorter *s, const struct entry *a, const struct entry *b)
{
    bool is_before;

    if (s->order == BY_FUNCTION)
        lua_pushvalue(s->L, s->function_index);
    lua_rawgeti(s->L, s->values_index, (lua_Integer)a->at + 1);
    lua_rawgeti(s->L, s->values_index, (lua_Integer)b->at + 1);
    if (s->order == BY_FUNCTION) {
        lua_call(s->L, 2, 1);
        is_before = lua_toboolean(s->L, -1);
        lua_pop(s->L, 1);
        return is_before;
    }
    is_before = lua_compare(s->L, -2, -1, LUA_OPLT);
    lua_pop(s->L, 2);
    return is_before;
}

/* Charges the work so far, except when sorting keys: the number of comparisons then depends on Lua's hash order, so
 * push_sorted_keys charges an upper bound in advance. */
static void charge(struct sorter *s)
{
    if (s->order != BY_KEY)
        vm_charge(s->L, s->work);
    s->work = 0;
}

static bool precedes(struct sorter *s, const struct entry *a, const struct entry *b)
{
    if (++s->work >= CHARGE_EVERY)
        charge(s);
    switch (s->order) {
    case BY_INTEGER:
        return a->v.i < b->v.i;
    case BY_FLOAT:
        return a->v.f < b->v.f;
    case BY_KEY:
        if (a->n == NUMBER_KEY || b->n == NUMBER_KEY)
            return a->n == b->n ? a->v.i < b->v.i : a->n == NUMBER_KEY;
        return text_precedes(s, a, b);
    case BY_STRING:
        return text_precedes(s, a, b);
    default:
        return lua_precedes(s, a, b);
    }
}

static void sort_run(struct sorter *s, struct entry *e, size_t n)
{
    for (size_t i = 1; i < n; i++) {
        struct entry moving = e[i];
        size_t to = i;
        for (; to > 0 && precedes(s, &moving, &e[to - 1]); to--)
            e[to] = e[to - 1];
        e[to] = moving;
    }
}

/* Merges the sorted halves [0, half) and [half, n) of `from` into `to`. */
static void merge(struct sorter *s, struct entry *to, const struct entry *from, size_t half, size_t n)
{
    size_t a = 0, b = half;

    if (half >= n || !precedes(s, &from[half], &from[half - 1])) {
        memcpy(to, from, n * sizeof *to);
        return;
    }
    while (a < half && b < n)
        *to++ = precedes(s, &from[b], &from[a]) ? from[b++] : from[a++];
    memcpy(to, from + a, (half - a) * sizeof *to);
    memcpy(to + (half - a), from + b, (n - b) * sizeof *to);
}

/* Sorts e[0, n), using the n entries after it as scratch. Returns the start of the result: e or e + n. */
static struct entry *sort(struct sorter *s, struct entry *e, size_t n)
{
    struct entry *from = e, *to = e + n, *swap;

    for (size_t i = 0; i < n; i += RUN_LENGTH)
        sort_run(s, from + i, n - i < RUN_LENGTH ? n - i : RUN_LENGTH);
    for (size_t width = RUN_LENGTH; width < n; width *= 2) {
        for (size_t i = 0; i < n; i += 2 * width) {
            size_t count = n - i < 2 * width ? n - i : 2 * width;
            merge(s, to + i, from + i, width < count ? width : count, count);
        }
        swap = from, from = to, to = swap;
    }
    s->work += n;
    charge(s);
    return from;
}

/* Returns space for n entries and n of scratch: `stack_entries`, or a userdata that it pushes. */
static struct entry *reserve_entries(lua_State *L, struct entry *stack_entries, size_t n)
{
    return n <= MAX_STACK_ENTRIES ? stack_entries : lua_newuserdatauv(L, 2 * n * sizeof *stack_entries, 0);
}

/* Returns the order in which C can compare all of t[1..n], or BY_LUA if there is none. */
static enum order order_of(lua_State *L, lua_Integer n)
{
    enum order order = BY_LUA, o;

    for (lua_Integer i = 1; i <= n; i++) {
        int type = lua_rawgeti(L, 1, i);
        o = type == LUA_TSTRING    ? BY_STRING
            : type != LUA_TNUMBER  ? BY_LUA
            : lua_isinteger(L, -1) ? BY_INTEGER
                                   : BY_FLOAT;
        lua_pop(L, 1);
        if (o == BY_LUA || (i > 1 && o != order))
            return BY_LUA;
        order = o;
    }
    return order;
}

/* Returns the entry of the value on top, which is element i, counted from 0. */
static struct entry entry_of(lua_State *L, enum order order, uint32_t i)
{
    struct entry e = { .at = i };

    if (order == BY_INTEGER)
        e.v.i = lua_tointeger(L, -1);
    else if (order == BY_FLOAT)
        e.v.f = lua_tonumber(L, -1);
    else if (order == BY_STRING)
        e.v.s = lua_tolstring(L, -1, &e.n);
    return e;
}

static void sort_table(lua_State *L, lua_Integer n, bool has_function)
{
    struct entry stack_entries[2 * MAX_STACK_ENTRIES], *e = reserve_entries(L, stack_entries, (size_t)n);
    bool is_plain = !has_function && !lua_getmetatable(L, 1);
    struct sorter s = { .L = L,
                        .order = has_function ? BY_FUNCTION
                                 : is_plain   ? order_of(L, n)
                                              : BY_LUA,
                        .function_index = 2 };

    lua_createtable(L, (int)n, 0);
    s.values_index = lua_gettop(L);
    for (lua_Integer i = 0; i < n; i++) {
        lua_geti(L, 1, i + 1);
        e[i] = entry_of(L, s.order, (uint32_t)i);
        lua_rawseti(L, s.values_index, i + 1);
    }
    e = sort(&s, e, (size_t)n);
    for (lua_Integer i = 0; i < n; i++)
        if (e[i].at != i) {
            lua_rawgeti(L, s.values_index, (lua_Integer)e[i].at + 1);
            lua_seti(L, 1, i + 1);
        }
}

static int table_sort(lua_State *L)
{
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_Integer n = luaL_len(L, 1);
    bool has_function = !lua_isnoneornil(L, 2);

    if (n < 2)
        return 0;
    luaL_argcheck(L, n < INT_MAX, 1, "array too big");
    if (has_function)
        luaL_checktype(L, 2, LUA_TFUNCTION);
    lua_settop(L, 2);
    vm_charge(L, (uint64_t)n * 4);
    sort_table(L, n, has_function);
    return 0;
}

/* ---- the other functions of table ---- */

static lua_Integer checked_length(lua_State *L)
{
    luaL_checktype(L, 1, LUA_TTABLE);
    return luaL_len(L, 1);
}

static int table_insert(lua_State *L)
{
    lua_Integer end = (lua_Integer)((lua_Unsigned)checked_length(L) + 1), at = end;

    switch (lua_gettop(L)) {
    case 2:
        break;
    case 3:
        at = luaL_checkinteger(L, 2);
        luaL_argcheck(L, (lua_Unsigned)at - 1u < (lua_Unsigned)end, 2, "position out of bounds");
        break;
    default:
        return luaL_error(L, "wrong number of arguments to 'insert'");
    }
    if (end > at)
        vm_charge(L, (lua_Unsigned)end - (lua_Unsigned)at);
    for (lua_Integer i = end; i > at; i--) {
        lua_geti(L, 1, i - 1);
        lua_seti(L, 1, i);
    }
    lua_seti(L, 1, at);
    return 0;
}

static int table_remove(lua_State *L)
{
    lua_Integer size = checked_length(L), at = luaL_optinteger(L, 2, size);

    if (at != size)
        luaL_argcheck(L, (lua_Unsigned)at - 1u <= (lua_Unsigned)size, 2, "position out of bounds");
    if (size > at)
        vm_charge(L, (lua_Unsigned)size - (lua_Unsigned)at);
    lua_geti(L, 1, at);
    for (; at < size; at++) {
        lua_geti(L, 1, at + 1);
        lua_seti(L, 1, at);
    }
    lua_pushnil(L);
    lua_seti(L, 1, at);
    return 1;
}

static int table_move(lua_State *L)
{
    lua_Integer from = luaL_checkinteger(L, 2), last = luaL_checkinteger(L, 3), to = luaL_checkinteger(L, 4);
    int dest_index = lua_isnoneornil(L, 5) ? 1 : 5;

    if (dest_index == 1 || lua_type(L, 1) != LUA_TSTRING) /* a string can be read through its __index */
        luaL_checktype(L, 1, LUA_TTABLE);
    luaL_checktype(L, dest_index, LUA_TTABLE);
    if (last >= from) {
        luaL_argcheck(L, from > 0 || last < LUA_MAXINTEGER + from, 3, "too many elements to move");
        lua_Integer n = last - from + 1;
        luaL_argcheck(L, to <= LUA_MAXINTEGER - n + 1, 4, "destination wrap around");
        vm_charge(L, (uint64_t)n);
        bool upwards = to > last || to <= from || (dest_index != 1 && !lua_compare(L, 1, dest_index, LUA_OPEQ));
        for (lua_Integer k = 0; k < n; k++) {
            lua_Integer i = upwards ? k : n - 1 - k;
            lua_geti(L, 1, from + i);
            lua_seti(L, dest_index, to + i);
        }
    }
    lua_pushvalue(L, dest_index);
    return 1;
}

static size_t add_field(lua_State *L, luaL_Buffer *out, lua_Integer i)
{
    int type = lua_geti(L, 1, i);
    size_t n;

    if (type == LUA_TNUMBER && !lua_isinteger(L, -1)) {
        luatext_push_number(L, -1);
        lua_remove(L, -2);
    } else if (type != LUA_TNUMBER && type != LUA_TSTRING) {
        luaL_error(L, "invalid value (%s) at index %I in table for 'concat'", luaL_typename(L, -1), (LUAI_UACINT)i);
    }
    lua_tolstring(L, -1, &n);
    luaL_addvalue(out);
    return n;
}

enum { FIELD_WORK = 25 /* work of a float field, charged for every field */ };

static int table_concat(lua_State *L)
{
    lua_Integer size = checked_length(L);
    size_t sep_n;
    const char *sep = luaL_optlstring(L, 2, "", &sep_n);
    lua_Integer i = luaL_optinteger(L, 3, 1), last = luaL_optinteger(L, 4, size);
    uint64_t work = 0;
    luaL_Buffer out;

    luaL_buffinit(L, &out);
    for (; i <= last; i++) {
        work += FIELD_WORK + (add_field(L, &out, i) + sep_n) / 8;
        if (work >= CHARGE_EVERY) {
            vm_charge(L, work);
            work = 0;
        }
        if (i == last)
            break;
        luaL_addlstring(&out, sep, sep_n);
    }
    vm_charge(L, work);
    luaL_pushresult(&out);
    return 1;
}

static int table_unpack(lua_State *L)
{
    lua_Integer i = luaL_optinteger(L, 2, 1);
    lua_Integer last = lua_isnoneornil(L, 3) ? luaL_len(L, 1) : luaL_checkinteger(L, 3);

    if (i > last)
        return 0;
    lua_Unsigned n = (lua_Unsigned)last - (lua_Unsigned)i;
    if (n >= INT_MAX || !lua_checkstack(L, (int)n + 1))
        return luaL_error(L, "too many results to unpack");
    vm_charge(L, n);
    for (lua_Unsigned k = 0; k <= n; k++)
        lua_geti(L, 1, (lua_Integer)((lua_Unsigned)i + k));
    return (int)n + 1;
}

void luatable_open(lua_State *L)
{
    static const luaL_Reg functions[] = {
        { "concat", table_concat }, { "insert", table_insert }, { "move", table_move }, { "remove", table_remove },
        { "sort", table_sort },     { "unpack", table_unpack }, { NULL, NULL }
    };

    luaL_setfuncs(L, functions, 0);
}

/* ---- pairs ---- */

/* The result of a walk over the keys. */
struct key_scan {
    size_t n, bytes;   /* n: number of keys; bytes: length of all string keys */
    bool has_strings;  /* whether there is a string key */
    bool is_ascending; /* whether the integer keys were visited in ascending order */
    lua_Integer first, last;
    const char *unordered_type; /* alphabetically first type among the keys that have no order; NULL: none */
};

static void record_key(lua_State *L, struct key_scan *k, struct entry *e)
{
    int type = lua_type(L, -1);

    e->at = 0;
    if (type == LUA_TSTRING) {
        k->has_strings = true;
        e->v.s = lua_tolstring(L, -1, &e->n);
        k->bytes += e->n;
    } else if (lua_isinteger(L, -1)) {
        e->v.i = lua_tointeger(L, -1);
        e->n = NUMBER_KEY;
        k->is_ascending = k->is_ascending && (k->n == 0 || e->v.i > k->last);
        if (k->n == 0 || e->v.i < k->first)
            k->first = e->v.i;
        if (k->n == 0 || e->v.i > k->last)
            k->last = e->v.i;
    } else {
        const char *kind = type == LUA_TNUMBER ? "float" : lua_typename(L, type);
        if (!k->unordered_type || strcmp(kind, k->unordered_type) < 0)
            k->unordered_type = kind;
    }
    k->n++;
}

/* Walks the keys of the table at stack index 1 and stores the entries of the first `capacity` keys in e. */
static struct key_scan scan_keys(lua_State *L, struct entry *e, size_t capacity)
{
    struct key_scan k = { .is_ascending = true };
    struct entry unused;

    lua_pushnil(L);
    while (lua_next(L, 1)) {
        lua_pop(L, 1);
        record_key(L, &k, k.n < capacity ? &e[k.n] : &unused);
    }
    return k;
}

/* The iterator over t[1..n]. Upvalue: n. */
static int next_item(lua_State *L)
{
    lua_Integer i = lua_tointeger(L, 2), n = lua_tointeger(L, lua_upvalueindex(1));

    luaL_checktype(L, 1, LUA_TTABLE);
    for (i = i < 0 ? n : i; i < n;) {
        lua_pushinteger(L, ++i);
        if (lua_rawgeti(L, 1, i) != LUA_TNIL)
            return 2;
        lua_pop(L, 2);
    }
    return lua_pushnil(L), 1;
}

/* The iterator over a list of keys. Upvalues: the list, the number of keys visited. */
static int next_key(lua_State *L)
{
    lua_Integer i = lua_tointeger(L, lua_upvalueindex(2));

    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    while (lua_rawgeti(L, lua_upvalueindex(1), ++i) != LUA_TNIL) {
        lua_pushvalue(L, 2);
        if (lua_rawget(L, 1) != LUA_TNIL) {
            lua_pushinteger(L, i);
            lua_replace(L, lua_upvalueindex(2));
            return 2;
        }
        lua_settop(L, 1);
    }
    return 1;
}

static int next_nothing(lua_State *L)
{
    return lua_pushnil(L), 1;
}

/* Returns an upper bound on the work of sorting the keys: three comparisons per key for the short runs, and one per key
 * for each pass of merges. */
static uint64_t sort_work(const struct key_scan *k)
{
    uint64_t comparisons = 3;

    for (size_t width = RUN_LENGTH; width < k->n; width *= 2)
        comparisons++;
    return comparisons * (k->n + k->bytes / 16);
}

static void push_sorted_keys(lua_State *L, struct key_scan k, struct entry *e)
{
    struct sorter s = { .L = L, .order = BY_KEY };

    luaL_argcheck(L, k.n < INT_MAX / 2, 1, "table too big");
    if (k.has_strings || !k.is_ascending) {
        vm_charge(L, sort_work(&k));
        e = sort(&s, e, k.n);
    }
    lua_createtable(L, (int)k.n, 0);
    for (size_t i = 0; i < k.n; i++) {
        if (e[i].n == NUMBER_KEY)
            lua_pushinteger(L, e[i].v.i);
        else
            lua_pushlstring(L, e[i].v.s, e[i].n);
        lua_rawseti(L, -2, (lua_Integer)i + 1);
    }
}

static void push_iterator(lua_State *L)
{
    struct entry stack_entries[2 * MAX_STACK_ENTRIES], *e;
    struct key_scan k = scan_keys(L, stack_entries, MAX_STACK_ENTRIES);

    vm_charge(L, 8 + k.n * 3);
    if (k.unordered_type)
        luaL_error(L, "pairs: keys of type %s have no fixed order", k.unordered_type);
    if (k.n == 0) {
        lua_pushcfunction(L, next_nothing);
    } else if (!k.has_strings && k.first == 1 && (lua_Unsigned)k.last == k.n) {
        lua_pushinteger(L, k.last);
        lua_pushcclosure(L, next_item, 1);
    } else {
        e = reserve_entries(L, stack_entries, k.n);
        if (e != stack_entries)
            scan_keys(L, e, k.n);
        push_sorted_keys(L, k, e);
        lua_pushinteger(L, 0);
        lua_pushcclosure(L, next_key, 2);
    }
}

int luatable_pairs(lua_State *L)
{
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL)
        return luaL_error(L, "pairs: __pairs is not supported");
    if (lua_getmetatable(L, 1))
        api_fill_table(L, 1);
    lua_settop(L, 1);
    push_iterator(L);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return luakeys_return(L, 3);
}
