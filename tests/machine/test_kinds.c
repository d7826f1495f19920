/*
 * test_kinds.c - what a kind of bullets says of its looks and of clears. test_crowd paints spin, order and frames anew.
 */
#include "rig.h"

static const char kinds[] =
    "spark.def('ping', { sprite = 'dot', life = 300 })\n"
    "spark.def('pong', { sprite = 'wink', life = 300 })\n"
    "bullet.def('plain', { sprite = 'dot', hit = { circle = 4 } })\n"
    "bullet.def('gone', { sprite = 'dot', hit = { circle = 4 }, vanish = 'ping', cloud = 'wink' })\n"
    "bullet.def('fixed', { sprite = 'dot', hit = { circle = 4 }, clearable = false, vanish = 'ping', cloud = 'wink' "
    "})\n"
    "local function fire(kind, x, delay)\n"
    "  return bullet.fire { kind = kind, x = x, y = 50, speed = 0, tag = kind, delay = delay }\n"
    "end\n"
    "local function many() for x = 10, 50, 10 do fire('plain', x) fire('gone', x) fire('fixed', x) end end\n"
    "local function count() return bullet.group().count end\n"
    "string.good = 0\n";

/* Runs the task, whose assertions must hold to its end. Sparks of the first and the second kind are counted. */
static void holds(const char *task, int pings, int pongs)
{
    static char text[4096];
    struct rig_game g;
    struct rig r;
    int seen[2] = { 0 };

    snprintf(text, sizeof text, "%s\ntask.go(function() %s string.good = 1 end)\n", kinds, task);
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 100);
    lua_getglobal(r.b->vm.L, "string");
    lua_getfield(r.b->vm.L, -1, "good");
    if (lua_tointeger(r.b->vm.L, -1) != 1)
        fail_msg("%s: it did not come to its end", task);
    EACH_LIVE (i, &r.b->sparks.s)
        seen[r.b->sparks.kind[i]]++;
    if (seen[0] != pings || seen[1] != pongs)
        fail_msg("%s: %d and %d sparks, expected %d and %d", task, seen[0], seen[1], pings, pongs);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(clear)
{
    holds("many() assert(bullet.clear() == 10 and count() == 5)", 5, 0);
    holds("many() assert(bullet.clear { spark = 'pong' } == 10 and count() == 5)", 0, 10);
    holds("many() assert(bullet.clear { all = true } == 15 and count() == 0)", 10, 0);
    holds("many() assert(bullet.clear { all = false } == 10)", 5, 0);
    holds("many() assert(bullet.clear { all = true, spark = 'pong' } == 15)", 0, 15);
    holds("many() assert(bullet.clear { tag = 'fixed' } == 0 and bullet.clear { tag = 'fixed', all = true } == 5)", 5,
          0);
    holds("many() assert(bullet.clear { x = 10, y = 50, radius = 12 } == 4)", 2, 0);
    holds("many() assert(bullet.clear { x = 10, y = 50, radius = 0, all = true } == 3)", 2, 0);
    holds("many() bullet.group():remove() assert(count() == 0)", 0, 0);
    holds("fire('fixed', 10):remove() fire('gone', 10):remove() assert(count() == 0)", 0, 0);
    holds("local b = fire('fixed', 10) b.kind = 'plain' assert(bullet.clear() == 1)", 0, 0);
    holds("fire('plain', 10).kind = 'fixed' assert(bullet.clear() == 0 and count() == 1)", 0, 0);
}

/* A delayed bullet is cleared as its kind says, not as its cloud. */
TEST(delayed)
{
    holds("fire('fixed', 10, 30) fire('gone', 20, 30) fire('plain', 30, 30) wait(5)\n"
          "assert(bullet.clear() == 2 and count() == 1) wait(40) assert(count() == 1)",
          1, 0);
    holds("fire('fixed', 10, 30) wait(5) assert(bullet.clear { all = true } == 1)", 1, 0);
}

/* The end of a phase takes all, and leaves the kinds' sparks. */
TEST(phase)
{
    static const char text[] = "enemy.def('foe', { sprite = 'dot', hit = { circle = 4 } })\n"
                               "bullet.def('fixed', { sprite = 'dot', hit = 'none', clearable = false })\n"
                               "boss.def('one', { title = 'One', kind = 'foe', x = 50, y = 50, phases = {\n"
                               "  { id = 'a', hp = 10, time = 60, rest = 40, run = function(e)\n"
                               "    bullet.fire { kind = 'fixed', x = 9, y = 9, speed = 0 }\n"
                               "    wait(20) bullet.clear() wait(forever) end } } })\n"
                               "task.go(function() boss.fight('one') end)\n";
    struct rig_game g;
    struct rig r;
    bool was = false;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    for (int f = 0; f < 400; f++) {
        rig_run(&r, 1);
        was |= r.b->bullets.s.live == 1 && r.b->core.clock - r.b->bullets.born[0] > 30;
    }
    assert_true(was);
    assert_int_equal(r.b->bullets.s.live, 0);
    rig_free(&r);
    rig_game_free(&g);
}

/* Two on one place: which of them is seen? */
static uint8_t seen(const char *a, const char *b)
{
    static char text[1024];
    struct rig_game g;
    struct rig r;

    snprintf(
        text, sizeof text,
        "bullet.def('a', { sprite = 'dot', hit = 'none', bank = 1 %s })\n"
        "bullet.def('b', { sprite = 'dot', hit = 'none', bank = 2 %s })\n"
        "bullet.fire { kind = 'b', x = 50, y = 50, speed = 0 } bullet.fire { kind = 'a', x = 50, y = 50, speed = 0 }",
        a, b);
    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    rig_picture(&r);
    uint8_t pixel = r.fb.pix[50 * r.fb.pitch + 51];
    assert_true(pixel % 16 != 0);
    rig_free(&r);
    rig_game_free(&g);
    return pixel / 16;
}

TEST(order)
{
    assert_int_equal(seen("", ""), 2);
    assert_int_equal(seen(", order = 1", ""), 1);
    assert_int_equal(seen(", order = -99", ", order = -100"), 1);
    assert_int_equal(seen(", order = 7", ", order = 7"), 2);
    assert_int_equal(seen(", order = 7", ", order = 8"), 2);
}

TEST(errors)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, "bullet.def('a', { sprite = 'dot', hit = 'none', spin = 3 })");
    rig_power_any(&r, &g, NULL);
    assert_non_null(rig_fault(&r));
    assert_string_equal(
        rig_fault(&r)->message,
        "main.lua:1: bullet.def: spin: sprite \"dot\" has no rotations (add `rotations` to it in rom.lua)");
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
