/*
 * vm.c - see vm.h.
 *
 * The collector is stopped while a tick runs. Between frames it takes small steps, more if much was allocated, until it
 * has been through the heap; then it rests until a little more is in use than it left.
 */
#include "vm.h"
#include <lualib.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "api/api.h"
#include "lua/lualib.h"
#include "../machine/machine.h"
#include "script.h"
#include "std.h"

/* Level 0 is a C function, or in a hook the function that was interrupted. The place of a task that the library
 * started is the author's line that led to it. */
void vm_where(lua_State *L, char *place, size_t size)
{
    lua_Debug ar;

    place[0] = 0;
    for (int level = 0; lua_getstack(L, level, &ar); level++) {
        lua_getinfo(L, "Sl", &ar);
        bool std = strncmp(ar.short_src, "@std/", 5) == 0;
        if (ar.currentline <= 0 || (std && place[0]))
            continue;
        snprintf(place, size, "%s:%d: ", ar.short_src, ar.currentline);
        if (!std)
            return;
    }
    const char *from = tasks_from(vm_board(L), L);
    if (from)
        snprintf(place, size, "%s", from);
}

enum { DEEP = 3000 /* nested calls; with as many when memory runs out, an endless recursion is likely */ };

/* After a failed allocation, before Lua collects and tries again: notes the place, because the error that may follow
 * has lost its stack. The collection counts as work: with memory nearly full there is one an allocation. */
static void note_shortage(struct board *b)
{
    struct output *o = b->output;
    lua_Debug ar;

    b->vm.work += heap_used(b->vm.heap) / 2;
    if (!b->vm.running)
        return;
    vm_where(b->vm.running, o->shortage, sizeof o->shortage);
    o->deep = lua_getstack(b->vm.running, DEEP, &ar);
}

/* True for a text that is too long; its size is noted for the message. */
static bool is_too_long(struct board *b, size_t size)
{
    b->vm.text_block = size;
    if (size > b->vm.text_max)
        b->output->long_text = size - b->vm.text_max + MAX_TEXT;
    return size > b->vm.text_max;
}

static void *allocate(void *ud, void *p, size_t old, size_t size)
{
    struct board *b = ud;
    /* For a new block Lua passes a type in place of the old size. */
    bool refused = !p && old == LUA_TSTRING && is_too_long(b, size);
    void *q = refused ? NULL : heap_realloc(b->vm.heap, p, p ? old : 0, size);

    if (!q && size)
        note_shortage(b);
    vm_allocated(b);
    return q;
}

/* ---- faults ---- */

/* Does it start with "FILE:LINE: "? */
static bool has_place(const char *message)
{
    for (const char *p = message; (p = strchr(p, ':')) != NULL && p - message < VM_PLACE; p++) {
        size_t digits = strspn(p + 1, "0123456789");
        if (digits && p[digits + 1] == ':')
            return true;
    }
    return false;
}

/* The author's place for a message that has none, or only the library's, which then follows it. */
static void missing_place(lua_State *L, const char *message, char *place, size_t size)
{
    bool std = strncmp(message, "@std/", 5) == 0;

    place[0] = 0;
    if (!has_place(message) || std)
        vm_where(L, place, size);
    if (std && strncmp(place, "@std/", 5) == 0)
        place[0] = 0;
}

void vm_place(lua_State *L)
{
    char place[VM_PLACE];

    if (lua_type(L, -1) != LUA_TSTRING)
        return;
    missing_place(L, lua_tostring(L, -1), place, sizeof place);
    lua_pushstring(L, place);
    lua_insert(L, -2);
    lua_concat(L, 2);
}

int vm_fault(lua_State *L, enum board_fault_kind kind, const char *format, ...)
{
    char place[VM_PLACE];
    va_list args;

    vm_board(L)->vm.kind = kind;
    lua_checkstack(L, 4);
    vm_where(L, place, sizeof place);
    lua_pushstring(L, place);
    va_start(args, format);
    lua_pushvfstring(L, format, args);
    va_end(args);
    lua_concat(L, 2);
    return lua_error(L);
}

void vm_note_dead(lua_State *L, const char *field)
{
    struct output *o = vm_board(L)->output;

    snprintf(o->dead_field, sizeof o->dead_field, "%s", field);
    vm_where(L, o->dead_place, sizeof o->dead_place);
}

