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

TEST(use)
{
    struct manifest m = with_values(2, 1, 1);

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
          "  shot.group().heat = 6 enemy.group().anger = 2 assert(s.heat == 6 and e.anger == 2)\n"
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
        board_tick(rig.b, (const uint16_t[MAX_PLAYERS]){ 0 });
    if (!rig_fault(&rig))
        fail_msg("%s: no fault", code);
    if (!strstr(rig_fault(&rig)->message, message))
        fail_msg("%s: expected \"%s\", got \"%s\"", code, message, rig_fault(&rig)->message);
    end();
}

TEST(errors)
{
    struct manifest none = with_values(0, 0, 0), few = with_values(1, 0, 1), all = with_values(4, 4, 4);

    refused(&none, "value.def('heat')",
            "value.def: \"heat\": too few value columns; set `values = { bullet = 1 }` in `board` in rom.lua");
    refused(&few, "value.def('a') value.def('b')",
            "\"b\": too few value columns; set `values = { bullet = 2 }` in `board` in rom.lua");
    refused(&few, "value.def('b', { of = 'shot' })", "set `values = { shot = 1 }` in `board`");
    refused(&all, "for i = 1, 5 do value.def('v' .. i) end", "\"v5\": too many values (at most 4 for a bullet)");
    refused(&all, "value.def('heat') value.def('heat')", "\"heat\" is already declared");
    for (const char *const *name = (const char *const[]){ "speed", "tag", "aim", "remove", "alive", "frozen", "from",
                                                          "delay", "each", "sweep", "count", NULL };
         *name; name++) {
        char code[60];
        snprintf(code, sizeof code, "value.def('%s')", *name);
        refused(&all, code,
                "is already a property or a method of a bullet, or an argument of bullet.fire or a pattern");
    }
    refused(&all, "value.def('hp', { of = 'enemy' })",
            "is already a property or a method of an enemy, or an argument of enemy.spawn");
    refused(&all, "value.def('a b')", "name: expected a word of letters, digits and _, got \"a b\"");
    refused(&all, "value.def('1st')", "name: expected a word");
    refused(&all, "value.def('a', { of = 'sprite' })",
            "of: expected \"bullet\", \"shot\" or \"enemy\", got \"sprite\"");
    refused(&all, "value.def('a', { start = 32768 })", "start: expected a number from -32768 to 32767, got 32768");
    refused(&all, "task.go(function() value.def('a') end)", "value.def: can only be called while scripts load");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0, heat = 1e9 }",
            "bullet.fire: heat: expected a number from -32768 to 32767");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0, heet = 1 }",
            "unknown argument \"heet\" (did you mean \"heat\"?)");
    refused(&all, "value.def('heat') bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0 }.heat = 'x'",
            "bullet: heat: expected a number from -32768 to 32767, got \"x\"");
    refused(&all, "value.def('heat') print(bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0 }.heet)",
            "did you mean \"heat\"?");
    refused(&all, "value.def('heat') print(bullet.group().heat)", "heat cannot be read from a group");
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

TEST(state)
{
    struct manifest m = with_values(1, 1, 1);
    int64_t seen = 0;

    rig_script(&g, &m,
               KINDS "value.def('heat', { start = 2 }) value.def('heat', { of = 'shot' }) value.def('anger', { of = "
                     "'enemy' })\n"
                     "task.go(function() while true do\n"
                     "  bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0, heat = board.frame() } wait(1)\n"
                     "end end)\n");
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 4);
    for (int i = 0; i < PART_COUNT; i++)
        if (machine_parts[i].chip == &bullets_chip)
            board_trace(rig.b, i, note, &seen);
    assert_int_equal(seen, FX_ONE);
    uint64_t hash = board_hash(rig.b);
    void *copy = malloc(board_snapshot_size(rig.b));
    board_save(rig.b, copy);
    rig.b->bullets.value1[1]++;
    assert_true(board_hash(rig.b) != hash);
    rig.b->bullets.initial_value[0] = 0;
    board_restore(rig.b, copy);
    assert_true(board_hash(rig.b) == hash && rig.b->bullets.initial_value[0] == 2 * FX_ONE);
    free(copy);
    end();
}

/* A program with names does what one with their numbers does, in every frame; what becomes of a value in the middle of
 * a step does not matter to that step. */
