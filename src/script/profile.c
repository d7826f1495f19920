/*
 * profile.c - see profile.h.
 *
 * Lua calls the hook before each instruction. Work and allocations since the previous call belong to the previous
 * instruction and so to its line; between the turns of scripts they belong to no line. A function of @std counts for
 * the author's line that called it or started its task.
 */
#include "profile.h"

#include <stdio.h>
#include <string.h>
#include "../base/hash.h"
#include "../machine/machine.h"
#include "tasks.h"
#include "vm.h"

uint64_t profile_work(const struct profile_line *line)
{
    return line->instructions + line->call_work;
}

/* Returns the entry for `location`, adding it if it is new, or `overflow` if there is no space for it. */
static struct profile_line *find_entry(struct profile *p, const char *location, size_t n)
{
    uint32_t i = (uint32_t)hash_bytes(HASH_START, location, n) % PROFILE_CAPACITY;

    for (int tries = 0; tries < PROFILE_CAPACITY / 4; tries++, i = (i + 1) % PROFILE_CAPACITY) {
        struct profile_line *line = &p->line[i];
        if (!line->location[0]) {
            memcpy(line->location, location, n);
            return line;
        }
        if (strncmp(line->location, location, n) == 0 && !line->location[n])
            return line;
    }
    return &p->overflow;
}

static struct profile_line *find_frame_entry(struct profile *p, const lua_Debug *ar)
{
    char location[PROFILE_LOCATION_SIZE];
    const int n = snprintf(location, sizeof location, "%.58s:%d", ar->short_src, ar->currentline);

    return find_entry(p, location, (size_t)n);
}

static bool is_library(const lua_Debug *ar)
{
    return strncmp(ar->source, "@@std/", 6) == 0;
}

/* Returns the line that a running library function counts for. */
static struct profile_line *find_caller(struct profile *p, lua_State *L)
{
    lua_Debug ar, nearest = { .currentline = 0 };

    for (int level = 0; lua_getstack(L, level, &ar); level++) {
        lua_getinfo(L, "Sl", &ar);
        if (ar.currentline > 0 && !is_library(&ar))
            return find_frame_entry(p, &ar);
        if (ar.currentline > 0 && nearest.currentline == 0)
            nearest = ar;
    }
    const char *start_location = tasks_origin(vm_board(L), L);
    if (!start_location)
        return find_frame_entry(p, &nearest);
    const size_t n = strlen(start_location) - 2; /* without ": " */
    return find_entry(p, start_location, n < PROFILE_LOCATION_SIZE ? n : PROFILE_LOCATION_SIZE - 1);
}

/* Returns the line that the next instruction counts for. This is usually the previous instruction's line. */
static struct profile_line *find_line(struct profile *p, lua_State *L, lua_Debug *ar)
{
    lua_getinfo(L, "Sl", ar);
    if (is_library(ar)) {
        struct profile_line *line = find_caller(p, L);
        p->source = NULL;
        line->library_instructions++;
        p->total.library_instructions++;
        return line;
    }
    if (ar->source == p->source && ar->currentline == p->source_line)
        return p->current;
    p->source = ar->source;
    p->source_line = ar->currentline;
    return find_frame_entry(p, ar);
}

/* Adds the work and allocations since the previous call to the last instruction's line. A board that was reset has a
 * new heap, whose count of allocated bytes starts at 0. */
static void attribute_work(struct profile *p, const struct vm *vm)
{
    const uint64_t allocated = heap_work(vm->heap);

    if (p->current) {
        const uint64_t calls = vm->work - p->counted_work,
                       bytes = allocated >= p->counted_bytes ? allocated - p->counted_bytes : 0;
        p->current->call_work += calls;
        p->total.call_work += calls;
        p->current->allocated_bytes += bytes;
        p->total.allocated_bytes += bytes;
    }
    p->counted_work = vm->work;
    p->counted_bytes = allocated;
}

static void on_instruction(lua_State *L, lua_Debug *ar)
{
    struct vm *vm = &vm_board(L)->vm;
    struct profile *p = vm->profile;

    attribute_work(p, vm);
    p->current = find_line(p, L, ar);
    p->current->instructions++;
    p->total.instructions++;
    if (--vm->until_check == 0)
        vm_check_work(L, ar);
    p->counted_work = vm->work;
}

static void pause_profile(struct vm *vm)
{
    attribute_work(vm->profile, vm);
    vm->profile->current = NULL;
    vm->profile->source = NULL;
}

void vm_profile_begin_turn(struct vm *vm, lua_State *L)
{
    pause_profile(vm);
    lua_sethook(L, on_instruction, LUA_MASKCOUNT, 1);
}

void vm_profile_reset_work(struct vm *vm)
{
    pause_profile(vm);
    vm->profile->counted_work = 0;
}

void board_set_profile(struct board *b, struct profile *p)
{
    if (b->vm.profile)
        pause_profile(&b->vm);
    b->vm.profile = p;
    if (p) {
        p->current = NULL;
        pause_profile(&b->vm);
    }
}