int vm_fault_at(lua_State *L, const char *place, const char *format, ...)
{
    va_list args;

    vm_board(L)->vm.kind = FAULT_SCRIPT;
    luaL_checkstack(L, 4, NULL);
    lua_pushstring(L, place);
    va_start(args, format);
    lua_pushvfstring(L, format, args);
    va_end(args);
    lua_concat(L, 2);
    return lua_error(L);
}

static enum board_fault_kind kind_of(const struct board *b, int status, const char *message)
{
    if (b->vm.kind != FAULT_NONE)
        return b->vm.kind;
    if (status == LUA_ERRERR || strstr(message, "stack overflow"))
        return FAULT_STACK;
    return FAULT_SCRIPT;
}

static void copy_text(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
}

/* Does a task have its turn, which could have waited? Not while loading, in a handler, or in a line of the console. */
static bool waits(const struct board *b)
{
    return b->tasks.current != NO_SLOT && b->vm.limit == WORK_LIMIT;
}

static void report_shortage(const struct board *b, struct board_fault *f)
{
    if (b->output->long_text) {
        snprintf(f->message, sizeof f->message, "%sstring too long: %zu bytes (at most %d)", b->output->shortage,
                 b->output->long_text, (int)MAX_TEXT);
        return;
    }
    const bool at_once = waits(b) && heap_work(b->vm.heap) - b->vm.swept > b->vm.heap_size / 2;
    snprintf(f->message, sizeof f->message, "%sout of Lua memory (%d KiB); raise `board.lua_kib` in rom.lua%s",
             b->output->shortage, b->cart.m.lua_kib,
             b->output->deep ? " (calls nested deeply: infinite recursion?)"
             : at_once       ? " (most of it allocated in one frame: infinite loop, missing wait?)"
                             : "");
}

/* The last name in a message that ends in "(field 'NAME')" and is about nil; false: it does not. */
static bool nil_field(const char *message, char *name, size_t size)
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

/* What to say behind Lua's own message: why a field may be nil here. */
static void hint(lua_State *L, const char *message, char *out, size_t size)
{
    const struct output *o = vm_board(L)->output;
    char name[32], calls[100], place[VM_PLACE];
    const char *space, *instead;

    out[0] = 0;
    if (!nil_field(message, name, sizeof name))
        return;
    vm_where(L, place, sizeof place);
    if ((instead = api_instead_field(name, &space)) != NULL)
        snprintf(out, size, " (%s.%s is not available: %s)", space, name, instead);
    else if (strstr(message, "to call") && api_help_calls(name, calls, sizeof calls))
        snprintf(out, size, " (did you mean %s?)", calls);
    else if (!strcmp(name, o->dead_field) && !strcmp(o->dead_place, place))
        snprintf(out, size, " (%s is nil once the thing has despawned; check `alive` first)", name);
}

/* The likely reason, where calls nest too deeply or a frame does not end. */
static const char *cause(const struct board *b, enum board_fault_kind kind)
{
    if (kind == FAULT_STACK)
        return " (calls nested too deeply: infinite recursion?)";
    if (kind != FAULT_LOOP || b->vm.limit != WORK_LIMIT)
        return "";
    return waits(b) ? " (missing wait?)" : " (only a task can wait; start one with task.go)";
}

/* Any other error value. */
static void report_error(struct board *b, lua_State *from, int status, struct board_fault *f)
{
    char place[VM_PLACE] = "", other[80], why[160] = "";
    bool raised = lualib_raised(from, -1);

    if (raised)
        lualib_unwrap(from, -1);
    int type = lua_type(from, -1);
    const char *message = other;
    if (type == LUA_TSTRING || type == LUA_TNUMBER)
        message = lua_tostring(from, -1);
    else
        snprintf(other, sizeof other, "error: expected a string as the error value, got a %s",
                 lua_typename(from, type));
    missing_place(from, message, place, sizeof place);
    if (!raised && b->vm.kind == FAULT_NONE)
        hint(from, message, why, sizeof why);
    f->kind = raised ? FAULT_SCRIPT : kind_of(b, status, message);
    snprintf(f->message, sizeof f->message, "%s%s%s%s", place, message, why, cause(b, f->kind));
    if (f->kind == FAULT_LOOP)
        board_full_forget(b);
}

