/*
 * test_boss.c - bosses: what a phase is worth, and what loses it; last phases; the safe and the armoured part; casts
 * with one bar or one each; talks; the history of spells; what boss.def refuses. Every case is a script that writes a
 * log; with RAM spoilt after every frame it writes the same.
 */
#include "rig.h"

static const char game[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 4 } })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3, safe = 9 })\n"
    "enemy.def('e', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, hp = 5 })\n"
    "local sys, log = string.sys, {}\n"
    "local function say(...) for _, s in ipairs { ... } do log[#log + 1] = tostring(s) end end\n"
    "function string.told() return table.concat(log, ' ') end\n"
    "local function hit() local p = player.get(1)\n"
    "  bullet.fire { kind = 'dot', x = p.x, y = p.y, speed = 0 } end\n"
    "local function idle() wait(forever) end\n"
    "local function down(n) return function(e) wait(n) e.hp = 0 end end\n"
    "local function phase(t) local p = { id = 'a', hp = 10, time = 50, rest = 0, run = idle }\n"
    "  for k, v in pairs(t) do p[k] = v end return p end\n"
    "local function one(...) boss.def('b', { title = 'B', kind = 'e', x = 50, y = 40, phases = { ... } }) end\n"
    "local function two(...) boss.def('b', { title = 'B', phases = { ... }, cast = {\n"
    "  { name = 'iris', title = 'Iris', kind = 'e', x = 30, y = 40 },\n"
    "  { name = 'opal', title = 'Opal', kind = 'e', x = 90, y = 40 } } }) end\n"
    "local function alone(args) task.go(function() wait(1) say(boss.fight('b', args), board.frame()) end) end\n"
    "on.phase(function(e, id, won, captured) say(id, won, captured) end)\n"
    "sys.join(1, 'ship')\n"
    "local function points() return player.get(1).score end\n";

struct story {
    const char *name, *code;
    int frames;
    const char *log;
};

