/*
 * test_order.c - where board.reset and an extend come within a frame. tests/scripts/order.lua has what else a game may
 * rely on within a frame.
 */
#include "rig.h"

/* As after power-on, but frames and nvram continue, and so does what the frame printed. */
TEST(reset)
{
    static const char text[] = "print('load')\n"
                               "local n = save.get('n', 0)\n"
                               "save.set('n', n + 1)\n"
                               "task.go(function()\n"
                               "  wait(3)\n"
                               "  if n == 0 then board.reset() print('last') end\n"
                               "  wait(forever)\n"
                               "end)\n";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;
    uint32_t changed;
    size_t size;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 3);
    const struct board_out *out = board_tick(r.b, none);
    assert_null(out->fault);
    assert_int_equal(out->log_size, 10);
    assert_memory_equal(out->log, "last\nload\n", 10);
    assert_int_equal(board_frame(r.b), 4);
    assert_int_equal(r.b->core.clock, 0);
    assert_int_equal(nvram_get(&r.b->nvram, "n").bits, 2);
    board_nvram(r.b, &size, &changed);
    assert_int_equal(changed, 2);
    rig_run(&r, 9);
    rig_close(&r);
}

/* The life is there at once; on.extend is told in the same frame, after scripts. */
TEST(extend)
{
    static const char text[] = "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 1 })\n"
                               "on.extend(function(p) print('extend', p.lives) end)\n"
                               "string.sys.join(1, 'ship')\n"
                               "task.go(function()\n"
                               "  for _, points in ipairs { 999, 1, 100000 } do\n"
                               "    score.add(points, 1)\n"
                               "    print(player.get(1).lives)\n"
                               "    wait(1)\n"
                               "  end\n"
                               "end)\n";
    struct manifest m = rig_manifest();
    struct rig_game g;

    m.n_extends = 2;
    m.extends[0] = 1000;
    m.extends[1] = 50000;
    rig_with_sys(&g, &m, text);
    assert_string_equal(rig_said(&g, 3, false), "0\n1\nextend\t1\n2\nextend\t2\n");
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
