/*
 * test_script_expect.c - the checks of a test script: expectations, pictures and hashes.
 *
 * A failed check is reported with its location, and the script continues, so that one run reports all failures.
 */
#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include "../../base/err.h"
#include "../../script/luakeys.h"
#include "../../script/lua/lualib.h"
#include "test_script_parts.h"

/* Reports the message on top of the stack, after the location in the script, and pops it. */
static void fail(lua_State *L)
{
    char place[VM_LOCATION_SIZE];

    vm_get_location(L, place, sizeof place);
    outcome_write(test_script_of(L)->out, LINE_FAILURE, "%s%s", place, lua_tostring(L, -1));
    lua_pop(L, 1);
}

/* Pushes "WHAT: ", or "" when the argument at idx is not given. */
static const char *push_what(lua_State *L, int idx)
{
    if (lua_isnoneornil(L, idx))
        return lua_pushliteral(L, "");
    return lua_pushfstring(L, "%s: ", lualib_tolstring(L, idx, NULL));
}

/* ---- values as text ---- */

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

/* Pushes the value as a script would write it. */
static void push_deep(lua_State *L, int idx, int depth)
{
    if (lua_type(L, idx) == LUA_TSTRING)
        push_text(L, idx);
    else if (lua_istable(L, idx) && depth < SHOWN_DEEP)
        push_table(L, idx, depth);
    else
        lualib_tolstring(L, idx, NULL);
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

/* Compares tables by their contents. */
static bool same_values(lua_State *L, int a, int b, int depth)
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
        same = same_values(L, value, value + 1, depth + 1);
        lua_settop(L, value - (same ? 1 : 2));
    }
    return same;
}

/* ---- functions ---- */

int test_script_expect(lua_State *L)
{
    luaL_checkany(L, 1);
    if (!lua_toboolean(L, 1)) {
        if (lua_isnoneornil(L, 2))
            lua_pushfstring(L, "expected a true value, got %s", lualib_tolstring(L, 1, NULL));
        else
            lua_pushfstring(L, "expected: %s", lualib_tolstring(L, 2, NULL));
        fail(L);
    }
    lua_pushboolean(L, lua_toboolean(L, 1));
    return 1;
}

int test_script_equal(lua_State *L)
{
    luaL_checkany(L, 1);
    luaL_checkany(L, 2);
    lua_settop(L, 3);
    const bool same = same_values(L, 1, 2, 0);
    if (!same) {
        const char *what = push_what(L, 3);
        push_deep(L, 2, 0);
        push_deep(L, 1, 0);
        lua_pushfstring(L, "%sexpected %s, got %s", what, lua_tostring(L, -2), lua_tostring(L, -1));
        fail(L);
    }
    lua_pushboolean(L, same);
    return 1;
}

static const char *check_name(lua_State *L, const char *what)
{
    size_t n;
    const char *name = luaL_checklstring(L, 1, &n);
    const bool good = n > 0 && n < TEST_NAME_SIZE && strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_-") == n;

    if (!good)
        vm_fault(L, FAULT_SCRIPT, "%s: name: expected 1 to %d of the characters a-z 0-9 _ -, got \"%s\"", what,
                 TEST_NAME_SIZE - 1, name);
    return name;
}

/* Notes the name of a file in tests/golden; each can be compared only once. */
static bool add_compared(struct test_script *s, const char *name, const char *ending, char *err, size_t err_size)
{
    char file[TEST_NAME_SIZE + 8];

    snprintf(file, sizeof file, "%s%s", name, ending);
    for (int i = 0; i < s->n_compared; i++)
        if (strcmp(s->compared[i], file) == 0)
            return err_set(err, err_size, "duplicate name in this test");
    if (s->n_compared == TEST_GOLDENS)
        return err_set(err, err_size, "expected at most %d names in a test", TEST_GOLDENS);
    memcpy(s->compared[s->n_compared++], file, sizeof file);
    return true;
}

static int compare(lua_State *L, const char *what, const char *ending,
                   bool (*f)(const struct golden *g, const struct board *b, const char *name, char *err,
                             size_t err_size))
{
    struct test_script *s = test_script_of(L);
    const char *name = check_name(L, what);
    const struct board *b = test_script_newest(L, 2)->b;
    char err[TEST_ERR_SIZE];
    const bool same = add_compared(s, name, ending, err, sizeof err) && f(&s->golden, b, name, err, sizeof err);

    if (!same) {
        lua_pushfstring(L, "%s: frame %d: %s", name, (int)board_frame(b), err);
        fail(L);
    }
    lua_pushboolean(L, same);
    return 1;
}

int test_script_shot(lua_State *L)
{
    return compare(L, "test.shot", ".png", golden_picture);
}

int test_script_hash(lua_State *L)
{
    return compare(L, "test.hash", ".hash", golden_hash);
}