/* Of a boss alone: it flies in over 60 frames from frame 1 on. */
static const struct story stories[] = {
    { "a bonus is paid whole", "one(phase { bonus = 700, run = down(9) }) alone()", 90, "true 71 a true true" },
    { "a bonus goes down",
      "one(phase { bonus = 700, bonus_to = 200, run = down(10) }) alone()\n"
      "task.go(function() wait(85) say(points()) end)",
      99, "true 72 a true true 590" },
    { "to its end",
      "one(phase { bonus = 701, bonus_to = 200, survive = true, hp = nil }) alone()\n"
      "task.go(function() wait(125) say(points()) end)",
      130, "true 111 a true true 200" },
    { "a death loses it",
      "one(phase { bonus = 700, run = function(e) hit() wait(5) e.hp = 0 end }) alone()\n"
      "task.go(function() wait(85) say(points(), player.get(1).lives) end)",
      99, "true 67 a true false 0 1" },
    { "so does a bomb",
      "one(phase { bonus = 700, run = function(e) sys.emit('bomb', player.get(1), false) wait(5) e.hp = 0 end }) "
      "alone()\n"
      "task.go(function() wait(85) say(points(), player.get(1).lives) end)",
      99, "true 67 a true false 0 2" },
    { "of that phase alone",
      "one(phase { bonus = 700, run = function(e) hit() wait(5) e.hp = 0 end }, phase { id = 'c', bonus = 3, run = "
      "down(5) }) alone()\ntask.go(function() wait(95) say(points()) end)",
      99, "a true false true 73 c true true 3" },
    { "so does the time", "one(phase { bonus = 700 }) alone() task.go(function() wait(175) say(points()) end)", 180,
      "a false false false 171 0" },
    { "a background stands between phases that share it",
      "local made = 0 bg.def('hall', function() made = made + 1 end) bg.def('yard', function() end)\n"
      "task.go(function() bg.show('yard', { over = 0 }) end)\n"
      "local function p(bg) return phase { bg = bg, rest = 40, run = down(40) } end\n"
      "local l = {} for i, bg in ipairs { 'hall', 'hall', 'yard', 'hall' } do l[i] = p(bg) l[i].id = 'p' .. i end\n"
      "boss.def('b', { title = 'B', kind = 'e', x = 50, y = 40, phases = l }) alone()\n"
      "task.go(function() while true do wait(60) say(made) end end)",
      430, "0 p1 true true 1 1 p2 true true 1 p3 true true 1 true 345 p4 true true 2 2" },
    { "and the one that is shown",
      "local made = 0 bg.def('hall', function() made = made + 1 end)\n"
      "task.go(function() bg.show('hall', { over = 0 }) end)\n"
      "one(phase { bg = 'hall', run = down(40) }) alone() task.go(function() wait(200) say(made) end)",
      220, "true 102 a true true 1" },
    { "whose portrait a phase has: its own, its leader's, the boss's",
      "local c = { { name = 'a', title = 'A', kind = 'e', x = 40, y = 40 },\n"
      "  { name = 'b', title = 'B', kind = 'e', x = 60, y = 40, portrait = 'wink', portrait_left = true } }\n"
      "local l = { phase { hp = { b = 5 } }, phase { hp = { a = 5, b = 5 } }, phase { hp = 9 },\n"
      "  phase { hp = { b = 5 }, portrait = 'dot', portrait_left = false }, phase { hp = { b = 5 }, cut_in = false } "
      "}\n"
      "for i, p in ipairs(l) do p.id, p.spell = 'p' .. i, 'Sign' end\n"
      "boss.def('two', { title = 'T', portrait = 'arrow', cast = c, phases = l })\n"
      "boss.each(function(b) for _, p in ipairs(b.phases) do\n"
      "  say(p.portrait, p.portrait_left, p.cut_in) end end)",
      1, "wink true true arrow false true arrow false true dot false true wink true false" },
    { "a last phase", "one(phase { run = down(2) }, phase { id = 'l', last = true, run = down(2) }) alone()", 99,
      "a true true true 67 l true true" },
    { "is not there after a loss",
      "one(phase { time = 5 }, phase { id = 'b', run = down(2) }, phase { id = 'l', last = true }) alone()", 199,
      "a false false false 69 b true true" },
    { "and ends with a hit, which costs nothing",
      "one(phase { id = 'l', last = true, bonus = 5, run = function() hit() wait(forever) end }) alone()\n"
      "task.go(function() wait(130) say(points(), player.get(1).lives) end)",
      140, "l false false false 122 0 2" },
    { "a hit elsewhere does not",
      "one(phase { run = function(e) hit() wait(20) e.hp = 0 end }, phase { id = 'l', last = true, run = down(2) }) "
      "alone()",
      140, "a true false true 85 l true true" },
    { "the safe part",
      "one(phase { safe = 6, run = function(e) for i = 1, 8 do e:hurt(1) say(e.hp) wait(1) end end, "
      "time = 20 }) alone()",
      99, "10 10 10 10 10 10 9 8 a false false" },
    { "the armoured part",
      "one(phase { hp = 100, safe = 2, armour = 3, run = function(e) for i = 1, 7 do e:hurt(8) say(e.hp) wait(1) end "
      "e.hp "
      "= 0 end }, phase { id = 'c', hp = 100, run = function(e) e:hurt(8) say(e.hp, e.rate) e.hp = 0 end }) alone()",
      99, "100 100 98 96 94 86 78 92 1.0 a true true true 70 c true true" },
    { "and its end when the phase is over in it",
      "enemy.def('soft', { sprite = 'dot', hit = { circle = 3 }, rate = 2, touch = false }) boss.def('b', { title = "
      "'B', "
      "kind = 'soft', x = 50, y = 40, phases = { phase { hp = 100, armour = 30, rate = 0.5, run = function(e) "
      "e:hurt(8) "
      "say(e.hp) e.hp = 0 end }, phase { id = 'c', hp = 100, run = function(e) e:hurt(8) say(e.hp) e.hp = 0 end } } }) "
      "alone()",
      99, "92 84 a true true true 63 c true true" },
    { "a boss that wanders goes home",
      "one(phase { time = 15, rest = 9, run = function(e) e:wander { w = 80, h = 40, every = 3, over = 3 } end }, "
      "phase { "
      "id = 'o', time = 15, rest = 9, run = function(e) e:orbit { x = 90, y = 90, radius = 20, spin = 3 } end }, phase "
      "{ "
      "id = 'c', time = 2, run = function(e) say(e.x, e.y) end }) alone()\n"
      "task.go(function() wait(85) say(boss.status().team[1].x) end)",
      199, "a false false 50.0 o false false 50.0 40.0 c false false false 171" },
    { "talks",
      "local function talk(s) return { talk = function(e) say(s, e.alive, e.safe == forever) wait(3) end } end\n"
      "one(talk 'first', talk 'second', phase { run = down(2) }, talk 'between', phase { id = 'c', run = "
      "down(2) }, talk 'end') alone()",
      140, "first true true second true true a true true between true true c true true end true true true 86" },
    { "a talk of a last phase goes with it",
      "one(phase { time = 2 }, { talk = function() say 'no' end }, phase { id = 'l', last = true }, { talk = "
      "function() "
      "say 'end' end }) alone()",
      199, "a false false end false 125" },
    { "what a talk put goes",
      "one({ talk = function() sprite.put { sprite = 'dot', x = 9, y = 9 } wait(5) "
      "say(board.live 'sprites') end }, phase { run = function(e) say(board.live 'sprites') "
      "e.hp = 0 end }) alone()",
      99, "1 0 true 69 a true true" },
    { "the stage's clock",
      "stage.def('s', function() task.go(function() boss.fight('b') say(board.frame()) end) "
      "stage.at(70) say('at', board.frame()) wait(200) end)\n"
      "one(phase { run = down(3) }) stage.play('s', string.sys.scope())",
      199, "64 a true true at 134" },
    { "goes on",
      "stage.def('s', function() task.go(function() boss.fight('b', { clock = true }) say(board.frame()) end) "
      "stage.at(62) say('at', board.frame()) wait(200) end)\n"
      "one(phase { run = down(3) }) stage.play('s', string.sys.scope())",
      199, "at 62 64 a true true" },
    { "a warning comes before",
      "boss.def('b', { title = 'B', kind = 'e', x = 50, y = 40, warning = 30, phases = { phase "
      "{ run = function(e) say(board.frame()) e.hp = 0 end } } }) alone()",
      120, "91 true 92 a true true" },
};

