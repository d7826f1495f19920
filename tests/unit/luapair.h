/*
 * luapair.h - two Lua states for tests: one with the stock libraries untouched, one with lualib.h's.
 */
#ifndef TESTS_LUAPAIR_H
#define TESTS_LUAPAIR_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
#include "../../src/base/rng.h"
#include "../../src/script/lua/lualib.h"
#include "../../src/machine/machine.h"
#include "../../src/script/vm.h"

enum { HEAP = 64 << 20 };

struct pair {
    lua_State *stock, *ours;
    struct board *b;
    void *block;
    struct rng rng;
    uint64_t spent; /* of the tick's work when a chunk starts */
};

static int open_ours(lua_State *L)
{
    lualib_open(L);
    assert_int_equal(lua_gettop(L), 0);
    return 0;
}

static int setup(void **state)
{
    struct pair *p = calloc(1, sizeof *p);

    p->b = calloc(1, sizeof *p->b);
    p->b->output = calloc(1, sizeof *p->b->output);
    p->b->tasks.current = NO_SLOT;
    p->block = aligned_alloc(4096, HEAP);
    assert_true(vm_open(p->b, p->block, HEAP));
    p->ours = p->b->vm.L;
    lua_pushcfunction(p->ours, open_ours);
    assert_int_equal(lua_pcall(p->ours, 0, 0, 0), LUA_OK);
    p->stock = luaL_newstate();
    luaL_openlibs(p->stock);
    rng_seed(&p->rng, 1);
    *state = p;
    return 0;
}

static int teardown(void **state)
{
    struct pair *p = *state;

    lua_close(p->stock);
    free(p->block);
    free(p->b->output);
    free(p->b);
    free(p);
    return 0;
}

#endif
