/*
 * test_values.c - numbers that a game declares: in fire, spawn and patterns, as properties of one and of a group, their
 * room, their names in a trace, through a snapshot.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static struct manifest with_values(int bullet, int shot, int enemy)
{
    struct manifest m = rig_manifest();

    m.bullet_values = bullet;
    m.shot_values = shot;
    m.enemy_values = enemy;
    return m;
}

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

#define KINDS                                                                                                          \
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"                                                    \
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"                                                     \
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"

/* Its asserts are the test. */
static void holds(const struct manifest *m, const char *text, int frames)
{
    rig_script(&g, m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, frames);
    end();
}

static void test_use(void **state)
{
    struct manifest m = with_values(2, 1, 1);

    (void)state;
    holds(&m,
          KINDS
          "value.def('heat', { start = 2.5 }) value.def('goal')\n"
          "value.def('heat', { of = 'shot', start = -1 }) value.def('anger', { of = 'enemy' })\n"
          "task.go(function()\n"
          "  local b = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }\n"
          "  local c = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0, goal = 7, heat = -32768, tag = 't' }\n"
          "  assert(b.heat == 2.5 and b.goal == 0 and c.heat == -32768 and c.goal == 7)\n"
          "  local s = shot.fire { kind = 'bolt', x = 9, y = 9, speed = 0 } assert(s.heat == -1)\n"
          "  local e = enemy.spawn { kind = 'foe', x = 9, y = 9, anger = 32767 } assert(e.anger == 32767)\n"
          "  b.heat = 1 / 65536 assert(b.heat == 1 / 65536 and c.heat == -32768)\n"
          "  bullet.group('t').goal = 3 assert(b.goal == 0 and c.goal == 3)\n"
          "  bullet.group().goal = 4 assert(b.goal == 4 and c.goal == 4)\n"
          "  pattern.ring { kind = 'dot', x = 50, y = 50, n = 5, speed = 0, heat = 9, tag = 'r' }\n"
          "  local n = 0 bullet.each('r', function(d) n = n + d.heat end) assert(n == 45)\n"
          "  pattern.ring { kind = 'dot', x = 50, y = 50, n = 2, speed = 0, heat = 9, tag = 'q',\n"
          "    each = function(a, i) a.goal = i bullet.fire(a) end }\n"
          "  n = 0 bullet.each('q', function(d) n = n + d.goal end) assert(n == 3)\n"
          "  c:remove() assert(c.heat == nil) c.heat = 3\n"
          "  local d = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } assert(d.heat == 2.5 and d.goal == 0)\n"
          "end)\n",
          3);
    /* board.reset: they are declared anew */
    holds(&m,
          KINDS
          "value.def('heat', { start = board.frame() > 0 and 3 or 2 })\n"
          "task.go(function() wait(2)\n"
          "  local b = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }\n"
          "  assert(b.heat == (board.frame() > 5 and 3 or 2)) wait(5) if board.frame() < 9 then board.reset() end\n"
          "end)\n",
          20);
}

static void refused(const struct manifest *m, const char *code, const char *message)
{
    static char text[2048];

    snprintf(text, sizeof text, "%s%s", KINDS, code);
    rig_script(&g, m, text);
    rig_power_any(&rig, &g, NULL);
    if (!rig_fault(&rig))
        board_tick(rig.b, (const uint16_t[PADS]){ 0 });
    if (!rig_fault(&rig))
        fail_msg("%s: no fault", code);
    if (!strstr(rig_fault(&rig)->message, message))
        fail_msg("%s: expected \"%s\", got \"%s\"", code, message, rig_fault(&rig)->message);
    end();
}

static void test_errors(void **state)
{
    struct manifest none = with_values(0, 0, 0), few = with_values(1, 0, 1), all = with_values(4, 4, 4);

    (void)state;
    refused(&none, "value.def('heat')",
            "value.def: \"heat\" needs room in rom.lua: board = { values = { bullet = 1 } }");
    refused(&few, "value.def('a') value.def('b')", "\"b\" needs room in rom.lua: board = { values = { bullet = 2 } }");
    refused(&few, "value.def('b', { of = 'shot' })", "board = { values = { shot = 1 } }");
    refused(&all, "for i = 1, 5 do value.def('v' .. i) end", "\"v5\" is one too many: there are at most 4 of a bullet");
    refused(&all, "value.def('heat') value.def('heat')", "\"heat\" is declared already");
    for (const char *const *name = (const char *const[]){ "speed", "tag", "aim", "remove", "alive", "frozen", "from",
                                                          "delay", "each", "sweep", "count", NULL };
         *name; name++) {
        char code[60];
        snprintf(code, sizeof code, "value.def('%s')", *name);
        refused(&all, code, "is taken: a bullet and bullet.fire use it");
    }
    refused(&all, "value.def('hp', { of = 'enemy' })", "is taken: an enemy and enemy.spawn use it");
    refused(&all, "value.def('a b')", "name: expected a word of letters, digits and _, got \"a b\"");
    refused(&all, "value.def('1st')", "name: expected a word");
    refused(&all, "value.def('a', { of = 'sprite' })",
            "of: expected \"bullet\", \"shot\" or \"enemy\", got \"sprite\"");
    refused(&all, "value.def('a', { start = 32768 })", "start: expected a number from -32768 to 32767, got 32768");
    refused(&all, "task.go(function() value.def('a') end)", "value.def: only while scripts load");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0, heat = 1e9 }",
            "bullet.fire: heat: expected a number from -32768 to 32767");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0, heet = 1 }",
            "unknown argument \"heet\" (did you mean \"heat\"?)");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0 }.heat = 'x'",
            "bullet: heat: expected a number from -32768 to 32767, got \"x\"");
    refused(&all, "value.def('heat') print(bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0 }.heet)",
            "did you mean \"heat\"?");
    refused(&all, "value.def('heat') print(bullet.group().heat)", "heat cannot be read of a group");
    refused(&all, "value.def('heat') shot.fire { kind = 'bolt', x = 1, y = 1, speed = 0, heat = 1 }",
            "shot.fire: unknown argument \"heat\"");
}

/* What a trace calls a column. */
static void note(void *context, const struct slots_value *v)
{
    if (v->slot == 1 && !strcmp(v->column, "heat"))
        *(int64_t *)context = (int32_t)v->value;
    assert_string_not_equal(v->column, "value1");
}

static void test_state(void **state)
{
    struct manifest m = with_values(1, 1, 1);
    int64_t seen = 0;

    (void)state;
    rig_script(&g, &m,
               KINDS "value.def('heat', { start = 2 }) value.def('heat', { of = 'shot' }) value.def('anger', { of = "
                     "'enemy' })\n"
                     "task.go(function() while true do\n"
                     "  bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0, heat = board.frame() } wait(1)\n"
                     "end end)\n");
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 4);
    for (int i = 0; i < PARTS; i++)
        if (machine_parts[i].chip == &bullets_chip)
            board_trace(rig.b, i, note, &seen);
    assert_int_equal(seen, FX_ONE);
    uint64_t hash = board_hash(rig.b);
    void *copy = malloc(board_snapshot_size(rig.b));
    board_save(rig.b, copy);
    rig.b->bullets.value1[1]++;
    assert_true(board_hash(rig.b) != hash);
    rig.b->bullets.value_start[0] = 0;
    board_restore(rig.b, copy);
    assert_true(board_hash(rig.b) == hash && rig.b->bullets.value_start[0] == 2 * FX_ONE);
    free(copy);
    end();
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_use), cmocka_unit_test(test_errors),
                                        cmocka_unit_test(test_state) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
