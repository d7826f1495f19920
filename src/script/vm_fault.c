/*
 * vm_fault.c - faults: place, message and traceback; and the protected call that all scripts run in.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../machine/machine.h"
#include "api/api_table.h"
#include "lua/lualib.h"
#include "vm.h"

/* Level 0 is a C function or, in a hook, the interrupted function. If only the library is on the stack of a task,
 * the place is the author's line that started the task. */
void vm_get_location(lua_State *L, char *location, size_t size)
{
    lua_Debug ar;

    location[0] = 0;
    for (int level = 0; lua_getstack(L, level, &ar); level++) {
        lua_getinfo(L, "Sl", &ar);
        bool is_std = strncmp(ar.short_src, "@std/", 5) == 0;
        if (ar.currentline <= 0 || (is_std && location[0]))
            continue;
        snprintf(location, size, "%s:%d: ", ar.short_src, ar.currentline);
        if (!is_std)
            return;
    }
    const char *start_location = tasks_origin(vm_board(L), L);
    if (start_location)
        snprintf(location, size, "%s", start_location);
}

/* Returns whether the message has a location: ":LINE:" within its first VM_LOCATION_SIZE bytes. */
static bool has_location(const char *message)
{
    for (const char *p = message; (p = strchr(p, ':')) != NULL && p - message < VM_LOCATION_SIZE; p++) {
        size_t digits = strspn(p + 1, "0123456789");
        if (digits && p[digits + 1] == ':')
            return true;
    }
    return false;
}

/* Writes the author's place to prefix the message with, if the message has no place or the library's. Writes "" if the
 * message has the author's place already, or if the author's place is unknown and the message has the library's. */
static void write_missing_location(lua_State *L, const char *message, char *location, size_t size)
{
    bool is_std = strncmp(message, "@std/", 5) == 0;

    location[0] = 0;
    if (!has_location(message) || is_std)
        vm_get_location(L, location, size);
    if (is_std && strncmp(location, "@std/", 5) == 0)
        location[0] = 0;
}

void vm_add_location(lua_State *L)
{
    char location[VM_LOCATION_SIZE];

    if (lua_type(L, -1) != LUA_TSTRING)
        return;
    write_missing_location(L, lua_tostring(L, -1), location, sizeof location);
    lua_pushstring(L, location);
    lua_insert(L, -2);
    lua_concat(L, 2);
}

static void push_message(lua_State *L, const char *location, const char *format, va_list args)
{
    lua_checkstack(L, 4);
    lua_pushstring(L, location);
    lua_pushvfstring(L, format, args);
    lua_concat(L, 2);
}

int vm_fault(lua_State *L, enum board_fault_kind kind, const char *format, ...)
{
    char location[VM_LOCATION_SIZE];
    va_list args;

    vm_board(L)->vm.raised_kind = kind;
    vm_get_location(L, location, sizeof location);
    va_start(args, format);
    push_message(L, location, format, args);
    va_end(args);
    return lua_error(L);
}

void vm_note_dead_read(lua_State *L, const char *field)
{
    struct output *o = vm_board(L)->output;

    snprintf(o->dead_field, sizeof o->dead_field, "%s", field);
    vm_get_location(L, o->dead_location, sizeof o->dead_location);
}

int vm_fault_at(lua_State *L, const char *location, const char *format, ...)
{
    va_list args;

    vm_board(L)->vm.raised_kind = FAULT_SCRIPT;
    va_start(args, format);
    push_message(L, location, format, args);
    va_end(args);
    return lua_error(L);
}

static enum board_fault_kind fault_kind_of(const struct board *b, int status, const char *message)
{
    if (b->vm.raised_kind != FAULT_NONE)
        return b->vm.raised_kind;
    if (status == LUA_ERRERR || strstr(message, "stack overflow"))
        return FAULT_STACK;
    return FAULT_SCRIPT;
}

/* Returns whether the running code can wait, i.e. is a task: false while loading, in a handler and in a console
 * line. */
static bool can_wait(const struct board *b)
{
    return b->tasks.current != NO_SLOT && b->vm.limit == WORK_LIMIT;
}

static void report_shortage(const struct board *b, struct board_fault *f)
{
    if (b->output->too_long_size) {
        snprintf(f->message, sizeof f->message, "%sstring too long: %zu bytes (at most %d)",
                 b->output->shortage_location, b->output->too_long_size, (int)MAX_TEXT);
        return;
    }
    const bool in_one_frame = can_wait(b) && heap_work(b->vm.heap) - b->vm.swept_heap_work > heap_used(b->vm.heap) / 2;
    snprintf(f->message, sizeof f->message, "%sout of Lua memory (%d KiB); raise `board.lua_kib` in rom.lua%s",
             b->output->shortage_location, b->cart.manifest.lua_kib,
             b->output->in_deep_calls ? " (calls nested deeply: infinite recursion?)"
             : in_one_frame           ? " (most of it allocated in one frame: infinite loop, missing wait?)"
                                      : "");
}

