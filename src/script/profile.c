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
    return line->instructions + line->calls;
}

/* Returns the entry for `place`, adding it if it is new, or `other` if there is no space for it. */
static struct profile_line *entry(struct profile *p, const char *place, size_t n)
{
    uint32_t i = (uint32_t)hash_bytes(HASH_START, place, n) % PROFILE_ROOM;

    for (int tries = 0; tries < PROFILE_ROOM / 4; tries++, i = (i + 1) % PROFILE_ROOM) {
        struct profile_line *line = &p->line[i];
        if (!line->place[0]) {
            memcpy(line->place, place, n + 1);
            return line;
        }
        if (strcmp(line->place, place) == 0)
            return line;
    }
    return &p->other;
}

static struct profile_line *entry_at(struct profile *p, const lua_Debug *ar)
{
    char place[PROFILE_PLACE];
    const int n = snprintf(place, sizeof place, "%.58s:%d", ar->short_src, ar->currentline);

    return entry(p, place, (size_t)n);
}

static bool is_library(const lua_Debug *ar)
{
    return strncmp(ar->source, "@@std/", 6) == 0;
}

/* Returns the line that a running library function counts for. */
static struct profile_line *caller(struct profile *p, lua_State *L)
{
    lua_Debug ar, nearest = { .currentline = 0 };
    char place[PROFILE_PLACE];

    for (int level = 0; lua_getstack(L, level, &ar); level++) {
        lua_getinfo(L, "Sl", &ar);
        if (ar.currentline > 0 && !is_library(&ar))
            return entry_at(p, &ar);
        if (ar.currentline > 0 && nearest.currentline == 0)
            nearest = ar;
    }
    const char *from = tasks_from(vm_board(L), L);
    if (!from)
        return entry_at(p, &nearest);
    const int n = snprintf(place, sizeof place, "%.*s", (int)strlen(from) - 2, from); /* ends in ": " */
    return entry(p, place, n < PROFILE_PLACE ? (size_t)n : PROFILE_PLACE - 1);
}

/* Returns the line that the next instruction counts for. This is usually the previous instruction's line. */
static struct profile_line *find_line(struct profile *p, lua_State *L, lua_Debug *ar)
{
    lua_getinfo(L, "Sl", ar);
    if (is_library(ar)) {
        struct profile_line *line = caller(p, L);
        p->source = NULL;
        line->library++;
        p->all.library++;
        return line;
    }
    if (ar->source == p->source && ar->currentline == p->at)
        return p->now;
    p->source = ar->source;
    p->at = ar->currentline;
    return entry_at(p, ar);
}

/* Adds the work and allocations since settle was last called to the last instruction's line. A board that was reset has
 * a new heap, whose count of allocated bytes starts at 0. */
static void settle(struct profile *p, const struct vm *vm)
{
    const uint64_t allocated = heap_work(vm->heap);

    if (p->now) {
        const uint64_t calls = vm->work - p->seen, bytes = allocated >= p->allocated ? allocated - p->allocated : 0;
        p->now->calls += calls;
        p->all.calls += calls;
        p->now->bytes += bytes;
        p->all.bytes += bytes;
    }
    p->seen = vm->work;
    p->allocated = allocated;
}

static void on_instruction(lua_State *L, lua_Debug *ar)
{
    struct vm *vm = &vm_board(L)->vm;
    struct profile *p = vm->profile;

    settle(p, vm);
    p->now = find_line(p, L, ar);
    p->now->instructions++;
    p->all.instructions++;
    if (--vm->left == 0)
        vm_look(L, ar);
    p->seen = vm->work;
}

static void pause(struct vm *vm)
{
    settle(vm->profile, vm);
    vm->profile->now = NULL;
    vm->profile->source = NULL;
}

void vm_profile_turn(struct vm *vm, lua_State *L)
{
    pause(vm);
    lua_sethook(L, on_instruction, LUA_MASKCOUNT, 1);
}

void vm_profile_begin(struct vm *vm)
{
    pause(vm);
    vm->profile->seen = 0;
}

void board_profile(struct board *b, struct profile *p)
{
    if (b->vm.profile)
        pause(&b->vm);
    b->vm.profile = p;
    if (p) {
        p->now = NULL;
        pause(&b->vm);
    }
}
