/*
 * test_run.c - the demo of the built-in game goes from the title through every part of the game to the score table, and
 * a practised stage starts again as it started first.
 */
#include <lauxlib.h>
#include "rig.h"
#include "../../tools/tally.h"

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
    struct rig_game g;
    struct rig r;
    struct demo d = { 0 };
    struct tally t = { 0 };
    struct nv_row rows[NV_MAX_ROWS];
    char err[256], title[64];
    unsigned phases = 0;

    rig_folder(&g, "glasstide");
    assert_true(demo_load(&d, "tests/demos/glasstide/clear-normal.demo", err, sizeof err));
    assert_true(d.complete);
    assert_string_equal(d.start.practice.section, "");
    rig_power(&r, &g, &d.start);
    const int to_beat = nvram_get_rows(&r.b->nvram, "normal", NULL, rows);
    while (board_frame(r.b) < d.frames) {
        uint16_t pads[MAX_PLAYERS];
        demo_pads(&d, board_frame(r.b), pads);
        tally_before(&t, r.b);
        rig_tick(&r, pads);
        tally_after(&t, r.b);
        int left = boss_left(r.b, title, sizeof title);
        if (left >= 0)
            phases |= 1u << (left + (strstr(title, "Queen") ? 0 : 8));
    }
    assert_int_equal(phases & 15, 15); /* all four of the boss */
    assert_true(phases >> 8);          /* the midboss */
    assert_true(t.kills > 0 && t.grazes > 0 && t.deaths > 0);
    assert_int_equal(nvram_get_rows(&r.b->nvram, "normal", NULL, rows), to_beat + 1); /* a name was entered */
    assert_true(rows[0].score > 0);
    demo_free(&d);
    rig_close(&r);
}

/* What the round before started has ended. A ship that stands still and shoots does not survive one. */
TEST(practice_rounds)
{
    struct rig_game g;
    struct rig r;
    struct board_start start = { .difficulty = -1, .practice.section = "one" };
    const uint16_t pads[MAX_PLAYERS] = { PAD_FIRE, 0 };
    uint32_t tasks[3], shots[3], rounds = 0, since = 0;

    rig_folder(&g, "glasstide");
    rig_power(&r, &g, &start);
    for (uint32_t f = 0; f < 6000 && rounds < 3; f++) {
        rig_tick(&r, pads);
        since = r.b->player.in_game[0] ? since + 1 : 0;
        if (since == 60) {
            tasks[rounds] = r.b->tasks.s.live;
            shots[rounds++] = r.b->shots.s.live;
        }
    }
    assert_int_equal(rounds, 3);
    for (int i = 1; i < 3; i++) {
        assert_int_equal(tasks[i], tasks[0]);
        assert_int_equal(shots[i], shots[0]);
    }
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
