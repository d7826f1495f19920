/*
 * trial.c - see trial.h.
 *
 * The machine is that of games (vm.h), in a board whose chips are never powered: so a script of tests obeys the same
 * sandbox, and ends in the same faults. Other than a game's, its collector runs whenever it likes, for nothing here is
 * hashed.
 */
#include "trial.h"

#include <stdio.h>
#include <string.h>
#include "../../base/host.h"
#include "../../script/api/api.h"
#include "../../script/lua/lualib.h"
#include "../../script/vm.h"
#include "trial_parts.h"

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
    trial_of(L)->host->print(trial_of(L)->host->context, lua_tostring(L, -1));
    return 0;
}

/* ---- scripts ---- */

/* require "helpers/bot": tests/helpers/bot.lua, once. */
static int require(lua_State *L)
{
    struct trial *t = trial_of(L);
    const char *name = luaL_checkstring(L, 1);
    char path[160];
    size_t n;

    lua_settop(L, 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
    if (lua_getfield(L, 2, name) != LUA_TNIL)
        return lua_islightuserdata(L, -1) ? vm_fault(L, FAULT_SCRIPT, "require: \"%s\" requires itself", name) : 1;
    const char *text = t->host->script(t->host->context, name, &n);
    if (!text)
        return vm_fault(L, FAULT_SCRIPT, "require: no script tests/%s.lua", name);
    lua_pushlightuserdata(L, t);
    lua_setfield(L, 2, name);
    snprintf(path, sizeof path, "tests/%s", name);
    vm_load_text(L, path, text, n);
    return vm_finish_require(L, name, 0);
}

static int run_script(lua_State *L)
{
    struct trial *t = trial_of(L);

    lualib_open(L);
    lua_register(L, "require", require);
    lua_register(L, "print", print);
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
    trial_open_runs(L);
    lua_newtable(L);
    trial_set_functions(L, "test.");
    lua_setglobal(L, "test");
    lua_pushglobaltable(L);
    lua_pushcfunction(L, undeclared);
    lua_pushcfunction(L, no_new_global);
    lualib_seal(L);
    lua_pop(L, 1);
    vm_load_text(L, t->chunk, t->text, t->text_size);
    lua_call(L, 0, 0);
    return 0;
}

/* ---- all of it ---- */

/* The guards' sentences speak of frames and of rom.lua; a test has other bounds. */
static void reword(struct board_fault *f, const struct output *o)
{
    char *loop = strstr(f->message, "infinite loop: ");
    const size_t at = loop ? (size_t)(loop - f->message) : 0;

    if (f->kind == FAULT_LOOP && loop)
        snprintf(loop, sizeof f->message - at, "infinite loop: more than %d instructions in one test", TRIAL_WORK);
    else if (f->kind == FAULT_MEMORY)
        snprintf(f->message, sizeof f->message, "%sout of memory (%d MiB for a test)%s", o->shortage_location,
                 TRIAL_HEAP >> 20, o->in_deep_calls ? " (calls nested deeply: infinite recursion?)" : "");
}

size_t trial_size(void)
{
    return (sizeof(struct trial) + 15) / 16 * 16 + TRIAL_HEAP;
}

bool trial_script(void *memory, const struct trial_host *host, const char *chunk, const char *text, size_t n,
                  struct board_fault *fault, uint32_t *frames)
{
    struct trial *t = memory;
    struct host settings;

    memset(t, 0, sizeof *t);
    t->host = host;
    t->chunk = chunk;
    t->text = text;
    t->text_size = n;
    t->values = (struct values){ .bytes = t->value_bytes, .capacity = sizeof t->value_bytes };
    t->board.output = &t->output;
    t->board.tasks.current = NO_SLOT;
    host_enter(&settings);
    bool good = vm_open(&t->board, (uint8_t *)memory + trial_size() - TRIAL_HEAP, TRIAL_HEAP);
    if (good) {
        vm_reset_work(&t->board, TRIAL_WORK);
        good = vm_call(&t->board, run_script);
    }
    host_leave(&settings);
    *fault = t->output.fault;
    if (!good)
        reword(fault, &t->output);
    *frames = t->frames;
    return good;
}