/* Of two at once. */
static const struct story casts[] = {
    { "one bar for both",
      "two(phase { run = function(i, o) o:hurt(4) wait(1) say(i.hp, o.hp) i:hurt(3) o:hurt(2) wait(1) "
      "say(i.hp, o.hp) i:hurt(1) end }) alone()",
      99, "6 6 1 1 true 64 a true true" },
    { "more than it has", "two(phase { run = function(i, o) i:hurt(9) o:hurt(9) end }) alone()", 99,
      "true 62 a true true" },
    { "a bar each, all down",
      "two(phase { hp = { iris = 5, opal = 7 }, run = function(i, o) say(i.hp, o.hp) i:hurt(9) "
      "wait(1) say(i.safe == forever) wait(1) o:hurt(7) end }) alone()",
      99, "5 7 true true 64 a true true" },
    { "or any", "two(phase { hp = { iris = 5, opal = 7 }, down = 'any', run = function(i, o) o:hurt(7) end }) alone()",
      99, "true 62 a true true" },
    { "who has none is safe",
      "two(phase { hp = { iris = 5 }, run = function(i, o) say(o.safe == forever) o:hurt(50) "
      "wait(2) i:hurt(5) end }) alone()",
      99, "true true 64 a true true" },
    { "each runs until its bar is empty",
      "local function count(s) return function(e) while true do wait(1) say(s) e:hurt(s == 'i' and 2 or 1) end end "
      "end\n"
      "two(phase { hp = { iris = 4, opal = 4 }, run = { iris = count 'i', opal = count 'o' } }) alone()",
      99, "i o i o o o true 66 a true true" },
    { "what it spawned goes with it",
      "two(phase { hp = { iris = 4, opal = 4 }, run = { iris = function(e) sprite.put { sprite = 'dot', x = 9, y = 9 } "
      "wait(2) e.hp = 0 wait(forever) end, opal = function(e) wait(1) say(board.live 'sprites') wait(5) say(board.live "
      "'sprites') e.hp = 0 end } }) alone()",
      99, "1 0 true 68 a true true" },
    { "one that is taken away",
      "two(phase { hp = { iris = 4, opal = 4 }, run = function(i, o) wait(2) i:remove() wait(2) "
      "o:hurt(4) end }) alone()",
      99, "true 66 a true true" },
    { "both", "two(phase { run = function(i, o) wait(2) i:remove() o:remove() end }) alone()", 99,
      "false 64 a false false" },
    { "none can be hurt who lasts",
      "two(phase { survive = true, hp = nil, run = function(i, o) i:hurt(99) o:hurt(99) end })"
      " alone()",
      150, "true 111 a true true" },
    { "both go home, then leave",
      "two(phase { run = function(i, o) i.x, i.y, o.x = 5, 5, 5 end, rest = 9, time = 4 }, phase { id = 'c', time = 2, "
      "run "
      "= function(i, o) say(i.x, i.y, o.x, o.y) end }) alone()\n"
      "task.go(function() wait(130) say(enemy.count()) wait(10) say(enemy.count()) end)",
      150, "a false false 30.0 40.0 90.0 40.0 c false false 2 false 136 0" },
};

static struct rig_game g;
static struct rig r;

