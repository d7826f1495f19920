/*
 * test_scenes.c - a stage that is over while its results are shown, and a board without free tasks.
 * tests/scripts/scenes.lua has what despawns with a boss's phase.
 */
#include "rig.h"

/* Plays a game for that many frames; START is pressed in the 8th and the 11th, for the title and its menu. */
static void play(struct rig *r, struct rig_game *g, const char *stage, int frames)
{
    const uint16_t none[MAX_PLAYERS] = { 0 }, start[MAX_PLAYERS] = { PAD_START };
    struct manifest m = rig_manifest();
    static char text[1 << 11];

    m.players = 1;
    snprintf(text, sizeof text,
             "player.def('ship', { sprite = 'dot', hit = { circle = 1 } })\n"
             "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
             "enemy.def('foe', { sprite = 'dot', hit = 'none' })\n"
             "stage.def('s', function()\n%send)\n"
             "boot.run { stages = { 's' }, players = { 'ship' }, continues = 1 }\n",
             stage);
    rig_with_sys(g, &m, text);
    rig_power(r, g, NULL);
    for (int f = 0; f < frames; f++)
        rig_tick(r, f == 7 || f == 11 ? start : none);
}

/* The stage's tasks and enemies end with it; its sprites stay behind the results, which have a plate. */
TEST(results)
{
    struct rig_game g;
    struct rig r;

    play(&r, &g,
         "  sprite.put { sprite = 'dot', x = 9, y = 9 }\n"
         "  local function run()\n"
         "    while true do\n"
         "      bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }\n"
         "      wait(1)\n"
         "    end\n"
         "  end\n"
         "  task.go(run)\n"
         "  enemy.spawn { kind = 'foe', x = 9, y = 9, run = run }\n"
         "  wait(20)\n",
         90);
    assert_int_equal(r.b->sprites.s.live, 2);
    assert_int_equal(r.b->bullets.s.live, 0);
    assert_int_equal(r.b->enemies.s.live, 0);
    rig_close(&r);
}

/* The screen that offers a continue takes a scope and a task: without room for both the game is not frozen. */
TEST(frozen)
{
    for (int room = 0; room <= 2; room++) {
        char stage[256];
        struct rig_game g;
        struct rig r;
        snprintf(stage, sizeof stage,
                 "  local all = {}\n"
                 "  repeat all[#all + 1] = task.go(wait, forever) until not all[#all].alive\n"
                 "  for i = 1, %d do task.stop(all[#all - i]) end\n"
                 "  wait(20) string.sys.leave(1) wait(forever)\n",
                 room);
        play(&r, &g, stage, 90);
        assert_int_equal(r.b->core.frozen != 0, room == 2);
        assert_int_equal(r.b->core.clock < r.b->core.frame, room == 2);
        rig_close(&r);
    }
}

RUN_TESTS(NULL, NULL)
