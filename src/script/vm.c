/*
 * vm.c - see vm.h.
 *
 * The garbage collector is stopped while a tick runs. Between frames it takes small steps, more of them if much was
 * allocated, until it completes a cycle; then it rests until heap use has grown a little.
 */
#include "vm.h"
#include <stdio.h>
#include <string.h>
#include "api/api.h"
#include "lua/lualib.h"
#include "../machine/machine.h"
#include "std.h"

enum { DEEP_CALLS = 3000 /* nested calls; a stack this deep when memory runs out suggests infinite recursion */ };

/* Called after a failed allocation, before Lua collects garbage and retries. Records the place, because the stack is
 * gone by the time an out-of-memory error is reported. Charges for the collection, because with memory nearly full each
 * allocation may need one. */
static void note_shortage(struct board *b)
{
    struct output *o = b->output;
    lua_Debug ar;

    b->vm.work += heap_used(b->vm.heap) / 2;
    if (!b->vm.running)
        return;
    vm_get_location(b->vm.running, o->shortage_location, sizeof o->shortage_location);
    o->in_deep_calls = lua_getstack(b->vm.running, DEEP_CALLS, &ar);
}

static void *allocate(void *ud, void *p, size_t old, size_t size)
{
    struct board *b = ud;
    /* For a new block Lua passes a type in place of the old size. */
    const bool is_string = !p && old == LUA_TSTRING, is_too_long = is_string && size > b->vm.max_text_block;
    void *q = is_too_long ? NULL : heap_realloc(b->vm.heap, p, p ? old : 0, size);

    if (is_string)
        b->vm.text_block_size = size;
    if (is_too_long)
        b->output->too_long_size = size - b->vm.max_text_block + MAX_TEXT; /* for the message */
    if (!q && size)
        note_shortage(b);
    vm_on_allocation(b);
    return q;
}

/* The collector's pace. A step does the work of allocating STEP_PERCENT of 2^STEP_SHIFT bytes. vm_collect_garbage takes
 * one step, plus one for each BYTES_PER_STEP bytes allocated since its last call. After a cycle that leaves U bytes in
 * use, the next one starts when PAUSE_BYTES + U / PAUSE_USED_DIVISOR more are in use, or 1 / PAUSE_FREE_DIVISOR of the
 * free bytes if that is less. */
enum {
    STEP_PERCENT = 100,
    STEP_SHIFT = 8,
    BYTES_PER_STEP = 4096,
    PAUSE_BYTES = 16384,
    PAUSE_USED_DIVISOR = 16,
    PAUSE_FREE_DIVISOR = 4
};

/* Ends a collector cycle: sets the heap use at which the next one starts. */
static void end_gc_cycle(struct vm *vm)
{
    const size_t used = heap_used(vm->heap), free_bytes = vm->heap_size - used,
                 max_growth = free_bytes / PAUSE_FREE_DIVISOR;
    const size_t growth = PAUSE_BYTES + used / PAUSE_USED_DIVISOR;

    vm->collecting = false;
    vm->collect_at = used + (growth < max_growth ? growth : max_growth);
}

int vm_collect_garbage(lua_State *L)
{
    struct vm *vm = &vm_board(L)->vm;
    const uint64_t allocated = heap_work(vm->heap) - vm->swept_heap_work;

    lualib_check_metatables(L);
    if (allocated && (vm->collecting || heap_used(vm->heap) >= vm->collect_at)) {
        uint64_t steps = 1 + allocated / BYTES_PER_STEP;
        vm->collecting = true;
        while (steps > 0 && !lua_gc(L, LUA_GCSTEP, 0))
            steps--;
        if (steps > 0)
            end_gc_cycle(vm);
    }
    vm->swept_heap_work = heap_work(vm->heap);
    return 0;
}

/* ---- the log ---- */

void vm_log(struct board *b, const char *s, size_t n)
{
    struct output *o = b->output;
    size_t free_bytes = o->log_size < LOG_BYTES ? LOG_BYTES - o->log_size : 0;

    if (n > free_bytes)
        n = free_bytes;
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

/* ---- opening the VM ---- */

static int fault_undeclared_global(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    const char *line = api_disabled_reason(&vm_board(L)->cart.manifest, name);

    if (api_push_lazy_table(L, name))
        return 1;
    if (api_is_reserved(name))
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (%s %s)", name, name, RESERVED_MESSAGE);
    if (line)
        return vm_fault(L, FAULT_SCRIPT, "%s: " API_DISABLED_FORMAT, name, line);
    if (api_replacement(NULL, name))
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (not available: %s)", name,
                        api_replacement(NULL, name));
    if (std_module_of_global(name) >= 0)
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (%s)", name, STD_NOT_PACKED);
    return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\"%s", name, api_push_suggestion(L, name, true));
}

