/*
 * test_boss.c - bosses that are practised, and the buttons of players during a talk. tests/scripts/boss.lua tests
 * everything that a script sees.
 */
#include "rig.h"

static const char definitions[] =
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3 })\n"
    "enemy.def('e', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, hp = 5 })\n"
    "local function phase(t) t.id, t.time, t.rest = t.id or 'a', 50, 0 return t end\n"
    "local function idle() wait(forever) end\n"
    "local function down(e) wait(2) e.hp = 0 end\n"
    "on.phase(function(e, id, won, captured) print(id, won, captured) end)\n"
    "stage.def('s', idle)\n";

static struct rig_game g;
static struct rig r;

static int end(void **state __attribute__((unused)))
{
    rig_close(&r);
    return 0;
}

static void power(const char *code, const char *section)
{
    static char text[1 << 13];
    struct board_start start = { .seed = 1, .difficulty = -1 };

    snprintf(text, sizeof text, "%s%s", definitions, code);
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    rig_with_sys(&g, NULL, text);
    rig_power(&r, &g, &start);
}

static void expect_output(int frames, const char *want)
{
    char got[512] = "";

    for (int f = 0; f < frames; f++) {
        rig_run(&r, 1);
        const struct board_out *out = board_last_output(r.b);
        strncat(got, out->log, out->log_size);
    }
    assert_string_equal(got, want);
}

/* Nobody fires in a talk. */
TEST(talk)
{
    power("boss.def('b', { title = 'B', kind = 'e', x = 50, y = 40, phases = {\n"
          "  { talk = function() wait(20) end }, phase { hp = 10, run = idle } } })\n"
          "string.sys.join(1, 'ship') task.go(function() wait(1) boss.fight('b') end)",
          "");
    rig_run(&r, 59);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_run(&r, 10);
    assert_int_not_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_run(&r, 15);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
}

/* A phase alone, of a cast with a warning and talks: none of these, again and again. */
TEST(practice)
{
    power(
        "boss.def('b', { title = 'B', warning = 50, cast = {\n"
        "  { name = 'iris', title = 'Iris', kind = 'e', x = 30, y = 40 },\n"
        "  { name = 'opal', title = 'Opal', kind = 'e', x = 90, y = 40 } }, phases = { phase { hp = 10, run = idle },\n"
        "  { talk = function() print 'talk' end }, phase { id = 'c', last = true, hp = { opal = 9 }, run = {\n"
        "    opal = function(e) print(board.frame(), e.x, e.hp) wait(3) e:hurt(9) end } },\n"
        "  { talk = function() print 'end' end } } })\n"
        "boot.run { stages = { 's' }, players = { 'ship' } }",
        "b/c");
    expect_output(230, "61\t90.0\t9\nc\ttrue\ttrue\n203\t90.0\t9\nc\ttrue\ttrue\n");
}

/* Practice does not count in the history of spells. */
TEST(history)
{
    power(
        "boss.def('b', { title = 'B', kind = 'e', x = 50, y = 40, phases = { phase { hp = 10, spell = 'S', run = down }"
        " } })\n"
        "task.go(function() wait(90) print(boss.history('b', 'a')) end)\n"
        "boot.run { stages = { 's' }, players = { 'ship' } }",
        "b/a");
    expect_output(99, "a\ttrue\ttrue\n0\t0\n");
    assert_int_equal(r.b->nvram.s.live, 4); /* its magic alone */
}

RUN_TESTS_EACH(NULL, end)