static void open_with(const char *code, const struct board_start *start)
{
    static char text[1 << 14];
    struct manifest m = rig_manifest();

    m.has_bodies = m.has_backgrounds = 1;
    snprintf(text, sizeof text, "%s%s", game, code);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, start);
}

static void close_it(void)
{
    rig_free(&r);
    rig_game_free(&g);
}

static void tell(const struct story *s, bool spoilt)
{
    open_with(s->code, NULL);
    for (int f = 0; f < s->frames; f++) {
        rig_run(&r, 1);
        if (spoilt) {
            rig_save(&r);
            rig_restore(&r);
        }
    }
    const char *got = rig_told(&r);
    if (strcmp(got, s->log))
        fail_msg("%s%s:\n     got %s\nexpected %s", s->name, spoilt ? ", spoilt" : "", got, s->log);
    close_it();
}

TEST(stories)
{
    for (size_t i = 0; i < sizeof stories / sizeof *stories; i++)
        for (int spoilt = 0; spoilt < 2; spoilt++)
            tell(&stories[i], spoilt);
}

TEST(casts)
{
    for (size_t i = 0; i < sizeof casts / sizeof *casts; i++)
        for (int spoilt = 0; spoilt < 2; spoilt++)
            tell(&casts[i], spoilt);
}

/* Tries and captures of spells, by difficulty and ship; a phase without a spell has none. */
TEST(history)
{
    static const char code[] =
        "player.def('other', { sprite = 'dot', hit = { circle = 2 } })\n"
        "one(phase { run = down(2) }, phase { id = 's', spell = 'S', run = down(2) }, phase { id = 'lost', spell = "
        "'L', "
        "time = 2 }) alone()\n"
        "task.go(function() wait(170)\n"
        "  say(boss.history('b', 'a')) say(boss.history('b', 's')) say(boss.history('b', 'lost'))\n"
        "  say(boss.history('b', 's', { ship = 'other' })) say(boss.history('b', 's', { ship = 'ship' }))\n"
        "  sys.leave(1) sys.join(1, 'other') boss.fight('b')\n"
        "  say(boss.history('b', 's')) say(boss.history('b', 's', { ship = 'other' })) end)\n";
    const char *all = "a true true s true true lost false false false 129 0 0 1 1 1 0 0 0 1 1 a true true s true true "
                      "lost false false 2 2 1 1";
    struct board_start practice = { .seed = 1, .difficulty = -1 };

    open_with(code, NULL);
    rig_run(&r, 330);
    assert_string_equal(rig_told(&r), all);
    close_it();
    snprintf(practice.practice.section, sizeof practice.practice.section, "b/a");
    open_with("one(phase { spell = 'S', run = down(2) }) stage.def('s', idle)\n"
              "task.go(function() wait(90) say(boss.history('b', 'a')) end)\n"
              "boot.run { stages = { 's' }, players = { 'ship' } }",
              &practice);
    rig_run(&r, 99);
    assert_string_equal(rig_told(&r), "a true true 0 0");
    assert_int_equal(r.b->nvram.s.live, 4); /* its magic alone */
    close_it();
}

/* In a talk nobody fires, and a stage's clock that goes on in the fight does so in its talks. */
TEST(talk)
{
    open_with("one({ talk = function() wait(20) end }, phase { run = down(9) })\n"
              "stage.def('s', function() task.go(function() boss.fight('b', { clock = true }) end) stage.at(75) "
              "say('at', board.frame()) wait(99) end) stage.play('s', string.sys.scope())",
              NULL);
    rig_run(&r, 59);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_run(&r, 10);
    assert_int_not_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_run(&r, 15);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
    assert_string_equal(rig_told(&r), "at 75");
    close_it();
}

/* A phase alone, of a cast with a warning and talks: none of these, again and again. */
TEST(practice)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .practice = { .section = "b/c" } };

    open_with("boss.def('b', { title = 'B', warning = 50, cast = {\n"
              "  { name = 'iris', title = 'Iris', kind = 'e', x = 30, y = 40 },\n"
              "  { name = 'opal', title = 'Opal', kind = 'e', x = 90, y = 40 } }, phases = { phase {},\n"
              "  { talk = function() say 'talk' end }, phase { id = 'c', last = true, hp = { opal = 9 }, run = {\n"
              "    opal = function(e) say(board.frame(), e.x, e.hp) wait(3) e:hurt(9) end } },\n"
              "  { talk = function() say 'end' end } } })\n"
              "stage.def('s', idle) boot.run { stages = { 's' }, players = { 'ship' } }",
              &start);
    rig_run(&r, 150);
    assert_string_equal(rig_told(&r), "60 90.0 9 c true true 125 90.0 9 c true true");
    close_it();
}

