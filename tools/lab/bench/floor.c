/*
 * floor.c - of section "prices": what scripts cost beside what Lua itself takes for the like, in turns.
 *
 * Beside each scene runs a Lua without an engine, in a heap of the same kind, its collector stopped in a frame and
 * stepped after it, as on a board. It runs the same lines; functions of the API and properties are C functions that do
 * nothing, so what it takes no binding can save.
 */
#include <lauxlib.h>
#include <lua.h>
#include <stdlib.h>
#include "../../../src/base/heap.h"
#include "bench.h"

enum { N = 4096, ROUNDS = 25, FRAMES = 8, HEAP = 16 << 20 };

static void *allocate(void *heap, void *p, size_t old, size_t size)
{
    return heap_realloc(heap, p, p ? old : 0, size);
}

static int nothing(lua_State *L)
{
    (void)L;
    return 0;
}

static int number(lua_State *L)
{
    lua_pushinteger(L, 1);
    return 1;
}

static int wait(lua_State *L)
{
    return lua_yield(L, 0);
}

/* each(f): f of so many numbers. */
static int each(lua_State *L)
{
    for (int i = 1; i <= N; i++) {
        lua_pushvalue(L, 1);
        lua_pushinteger(L, i);
        lua_call(L, 1, 0);
    }
    return 0;
}

/* tasks(f): makes as many coroutines of it, kept in the registry. */
static int tasks(lua_State *L)
{
    for (int i = 1; i <= N; i++) {
        lua_State *co = lua_newthread(L);
        lua_rawseti(L, LUA_REGISTRYINDEX, 100 + i);
        lua_pushvalue(L, 1);
        lua_xmove(L, co, 1);
    }
    return 0;
}

static void resume_all(lua_State *L)
{
    int results;

    for (int i = 1; i <= N; i++) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, 100 + i);
        lua_State *co = lua_tothread(L, -1);
        lua_pop(L, 1);
        if (lua_resume(co, L, 0, &results) != LUA_YIELD)
            report_fail("a bare task ended");
        lua_pop(co, results);
    }
}

/* What is beside a scene: lines that return the function of a frame; or none, and the tasks are resumed. */
static const struct pair {
    const char *price, *what, *lines;
} PAIRS[] = {
    { "fire", "`bullet.fire` with a table of seven fields",
      "local n, fire = ... return function() for i = 1, n do fire { kind = 'd8', x = i % 64 * 4, y = i // 64 % 16, "
      "dir = 7 * i, speed = 0.001, tag = 'all', motion = 5 } end end" },
    { "each", "`bullet.each` with a function that writes one property",
      "local n, fire, each = ... return function() each(function(b) b.bank = 3 end) end" },
    { "task", "a task that wakes in every frame",
      "local n, fire, each, wait, tasks = ... tasks(function() while true do wait(1) end end)" },
};
enum { COUNT = sizeof PAIRS / sizeof *PAIRS };

static struct run {
    struct scene scene;
    lua_State *L;
    void *block;
    struct samples engine, bare;
} runs[COUNT];

static void open_bare(struct run *r, const char *lines)
{
    r->block = aligned_alloc(64, HEAP);
    struct heap *heap = r->block ? heap_init(r->block, HEAP) : NULL;

    r->L = heap ? lua_newstate(allocate, heap) : NULL;
    if (!r->L)
        report_fail("out of memory");
    lua_gc(r->L, LUA_GCINC, 100, 400, 13);
    lua_gc(r->L, LUA_GCSTOP);
    lua_pushinteger(r->L, 0);
    lua_createtable(r->L, 0, 1);
    lua_pushcfunction(r->L, nothing);
    lua_setfield(r->L, -2, "__newindex");
    lua_setmetatable(r->L, -2);
    lua_settop(r->L, 0);
    if (luaL_loadstring(r->L, lines) != LUA_OK)
        report_fail(lua_tostring(r->L, -1));
    lua_pushinteger(r->L, N);
    lua_pushcfunction(r->L, number);
    lua_pushcfunction(r->L, each);
    lua_pushcfunction(r->L, wait);
    lua_pushcfunction(r->L, tasks);
    lua_call(r->L, 5, 1);
}

static void bare_frame(struct run *r)
{
    if (lua_isfunction(r->L, 1)) {
        lua_pushvalue(r->L, 1);
        lua_call(r->L, 0, 0);
    } else {
        resume_all(r->L);
    }
    lua_gc(r->L, LUA_GCSTEP, 1);
}

static void slice(struct run *r, bool counts)
{
    for (int f = 0; f < FRAMES; f++) {
        double from = bench_now();
        bench_tick(&r->scene);
        if (counts && f > 0) /* the first fetches its memory into the caches */
            samples_add(&r->engine, bench_since(from));
    }
    for (int f = 0; f < FRAMES; f++) {
        double from = bench_now();
        bare_frame(r);
        if (counts && f > 0)
            samples_add(&r->bare, bench_since(from));
    }
}

void floor_prices(void)
{
    for (int i = 0; i < COUNT; i++) {
        bench_scene(&runs[i].scene,
                    &(struct scene_want){ .does = "prices", .price = PAIRS[i].price, .n = N, .bullets = N });
        open_bare(&runs[i], PAIRS[i].lines);
    }
    bench_own_clock(true);
    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < COUNT; i++)
            slice(&runs[i], round >= 0);
    bench_own_clock(false);
    report_text(
        "**Lua's minimum.** No binding can be faster than Lua itself. The table shows the nanoseconds for each of %s "
        "calls or tasks, in the engine and in plain Lua. In plain Lua, the API's functions and properties do nothing.",
        report_count(N));
    report_table(NULL, "script | engine> | Lua only> | ratio>");
    for (int i = 0; i < COUNT; i++) {
        struct run *r = &runs[i];
        report_row(false, PAIRS[i].what, samples_figure(&r->engine, N),
                   report_string("%s", samples_figure(&r->bare, N)),
                   report_figure(samples_median(&r->engine) / samples_median(&r->bare)), NULL);
        samples_free(&r->engine);
        samples_free(&r->bare);
        lua_close(r->L);
        free(r->block);
        scene_close(&r->scene);
    }
    report_table_end();
}