void vm_report(struct board *b, lua_State *from, int status)
{
    struct board_fault *f = &b->output->fault;

    if (f->kind != FAULT_NONE)
        return;
    f->kind = FAULT_MEMORY;
    if (status == LUA_ERRMEM)
        report_shortage(b, f);
    else
        report_error(b, from, status, f);
    b->output->out.fault = f;
}

void vm_trace(struct board *b, lua_State *L, lua_State *from)
{
    if (b->output->fault.trace[0])
        return;
    lualib_trace(L); /* of a fault that went through a pcall */
    if (!lua_isstring(L, -1))
        luaL_traceback(L, from, NULL, 0);
    copy_text(b->output->fault.trace, sizeof b->output->fault.trace, lua_tostring(L, -1));
    lua_pop(L, 1);
}

/* Message handler of vm_call: the stack is still there, so this is where the traceback is taken. */
static int on_error(lua_State *L)
{
    struct board *b = vm_board(L);

    vm_report(b, L, LUA_ERRRUN);
    lua_settop(L, 1);
    vm_trace(b, L, L);
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
        vm_report(b, L, status);
    lua_settop(L, 0);
    return status == LUA_OK;
}

/* The collector's pace. A step is as much work as STEP_PERCENT of 2^STEP_SHIFT bytes; a turn is a step, and one more
 * for each STEP_FOR bytes that were allocated since the last. A round begins when REST_BYTES, and a REST_PART of what
 * the last one left, are in use beyond that; where room is short, a REST_OF_ROOM of it. */
enum { STEP_PERCENT = 100, STEP_SHIFT = 8, STEP_FOR = 4096, REST_BYTES = 16384, REST_PART = 16, REST_OF_ROOM = 4 };

/* The collector has been through the heap, which leaves it so much in use. */
static void rest(struct vm *vm)
{
    const size_t used = heap_used(vm->heap), room = vm->heap_size - used, most = room / REST_OF_ROOM;
    const size_t more = REST_BYTES + used / REST_PART;

    vm->collecting = false;
    vm->collect_at = used + (more < most ? more : most);
}

static void collect(lua_State *L, struct vm *vm, uint64_t allocated)
{
    vm->collecting = true;
    for (uint64_t n = 1 + allocated / STEP_FOR; n > 0; n--)
        if (lua_gc(L, LUA_GCSTEP, 0)) {
            rest(vm);
            return;
        }
}

int vm_collect(lua_State *L)
{
    struct vm *vm = &vm_board(L)->vm;
    const uint64_t allocated = heap_work(vm->heap) - vm->swept;

    lualib_check_metatables(L);
    if (allocated && (vm->collecting || heap_used(vm->heap) >= vm->collect_at))
        collect(L, vm, allocated);
    vm->swept = heap_work(vm->heap);
    return 0;
}

/* ---- scripts ---- */