static int fault_new_global(lua_State *L)
{
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    const char *suggestion = api_push_suggestion(L, name, false);

    if (suggestion[0])
        return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\"%s", name, suggestion);
    return vm_fault(L, FAULT_SCRIPT, "undeclared global \"%s\" (scripts cannot create globals; write \"local %s\")",
                    name, name);
}

/* Sets the largest allowed string block. Lua's block for a string is a header and the text; the header's size, which
 * differs between hosts, is measured with a sample string. */
static void limit_string_size(lua_State *L)
{
    struct vm *vm = &vm_board(L)->vm;
    char text[VM_LOCATION_SIZE] = "";

    lua_pushlstring(L, text, sizeof text);
    vm->max_text_block = vm->text_block_size - sizeof text + MAX_TEXT;
    lua_pop(L, 1);
}

int vm_boot(lua_State *L)
{
    struct board *b = vm_board(L);

    lua_gc(L, LUA_GCINC, 100, STEP_PERCENT, STEP_SHIFT);
    lua_gc(L, LUA_GCSTOP);
    limit_string_size(L);
    lualib_open(L);
    lua_register(L, "require", vm_require);
    lua_register(L, "print", vm_print);
    api_open_globals(L); /* pushes the sys table */
    int sys = lua_gettop(L);
    vm_open_scripts(L, sys);
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        vm_load_std(L, i, sys);
    /* Free the garbage left by loading the library, so that the game's scripts get that memory. */
    lua_gc(L, LUA_GCCOLLECT);
    api_explain_missing_fields(L);
    lua_pushglobaltable(L);
    lua_pushcfunction(L, fault_undeclared_global);
    lua_pushcfunction(L, fault_new_global);
    lualib_seal(L);
    lua_pop(L, 1);
    vm_load_script(L, b->cart.manifest.entry);
    lua_call(L, 0, 0);
    lua_gc(L, LUA_GCCOLLECT); /* a run starts without garbage from loading */
    end_gc_cycle(&b->vm);
    if (board_is_listing(b) && !b->vm.practice_read)
        vm_fault(L, FAULT_SCRIPT, "practice: no sections to choose from, because %s.lua does not call boot.run",
                 b->cart.manifest.entry);
    if (b->start.practice.section[0] && !b->vm.practice_read)
        vm_fault(L, FAULT_SCRIPT, "--stage: cannot start at \"%s\", because %s.lua does not call boot.run",
                 b->start.practice.section, b->cart.manifest.entry);
    return 0;
}

static void raise_fault(struct board *b, enum board_fault_kind kind, const char *message)
{
    vm_fault(b->vm.running, kind, "%s", message);
}

static void write_location(struct board *b, char *location, size_t size)
{
    location[0] = 0;
    if (b->vm.running)
        vm_get_location(b->vm.running, location, size);
}

static const char emits_key = 0; /* registry: the memory of the emit queue */

static void *provide_emit_queue(const struct board *b, const void *old, size_t *size)
{
    lua_State *L = b->vm.running;

    luaL_checkstack(L, 4, NULL);
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &emits_key) == LUA_TUSERDATA && !old)
        *size = (size_t)lua_rawlen(L, -1);
    else {
        lua_pop(L, 1);
        memset(lua_newuserdatauv(L, *size, 0), 0, *size);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &emits_key);
    }
    void *block = lua_touserdata(L, -1);
    lua_pop(L, 1);
    return block;
}

static const struct vm_calls callbacks = { raise_fault, write_location, provide_emit_queue };

bool vm_open(struct board *b, void *block, size_t size)
{
    b->vm.heap = heap_init(block, size);
    b->vm.heap_size = size;
    b->vm.api = &api_table;
    b->vm.max_text_block = SIZE_MAX;
    b->vm.running = NULL;
    vm_reset_work(b, WORK_LIMIT);
    b->vm.L = lua_newstate(allocate, b);
    if (!b->vm.L)
        return false;
    *(struct board **)lua_getextraspace(b->vm.L) = b;
    b->vm.running = b->vm.L;
    b->vm.swept_heap_work = 0;
    b->vm.raised_kind = FAULT_NONE;
    b->calls = &callbacks;
    return true;
}
