/*
 * test_script.c - see test_script.h.
 *
 * The Lua machine is that of games (vm.h), in a board whose chips are never powered on. Test scripts therefore have the
 * same sandbox and end in the same faults. Nothing here is hashed, so the garbage collector may run at any time.
 */
#include "test_script.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../base/host.h"
#include "../../common/clock.h"
#include "../../common/files.h"
#include "../../common/tree.h"
#include "../../script/api/api.h"
#include "../../script/lua/lualib.h"
#include "test_script_parts.h"

static const char modules_key = 0;

/* ---- globals ---- */

static int undeclared(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);

    return vm_fault(L, FAULT_SCRIPT,
                    "undeclared global \"%s\" (tests can use only Lua's library and `test`; read the game's globals "
                    "with run:eval \"%s\")",
                    name, name);
}

static int no_new_global(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);

    return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (scripts cannot create globals; write \"local %s\")",
                    name, name);
}

static int print(lua_State *L)
{
    const int n = lua_gettop(L);
    luaL_Buffer line;

    luaL_checkstack(L, n + 8, NULL);
    luaL_buffinit(L, &line);
    for (int i = 1; i <= n; i++) {
        if (i > 1)
            luaL_addchar(&line, '\t');
        lualib_tolstring(L, i, NULL);
        luaL_addvalue(&line);
    }
    luaL_pushresult(&line);
    outcome_write(test_script_of(L)->out, LINE_PRINTED, "%s", lua_tostring(L, -1));
    return 0;
}

/* ---- scripts ---- */

static uint8_t *read_script(const struct testing *t, const char *name, size_t *n, char *err, size_t err_size)
{
    char path[FILES_PATH_SIZE];
    uint8_t *text;

    if (snprintf(path, sizeof path, "%s/%s", t->dir, name) >= (int)sizeof path) {
        err_set(err, err_size, "%s: path too long", name);
        return NULL;
    }
    return files_read_text(path, name, TREE_SCRIPT, &text, n, err, err_size) ? text : NULL;
}

/* Returns the text of tests/NAME.lua, or NULL. */
static const char *read_required(struct test_script *s, const char *name, size_t *n)
{
    char path[FILES_PATH_SIZE], err[FILES_ERR_SIZE];

    if (!manifest_path_ok(name) || s->n_required == TEST_SCRIPTS)
        return NULL;
    snprintf(path, sizeof path, "tests/%s.lua", name);
    uint8_t *text = read_script(s->testing, path, n, err, sizeof err);
    s->required[s->n_required++] = text;
    return (const char *)text;
}

/* require "helpers/bot" runs tests/helpers/bot.lua once. */
static int require(lua_State *L)
{
    struct test_script *s = test_script_of(L);
    const char *name = luaL_checkstring(L, 1);
    char path[160];
    size_t n;

    lua_settop(L, 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
    if (lua_getfield(L, 2, name) != LUA_TNIL)
        return lua_islightuserdata(L, -1) ? vm_fault(L, FAULT_SCRIPT, "require: \"%s\" requires itself", name) : 1;
    const char *text = read_required(s, name, &n);
    if (!text)
        return vm_fault(L, FAULT_SCRIPT, "require: no script tests/%s.lua", name);
    lua_pushlightuserdata(L, s);
    lua_setfield(L, 2, name);
    snprintf(path, sizeof path, "tests/%s", name);
    vm_load_text(L, path, text, n);
    return vm_finish_require(L, name, 0);
}

static int run_chunk(lua_State *L)
{
    struct test_script *s = test_script_of(L);

    lualib_open(L);
    lua_register(L, "require", require);
    lua_register(L, "print", print);
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
    test_script_open_runs(L);
    lua_newtable(L);
    test_script_set_functions(L, "test.");
    lua_setglobal(L, "test");
    lua_pushglobaltable(L);
    lua_pushcfunction(L, undeclared);
    lua_pushcfunction(L, no_new_global);
    lualib_seal(L);
    lua_pop(L, 1);
    vm_load_text(L, s->chunk, (const char *)s->text, s->text_size);
    lua_call(L, 0, 0);
    return 0;
}

/* ---- a test ---- */

/* Replaces the limits in the VM's messages, which are those of a game's frame. */
static void reword(struct board_fault *f, const struct output *o)
{
    char *loop = strstr(f->message, "infinite loop: ");
    const size_t at = loop ? (size_t)(loop - f->message) : 0;

    if (f->kind == FAULT_LOOP && loop)
        snprintf(loop, sizeof f->message - at, "infinite loop: more than %d instructions in one test", TEST_WORK);
    else if (f->kind == FAULT_MEMORY)
        snprintf(f->message, sizeof f->message, "%sout of memory (%d MiB for a test)%s", o->shortage_location,
                 TEST_HEAP >> 20, o->in_deep_calls ? " (calls nested deeply: infinite recursion?)" : "");
}

static void write_fault(struct board_fault *f, const struct output *o, FILE *out)
{
    reword(f, o);
    outcome_write(out, LINE_FAILURE, "%s", f->message);
    for (const char *p = f->trace; *p; p += strcspn(p, "\n"), p += *p == '\n')
        outcome_write(out, LINE_TRACE, "%.*s", (int)strcspn(p, "\n"), p);
}

/* heap: TEST_HEAP bytes, aligned to 16. */
static void run(struct test_script *s, void *heap)
{
    struct host settings;

    s->values = (struct values){ .bytes = s->value_bytes, .capacity = sizeof s->value_bytes };
    s->board.output = &s->output;
    s->board.tasks.current = NO_SLOT;
    host_enter(&settings);
    bool good = vm_open(&s->board, heap, TEST_HEAP);
    if (good) {
        vm_reset_work(&s->board, TEST_WORK);
        good = vm_call(&s->board, run_chunk);
    }
    host_leave(&settings);
    if (!good)
        write_fault(&s->output.fault, &s->output, s->out);
    for (int i = 0; i < MAX_TEST_RUNS; i++)
        test_run_close(&s->run[i]);
    for (int i = 0; i < s->n_required; i++)
        free(s->required[i]);
}

void test_script_run(const struct testing *t, const char *name, FILE *out)
{
    const uint64_t start = plat_usec();
    const size_t size = (sizeof(struct test_script) + 15) / 16 * 16;
    char chunk[FILES_PATH_SIZE], err[FILES_ERR_SIZE];
    void *block;
    struct test_script *s = tree_work(size + TEST_HEAP, &block);
    size_t n = 0;
    uint8_t *text = read_script(t, name, &n, err, sizeof err);
    uint32_t frames = 0;

    snprintf(chunk, sizeof chunk, "%.*s", (int)(strlen(name) - strlen(".lua")), name);
    if (!text) {
        outcome_write(out, LINE_HOST_ERROR, "%s", err);
    } else if (!s) {
        outcome_write(out, LINE_HOST_ERROR, "%s: out of memory", name);
    } else {
        memset(s, 0, sizeof *s);
        s->testing = t;
        s->out = out;
        s->golden = (struct golden){ t->dir, t->args->update, out };
        s->chunk = chunk;
        s->text = text;
        s->text_size = n;
        run(s, (uint8_t *)s + size);
        frames = s->frames;
    }
    outcome_write(out, LINE_COST, "%u %llu", (unsigned)frames, (unsigned long long)clock_since(start));
    free(block);
    free(text);
}
