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

static const char chunk_name[] = "=console", error_prefix[] = "console:1: ";

static void compile_line(lua_State *L, const char *line)
{
    const char *message, *expression = lua_pushfstring(L, "return %s", line);
    int at;

    if (!script_scan(line, strlen(line), &at, &message)) {
        lua_pushstring(L, message);
        lua_error(L);
    }
    int status = luaL_loadbufferx(L, expression, strlen(expression), chunk_name, "t");
    if (status == LUA_ERRSYNTAX) {
        lua_pop(L, 1);
        status = luaL_loadbufferx(L, line, strlen(line), chunk_name, "t");
    }
    lua_remove(L, -2);
    if (status != LUA_OK)
        lua_error(L);
}

/* ---- values as text ---- */

/* Pushes "bullet 12" for a live handle, "no bullet" for a dead one. */
static void push_thing_text(lua_State *L, int64_t h)
{
    const char *name = strchr(api_thing_names[handle_kind(h)], ' ') + 1;

    if (board_is_alive(vm_board(L), h))
        lua_pushfstring(L, "%s %d", name, (int)handle_slot(h) + (handle_kind(h) == H_PLAYER));
    else
        lua_pushfstring(L, "no %s", name);
}

/* Pushes the value at idx as text. */
static void push_value_text(lua_State *L, int idx)
{
    if (lua_isinteger(L, idx) && handle_is_well_formed(lua_tointeger(L, idx)))
        push_thing_text(L, lua_tointeger(L, idx));
    else
        lualib_tolstring(L, idx, NULL);
}

enum { MAX_SHOWN_ENTRIES = 24 /* most entries of a table that are shown */ };

/* Appends the entry whose key and value are on top of the stack to the text below them; pops the value. */
static void append_entry(lua_State *L, lua_Integer n)
{
    int key = lua_gettop(L) - 1, text = key - 1;
    bool is_list_item = lua_isinteger(L, key) && lua_tointeger(L, key) == n;

    vm_charge(L, WORK_CALL);
    lua_pushvalue(L, text);
    lua_pushstring(L, n > 1 ? ", " : " ");
    push_value_text(L, key);
    lua_pushstring(L, " = ");
    push_value_text(L, key + 1);
    if (is_list_item) {
        lua_replace(L, -3);
        lua_pop(L, 1);
    }
    lua_concat(L, is_list_item ? 3 : 5);
    lua_replace(L, text);
    lua_pop(L, 1);
}

/* Pushes "{ 1, 2, x = 3 }" for the table at idx. */
static void push_table_text(lua_State *L, int idx)
{
    lua_Integer n = 1;

    api_fill_table(L, idx);
    lua_pushliteral(L, "{");
    lua_pushnil(L);
    for (int key_count; (key_count = luakeys_next(L, idx)) > 0; n++) {
        if (n > MAX_SHOWN_ENTRIES) {
            lua_pop(L, 1);
            lua_pushliteral(L, ", ...");
            lua_concat(L, 2);
            break;
        }
        luakeys_push_value(L, idx, key_count);
        append_entry(L, n);
    }
    lua_pushliteral(L, " }");
    lua_concat(L, 2);
}

static void replace_with_text(lua_State *L, int idx)
{
    if (lua_istable(L, idx) && !values_have_text_form(L, idx))
        push_table_text(L, idx);
    else
        push_value_text(L, idx);
    lua_replace(L, idx);
}

/* ---- running ---- */

static int run_line(lua_State *L)
{
    struct output *o = vm_board(L)->output;

    lua_settop(L, 0);
    compile_line(L, o->eval_line);
    lua_call(L, 0, LUA_MULTRET);
    int n = lua_gettop(L);
    if (o->values) {
        values_put(L, o->values);
        return 0;
    }
    luaL_checkstack(L, 16, NULL);
    for (int i = 1; i <= n; i++)
        replace_with_text(L, i);
    return n ? vm_print(L) : 0;
}

/* Returns the message without the prefix "console:1: ", which is the same for every line. */
static const char *skip_error_prefix(const char *message)
{
    return strncmp(message, error_prefix, sizeof error_prefix - 1) ? message : message + sizeof error_prefix - 1;
}

bool api_run_between_frames(struct board *b, lua_CFunction f, uint64_t limit)
{
    struct output *o = b->output;
    struct board_out saved_out = o->out;
    struct host host;

    if (o->fault.kind != FAULT_NONE)
        return false;
    host_enter(&host);
    o->log_size = 0;
    vm_reset_work(b, limit);
    bool ok = vm_call(b, f) && vm_call(b, events_run);
    b->vm.limit = WORK_LIMIT;
    o->out = saved_out;
    o->out.log_size = 0;
    host_leave(&host);
    return ok;
}

/* Implements board_eval_values; if `values` is NULL, prints the values as board_eval does. */
static bool evaluate_line(struct board *b, const char *line, struct values *values, char *out, size_t size)
{
    struct output *o = b->output;

    if (o->fault.kind != FAULT_NONE) {
        snprintf(out, size, "%s", o->fault.message);
        return false;
    }
    o->eval_line = line;
    o->values = values;
    bool ok = api_run_between_frames(b, run_line, EVAL_LIMIT);
    snprintf(out, size, "%.*s", ok ? (int)o->log_size : -1, ok ? o->log : skip_error_prefix(o->fault.message));
    o->eval_line = NULL;
    o->values = NULL;
    o->log_size = 0;
    return ok;
}

bool board_eval(struct board *b, const char *line, char *out, size_t size)
{
    return evaluate_line(b, line, NULL, out, size);
}

bool board_eval_values(struct board *b, const char *line, struct values *v, char *out, size_t size)
{
    return evaluate_line(b, line, v, out, size);
}
