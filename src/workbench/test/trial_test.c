/*
 * trial_test.c - what a test script says: expectations, pictures, hashes.
 *
 * What does not hold is told with its place, and the script goes on: so one run of it tells all.
 */
#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include "../../script/luakeys.h"
#include "../../script/lua/lualib.h"
#include "trial_parts.h"

/* Tells the sentence on top of the stack, the place of the script's line before it. */
static void fails(lua_State *L)
{
    const struct trial_host *host = trial_of(L)->host;
    char place[VM_LOCATION_SIZE];

    vm_get_location(L, place, sizeof place);
    lua_pushfstring(L, "%s%s", place, lua_tostring(L, -1));
    host->fails(host->context, lua_tostring(L, -1));
    lua_pop(L, 2);
}

/* Pushes ": WHAT", or "" when the argument at idx is not given. */
static const char *push_what(lua_State *L, int idx)
{
    if (lua_isnoneornil(L, idx))
        return lua_pushliteral(L, "");
    return lua_pushfstring(L, "%s: ", lualib_tolstring(L, idx, NULL));
}

/* ---- values as words ---- */

enum { SHOWN_DEEP = 3, SHOWN_ENTRIES = 12, SHOWN_TEXT = 120 };

static void push_text(lua_State *L, int idx)
{
    size_t n;
    const char *text = lua_tolstring(L, idx, &n);

    if (n <= SHOWN_TEXT) {
        lua_pushfstring(L, "\"%s\"", text);
        return;
    }
    lua_pushlstring(L, text, SHOWN_TEXT);
    lua_pushfstring(L, "\"%s...\"", lua_tostring(L, -1));
    lua_remove(L, -2);
}

static void push_deep(lua_State *L, int idx, int depth);

static void push_table(lua_State *L, int idx, int depth)
{
    lua_Integer n = 0;

    luaL_checkstack(L, 12, NULL);
    lua_pushliteral(L, "{");
    const int text = lua_gettop(L);
    lua_pushnil(L);
    for (int like; (like = luakeys_next(L, idx)) > 0;) {
        if (n++ == SHOWN_ENTRIES) {
            lua_pop(L, 1);
            lua_pushfstring(L, "%s, ...", lua_tostring(L, text));
            lua_replace(L, text);
            break;
        }
        luakeys_push_value(L, idx, like);
        const bool listed = lua_isinteger(L, -2) && lua_tointeger(L, -2) == n;
        push_deep(L, lua_gettop(L), depth + 1);
        lualib_tolstring(L, text + 1, NULL);
        lua_pushfstring(L, "%s%s%s%s%s", lua_tostring(L, text), n > 1 ? ", " : " ", listed ? "" : lua_tostring(L, -1),
                        listed ? "" : " = ", lua_tostring(L, -2));
        lua_replace(L, text);
        lua_settop(L, text + 1); /* the key */
    }
    lua_settop(L, text);
    lua_pushfstring(L, n ? "%s }" : "{}", lua_tostring(L, text));
    lua_replace(L, text);
}

static void push_deep(lua_State *L, int idx, int depth)
{
    if (lua_type(L, idx) == LUA_TSTRING)
        push_text(L, idx);
    else if (lua_istable(L, idx) && depth < SHOWN_DEEP)
        push_table(L, idx, depth);
    else
        lualib_tolstring(L, idx, NULL);
}

void trial_push_words(lua_State *L, int idx)
{
    push_deep(L, lua_absindex(L, idx), 0);
}

/* ---- equality ---- */

static int entries(lua_State *L, int idx)
{
    int n = 0;

    lua_pushnil(L);
    for (; lua_next(L, idx); n++)
        lua_pop(L, 1);
    return n;
}

bool trial_same(lua_State *L, int a, int b, int depth)
{
    bool same = true;

    if (!lua_istable(L, a) || !lua_istable(L, b) || depth > VALUES_MAX_DEPTH)
        return lua_compare(L, a, b, LUA_OPEQ);
    luaL_checkstack(L, 8, NULL);
    if (entries(L, a) != entries(L, b))
        return false;
    lua_pushnil(L);
    while (same && lua_next(L, a)) {
        const int value = lua_gettop(L);
        vm_charge(L, WORK_CALL);
        lua_pushvalue(L, value - 1);
        lua_rawget(L, b);
        same = trial_same(L, value, value + 1, depth + 1);
        lua_settop(L, value - (same ? 1 : 2));
    }
    return same;
}

/* ---- what scripts call ---- */

int trial_test_expect(lua_State *L)
{
    luaL_checkany(L, 1);
    if (!lua_toboolean(L, 1)) {
        if (lua_isnoneornil(L, 2))
            lua_pushfstring(L, "expected a true value, got %s", lualib_tolstring(L, 1, NULL));
        else
            lua_pushfstring(L, "expected: %s", lualib_tolstring(L, 2, NULL));
        fails(L);
    }
    lua_pushboolean(L, lua_toboolean(L, 1));
    return 1;
}

int trial_test_equal(lua_State *L)
{
    luaL_checkany(L, 1);
    luaL_checkany(L, 2);
    lua_settop(L, 3);
    const bool same = trial_same(L, 1, 2, 0);
    if (!same) {
        const char *what = push_what(L, 3);
        trial_push_words(L, 2);
        trial_push_words(L, 1);
        lua_pushfstring(L, "%sexpected %s, got %s", what, lua_tostring(L, -2), lua_tostring(L, -1));
        fails(L);
    }
    lua_pushboolean(L, same);
    return 1;
}

static const char *check_name(lua_State *L, const char *what)
{
    size_t n;
    const char *name = luaL_checklstring(L, 1, &n);
    const bool good = n > 0 && n < TRIAL_NAME && strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_-") == n;

    if (!good)
        vm_fault(L, FAULT_SCRIPT, "%s: name: expected 1 to %d of the characters a-z 0-9 _ -, got \"%s\"", what,
                 TRIAL_NAME - 1, name);
    return name;
}

static int compare(lua_State *L, const char *what,
                   bool (*f)(void *context, int run, const char *name, char *err, size_t err_size))
{
    const char *name = check_name(L, what);
    const int run = trial_newest(L, 2);
    char err[TRIAL_ERR];
    const bool same = f(trial_of(L)->host->context, run, name, err, sizeof err);

    if (!same) {
        lua_pushfstring(L, "%s: frame %d: %s", name, (int)board_frame(trial_of(L)->run[run].b), err);
        fails(L);
    }
    lua_pushboolean(L, same);
    return 1;
}

int trial_test_shot(lua_State *L)
{
    return compare(L, "test.shot", trial_of(L)->host->shot);
}

int trial_test_hash(lua_State *L)
{
    return compare(L, "test.hash", trial_of(L)->host->hash);
}
