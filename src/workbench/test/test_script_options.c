/*
 * test_script_options.c - reads the argument of test.run.
 */
#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include "../../script/api/api_parts.h"
#include "test_script_parts.h"

enum { SETTINGS = ARGS_MAX_DIPS }; /* as many as ARGS_MAX_REGISTERS */

static void fail_type(lua_State *L, const char *field, const char *expected)
{
    vm_fault(L, FAULT_SCRIPT, "test.run: %s: expected %s, got %s", field, expected, luaL_typename(L, -1));
}

/* Returns the text on top, which is the value of the field. */
static const char *get_string(lua_State *L, const char *field)
{
    if (lua_type(L, -1) != LUA_TSTRING)
        fail_type(L, field, "a string");
    return lua_tostring(L, -1);
}

static lua_Integer get_integer(lua_State *L, const char *field, lua_Integer low, lua_Integer high)
{
    char expected[80];
    int is;
    const lua_Integer n = lua_tointegerx(L, -1, &is);

    if (is && lua_type(L, -1) == LUA_TNUMBER && n >= low && n <= high)
        return n;
    snprintf(expected, sizeof expected, "a whole number from %lld to %lld", (long long)low, (long long)high);
    if (lua_type(L, -1) == LUA_TNUMBER)
        vm_fault(L, FAULT_SCRIPT, "test.run: %s: expected %s, got %s", field, expected, lua_tostring(L, -1));
    fail_type(L, field, expected);
    return 0;
}

static bool get_boolean(lua_State *L, const char *field)
{
    if (!lua_isboolean(L, -1))
        fail_type(L, field, "true or false");
    return lua_toboolean(L, -1);
}

/* Converts the table on top, { coins = "free", ships = 3 }, to "coins=free", "ships=3". These texts remain on the stack
 * below the table. */
static int settings(lua_State *L, const char *field, const char *list[SETTINGS])
{
    static const char expected[] = "{ NAME = string or number }";
    const int table = lua_gettop(L);

    if (!lua_istable(L, table))
        fail_type(L, field, "a table { NAME = value }");
    luaL_checkstack(L, SETTINGS + 8, NULL);
    const int n = api_read_sorted_keys(L, "test.run", field, expected, table, list, SETTINGS);
    for (int i = 0; i < n; i++) {
        const int type = lua_getfield(L, table, list[i]);
        if (type != LUA_TSTRING && type != LUA_TNUMBER)
            vm_fault(L, FAULT_SCRIPT, "test.run: %s.%s: expected a string or a number, got %s", field, list[i],
                     api_push_description(L, -1));
        lua_pushfstring(L, "%s=%s", list[i], lua_tostring(L, -1));
        list[i] = lua_tostring(L, -1);
        lua_remove(L, -2);
    }
    lua_pushvalue(L, table);
    lua_remove(L, table);
    return n;
}

/* ---- fields ---- */

static void read_stage(lua_State *L, struct test_options *o)
{
    o->start.stage = get_string(L, "stage");
}

static void read_seed(lua_State *L, struct test_options *o)
{
    o->start.seed = (uint64_t)get_integer(L, "seed", LUA_MININTEGER, LUA_MAXINTEGER);
    o->start.seeded = true;
}

static void read_difficulty(lua_State *L, struct test_options *o)
{
    o->start.difficulty = get_string(L, "difficulty");
}

static void read_frames(lua_State *L, struct test_options *o)
{
    o->frames = (uint32_t)get_integer(L, "frames", 0, TEST_FRAMES);
    o->has_frames = true;
}

static void read_pads(lua_State *L, struct test_options *o)
{
    o->pads_is_function = lua_isfunction(L, -1);
    if (!o->pads_is_function && lua_type(L, -1) != LUA_TSTRING)
        fail_type(L, "pads", "buttons such as \"fire,left@60:90\" or a function");
    o->pads = o->pads_is_function ? NULL : lua_tostring(L, -1);
}

static void read_demo(lua_State *L, struct test_options *o)
{
    o->demo = get_string(L, "demo");
}

static void read_lang(lua_State *L, struct test_options *o)
{
    o->start.lang = get_string(L, "lang");
}

static void read_lives(lua_State *L, struct test_options *o)
{
    o->start.lives = (int)get_integer(L, "lives", 1, PRACTICE_MAX_LIVES);
}

static void read_invincible(lua_State *L, struct test_options *o)
{
    o->start.invincible = get_boolean(L, "invincible");
}

static void read_dips(lua_State *L, struct test_options *o)
{
    o->start.n_dips = settings(L, "dips", o->start.dips);
}

static void read_registers(lua_State *L, struct test_options *o)
{
    o->start.n_registers = settings(L, "registers", o->start.registers);
}

static void read_faults(lua_State *L, struct test_options *o)
{
    o->faults = get_boolean(L, "faults");
}

static const struct {
    const char *name;
    void (*read)(lua_State *L, struct test_options *o);
} fields[] = {
    { "stage", read_stage },   { "seed", read_seed },           { "difficulty", read_difficulty },
    { "frames", read_frames }, { "pads", read_pads },           { "demo", read_demo },
    { "lang", read_lang },     { "lives", read_lives },         { "invincible", read_invincible },
    { "dips", read_dips },     { "registers", read_registers }, { "faults", read_faults },
};
enum { FIELDS = sizeof fields / sizeof *fields };

static void unknown(lua_State *L, const char *name)
{
    struct api_hint hint;

    api_hint_begin(&hint, name);
    for (int i = 0; i < FIELDS; i++)
        api_hint_add(&hint, fields[i].name);
    vm_fault(L, FAULT_SCRIPT, "test.run: unknown field \"%s\"%s", name, api_hint_push(L, &hint, "fields"));
}

static bool knows_option(lua_State *L, const char *key, const void *of)
{
    (void)L, (void)of;
    for (int i = 0; key && i < FIELDS; i++)
        if (!strcmp(fields[i].name, key))
            return true;
    return false;
}

static void check_names(lua_State *L)
{
    if (!luakeys_push_unknown(L, 1, knows_option, NULL))
        return;
    if (!luakeys_text(L, -1))
        vm_fault(L, FAULT_SCRIPT, "test.run: expected a table such as { stage = \"one\", frames = 600 }");
    unknown(L, luakeys_text(L, -1));
}

/* A demo has its own start and buttons; practice needs a stage. */
static void check_pairs(lua_State *L, const struct test_options *o)
{
    const struct args *s = &o->start;
    const bool practice = s->lives || s->invincible || s->n_registers;
    const bool own = s->stage || s->difficulty || s->lang || s->seeded || practice || s->n_dips;

    if (o->demo && (own || o->pads || o->pads_is_function))
        vm_fault(L, FAULT_SCRIPT,
                 "test.run: a demo has its own start settings and buttons; combine demo only with frames and faults");
    if (!s->stage && practice)
        vm_fault(L, FAULT_SCRIPT, "test.run: lives, invincible and registers require stage");
}

void test_options_read(lua_State *L, struct test_options *o)
{
    *o = (struct test_options){ 0 };
    if (lua_isnil(L, 1)) {
        lua_newtable(L);
        lua_replace(L, 1);
    }
    if (!lua_istable(L, 1))
        vm_fault(L, FAULT_SCRIPT, "test.run: expected a table such as { stage = \"one\", frames = 600 }, got %s",
                 luaL_typename(L, 1));
    check_names(L);
    for (int i = 0; i < FIELDS; i++) {
        if (lua_getfield(L, 1, fields[i].name) != LUA_TNIL)
            fields[i].read(L, o);
        lua_pop(L, 1);
    }
    check_pairs(L, o);
}