TEST(steps)
{
    static const char text[] =
        KINDS "for _, of in ipairs { 'bullet', 'shot' } do\n"
              "  if of == 'shot' then value.def('spare', { of = of }) end\n"
              "  for _, name in ipairs { 'a', 'b', 'len' } do value.def(name, { of = of }) end\n"
              "end\n"
              "local shapes = {\n"
              "  function(a, b, n) return { { turn = a, over = n }, { speed = b } } end,\n"
              "  function(a, b, n) return { { speed = b, over = n }, { accel = b, over = n } } end,\n"
              "  function(a, b, n) return { { dir = a, bank = n }, { wait = n }, { turn = a, speed = b } } end,\n"
              "  function(a, b, n) return { { aim = true, home = a, over = n }, { turn = b, accel = b, speed = b, over "
              "= n } } end,\n"
              "  function(a, b, n) return { { loop = 3, { wait = n }, { turn = a, over = n } }, { die = true } } end,\n"
              "  function(a, b, n) return { fine = true, { speed = b, turn = a, over = n }, { accel = b } } end,\n"
              "}\n"
              "local named = {}\n"
              "for i, f in ipairs(shapes) do named[i] = motion.def(f('a', 'b', 'len')) end\n"
              "local function number(most) return math.floor(rng.number(-most, most) * 65536) / 65536 end\n"
              "task.go(function()\n"
              "  for run = 1, 60 do\n"
              "    for i, f in ipairs(shapes) do\n"
              "      local a, b, n = number(run % 5 == 0 and 32767 or 180), number(6), rng.int(1, 15)\n"
              "      if i == 4 then a = math.abs(number(180)) end\n"
              "      local fire = run % 2 == 0 and bullet.fire or shot.fire\n"
              "      local t = { kind = run % 2 == 0 and 'dot' or 'bolt', x = 120, y = 150, dir = 30, speed = 1 }\n"
              "      local before = board.live('motions')\n"
              "      t.motion = motion.def(f(a, b, n)) local one = fire(t)\n"
              "      t.motion, t.a, t.b, t.len = named[i], a, b, n + (run % 3) / 4 local two = fire(t)\n"
              "      for k = 1, 20 do\n"
              "        wait(1)\n"
              "        assert(one.alive == two.alive, i)\n"
              "        if one.alive then\n"
              "          for _, p in ipairs { 'x', 'y', 'dir', 'speed', 'vx', 'vy', 'bank' } do\n"
              "            assert(one[p] == two[p], ('%d %d %s: %.9f %.9f'):format(i, k, p, one[p], two[p]))\n"
              "          end\n"
              "          if k == n - 1 and i <= 2 then two.a, two.len = 99, 99 two.a, two.len = a, n end\n"
              "          if k < n and i == 1 then two.a = k if k == n - 1 then two.a = a end end\n"
              "        end\n"
              "      end\n"
              "      bullet.group():remove() if one.alive then one:remove() end if two.alive then two:remove() end\n"
              "    end\n"
              "  end\n"
              "  board.note('done')\n"
              "end)\n";
    struct manifest m = with_values(3, 4, 0);

    m.motions = 512;
    rig_script(&g, &m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 60 * 6 * 20);
    assert_int_equal(rig.b->core.note_digest != 0, 0);
    rig_run(&rig, 2);
    assert_int_equal(rig.b->core.note_digest != 0, 1);
    end();
    /* one program for all; a kind of thing without the value has 0; a value below 1 is one frame */
    holds(&m,
          KINDS "value.def('swift')\n"
                "local p = motion.def { { speed = 'swift', over = 'swift' }, { wait = forever } }\n"
                "task.go(function()\n"
                "  for i = 1, 40 do bullet.fire { kind = 'dot', x = 50, y = 50, speed = 0, swift = i / 8, motion = "
                "motion.def {\n"
                "    { speed = 'swift', over = 'swift' }, { wait = forever } }, tag = 't' .. i } end\n"
                "  local s = shot.fire { kind = 'bolt', x = 50, y = 50, speed = 3, motion = p }\n"
                "  assert(board.live 'motions' == 1)\n"
                "  wait(1) assert(s.speed == 0)\n"
                "  for i = 1, 12 do bullet.each('t' .. i, function(b) assert(b.speed == i / 8) end) end\n"
                "end)\n",
          5);
    refused(&m, "value.def('swift') motion.def { { wait = 1 }, { speed = 'swfit' } }",
            "motion.def: step 2: speed: unknown value \"swfit\" (did you mean \"swift\"?)");
    refused(&m, "motion.def { { speed = 'x' } }",
            "step 1: speed: expected a number or the name of a value (value.def), got \"x\"");
    refused(&m, "value.def('swift') motion.def { { aim = 'swift' } }", "aim: expected true or false");
    refused(&m, "value.def('swift') motion.def { { dir = 'swift', over = 3 } }", "`dir` takes effect immediately");
}

RUN_TESTS(NULL, NULL)
