/*
 * eval.c - see eval.h.
 *
 * The line is first compiled with "return " in front, so that the values of an expression become results. If that is a
 * syntax error, the line is compiled as statements, whose error is reported.
 */
#include "eval.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>
#include "api.h"
#include "api_parts.h"
#include "../events_run.h"
#include "../../base/host.h"
#include "../values.h"
#include "../lua/lualib.h"
#include "../script.h"

static const char chunk[] = "=console", place[] = "console:1: ";

static void compile(lua_State *L, const char *line)
{
    const char *what, *text = lua_pushfstring(L, "return %s", line);
    int at;

    if (!script_scan(line, strlen(line), &at, &what)) {
        lua_pushstring(L, what);
        lua_error(L);
    }
    int status = luaL_loadbufferx(L, text, strlen(text), chunk, "t");
    if (status == LUA_ERRSYNTAX) {
        lua_pop(L, 1);
        status = luaL_loadbufferx(L, line, strlen(line), chunk, "t");
    }
    lua_remove(L, -2);
    if (status != LUA_OK)
        lua_error(L);
}

/* ---- values as text ---- */

/* Pushes "bullet 12" for a live handle, "no bullet" for a dead one. */
static void push_thing(lua_State *L, int64_t h)
{
    const char *name = strchr(api_thing_names[handle_kind(h)], ' ') + 1;

    if (board_alive(vm_board(L), h))
        lua_pushfstring(L, "%s %d", name, (int)handle_slot(h) + (handle_kind(h) == H_PLAYER));
    else
        lua_pushfstring(L, "no %s", name);
}

/* Pushes the value at idx as text. */
static void push_words(lua_State *L, int idx)
{
    if (lua_isinteger(L, idx) && handle_is(lua_tointeger(L, idx)))
        push_thing(L, lua_tointeger(L, idx));
    else
        lualib_tolstring(L, idx, NULL);
}

enum { ENTRIES = 24 /* most entries of a table that are shown */ };

/* Appends the entry whose key and value are on top of the stack to the text below them; pops the value. */
static void append_entry(lua_State *L, lua_Integer n)
{
    int key = lua_gettop(L) - 1, text = key - 1;
    bool listed = lua_isinteger(L, key) && lua_tointeger(L, key) == n;

    vm_charge(L, WORK_CALL);
    lua_pushvalue(L, text);
    lua_pushstring(L, n > 1 ? ", " : " ");
    push_words(L, key);
    lua_pushstring(L, " = ");
    push_words(L, key + 1);
    if (listed) {
        lua_replace(L, -3);
        lua_pop(L, 1);
    }
    lua_concat(L, listed ? 3 : 5);
    lua_replace(L, text);
    lua_pop(L, 1);
}

/* Pushes "{ 1, 2, x = 3 }" for the table at idx. */
static void push_table(lua_State *L, int idx)
{
    lua_Integer n = 1;

    api_fill(L, idx);
    lua_pushliteral(L, "{");
    lua_pushnil(L);
    for (int like; (like = luakeys_next(L, idx)) > 0; n++) {
        if (n > ENTRIES) {
            lua_pop(L, 1);
            lua_pushliteral(L, ", ...");
            lua_concat(L, 2);
            break;
        }
        luakeys_push_value(L, idx, like);
        append_entry(L, n);
    }
    lua_pushliteral(L, " }");
    lua_concat(L, 2);
}

static bool is_plain_table(lua_State *L, int idx)
{
    return lua_istable(L, idx) && luaL_getmetafield(L, idx, "__tostring") == LUA_TNIL &&
           luaL_getmetafield(L, idx, "__name") == LUA_TNIL;
}

static void put_words(lua_State *L, int idx)
{
    int top = lua_gettop(L);
    bool plain = is_plain_table(L, idx);

    lua_settop(L, top);
    if (plain)
        push_table(L, idx);
    else
        push_words(L, idx);
    lua_replace(L, idx);
}

/* ---- running ---- */

static int run_line(lua_State *L)
{
    struct output *o = vm_board(L)->output;

    lua_settop(L, 0);
    compile(L, o->line);
    lua_call(L, 0, LUA_MULTRET);
    int n = lua_gettop(L);
    if (o->values) {
        values_put(L, o->values);
        return 0;
    }
    luaL_checkstack(L, 16, NULL);
    for (int i = 1; i <= n; i++)
        put_words(L, i);
    return n ? vm_print(L) : 0;
}

/* Returns the message without the prefix "console:1: ", which is the same for every line. */
static const char *without_place(const char *message)
{
    return strncmp(message, place, sizeof place - 1) ? message : message + sizeof place - 1;
}

bool api_between(struct board *b, lua_CFunction f, uint64_t limit)
{
    struct output *o = b->output;
    struct board_out was = o->out;
    struct host host;

    if (o->fault.kind != FAULT_NONE)
        return false;
    host_enter(&host);
    o->log_size = 0;
    vm_begin(b, limit);
    bool fine = vm_call(b, f) && vm_call(b, events_run);
    b->vm.limit = WORK_LIMIT;
    o->out = was;
    o->out.log_size = 0;
    host_leave(&host);
    return fine;
}

/* Implements board_eval_values; if `values` is NULL, prints the values as board_eval does. */
static bool eval(struct board *b, const char *line, struct values *values, char *out, size_t size)
{
    struct output *o = b->output;

    if (o->fault.kind != FAULT_NONE) {
        snprintf(out, size, "%s", o->fault.message);
        return false;
    }
    o->line = line;
    o->values = values;
    bool fine = api_between(b, run_line, EVAL_LIMIT);
    snprintf(out, size, "%.*s", fine ? (int)o->log_size : -1, fine ? o->log : without_place(o->fault.message));
    o->line = NULL;
    o->values = NULL;
    o->log_size = 0;
    return fine;
}

bool board_eval(struct board *b, const char *line, char *out, size_t size)
{
    return eval(b, line, NULL, out, size);
}

bool board_eval_values(struct board *b, const char *line, struct values *v, char *out, size_t size)
{
    return eval(b, line, v, out, size);
}