void vm_seal(lua_State *L)
{
    lua_createtable(L, 0, 3);
    lua_rotate(L, -3, 1);
    lua_setfield(L, -3, "__newindex");
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

void vm_load(lua_State *L, const char *name)
{
    const struct cart *cart = &vm_board(L)->cart;
    const char *text, *what;
    size_t size;
    int line;
    char chunk[160], meant[SCRIPT_NAME];

    if (!cart_script(cart, name, &text, &size)) {
        if (script_name(name, meant) && cart_script(cart, meant, &text, &size))
            vm_fault(L, FAULT_SCRIPT, "require: no script \"%s.lua\" in the game (did you mean require \"%s\"?)", name,
                     meant);
        vm_fault(L, FAULT_SCRIPT, "require: no script \"%s.lua\" in the game", name);
    }
    if (!script_scan(text, size, &line, &what)) {
        lua_pushfstring(L, "%s.lua:%d: %s", name, line, what);
        lua_error(L);
    }
    snprintf(chunk, sizeof chunk, "@%s.lua", name);
    if (luaL_loadbufferx(L, text, size, chunk, "t") != LUA_OK)
        lua_error(L);
}

static const char modules_key = 0;

/* require "stages/one": runs a script of the game once, at load. */
static int l_require(lua_State *L)
{
    struct board *b = vm_board(L);
    const char *name = luaL_checkstring(L, 1);

    lua_settop(L, 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key);
    if (lua_getfield(L, 2, name) != LUA_TNIL) {
        if (lua_type(L, -1) == LUA_TLIGHTUSERDATA)
            return vm_fault(L, FAULT_SCRIPT, "require: \"%s\" requires itself", name);
        return 1;
    }
    if (!b->vm.loading)
        return vm_fault(L, FAULT_SCRIPT, "require: \"%s\" is not loaded; scripts can only be loaded at startup", name);
    lua_pushlightuserdata(L, b);
    lua_setfield(L, 2, name);
    vm_load(L, name);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    lua_pushvalue(L, -1);
    lua_setfield(L, 2, name);
    return 1;
}

void vm_log(struct board *b, const char *s, size_t n)
{
    struct output *o = b->output;
    size_t room = o->log_size < LOG_BYTES ? LOG_BYTES - o->log_size : 0;

    if (n > room)
        n = room;
    memcpy(o->log + o->log_size, s, n);
    o->log_size += n;
}

int vm_print(lua_State *L)
{
    struct board *b = vm_board(L);
    int n = lua_gettop(L);

    for (int i = 1; i <= n; i++) {
        size_t size;
        const char *s = lualib_tolstring(L, i, &size);
        if (i > 1)
            vm_log(b, "\t", 1);
        vm_log(b, s, size);
        vm_charge(L, WORK_CALL);
        lua_pop(L, 1);
    }
    vm_log(b, "\n", 1);
    return 0;
}

static int undeclared(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    const char *line = api_off(&vm_board(L)->cart.m, name);

    if (api_open_late(L, name))
        return 1;
    if (api_reserved("", '.', name))
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (%s %s)", name, name, NOT_YET);
    if (line)
        return vm_fault(L, FAULT_SCRIPT, "%s: " API_OFF, name, line);
    if (api_instead(NULL, name))
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (not available: %s)", name, api_instead(NULL, name));
    if (std_of(name) >= 0)
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (%s)", name, STD_NOT_HERE);
    return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\"%s", name, api_push_meant(L, name, true));
}

static int no_new_global(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    const char *meant = api_push_meant(L, name, false);

    if (meant[0])
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\"%s", name, meant);
    return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (scripts cannot create globals; write \"local %s\")",
                    name, name);
}

static void seal_globals(lua_State *L)
{
    lua_pushglobaltable(L);
    lua_pushcfunction(L, undeclared);
    lua_pushcfunction(L, no_new_global);
    vm_seal(L);
    lua_pop(L, 1);
}

static const char sys_key = 0; /* registry: the sys table */

void vm_read_piece(lua_State *L, const char *name)
{
    char path[64];
    const char *text;
    size_t size;

    snprintf(path, sizeof path, "@std/%s", name);
    if (!cart_script(&vm_board(L)->cart, path, &text, &size))
        vm_fault(L, FAULT_SCRIPT, "sys.read: no library file \"%s\" in this ROM", name);
    vm_charge(L, size);
    vm_load(L, path);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &sys_key);
    lua_call(L, 1, 1);
}

/* Runs module i, @std/NAME, if the ROM has it and what it adds to is on, with sys and binds what it returns: prelude's
 * entries one by one, the others under their name. */
static void load_std(lua_State *L, int i, int sys)
{
    const char *name = std_module(i);
    char path[64];
    const char *text;
    size_t size;

    snprintf(path, sizeof path, "@std/%s", name);
    if (!cart_script(&vm_board(L)->cart, path, &text, &size))
        return;
    if (std_adds_to(i) && api_off(&vm_board(L)->cart.m, std_adds_to(i)))
        return;
    vm_load(L, path);
    snprintf(path, sizeof path, "@@std/%s.lua", name);
    lualib_drop_locals(L, path);
    lua_pushvalue(L, sys);
    lua_call(L, 1, 1);
    lua_pushglobaltable(L);
    if (!strcmp(name, "prelude")) {
        if (!lua_istable(L, -2))
            vm_fault(L, FAULT_SCRIPT, "%s.lua: expected the script to return a table of functions", path);
        lua_pushnil(L);
        while (lua_next(L, -3)) {
            lua_pushvalue(L, -2);
            lua_insert(L, -2);
            lua_rawset(L, -4);
        }
    } else {
        lua_pushvalue(L, -2);
        lua_setfield(L, -2, name);
    }
    lua_pop(L, 2);
}

