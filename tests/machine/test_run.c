/*
 * test_run.c - the demos of the built-in game show what they are there to show: the attract demo is long enough, and
 * the whole run goes from the title through every part of the game to the score table. And two runs that must fail, do.
 */
#include <lauxlib.h>
#include "../test.h"
#include "../../src/demo/demo.h"
#include "../../src/workbench/pack/pack.h"
#include "../../tools/tally.h"

struct game {
    struct rom_image image;
    struct cart cart;
    void *ram;
    struct board *b;
};

static void power(struct game *g, const struct board_start *start)
{
    char err[256];
    size_t size;

    assert_true(pack_load_game("roms/glasstide", false, &g->image, err, sizeof err));
    assert_true(cart_open(&g->cart, &g->image.rom, err, sizeof err));
    assert_true(board_size(&g->image.rom, &size, err, sizeof err));
    g->ram = aligned_alloc(64, (size + 63) / 64 * 64);
    g->b = board_power_on(g->ram, size, &g->image.rom, start, err, sizeof err);
    assert_non_null(g->b);
    assert_null(board_last_output(g->b)->fault);
}

static void drop(struct game *g)
{
    free(g->ram);
    rom_image_free(&g->image);
}

/* What the boss on the field is and how many phases it has left, from boss.status(); -1: none is fighting. */
static int boss_left(struct board *b, char *title, size_t size)
{
    lua_State *L = b->vm.L;
    int left = -1;

    lua_getglobal(L, "boss");
    lua_getfield(L, -1, "status");
    assert_int_equal(lua_pcall(L, 0, 1, 0), LUA_OK);
    if (lua_istable(L, -1)) {
        lua_getfield(L, -1, "boss");
        lua_getfield(L, -1, "title");
        snprintf(title, size, "%s", lua_tostring(L, -1));
        lua_getfield(L, -3, "left");
        left = (int)lua_tointeger(L, -1);
    }
    lua_settop(L, 0);
    return left;
}

TEST(whole_run)
{
    struct game g;
    struct demo d = { 0 };
    struct tally t = { 0 };
    struct nv_row rows[NV_MAX_ROWS];
    char err[256], title[64];
    unsigned phases = 0, stages = 0;

    assert_true(demo_load(&d, "tests/demos/glasstide/clear-normal.demo", err, sizeof err));
    assert_true(d.complete);
    assert_string_equal(d.start.practice.section, "");
    power(&g, &d.start);
    assert_int_equal(nvram_get_rows(&g.b->nvram, "normal", NULL, rows), 0);
    while (board_frame(g.b) < d.frames) {
        uint16_t pads[MAX_PLAYERS];
        demo_pads(&d, board_frame(g.b), pads);
        tally_before(&t, g.b);
        assert_null(board_tick(g.b, pads)->fault);
        tally_after(&t, g.b);
        stages |= g.b->player.in_game[0] ? 1u : 0;
        int left = boss_left(g.b, title, sizeof title);
        if (left >= 0)
            phases |= 1u << (left + (strstr(title, "Queen") ? 0 : 8));
    }
    print_message("# %llu fired, %u at once, %llu kills, %llu grazes, %llu deaths, phases %x\n",
                  (unsigned long long)t.fired, t.most, (unsigned long long)t.kills, (unsigned long long)t.grazes,
                  (unsigned long long)t.deaths, phases);
    assert_true(stages);
    assert_int_equal(phases & 15, 15); /* all four of the boss */
    assert_true(phases >> 8);          /* the midboss */
    assert_true(t.fired >= 5000);
    assert_true(t.most >= 100);
    assert_true(t.kills >= 100);
    assert_true(t.grazes >= 50);
    assert_true(t.deaths >= 1);
    assert_true(nvram_get_rows(&g.b->nvram, "normal", NULL, rows) > 0); /* a name was entered */
    assert_true(rows[0].score > 0);
    demo_free(&d);
    drop(&g);
}

TEST(attract)
{
    struct demo d = { 0 };
    char err[256];

    assert_true(demo_load(&d, "roms/glasstide/demos/attract.demo", err, sizeof err));
    assert_true(d.complete && d.fault == FAULT_NONE);
    assert_true(d.frames >= 30 * 60);
    demo_free(&d);
}

/* Who stands still and shoots is out of the game before the midboss; who only flies about never clears the stage. */
TEST(standing_still)
{
    struct game g;
    struct board_start start = { .difficulty = -1, .practice.section = "one" };
    const uint16_t pads[MAX_PLAYERS] = { PAD_FIRE, 0 };
    uint32_t f = 0;

    power(&g, &start);
    while (f < 60 * 60 && !(f > 60 && !g.b->player.in_game[0])) {
        assert_null(board_tick(g.b, pads)->fault);
        f++;
    }
    print_message("# out after %u frames\n", f);
    assert_true(f < 60 * 60);
    drop(&g);
}

/* Each round of a practice start is like the first: what the round before started has ended. */
TEST(practice_rounds)
{
    struct game g;
    struct board_start start = { .difficulty = -1, .practice.section = "one" };
    const uint16_t pads[MAX_PLAYERS] = { PAD_FIRE, 0 };
    uint32_t tasks[3], shots[3], rounds = 0, since = 0;

    power(&g, &start);
    for (uint32_t f = 0; f < 6000 && rounds < 3; f++) {
        assert_null(board_tick(g.b, pads)->fault);
        since = g.b->player.in_game[0] ? since + 1 : 0;
        if (since == 60) {
            tasks[rounds] = g.b->tasks.s.live;
            shots[rounds++] = g.b->shots.s.live;
        }
    }
    assert_int_equal(rounds, 3);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(tasks[i], tasks[0]);
        assert_int_equal(shots[i], shots[0]);
    }
    drop(&g);
}

TEST(never_shooting)
{
    struct game g;
    struct board_start start = { .difficulty = -1, .practice.section = "one" };
    const uint16_t pads[MAX_PLAYERS] = { 0, 0 };
    char title[64];
    bool crab = false;

    power(&g, &start);
    for (uint32_t f = 0; f < 25000; f++) {
        g.b->player.safe_left[0] = 100; /* nothing can hit it: only shooting is missing */
        assert_null(board_tick(g.b, pads)->fault);
        bool fights = boss_left(g.b, title, sizeof title) >= 0 && strstr(title, "Crab");
        crab |= fights;
        for (uint32_t i = 0; i < g.b->fix.s.live; i++) /* the banner of a stage's end */
            assert_false(crab && i + 5 <= g.b->fix.s.live && !memcmp(g.b->fix.code + i, "CLEAR", 5));
    }
    assert_true(crab);
    drop(&g);
}

RUN_TESTS(NULL, NULL)
