/*
 * test_values.c - numbers that a game declares: their names in a trace, hashes, snapshots and a reset. Scripts see them
 * in tests/scripts/values.lua.
 */
#include "rig.h"

/* What a trace calls a column. */
static void note(void *context, const struct slots_value *v)
{
    if (v->slot == 1 && !strcmp(v->column, "heat"))
        *(int64_t *)context = (int32_t)v->value;
    assert_string_not_equal(v->column, "value1");
}

TEST(state)
{
    static const char text[] = "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
                               "value.def('heat', { start = 2 })\n"
                               "task.go(function() while board.frame() < 9 do\n"
                               "  bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0, heat = board.frame() } wait(1)\n"
                               "end board.reset() end)\n";
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    int64_t seen = 0;

    m.bullet_values = 1;
    rig_script(&g, &m, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 4);
    for (int i = 0; i < PART_COUNT; i++)
        if (machine_parts[i].chip == &bullets_chip)
            board_trace(r.b, i, note, &seen);
    assert_int_equal(seen, FX_ONE);
    uint64_t hash = board_hash(r.b);
    rig_save(&r);
    r.b->bullets.value1[1]++;
    assert_true(board_hash(r.b) != hash);
    r.b->bullets.initial_value[0] = 0;
    rig_restore(&r);
    assert_true(board_hash(r.b) == hash && r.b->bullets.initial_value[0] == 2 * FX_ONE);
    rig_run(&r, 8); /* through the reset, in which they are declared again */
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
