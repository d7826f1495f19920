/*
 * test_luanames.c - a function whose locals lost their names is the same function: the same code, constants, lines and
 * upvalues, of every module of the standard library and of Lua that has all sorts of constants in it.
 */
#include "../test.h"
#include <dirent.h>
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
#include "../../platform/platform.h"
#include "../../src/script/lua/lualib.h"

static const char SORTS[] =
    "local first, second = ...\n"
    "local long <const> = 'a text of more than forty characters, which Lua keeps in another way'\n"
    "local function inner(x, ...)\n"
    "  for i = 1, 300 do local y = i * 1.5 + 0x7fffffffffffffff first = first + y end\n"
    "  return function() return x, first, long, nil, true, false, -0.0, '' end, ...\n"
    "end\n"
    "goto done\n"
    "::done::\n"
    "return inner(second, 'b', nil)\n";

static lua_State *L;

static int setup(void **state)
{
    (void)state;
    L = luaL_newstate();
    luaL_openlibs(L);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    lua_close(L);
    return 0;
}

static void load(const char *text, size_t n)
{
    assert_int_equal(luaL_loadbufferx(L, text, n, "@here.lua", "t"), LUA_OK);
}

/* The dump of the function on top stands in its place. */
static const char *dumped(int strip, size_t *n)
{
    const int f = lua_gettop(L);

    lua_getglobal(L, "string");
    lua_getfield(L, -1, "dump");
    lua_pushvalue(L, f);
    lua_pushboolean(L, strip);
    lua_call(L, 2, 1);
    lua_replace(L, f);
    lua_settop(L, f);
    return lua_tolstring(L, f, n);
}

/* Bare dumps have neither lines nor names: they are equal. The whole one is shorter by the names. */
static void assert_same(const char *text, size_t size)
{
    size_t n[4];
    const char *dump[4];

    for (int i = 0; i < 4; i++) {
        load(text, size);
        if (i & 1)
            lualib_strip_locals(L, "@here.lua");
        dump[i] = dumped(i < 2, &n[i]);
    }
    assert_int_equal(n[0], n[1]);
    assert_memory_equal(dump[0], dump[1], n[0]);
    assert_true(n[3] < n[2]);
    lua_settop(L, 0);
}

TEST(modules_stay_the_same)
{
    static char text[1 << 16];
    DIR *d = opendir("scripts");
    int modules = 0;

    assert_same(SORTS, sizeof SORTS - 1);
    assert_non_null(d);
    for (struct dirent *e; (e = readdir(d));) {
        char path[512];
        if (!strstr(e->d_name, ".lua"))
            continue;
        snprintf(path, sizeof path, "scripts/%s", e->d_name);
        const long n = plat_load(path, text, sizeof text);
        assert_in_range(n, 1, sizeof text - 1);
        assert_same(text, (size_t)n);
        modules++;
    }
    closedir(d);
    assert_true(modules > 8);
}

/* Lines, globals and upvalues are told as before; a local has no name. */
TEST(faults_have_their_place)
{
    static const struct {
        const char *text, *before, *after;
    } of[] = {
        { "local a\n\nreturn a.x", "here.lua:3: attempt to index a nil value (local 'a')",
          "here.lua:3: attempt to index a nil value" },
        { "local a\nreturn (function()\nreturn a.x end)()", "here.lua:3: attempt to index a nil value (upvalue 'a')",
          "here.lua:3: attempt to index a nil value (upvalue 'a')" },
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        for (int dropped = 0; dropped < 2; dropped++) {
            load(of[i].text, strlen(of[i].text));
            if (dropped)
                lualib_strip_locals(L, "@here.lua");
            assert_int_equal(lua_pcall(L, 0, 0, 0), LUA_ERRRUN);
            assert_string_equal(lua_tostring(L, -1), dropped ? of[i].after : of[i].before);
            lua_settop(L, 0);
        }
}

RUN_TESTS_EACH(setup, teardown)