/* Copies NAME from a message that ends in "a nil value (field 'NAME')". Returns false for any other message. */
static bool parse_nil_field(const char *message, char *name, size_t size)
{
    const char *field = strstr(message, "a nil value (field '"), *end;

    if (!field)
        return false;
    field += strlen("a nil value (field '");
    end = strchr(field, '\'');
    size_t n = end ? (size_t)(end - field) : 0;
    if (!n || n >= size || strcmp(end, "')") != 0)
        return false;
    snprintf(name, size, "%.*s", (int)n, field);
    return true;
}

/* Writes a hint, to be appended to Lua's own message, about why a field may be nil here, or "" if there is none. */
static void write_hint(lua_State *L, const char *message, char *out, size_t size)
{
    const struct output *o = vm_board(L)->output;
    char name[32], calls[100], location[VM_LOCATION_SIZE];
    const char *library, *replacement;

    out[0] = 0;
    if (!parse_nil_field(message, name, sizeof name))
        return;
    vm_get_location(L, location, sizeof location);
    if ((replacement = api_find_replacement(name, &library)) != NULL)
        snprintf(out, size, " (%s.%s is not available: %s)", library, name, replacement);
    else if (strstr(message, "to call") && api_suggest_calls(vm_board(L)->vm.api, name, calls, sizeof calls))
        snprintf(out, size, " (did you mean %s?)", calls);
    else if (!strcmp(name, o->dead_field) && !strcmp(o->dead_location, location))
        snprintf(out, size, " (%s is nil once the thing has despawned; check `alive` first)", name);
}

/* Returns the likely cause of calls nested too deeply or of a frame that does not end, or "". */
static const char *find_likely_cause(const struct board *b, enum board_fault_kind kind)
{
    if (kind == FAULT_STACK)
        return " (calls nested too deeply: infinite recursion?)";
    if (kind != FAULT_LOOP || b->vm.limit != WORK_LIMIT)
        return "";
    return can_wait(b) ? " (missing wait?)" : " (only a task can wait; start one with task.go)";
}

/* Reports any error other than lack of memory. */
static void report_error(struct board *b, lua_State *thread, int status, struct board_fault *f)
{
    char location[VM_LOCATION_SIZE] = "", substitute[80], reason[160] = "";
    bool is_raised = lualib_is_raised(thread, -1);

    if (is_raised)
        lualib_push_error_value(thread, -1);
    int type = lua_type(thread, -1);
    const char *message = substitute;
    if (type == LUA_TSTRING || type == LUA_TNUMBER)
        message = lua_tostring(thread, -1);
    else
        snprintf(substitute, sizeof substitute, "error: expected a string as the error value, got a %s",
                 lua_typename(thread, type));
    write_missing_location(thread, message, location, sizeof location);
    if (!is_raised && b->vm.raised_kind == FAULT_NONE)
        write_hint(thread, message, reason, sizeof reason);
    f->kind = is_raised ? FAULT_SCRIPT : fault_kind_of(b, status, message);
    snprintf(f->message, sizeof f->message, "%s%s%s%s", location, message, reason, find_likely_cause(b, f->kind));
    if (f->kind == FAULT_LOOP)
        board_withdraw_full_reports(b);
}

void vm_report_fault(struct board *b, lua_State *thread, int status)
{
    struct board_fault *f = &b->output->fault;

    if (f->kind != FAULT_NONE)
        return;
    f->kind = FAULT_MEMORY;
    if (status == LUA_ERRMEM)
        report_shortage(b, f);
    else
        report_error(b, thread, status, f);
    b->output->out.fault = f;
}

void vm_add_traceback(struct board *b, lua_State *L, lua_State *thread)
{
    if (b->output->fault.trace[0])
        return;
    lualib_push_trace(L); /* the traceback of a fault that passed through a pcall, or nil */
    if (!lua_isstring(L, -1))
        luaL_traceback(L, thread, NULL, 0);
    snprintf(b->output->fault.trace, sizeof b->output->fault.trace, "%s", lua_tostring(L, -1));
    lua_pop(L, 1);
}

/* The message handler of vm_call. Takes the traceback here because the stack still exists. */
static int on_error(lua_State *L)
{
    struct board *b = vm_board(L);

    vm_report_fault(b, L, LUA_ERRRUN);
    lua_settop(L, 1);
    vm_add_traceback(b, L, L);
    return 1;
}

bool vm_call(struct board *b, lua_CFunction f)
{
    lua_State *L = b->vm.L;

    vm_enter(b, L);
    lua_settop(L, 0);
    lua_pushcfunction(L, on_error);
    lua_pushcfunction(L, f);
    int status = lua_pcall(L, 0, 0, 1);
    if (status != LUA_OK)
        vm_report_fault(b, L, status);
    lua_settop(L, 0);
    return status == LUA_OK;
}