/* Lua's block for a text is a header and the text; the header's size differs between hosts. */
static void limit_texts(lua_State *L)
{
    struct vm *vm = &vm_board(L)->vm;
    char text[VM_PLACE] = "";

    lua_pushlstring(L, text, sizeof text);
    vm->text_max = vm->text_block - sizeof text + MAX_TEXT;
    lua_pop(L, 1);
}

static int open_libraries(lua_State *L)
{
    static const luaL_Reg libs[] = { { LUA_GNAME, luaopen_base },
                                     { LUA_TABLIBNAME, luaopen_table },
                                     { LUA_STRLIBNAME, luaopen_string },
                                     { LUA_MATHLIBNAME, luaopen_math },
                                     { LUA_UTF8LIBNAME, luaopen_utf8 } };

    for (size_t i = 0; i < sizeof libs / sizeof *libs; i++) {
        luaL_requiref(L, libs[i].name, libs[i].func, 1);
        lua_pop(L, 1);
    }
    lualib_open(L);
    lua_register(L, "require", l_require);
    lua_register(L, "print", vm_print);
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
    return 0;
}

int vm_boot(lua_State *L)
{
    struct board *b = vm_board(L);

    lua_gc(L, LUA_GCINC, 100, STEP_PERCENT, STEP_SHIFT);
    lua_gc(L, LUA_GCSTOP);
    limit_texts(L);
    open_libraries(L);
    api_open(L); /* leaves the sys table */
    int sys = lua_gettop(L);
    lua_pushvalue(L, sys);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &sys_key);
    for (int i = 0; i < STD_MODULES; i++)
        load_std(L, i, sys);
    lua_gc(L, LUA_GCCOLLECT); /* the game's scripts get the place of what only loading needed */
    api_reserved_install(L);
    seal_globals(L);
    vm_load(L, b->cart.m.entry);
    lua_call(L, 0, 0);
    lua_gc(L, LUA_GCCOLLECT); /* a run begins with what loading left and no more */
    rest(&b->vm);
    if (board_lists(b) && !b->vm.practice_read)
        vm_fault(L, FAULT_SCRIPT, "practice: no sections to choose from, because %s.lua does not call boot.run",
                 b->cart.m.entry);
    if (b->start.practice.section[0] && !b->vm.practice_read)
        vm_fault(L, FAULT_SCRIPT, "--stage: cannot start at \"%s\", because %s.lua does not call boot.run",
                 b->start.practice.section, b->cart.m.entry);
    return 0;
}

static int panic(lua_State *L)
{
    /* Unreachable: every script runs inside vm_call. */
    (void)L;
    return 0;
}

static void raise_fault(struct board *b, enum board_fault_kind kind, const char *message)
{
    vm_fault(b->vm.running, kind, "%s", message);
}

static void find_place(struct board *b, char *place, size_t size)
{
    place[0] = 0;
    if (b->vm.running)
        vm_where(b->vm.running, place, size);
}

static const char emits_key = 0; /* registry: the queue of emits */

static void *emit_room(const struct board *b, const void *had, size_t *size)
{
    lua_State *L = b->vm.running;

    luaL_checkstack(L, 4, NULL);
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &emits_key) == LUA_TUSERDATA && !had)
        *size = (size_t)lua_rawlen(L, -1);
    else {
        lua_pop(L, 1);
        memset(lua_newuserdatauv(L, *size, 0), 0, *size);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &emits_key);
    }
    void *room = lua_touserdata(L, -1);
    lua_pop(L, 1);
    return room;
}

static const struct vm_calls calls = { raise_fault, find_place, emit_room };

bool vm_open(struct board *b, void *block, size_t size)
{
    b->vm.heap = heap_init(block, size);
    b->vm.heap_size = size;
    b->vm.text_max = SIZE_MAX;
    b->vm.running = NULL;
    vm_begin(b, WORK_LIMIT);
    b->vm.L = lua_newstate(allocate, b);
    if (!b->vm.L)
        return false;
    *(struct board **)lua_getextraspace(b->vm.L) = b;
    lua_atpanic(b->vm.L, panic);
    b->vm.running = b->vm.L;
    b->vm.swept = 0;
    b->vm.kind = FAULT_NONE;
    b->calls = &calls;
    return true;
}