static void says(const char *code, const char *line)
{
    struct rig_game played;
    static char text[1 << 14];

    snprintf(text, sizeof text, "%s%s", game, code);
    rig_with_sys(&played, NULL, text);
    const char *got = rig_said(&played, 200, false);
    if (strcmp(got, line))
        fail_msg("%s:\n     got %s\nexpected %s", code, got, line);
    rig_game_free(&played);
}

TEST(errors)
{
    says("one()", "boss.def: phases: expected at least one phase");
    says("one({ talk = idle })", "boss.def: phases: expected at least one phase");
    says("one(phase {}, phase {})", "boss.def: duplicate phase \"a\"");
    says("one(phase { hp = 'x' })",
         "boss.def: phase \"a\": hp: expected a whole number from 1 to 2147483647, got \"x\"");
    says("one(phase { hp = { iris = 3 } })",
         "boss.def: phase \"a\": hp: expected a whole number from 1 to 2147483647, got a table");
    says("one(phase { armor = 3 })", "boss.def phase \"a\": unknown argument \"armor\" (did you mean \"armour\"?)");
    says("one(phase { safe = 2.5 })",
         "boss.def phase \"a\": safe: expected a whole number from 0 to 65535 frames, got 2.5");
    says("one(phase { armour = 9 })", "boss.def: armour: disabled; add `bodies = true` to `board` in rom.lua");
    says("one(phase { bonus = 5, bonus_to = 7 })", "boss.def: phase \"a\": bonus_to: 7 is greater than `bonus` (5)");
    says("one(phase { spell = 'S', cut_in = true })",
         "boss.def: phase \"a\": `cut_in` requires a portrait (`portrait = SPRITE`)");
    says("one(phase { portrait = 'none' })", "boss.def phase \"a\": unknown sprite \"none\" (declare it in rom.lua)");
    says("one({ talk = 3 }, phase {})", "boss.def talk: talk: expected a function, got 3");
    says("one({ talk = idle, id = 'x' }, phase {})", "boss.def talk: unknown argument \"id\" (arguments: talk)");
    says("one({ talk = idle }, { hp = 5 })", "boss.def phase \"#2\": id: expected a string, got nil");
    says("one(phase { music = 'x' })", "boss.def phase \"a\": unknown music \"x\" (declare it in rom.lua)");
    says("one(3)", "boss.def phase \"#1\": expected a table of named arguments, got 3");
    says("two(phase { hp = { irs = 3 } })",
         "boss.def: phase \"a\": hp: no member of the cast is named \"irs\" (did you mean \"iris\"?)");
    says("two(phase { hp = { iris = 0 } })",
         "boss.def: phase \"a\": hp: iris: expected a whole number from 1 to 2147483647, got 0");
    says("two(phase { hp = {} })", "boss.def: phase \"a\": hp: expected { NAME = value }, got {}");
    says("two(phase { hp = { 5, 6 } })",
         "boss.def: phase \"a\": hp: expected { NAME = value } with names from the cast");
    says("two(phase { run = { opal = 5 } })", "boss.def: phase \"a\": run: opal: expected a function, got 5");
    says("two(phase { down = 'one' })", "boss.def phase \"a\": down: expected all or any, got \"one\"");
    says("boss.def('b', { title = 'B', kind = 'e', x = 5, y = 5, cast = {}, phases = { phase {} } })",
         "boss.def: kind: set it on each member of the cast instead");
    says(
        "boss.def('b', { title = 'B', cast = { { name = 'i', title = 'I', kind = 'e', x = 5, y = 5 } }, phases = {} })",
        "boss.def: cast: expected at least two members, got 1");
    says("boss.def('b', { title = 'B', x = 5, y = 5, phases = { phase {} } })",
         "boss.def: kind: expected a name, got nil");
    says("one(phase {}) alone() alone()",
         "boss.fight: boss \"b\": \"b\" is still fighting; for two bosses at once, declare one with "
         "`cast = { .. }`");
    says("one(phase {}) task.go(function() boss.history('b', 'aa') end)",
         "boss.history: unknown phase \"aa\" (did you mean \"a\"?)");
    says("one(phase {}) task.go(function() boss.history('b', 'a', { difficulty = 'norml' }) end)",
         "boss.history: unknown difficulty \"norml\" (did you mean \"normal\"?)");
    says("one(phase {}) alone { clok = true }", "boss.fight: unknown argument \"clok\" (did you mean \"clock\"?)");
}

RUN_TESTS(NULL, NULL)
