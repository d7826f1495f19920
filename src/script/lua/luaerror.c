/*
 * luaerror.c - error, assert and pcall.
 *
 * error wraps its value in a wrapper, a userdata with its own metatable, so that pcall can distinguish errors raised by
 * a script from faults raised by the VM. A fault that passes through a pcall is stored in the registry, so that a
 * __close handler cannot hide it by raising another error: from then on every failing pcall raises the fault again.
 */
#include <stdint.h>
#include "../../machine/machine.h"
#include "../tasks.h"
#include "../vm.h"
#include "lualib.h"
#include "luaparts.h"

/* Registry keys. error_wrapper_key: the wrappers' metatable; fault_key, trace_key: the first fault that passed through
 * a pcall, and its traceback. */
static const char error_wrapper_key, fault_key, trace_key;

bool lualib_is_raised(lua_State *L, int idx)
{
    if (lua_type(L, idx) != LUA_TUSERDATA || !lua_getmetatable(L, idx))
        return false;
    lua_rawgetp(L, LUA_REGISTRYINDEX, &error_wrapper_key);
    bool is_wrapper = lua_rawequal(L, -1, -2);
    lua_pop(L, 2);
    return is_wrapper;
}

void lualib_push_error_value(lua_State *L, int idx)
{
    lua_getiuservalue(L, idx, 1);
}

void lualib_push_trace(lua_State *L)
{
    lua_rawgetp(L, LUA_REGISTRYINDEX, &trace_key);
}

/* Raises the value on top, in a wrapper. A wrapper, which a __close handler may receive, is raised
 * unchanged. */
static int throw_value(lua_State *L)
{
    if (!lualib_is_raised(L, -1)) {
        lua_newuserdatauv(L, 0, 1);
        lua_insert(L, -2);
        lua_setiuservalue(L, -2, 1);
        lua_rawgetp(L, LUA_REGISTRYINDEX, &error_wrapper_key);
        lua_setmetatable(L, -2);
    }
    return lua_error(L);
}

static int throw_at(lua_State *L, int level)
{
    if (lua_type(L, 1) == LUA_TSTRING && level > 0) {
        luaL_where(L, level);
        lua_pushvalue(L, 1);
        lua_concat(L, 2);
    }
    return throw_value(L);
}

static int base_error(lua_State *L)
{
    lua_Integer level = luaL_optinteger(L, 2, 1);

    lua_settop(L, 1);
    return throw_at(L, level < 0 || level > INT16_MAX ? 0 : (int)level);
}

static int base_assert(lua_State *L)
{
    if (lua_toboolean(L, 1))
        return lua_gettop(L);
    luaL_checkany(L, 1);
    lua_remove(L, 1);
    lua_pushliteral(L, "assertion failed!");
    lua_settop(L, 1);
    return throw_at(L, 1);
}

/* The message handler of pcall: stores the first fault and its traceback while the stack still exists. */
static int store_fault(lua_State *L)
{
    if (lualib_is_raised(L, 1) || lua_rawgetp(L, LUA_REGISTRYINDEX, &fault_key) != LUA_TNIL) {
        lua_settop(L, 1);
        return 1;
    }
    lua_settop(L, 1);
    vm_add_location(L);
    lua_pushvalue(L, 1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &fault_key);
    luaL_traceback(L, L, NULL, 1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &trace_key);
    return 1;
}

enum { IN_TASK = 1 }; /* pcall_done's context after a wait; only tasks can wait, so no handler is running */

/* Finishes pcall. The stack holds the message handler, true, and then the function's results or the error. */
static int pcall_done(lua_State *L, int status, lua_KContext context)
{
    if (status == LUA_OK || status == LUA_YIELD)
        return lua_gettop(L) - 1;
    if (context == IN_TASK)
        tasks_restore_context(vm_board(L));
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &fault_key) != LUA_TNIL)
        return lua_error(L);
    lua_pop(L, 1);
    if (!lualib_is_raised(L, -1))
        return lua_error(L);
    lua_pushboolean(L, 0);
    lualib_push_error_value(L, -2);
    return 2;
}

enum { PCALL_WORK = 20 /* work of a pcall that catches an error, charged for every pcall */ };

static int base_pcall(lua_State *L)
{
    luaL_checkany(L, 1);
    vm_charge(L, PCALL_WORK);
    lua_pushcfunction(L, store_fault);
    lua_insert(L, 1);
    lua_pushboolean(L, 1);
    lua_insert(L, 2);
    struct tasks_context saved = { vm_board(L)->tasks.current_owner, vm_board(L)->tasks.current_scene };
    int status = lua_pcallk(L, lua_gettop(L) - 3, LUA_MULTRET, 1, IN_TASK, pcall_done);
    tasks_set_context(vm_board(L), saved); /* an error may have unwound an enemy's handler */
    return pcall_done(L, status, 0);
}

/* The __tostring of a wrapper, which a __close handler may call: the text of the wrapped value. */
static int error_wrapper_tostring(lua_State *L)
{
    if (!lualib_is_raised(L, 1))
        return luaL_argerror(L, 1, "error expected");
    lualib_push_error_value(L, 1);
    lualib_tolstring(L, -1, NULL);
    return 1;
}

void luaerror_open(lua_State *L)
{
    static const luaL_Reg functions[] = {
        { "assert", base_assert }, { "error", base_error }, { "pcall", base_pcall }, { NULL, NULL }
    };

    luaL_setfuncs(L, functions, 0);
    lua_createtable(L, 0, 3);
    lua_pushcfunction(L, error_wrapper_tostring);
    lua_setfield(L, -2, "__tostring");
    lua_pushliteral(L, "error");
    lua_setfield(L, -2, "__name");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_rawsetp(L, LUA_REGISTRYINDEX, &error_wrapper_key);
}
