/*
 * test_told.c - what a script is told, and what it is not: writes to what is read only, registers at 0, names that are
 * kept for later, two fights at once, waits where there can be none, and nil for all.
 */
#include "../../src/script/api/api_parts.h"
#include "rig.h"
#include "../../src/script/api/eval.h"

static const char kinds[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } }) shot.def('bolt', { sprite = 'dot', hit = { circle = 3 "
    "} }) "
    "enemy.def('wall', { sprite = 'dot', hit = { circle = 9 }, hp = 9 }) enemy.def('foe', { sprite = 'dot', hit = "
    "'none', hp = 9 }) spark.def('glow', { sprite = 'dot', life = 9 }) item.def('gem', { sprite = 'dot', radius = 3 }) "
    "laser.def('ray', { strip = 'dot', width = 4, hit = 'none' }) "
    "option.def('bead', { sprite = 'dot', run = function(o) string.bead = o end }) "
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { power = 3 }, options = { kind = 'bead', "
    "levels = { { wide = { { 9, 9 } } } } } }) "
    "string.route = path.def { { x = 9, y = 9 }, { wait = 999 } }\n";

static struct rig_game g;
static struct rig rig;

/* What a script says in so many frames. */
static const char *said(const char *script, int frames)
{
    struct manifest m = rig_manifest();

    m.items = m.lines = m.lasers = 8;
    m.curve_points = 64;
    m.options = 4;
    rig_with_sys(&g, &m, script);
    const char *all = rig_said(&g, frames, true);
    rig_game_free(&g);
    return all;
}

/* Of `text` from line 2 of main.lua on, as a task, with player 1 in the game. */
static const char *says(const char *text)
{
    char script[4096];

    snprintf(
        script, sizeof script,
        "%slocal sys, p = string.sys, player.get(1) sys.join(1, 'ship') task.go(function() p = player.get(1) %s end)",
        kinds, text);
    return said(script, 200);
}

#define SAYS(text, words) assert_string_equal(says(text), words)

/* ---- read only ---- */

/* A thing of each kind. */
static const char *const made[HANDLE_KINDS] = {
    NULL,
    "bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }",
    "shot.fire { kind = 'bolt', x = 9, y = 9, speed = 0 }",
    "enemy.spawn { kind = 'foe', x = 9, y = 9 }",
    "player.get(1)",
    "sprite.put { sprite = 'dot', x = 9, y = 9 }",
    "task.go(function() wait(forever) end)",
    "motion.def { { wait = 1 } }",
    "bullet.group('t')",
    "shot.group('t')",
    "enemy.group('t')",
    "(function() item.drop { kind = 'gem', x = 9, y = 9 } return query.near { what = 'item', x = 9, y = 9, radius = 1 "
    "}[1] end)()",
    "item.group('t')",
    "text.line { x = 9, y = 9, text = 'words' }",
    [H_LASER] = "laser.beam { kind = 'ray', x = 9, y = 9, length = 5, hold = forever }",
    [H_LASERS] = "laser.group('t')",
    [H_OPTION] = "string.bead",
};

TEST(read_only)
{
    int seen = 0;
    for (int k = 1; k < HANDLE_KINDS; k++) {
        const struct api_thing *t = api_table.things[k];
        char text[300], want[200];
        if (!made[k]) /* what is of backgrounds has nothing that is read only */
            continue;
        for (int i = -1; i < t->n; i++) {
            const char *name = i < 0 ? "alive" : t->props[i].name;
            if (i < 0 ? k == H_MOTION || k == H_LAYER || k == H_PLANE || handle_kind_is_group((enum handle_kind)k)
                      : t->props[i].access & PROP_WRITE)
                continue;
            snprintf(text, sizeof text, "wait(2) local t = %s t.%s = 1", made[k], name);
            snprintf(want, sizeof want, "main.lua:2: %s: %s is read-only", t->name, name);
            SAYS(text, want);
            seen++;
        }
    }
    assert_int_equal(seen, 53);
    SAYS("local b = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } b:remove() b.alive = true",
         "main.lua:2: bullet: alive is read-only");
    SAYS("task.scope().alive = false", "main.lua:2: task: alive is read-only");
    SAYS("p.bomb = 3", "main.lua:2: player: bomb is a method; call it with a colon, thing:bomb(...)");
    SAYS("local e = enemy.spawn { kind = 'foe', x = 9, y = 9 } e.kill = print",
         "main.lua:2: enemy: kill is a method; call it with a colon, thing:kill(...)");
    SAYS("bullet.group('t').alive = false", "main.lua:2: a group has no property \"alive\"");
    SAYS("p.alve = false", "main.lua:2: a player has no property \"alve\" (did you mean \"alive\"?)");
    SAYS("rom.title = 'x'", "main.lua:2: rom.title is read-only");
    SAYS("rom.field.w = 3", "main.lua:2: rom.field.w is read-only");
    SAYS("rom.new = 3", "main.lua:2: rom.new is read-only");
    SAYS("print(bullet.group('t').age)", "main.lua:2: group: age cannot be read from a group (only `count` can)");
    SAYS("print(bullet.group('t').speed)", "main.lua:2: group: speed cannot be read from a group (only `count` can)");
}

/* ---- registers ---- */

TEST(registers)
{
    SAYS("p.power = -5 print(p.power) p.power = 2 p.power = p.power - 3 print(p.power) p.power = p.power - 1.0 "
         "print(p.power) "
         "p.power = math.mininteger print(p.power) p.power = 2147483647 print(p.power)",
         "0\n0\n0\n0\n2147483647\n");
    SAYS("p.power = -2.5", "main.lua:2: player: power: expected a whole number from 0 to 2147483647, got -2.5");
    SAYS("p.power = 2147483648",
         "main.lua:2: player: power: expected a whole number from 0 to 2147483647, got 2147483648");
    SAYS("p.power = '-5'", "main.lua:2: player: power: expected a whole number from 0 to 2147483647, got \"-5\"");
    SAYS("score.add(-5, p) print(p.score) score.add(3, p) score.add(-9, p) print(p.score)", "0\n0\n");
    SAYS("p.lives = -1", "main.lua:2: player: lives: expected a whole number from 0 to 99, got -1");
    rig_script(&g, NULL, "player.def('a', { sprite = 'dot', hit = { circle = 1 }, registers = { power = -1 } })");
    rig_power_any(&rig, &g, NULL);
    assert_non_null(rig_fault(&rig));
    assert_string_equal(
        rig_fault(&rig)->message,
        "main.lua:1: player.def: registers.power: expected a whole number from 0 to 2147483647, got -1");
    rig_free(&rig);
    rig_game_free(&g);
}

/* ---- names for later ---- */

TEST(later)
{
    SAYS("sound.play('x')",
         "main.lua:2: sound: sound is disabled; add `sounds = { ... }` or `music = { ... }` in rom.lua");
    SAYS("local f = optn", "main.lua:2: undeclared global \"optn\" (did you mean \"on\"?)");
    SAYS("local f = test", "main.lua:2: undeclared global \"test\" (test is reserved for a later version)");
    SAYS("print(board.test, on[1], text.lines)", "nil\tnil\tnil\n");
    SAYS("board.test = print board.test('mine')", "mine\n");
    SAYS("bullet.fier {}",
         "main.lua:2: attempt to call a nil value (field 'fier') (did you mean bullet.fire or shot.fire?)");
    SAYS("bullet.dfe()", "main.lua:2: attempt to call a nil value (field 'dfe')"); /* too many are called def */
    SAYS("talk.sya()", "main.lua:2: attempt to call a nil value (field 'sya') (did you mean say?)");
    SAYS("text.printed()", "main.lua:2: attempt to call a nil value (field 'printed')");
    SAYS("hud.center(3, 'a')",
         "main.lua:2: attempt to call a nil value (field 'center') (did you mean score.enter or hud.centre?)");
    SAYS("hud.banner('GO', 60)", "main.lua:2: hud.banner: lines: expected a list of strings such as { \"GO\" }");
    SAYS("hud.banner({ 'GO' })", "main.lua:2: hud.banner: frames: expected a whole number");
    SAYS("hud.centre('a', 3)", "main.lua:2: hud.centre: row: expected a whole number, got a");
    SAYS("menu.choose { 'a', 'b' }",
         "main.lua:2: menu.choose: items: expected a list of strings, as in { items = { \"YES\", \"NO\" }, row = 12 }");
    SAYS("menu.choose { items = { 'a' } }", "main.lua:2: menu.choose: row: expected a whole number, got nil");
    SAYS("sprite.put('dot', 10, 20)",
         "main.lua:2: sprite.put: expected a table of named arguments (sprite.put { ... }), got 3 arguments");
    SAYS("local s = sprite.put { sprite = 'dot', x = 1, y = 2 } s.z = 4", "main.lua:2: a sprite has no property \"z\"");
    SAYS("bullet.group().clear(7)", "main.lua:2: group:clear: call it on a thing with a colon, as in thing:name()");
    SAYS("bullet.group().clear(player.get(1))",
         "main.lua:2: group:clear: self: expected group, got a player (call it with a colon)");
    SAYS("board.difficulty('esay')", "main.lua:2: board.difficulty: unknown difficulty \"esay\" (in rom.lua: normal)");
    SAYS("board.dip('coin')", "main.lua:2: board.dip: unknown DIP switch \"coin\" (in rom.lua: none)");
    SAYS("board.live('bulets')", "main.lua:2: board.live: unknown pool \"bulets\" (did you mean \"bullets\"?)");
    SAYS("palette.load('dusk')", "main.lua:2: palette.load: unknown palette \"dusk\" (in rom.lua: main, other)");
    SAYS("say('Hello')", "main.lua:2: say: expected a speaker and a text; for no speaker, write say(nil, \"Hello\")");
    SAYS("choose('a', 'b')", "main.lua:2: choose: list: expected a list of strings, as in choose { \"YES\", \"NO\" }");
    SAYS("pattern.ring { kind = 'dot', x = 9, y = 9, speed = 1, n = 3, delay = 3, needle = 1 }",
         "main.lua:2: pattern.ring: unknown argument \"needle\" (arguments: n, skip, fire, each, kind, speed, x, y, "
         "from, dx, dy, "
         "dir, aim, bank, tag, motion, delay, around)");
}

static bool has_global(const char *name)
{
    const size_t n = strlen(name);

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const char *entry = api_get_entry(&api_table, i)->name;
        if (!strncmp(entry, name, n) && (!entry[n] || entry[n] == '.'))
            return true;
    }
    return false;
}

/* No reserved global exists: the error would be wrong. */
TEST(none_is_there)
{
    char word[32];
    int n = 0;

    for (const char *names = api_reserved_globals; *names; names += strspn(names, " "), n++) {
        const size_t length = strcspn(names, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, names);
        names += length;
        if (has_global(word))
            fail_msg("reserved global %s exists", word);
        assert_true(api_is_reserved(word));
    }
    assert_true(n > 0);
    assert_true(has_global("bullet"));
    assert_true(has_global("wait"));
    assert_false(has_global("bull"));
    assert_false(api_is_reserved("bullet"));
    assert_false(api_is_reserved(""));
    assert_false(api_is_reserved("te"));
    assert_false(api_is_reserved("est"));
}

/* A chip's names are off until rom.lua gives it room. */
TEST(off)
{
    struct manifest m;

    manifest_set_defaults(&m);
    assert_string_equal(api_disabled_reason(&m, "item"), "items are disabled; add `items = 512` to `board`");
    assert_string_equal(api_disabled_reason(&m, "items"), "items are disabled; add `items = 512` to `board`");
    assert_null(api_disabled_reason(&m, "ite"));
    assert_null(api_disabled_reason(&m, "bullet"));
    assert_string_equal(api_disabled_reason(&m, "text.line"), "text lines are disabled; add `lines = 32` to `board`");
    assert_null(api_disabled_reason(&m, "line"));
    m.lines = 1;
    assert_null(api_disabled_reason(&m, "text.line"));
    assert_string_equal(api_disabled_reason(&m, "laser"), "lasers are disabled; add `lasers = 64` to `board`");
    assert_string_equal(api_disabled_reason(&m, "laser.curve"),
                        "curved lasers are disabled; add `curve_points = 2048` to `board`");
    m.lasers = 1;
    assert_null(api_disabled_reason(&m, "laser"));
    m.curve_points = 1;
    assert_null(api_disabled_reason(&m, "laser.curve"));
    m.items = 1;
    assert_null(api_disabled_reason(&m, "item"));
    assert_null(api_disabled_reason(&m, "items"));
}

/* What is off says which line of rom.lua switches it on. */
TEST(off_says)
{
    static const char *const uses[][2] = {
        { "local i = item", "item" },
        { "on.take(print)", "on.take" },
        { "bullet.def('b', { sprite = 'dot', hit = 'none' }) bullet.clear { items = 'gem' }", "bullet.clear: items" },
        { "bullet.def('b', { sprite = 'dot', hit = 'none' }) bullet.group():clear { items = 'gem' }",
          "group:clear: items" },
        { "query.near { what = 'item', x = 9, y = 9, radius = 3 }", "query.near: what" },
        { "enemy.def('e', { sprite = 'dot', hit = 'none', drops = { gem = 3 } })", "enemy.def: drops" },
        { "player.def('p', { sprite = 'dot', hit = { circle = 2 }, magnet = 3 })", "player.def: magnet" },
    };
    struct board_start start = { .difficulty = -1 };

    for (size_t i = 0; i < sizeof uses / sizeof *uses; i++) {
        char want[200];
        rig_script(&g, NULL, uses[i][0]);
        rig_power_any(&rig, &g, &start);
        snprintf(want, sizeof want, "main.lua:1: %s: items are disabled; add `items = 512` to `board` in rom.lua",
                 uses[i][1]);
        assert_non_null(rig_fault(&rig));
        assert_string_equal(rig_fault(&rig)->message, want);
        rig_free(&rig);
        rig_game_free(&g);
    }
}

/* ---- two fights ---- */

#define QUEEN                                                                                                          \
    "boss.def('queen', { title = 'Q', kind = 'foe', x = 50, y = 50, phases = { { id = 'a', hp = 9, time = 40, rest = " \
    "0, run = function(e) wait(forever) end } } })\n"                                                                  \
    "boss.def('king', { title = 'K', kind = 'foe', x = 60, y = 50, phases = { { id = 'a', hp = 9, time = 9, rest = "   \
    "0, "                                                                                                              \
    "run = function(e) wait(forever) end } } })\n"

/* Of a whole script. */
static const char *script_says(const char *text)
{
    char script[4096];

    snprintf(script, sizeof script, "%s%s", kinds, text);
    return said(script, 600);
}

TEST(fights)
{
    assert_string_equal(
        script_says(QUEEN "task.go(function() boss.fight 'queen' end)\n"
                          "task.go(function() wait(70)\n"
                          "  boss.fight 'king' end)\n"),
        "main.lua:6: boss.fight: boss \"king\": \"queen\" is still fighting; for two bosses at once, declare one with "
        "`cast = { .. }`");
    assert_string_equal(
        script_says(QUEEN "task.go(function() boss.fight 'queen' end)\n"
                          "task.go(function()\n"
                          "  boss.fight 'queen' end)\n"),
        "main.lua:6: boss.fight: boss \"queen\": \"queen\" is still fighting; for two bosses at once, declare one with "
        "`cast = { .. }`");
    /* one after the other; and after one whose task was stopped, in the same frame and later */
    assert_string_equal(script_says(QUEEN "task.go(function() print(boss.fight 'queen', boss.fight 'king') end)\n"),
                        "false\tfalse\n");
    for (int wait = 0; wait < 2; wait++) {
        char text[1024];
        snprintf(text, sizeof text,
                 QUEEN "local t = task.go(function() boss.fight 'queen' end)\n"
                       "task.go(function() wait(70) task.stop(t) wait(%d) print(boss.fight 'king') end)\n",
                 wait);
        assert_string_equal(script_says(text), "false\n");
    }
    /* and after one that an error ended */
    assert_string_equal(
        script_says(
            "enemy.def('thin', { sprite = 'dot', hit = { circle = 9 }, hp = 1, on_death = function() error('burst') "
            "end })\n"
            "boss.def('thin', { title = 'T', kind = 'thin', x = 9, y = 9, phases = { { id = 'a', hp = 1, time = 9, "
            "run = function(e) e.hp = 0 end } } })\n" QUEEN
            "task.go(function() print((pcall(boss.fight, 'thin'))) print(boss.fight 'king') end)\n"),
        "false\nfalse\n");
}

/* ---- each ---- */

TEST(each)
{
    static const char *const patterns[] = { "ring { n = 3,",
                                            "fan { n = 3, spread = 30,",
                                            "arc { n = 3, sweep = 30,",
                                            "stack { n = 3, speed_to = 2,",
                                            "line { n = 3, width = 30,",
                                            "spiral { n = 3, step = 9, every = 1,",
                                            "aimed { n = 3, every = 1," };
    static const char cannot[] = "main.lua:2: wait: cannot wait inside a callback from C (bullet.each, table.sort, "
                                 "string.gsub, <close> and the like)";

    SAYS("for i = 1, 3 do bullet.fire { kind = 'dot', x = i, y = 9, speed = 0, tag = i < 3 and 't' or nil } end "
         "local n = 0 bullet.each(nil, function(b) n = n + b.x end) print(n) "
         "n = 0 bullet.each('t', function(b) n = n + b.x end) print(n) print(bullet.group().count, "
         "bullet.group('t').count) "
         "enemy.spawn { kind = 'foe', x = 9, y = 9 } enemy.spawn { kind = 'foe', x = 9, y = 9, tag = 't' } "
         "n = 0 enemy.each(nil, function() n = n + 1 end) print(n, enemy.count(), enemy.count(nil), enemy.count('t')) "
         "print(bullet.clear { tag = 't' }, bullet.clear { tag = nil })",
         "6.0\n3.0\n3\t2\n2\t2\t2\t1\n2\t1\n");
    SAYS("bullet.each(function() end)", "main.lua:2: bullet.each: tag: expected a string, got a function");
    /* what C calls cannot wait, a pattern's `each` may: the pattern goes on where it was */
    SAYS("bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } bullet.each(nil, function() wait(1) end)", cannot);
    SAYS("enemy.spawn { kind = 'foe', x = 9, y = 9 } enemy.each(nil, function() wait(1) end)", cannot);
    SAYS("player.each(function() wait(1) end)", cannot);
    SAYS("table.sort({ 2, 1 }, function() wait(1) end)", cannot);
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "local from, n = board.frame(), 0 pattern.%s kind = 'dot', x = 50, y = 50, speed = 1, each = "
                 "function(a, i) "
                 "n = n + i wait(10) bullet.fire(a) end } print(n, bullet.group().count, board.frame() - from >= 30)",
                 patterns[i]);
        SAYS(text, "6\t3\ttrue\n");
    }
}

/* ---- full pools ---- */

TEST(full)
{
    static const struct {
        const char *text, *words;
    } of[] = {
        { "for i = 1, 300 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end",
          "bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua" },
        { "for i = 1, 100 do shot.fire { kind = 'bolt', x = 9, y = 9, speed = 0 } end",
          "shot pool full (64): new shots are dropped; raise `board.shots` in rom.lua" },
        { "for i = 1, 40 do enemy.spawn { kind = 'foe', x = 9, y = 9 } end",
          "enemy pool full (32): new enemies are dropped; raise `board.enemies` in rom.lua" },
        { "for i = 1, 20 do sprite.put { sprite = 'dot', x = 9, y = 9 } end",
          "sprite pool full (16): new sprites are dropped; raise `board.sprites` in rom.lua" },
        { "spark.burst { kind = 'glow', x = 9, y = 9, n = 129 }",
          "spark pool full (128): new sparks are dropped; raise `board.sparks` in rom.lua" },
        { "item.drop { kind = 'gem', x = 9, y = 9, n = 9 }",
          "item pool full (8): new items are discarded; raise `board.items` in rom.lua" },
        { "for i = 1, 9 do laser.bolt { kind = 'ray', x = 9, y = 9, speed = 1, length = 5 } end",
          "laser pool full (8): new lasers are dropped; raise `board.lasers` in rom.lua" },
        { "for i = 1, 3 do laser.curve { kind = 'ray', x = 9, y = 9, speed = 0, points = 33 } end",
          "curve point pool full (64): new curves are dropped; raise `board.curve_points` in rom.lua" },
        { "for i = 1, 99 do task.go(function() wait(forever) end) end",
          "task pool full (64): new tasks do not start; raise `board.tasks` in rom.lua" },
        { "for i = 1, 99 do task.scope() end",
          "task pool full (64): new tasks do not start; raise `board.tasks` in rom.lua" },
        { "for i = 1, 99 do motion.def { { wait = i } } end",
          "motion pool full (32): bullets with a new motion fly straight; raise `board.motions` in rom.lua" },
        { "for i = 1, 3 do local steps = {} for k = 1, 200 do steps[k] = { wait = i } end motion.def(steps) end",
          "motion step pool full (512): bullets with a new motion fly straight; raise `board.motions` in rom.lua" },
        /* @std stands between */
        { "pattern.ring { kind = 'dot', x = 9, y = 9, speed = 0, n = 300 }",
          "bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua" },
        { "stage.wave { kind = 'foe', n = 40, every = 1, path = string.route }",
          "enemy pool full (32): new enemies are dropped; raise `board.enemies` in rom.lua" },
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        char text[2000], want[600];
        /* said once, whatever comes after; the place is of the line that asked */
        snprintf(text, sizeof text, "local function ask()\n%s\nend\nfor k = 1, 3 do ask() wait(60) end", of[i].text);
        snprintf(want, sizeof want, "main.lua:3: %s\n", of[i].words);
        SAYS(text, want);
    }
    SAYS("for i = 1, 257 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end",
         "main.lua:2: bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua\n");
    SAYS("for i = 1, 256 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end", "");
    SAYS("for i = 1, 300 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end print 'more' bullet.clear()\n"
         "for i = 1, 300 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } end "
         "print(board.refused('bullets'))",
         "main.lua:2: bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua\nmore\n88\n");
    /* what nobody is left to own is no refusal */
    SAYS("for i = 1, 17 do sprite.put { sprite = 'dot', x = 9, y = 9 } end local s = sys.scene(task.scope()) "
         "task.own(s, function() local c <close> = setmetatable({}, { __close = function()\n"
         "for i = 1, 3 do print(sprite.put { sprite = 'dot', x = 9, y = 9 }.alive) end end }) wait(forever) end) "
         "wait(2) task.stop(s)",
         "main.lua:2: sprite pool full (16): new sprites are dropped; raise `board.sprites` in "
         "rom.lua\nfalse\nfalse\nfalse\n");
    /* however much was printed in that frame */
    const char *all =
        says("for i = 1, 100 do print(('x'):rep(70)) end for i = 1, 17 do sprite.put { sprite = 'dot', x = 9, "
             "y = 9 } end");
    assert_non_null(strstr(all, "x\nmain.lua:2: sprite pool full"));
}

/* A run that goes on from a snapshot says what the other said, and a reset is a new run. */
TEST(full_again)
{
    static const char text[] =
        "task.go(function() wait(5) for i = 1, 300 do bullet.fire { kind = 'dot', x = 9, y = 9, speed = "
        "0 } end wait(5) if save.get('n', 0) < 2 then save.set('n', save.get('n', 0) + 1) board.reset() "
        "end end)";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    char script[2048];
    int heard[2] = { 0 };

    snprintf(script, sizeof script, "%s%s", kinds, text);
    struct manifest m = rig_manifest();
    m.items = m.lasers = m.options = 8;
    rig_script(&g, &m, script);
    for (int spoilt = 0; spoilt < 2; spoilt++) {
        rig_power(&rig, &g, NULL);
        for (int f = 0; f < 60; f++) {
            const struct board_out *out = board_tick(rig.b, none);
            rig_sound(&rig);
            heard[spoilt] += out->full_pool_count;
            assert_int_equal(out->full_pool_count, f == 5 || f == 16 || f == 27);
            for (int i = 0; i < out->full_pool_count; i++) {
                assert_string_equal(out->full_pool[i].part, "bullets");
                assert_int_equal(strlen(out->full_pool[i].line) + 1, out->log_size);
                assert_memory_equal(out->full_pool[i].line, out->log, out->log_size - 1);
            }
            if (spoilt)
                rig_spoil(&rig);
        }
        rig_free(&rig);
    }
    assert_int_equal(heard[0], 3);
    assert_int_equal(heard[1], 3);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 5);
    rig_save(&rig);
    for (int again = 0; again < 3; again++) {
        assert_int_equal(board_tick(rig.b, none)->full_pool_count, 1);
        assert_int_equal(board_tick(rig.b, none)->full_pool_count, 0);
        rig_restore(&rig);
    }
    rig_free(&rig);
    rig_game_free(&g);
}

/* What a task of the library's does wrong is placed where it was started. */
TEST(places)
{
    assert_string_equal(script_says("stage.def('s', function() wait(1) end)\n"
                                    "task.go(boss.fight,\n'quen')"),
                        "main.lua:3: boss.fight: unknown boss \"quen\" (known: none)");
    assert_string_equal(
        script_says(QUEEN "task.go(boss.fight, 'queen')\n"
                          "task.go(boss.fight, 'king')\n"),
        "main.lua:5: boss.fight: boss \"king\": \"queen\" is still fighting; for two bosses at once, declare one with "
        "`cast = { .. }`");
    assert_string_equal(script_says("task.go(function() task.go(pattern.ring, { n = 3 }) wait(3) end)"),
                        "main.lua:2: pattern.ring: kind: expected a name, got nil");
}

/* What Lua itself refuses inside a library file stands behind the author's line. */
TEST(places_in_library)
{
    static const char library[] = "return { def = function(a)\nreturn a.b.c end, known = function() end,\n"
                                  "run = function() task.go(function() wait(1)\nreturn nil + 1 end) end }";
    static const struct {
        const char *text, *says;
    } of[] = {
        { "path.def {}", "main.lua:1: @std/path.lua:2: attempt to index a nil value (field 'b')" },
        { "task.go(function()\npath.def {} end)",
          "main.lua:2: @std/path.lua:2: attempt to index a nil value (field 'b')" },
        { "pcall(path.def, {})", "main.lua:1: @std/path.lua:2: attempt to index a nil value (field 'b')" },
        { "\npath.run()", "main.lua:2: @std/path.lua:4: attempt to perform arithmetic on a nil value" },
    };
    static const uint16_t none[MAX_PLAYERS];

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        const struct rig_script scripts[] = { { "@std/path", library }, { "main", of[i].text } };
        rig_scripts(&g, NULL, scripts, 2);
        rig_power_any(&rig, &g, NULL);
        for (int f = 0; f < 4 && !rig_fault(&rig); f++)
            board_tick(rig.b, none);
        assert_non_null(rig_fault(&rig));
        assert_string_equal(rig_fault(&rig)->message, of[i].says);
        rig_free(&rig);
        rig_game_free(&g);
    }
}

/* A piece is run anew each time it is read, with sys, and one that is not there is a fault. */
TEST(pieces)
{
    static const char piece[] = "local sys = ...\nstring.runs = (string.runs or 0) + 1\n"
                                "return function(x) return x .. string.runs .. type(sys.read) end";
    static const char game[] = "local read = string.sys.read\n"
                               "assert(read('boot/list')('a') == 'a1function')\n"
                               "task.go(function()\n"
                               "  assert(read('boot/list')('b') == 'b2function')\n"
                               "  wait(2)\n"
                               "  read('boot/lists')\n"
                               "end)";
    const struct rig_script scripts[] = { { "@std/boot/list", piece },
                                          { "@std/prelude", "string.sys = ... return {}" },
                                          { "main", game } };
    static const uint16_t none[MAX_PLAYERS];

    rig_scripts(&g, NULL, scripts, 3);
    rig_power(&rig, &g, NULL);
    for (int f = 0; f < 4 && !rig_fault(&rig); f++)
        board_tick(rig.b, none);
    assert_non_null(rig_fault(&rig));
    assert_string_equal(rig_fault(&rig)->message, "main.lua:6: sys.read: no library file \"boot/lists\" in this ROM");
    rig_free(&rig);
    rig_game_free(&g);
}

/* ---- what docs/guide/10-players.md says of places, grazes and hits ---- */

TEST(guide)
{
    SAYS("p.x = -50 print(p.x) wait(1) print(p.x, p.y < rom.field.h - 8) p.y = 9999 wait(1) print(p.y == rom.field.h - "
         "8)",
         "-50.0\n8.0\ttrue\ntrue\n");
    /* a bullet that touches the ship does not graze it, though it is safe; one beside it does */
    SAYS("p.safe = 60 local b = bullet.fire { kind = 'dot', from = p, speed = 0 } wait(3) print(p.grazes, b.alive) "
         "b.x = p.x + 12 wait(3) print(p.grazes, p.safe)",
         "0\ttrue\n1\t54\n");
    /* of the hits of a frame those after the first are not told, saved or not */
    for (int saves = 0; saves < 2; saves++) {
        char text[600];
        snprintf(
            text, sizeof text,
            "local sys = string.sys on.hit(function(p, by) print('hit') if %s then p.safe = 9 end end) "
            "on.death(function() print('death') end) sys.join(1, 'ship') task.go(function() local p = player.get(1) "
            "p.safe "
            "= 0 for i = 1, 3 do bullet.fire { kind = 'dot', from = p, speed = 0 } end wait(1) bullet.clear() end)",
            saves ? "true" : "false");
        assert_string_equal(script_says(text), saves ? "hit\n" : "hit\ndeath\n");
    }
    /* a shot is spent by one enemy, safe or not, and flies on when that died before */
    SAYS("enemy.spawn { kind = 'wall', x = 50, y = 50 }.safe = forever local a = shot.fire { kind = 'bolt', x = 50, y "
         "= 50, "
         "speed = 0 } wait(1) print(a.alive, enemy.count())",
         "false\t1\n");
    SAYS("enemy.spawn { kind = 'wall', x = 50, y = 50, hp = 1 } local a, b = shot.fire { kind = 'bolt', x = 50, y = "
         "50, speed = 0 "
         "}, shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0 } wait(1) print(a.alive, b.alive, enemy.count())",
         "false\ttrue\t0\n");
}

/* ---- the host is asked ---- */

/* What a frame asks for is told once, and stands in the digest of what scripts did, each screen in its own way. */
TEST(ask)
{
    static const char *const words[] = { "settings", "replays", "practice", "keys" };
    uint64_t hash[HOST_SCREENS + 1];
    char text[120];

    for (int i = 0; i <= HOST_SCREENS; i++) {
        snprintf(text, sizeof text, "task.go(function() wait(5) %s%s%s wait(forever) end)",
                 i < HOST_SCREENS ? "board.ask '" : "", i < HOST_SCREENS ? words[i] : "", i < HOST_SCREENS ? "'" : "");
        rig_script(&g, NULL, text);
        rig_power(&rig, &g, NULL);
        for (int f = 0; f < 10; f++) {
            rig_run(&rig, 1);
            const struct board_out *out = board_last_output(rig.b);
            assert_int_equal(out->request, f == 5 && i < HOST_SCREENS ? REQUEST_HOST_SCREEN : REQUEST_NONE);
            if (f == 5 && i < HOST_SCREENS)
                assert_int_equal(out->host_screen, i);
        }
        hash[i] = board_hash(rig.b);
        for (int k = 0; k < i; k++)
            assert_true(hash[k] != hash[i]);
        rig_free(&rig);
        rig_game_free(&g);
    }
    SAYS("board.ask('setings')", "main.lua:2: board.ask: what: expected settings, replays, practice or keys, got "
                                 "\"setings\"");
}

/* ---- how many play ---- */

TEST(players)
{
    static const char text[] = "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                               "stage.def('s', function() wait(forever) end)\n"
                               "boot.run { stages = { 's' }, players = { 'ship' } }\n";
    const uint16_t none[MAX_PLAYERS] = { 0 }, start[MAX_PLAYERS] = { PAD_START }, down[MAX_PLAYERS] = { PAD_DOWN };
    struct manifest m;

    for (int players = 0; players <= 2; players++) {
        manifest_set_defaults(&m);
        m.players = players ? players : m.players; /* 0: rom.lua says nothing */
        rig_script(&g, &m, text);
        rig_power(&rig, &g, NULL);
        rig_tick(&rig, none);
        rig_tick(&rig, start);
        rig_run(&rig, 3);
        assert_int_equal(rig.b->player.in_game[0], 0); /* where to is asked first */
        rig_tick(&rig, down);
        rig_tick(&rig, none);
        rig_tick(&rig, start);
        rig_run(&rig, 3);
        assert_int_equal(rig.b->player.in_game[1], players == 2); /* else what comes below START was chosen */
        rig_free(&rig);
        rig_game_free(&g);
    }
}

/* ---- whose mistake it is ---- */

/* A board on which all of the library can be called, and a line for it. */
struct blame {
    struct rig rig;
    char line[2048];
    size_t n;
    bool loading; /* the line runs while scripts load */
    int lines;
    uint32_t seed;
};

static const char scene[] =
    "motion.def { name = 'way', { wait = 1 } } bg.def('sky', function() end) value.def('heat') "
    "bomb.def('bang', { over = 9, run = function() end }) "
    "talk.def('iri', { name = 'Iri', faces = { calm = 'dot' } }) score.rule { name = 'chain', points = 3 } "
    "unlock.def('more', { when = { clear = true } }) game.def { registers = { heat = 3 } } "
    "boss.def('king', { title = 'K', kind = 'foe', x = 9, y = 9, phases = { { id = 'a', hp = 1, time = 9, run = "
    "function() end } } }) "
    "stage.def('one', function() wait(forever) end) "
    "mission.def('first', { title = 'F', stage = 'one', clear = true }) "
    "string.sys.join(1, 'ship') "
    "task.go(function() stage.play('one') string.dead = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1 } "
    "string.dead:remove() wait(1) string.item = item.drop { kind = 'gem', x = 9, y = 9 } "
    "string.item = query.near { what = 'item', x = 9, y = 9, radius = 20 }[1] "
    "string.foe = enemy.spawn { kind = 'foe', x = 50, y = 50 } end)\n";

static void put(struct blame *t, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    t->n += (size_t)vsnprintf(t->line + t->n, sizeof t->line - t->n, format, args);
    va_end(args);
    assert_true(t->n < sizeof t->line);
}

/* What can be given for text and tables, by the entry and the parameter. */
static const struct {
    const char *entry, *param, *text;
} fitting[] = {
    { "boss.def", "kind", "'foe'" },
    { "boss.def", "phases", "{ { id = 'b', hp = 1, time = 9, run = print } }" },
    { "boss.fight", "name", "'king'" },
    { "boss.history", "name", "'king'" },
    { "boss.history", "id", "'a'" },
    { "stage.mark", "name", "'here'" },
    { "bg.show", "name", "'sky'" },
    { "score.count", "name", "'chain'" },
    { "score.tally", "list", "{ { label = 'A', value = 'score', points = 1 } }" },
    { "unlock.def", "when", "{ clear = true }" },
    { "unlock.has", "name", "'more'" },
    { "mission.best", "name", "'first'" },
    { "mission.def", "goal", "{ kills = 3 }" },
    { "say", "who", "'iri'" },
    { "choose", "list", "{ 'YES', 'NO' }" },
    { "path.def", "list", "{ { x = 1, y = 1 }, { x = 9, y = 9, over = 3 } }" },
    { "boot.run", "players", "{ 'ship' }" },
    { "boot.run", "stages", "{ 'one' }" },
    { "by_difficulty", "values", "{ 1 }" },
    { "game.def", "registers", "{ power = 3 }" },
    { "motion.def", "steps", "{ { wait = 1 } }" },
    { "pattern.points", "list", "{ { 1, 2 } }" },
    { "pattern.picture", "dots", "'# #'" },
    { "stage.wave", "path", "string.route" },
    { "board.difficulty", "name", "'normal'" },
    { "board.live", "chip", "'bullets'" },
    { "board.refused", "chip", "'bullets'" },
    { "palette.load", "name", "'other'" },
    { "rom.text", "path", "'words.txt'" },
};

static const char *fits(const struct api_entry *e, const struct api_param *p)
{
    static const char *const texts[] = {
        [A_DIR] = "90",
        [A_STR] = "'x'",
        [A_BOOL] = "true",
        [A_FUNC] = "function() end",
        [A_TABLE] = "{}",
        [A_ANY] = "1",
        [A_SPAN] = "{ 1, 2 }",
        [A_ROUTE] = "string.route",
        [A_HIT_SHAPE] = "{ circle = 2 }",
        [A_MOTION] = "'way'",
        [A_BULLET_KIND] = "'dot'",
        [A_SHOT_KIND] = "'bolt'",
        [A_ENEMY_KIND] = "'foe'",
        [A_PLAYER_KIND] = "'ship'",
        [A_SPARK_KIND] = "'glow'",
        [A_ITEM_KIND] = "'gem'",
        [A_LASER_KIND] = "'ray'",
        [A_OPTION_KIND] = "'bead'",
        [A_SPRITE] = "'dot'",
        [A_BLEND] = "'none'",
        [A_FONT] = "'tiny'",
        [A_MAP] = "'sea'",
        [A_SOUND] = "'hit'",
        [A_TUNE] = "'tide'",
        [A_PLAYER] = "1",
    };
    static char text[64];
    int words;

    for (size_t i = 0; i < sizeof fitting / sizeof *fitting; i++)
        if (!strcmp(fitting[i].entry, e->name) && !strcmp(fitting[i].param, p->name))
            return fitting[i].text;
    if (api_get_type_words(p->type, &words)) {
        snprintf(text, sizeof text, "'%s'", api_get_type_words(p->type, &words)[0]);
        return text;
    }
    if (p->type == A_THING) {
        for (int k = 1; k < HANDLE_KINDS; k++)
            if ((unsigned)p->lo >> k & 1 && made[k])
                return made[k];
        return "string.foe";
    }
    if (texts[p->type])
        return texts[p->type];
    snprintf(text, sizeof text, "%.0f", p->lo > 1 ? p->lo : p->hi < 1 ? p->hi : 1);
    return text;
}

/* Entries that are tables in another's, and a call that has one. */
static const struct {
    const char *entry, *call;
} inner[] = {
    { "boss.def phase", "boss.def('x', { title = 'x', kind = 'foe', x = 9, y = 9, phases = { %s } })" },
    { "boss.def talk", "boss.def('x', { title = 'x', kind = 'foe', x = 9, y = 9, phases = { %s, { id = 'a', hp = 1, "
                       "time = 9, run = print } } })" },
    { "boss.def clear", "boss.def('x', { title = 'x', kind = 'foe', x = 9, y = 9, phases = { { id = 'a', hp = 1, time "
                        "= 9, run = print, clear = %s } } })" },
    { "boss.def cast", "boss.def('x', { title = 'x', cast = { %s, { name = 'b', title = 'B', kind = 'foe', x = 9, y = "
                       "9 } }, phases = { { id = 'a', hp = 1, time = 9, run = print } } })" },
    { "path.def point", "path.def { { x = 1, y = 1 }, %s }" },
    { "score.tally line", "score.tally { %s }" },
    { "unlock.def when", "unlock.def('y', { when = %s })" },
    { "boot.run music", "boot.run { players = { 'ship' }, stages = { 'one' }, music = { %s } }" },
};

/* A call of e, whose parameters are followed by those of fire (or NULL), with all that it needs, and with `value` for
 * parameter `wrong` (NULL: it is left out). */
static void put_call(struct blame *t, const struct api_entry *e, const struct api_entry *fire, const char *word,
                     bool each, int wrong, const char *value)
{
    const int n = api_param_count(e, fire);
    const bool method = e->flags & API_METHOD;

    t->n = 0;
    for (int k = 1; method && k < HANDLE_KINDS; k++)
        if (!strncmp(e->name, api_table.things[k]->name, strcspn(e->name, ":")) &&
            !api_table.things[k]->name[strcspn(e->name, ":")])
            put(t, "local self = %s ", made[k] ? made[k] : "nil");
    put(t, "%s%s(", method ? "self:" : "", method ? strchr(e->name, ':') + 1 : e->name);
    for (int i = method; i < e->positional_count; i++)
        put(t, "%s%s", i == method ? "" : ", ", i == wrong ? value ? value : "nil" : fits(e, &e->params[i]));
    if (n > e->positional_count)
        put(t, "%s{ ", e->positional_count > method ? ", " : "");
    for (int i = e->positional_count; i < n; i++) {
        const struct api_param *p = api_param_at(e, fire, i);
        const bool often = !p->optional || !strcmp(p->name, "x") || !strcmp(p->name, "y");
        if (i == wrong ? value != NULL : often)
            put(t, "%s = %s, ", p->name, i == wrong ? value : fits(e, p));
    }
    if (word)
        put(t, "fire = '%s', ", word);
    if (each)
        put(t, "each = function() end ");
    put(t, n > e->positional_count ? "})" : ")");
    for (size_t i = 0; i < sizeof inner / sizeof *inner; i++)
        if (!strcmp(inner[i].entry, e->name)) {
            char table[sizeof t->line];
            snprintf(table, sizeof table, "%.*s", (int)(t->n - strlen(e->name) - 2), t->line + strlen(e->name) + 1);
            t->n = 0;
            put(t, inner[i].call, table);
        }
}

static bool is_inner(const struct api_entry *e)
{
    for (size_t i = 0; i < sizeof inner / sizeof *inner; i++)
        if (!strcmp(inner[i].entry, e->name))
            return true;
    return false;
}

/* Runs the line as it is, or in a task. Returns what it failed with, or NULL. */
static const char *failure(struct blame *t, bool task)
{
    static char out[EVAL_TEXT_SIZE], line[sizeof t->line + 40];
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct board *b = t->rig.b;
    const char *said = NULL;

    t->lines++;
    snprintf(line, sizeof line, task ? "task.go(function() %s end)" : "do %s end", t->line);
    b->vm.loading = t->loading;
    if (!board_eval(b, line, out, sizeof out))
        said = out;
    b->vm.loading = false;
    for (int i = 0; task && !said && i < 3; i++)
        if (board_tick(b, none)->fault) {
            snprintf(out, sizeof out, "%s", board_last_output(b)->fault->message);
            said = strncmp(out, "console:1: ", 11) ? out : out + 11;
        }
    rig_restore(&t->rig);
    return said;
}

/* A message names the function that was called, and nothing of how it works inside. */
static void judge(struct blame *t, const struct api_entry *e)
{
    const bool both = !t->loading && (rig_long() || e->flags & API_LUA);

    for (int task = 0; task < 1 + both; task++) {
        const char *said = failure(t, task);
        if (!said || strstr(said, "only a task can") || !strcmp(said, "mine"))
            continue;
        if (strstr(said, "@std") || strstr(said, "attempt to") || strstr(said, "bad argument") ||
            strncmp(said, e->name, strcspn(e->name, " ")) != 0)
            fail_msg("%s: %s", t->line, said);
    }
}

/* e with each argument left out, of a wrong type, and beyond its ends. */
static void mistake_all(struct blame *t, const struct api_entry *e, const struct api_entry *fire, const char *word,
                        bool each)
{
    static const char *const junk[] = { NULL,
                                        "true",
                                        "'zz'",
                                        "{}",
                                        "{ 1 }",
                                        "{ { } }",
                                        "{ 'a' }",
                                        "{ a = 1 }",
                                        "{ [2.5] = 1 }",
                                        "{ nil, 3 }",
                                        "print",
                                        "function() return {} end",
                                        "function() error('mine') end",
                                        "0/0",
                                        "1e300",
                                        "-1e300",
                                        "math.maxinteger",
                                        "math.mininteger",
                                        "0",
                                        "-1",
                                        "0.5",
                                        "''",
                                        "'a\\0b'",
                                        "('x'):rep(300)",
                                        "string.dead",
                                        "string.foe",
                                        "player.get(1)",
                                        "player.get(2)" };
    const int n = sizeof junk / sizeof *junk;

    for (int wrong = e->flags & API_METHOD ? 1 : 0; wrong < api_param_count(e, fire); wrong++)
        for (int k = 0; k < n; k++) {
            const bool few = word && (strcmp(word, "bullet") != 0 || each);
            if (!rig_long() && k > 0 && (wrong + k) % (few ? 12 : 3))
                continue;
            put_call(t, e, fire, word, each, wrong, junk[k]);
            judge(t, e);
        }
}

TEST(blame)
{
    static const char *const words[FIRE_ENTRY_COUNT] = { "bullet", "shot", "bolt", "curve", "beam" };
    struct blame t = { 0 };
    struct manifest m = rig_manifest();
    char script[8192];

    m.items = m.lines = m.lasers = 8;
    m.curve_points = 64;
    m.options = 4;
    m.bullet_values = 1;
    m.has_freeze = m.bullets_can_meet = m.has_backgrounds = m.has_bodies = m.has_pierce = m.has_sound = m.has_orbit = 1;
    m.lua_kib = 512;
    snprintf(script, sizeof script, "%s%s", kinds, scene);
    rig_with_sys(&g, &m, script);
    rig_maps(&g);
    rig_sounds(&g);
    rig_power(&t.rig, &g, NULL);
    rig_run(&t.rig, 3);
    rig_save(&t.rig);
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        t.loading = e->flags & API_LOAD_ONLY || is_inner(e);
        if ((e->flags & API_SYS && !is_inner(e)) || api_disabled_reason(&m, e->name))
            continue;
        for (int f = 0; e->flags & API_PATTERN && f < FIRE_ENTRY_COUNT; f++)
            for (int each = 0; each < 2; each++)
                mistake_all(&t, e, api_table.fire_entries[f], words[f], each);
        if (!(e->flags & API_PATTERN))
            mistake_all(&t, e, NULL, NULL, false);
    }
    assert_true(t.lines > 5000);
    rig_free(&t.rig);
    rig_game_free(&g);
}

/* ---- which of many mistakes ---- */

/* Twenty keys that nobody knows. Lua's own order of them differs between runs, and the first is hardly ever "za". */
#define MANY                                                                                                           \
    "zt = 1, zs = 1, zr = 1, zq = 1, zp = 1, zo = 1, zn = 1, zm = 1, zl = 1, zk = 1, za = 1, zb = 1, zc = 1, zd = 1, " \
    "ze = 1, zf = 1, zg = 1, zh = 1, zi = 1, zj = 1"

TEST(first_key)
{
    static const struct {
        const char *text, *words;
    } of[] = {
        { "motion.def { { " MANY " } }", "motion.def: step 1: unknown argument \"za\"" },
        { "motion.def { { " MANY ", [true] = 1, [print] = 1 } }",
          "motion.def: step 1: expected named arguments ({ name = value }), got key true" },
        { "motion.def { { wait = 1 }, " MANY " }", "motion.def: unknown argument \"za\" (arguments: name, fine)" },
        { "motion.def { { emit = { " MANY " } } }", "motion.def: step 1: emit: unknown argument \"za\"" },
        { "motion.def { { wait_for = { " MANY " } } }",
          "motion.def: step 1: wait_for: unknown argument \"za\" (arguments: x, y, near, tag, limit)" },
        { "bullet.def('x', { sprite = 'dot', hit = { " MANY " } })", "got a table with key \"za\"" },
        { "bullet.def('x', { sprite = 'dot', hit = { circle = 1, box = { 1, 1 }, capsule = { 1, 1 }, circles = {} } })",
          "got a table with both \"circle\" and \"box\"" },
        { "laser.def('x', { strip = 'dot', width = 1, hit = { " MANY " } })", "got a table with key \"za\"" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { a = { " MANY " } } })",
          "player.def: registers.a: unknown argument \"za\"" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { zc = {}, zd = true, za = -1, zb = -1, "
          "ze = '', zf = '' } })",
          "player.def: registers.za: expected a whole number" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, options = { " MANY " } })",
          "player.def: options: unknown argument \"za\"" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, options = { kind = 'bead', levels = { { " MANY
          " } } } })",
          "player.def: options.levels[1]: unknown argument \"za\" (arguments: at, n, wide, close)" },
        { "enemy.def('x', { sprite = 'dot', hit = 'none', pictures = { ze = 1, zd = 1, zc = 1, zb = 1, za = 1 } })",
          "enemy.def: pictures.za: expected a sprite name, got 1" },
        { "enemy.def('x', { sprite = 'dot', hit = 'none', drops = { " MANY " } })",
          "enemy.def: drops: expected at most 18 names, got 20" },
        { "item.def('x', { sprite = 'dot', radius = 1, gives = { ze = '', zd = '', zc = '', zb = '', za = '' } })",
          "item.def: gives.za: expected a whole number" },
        { "boss.def('x', { title = 'x', cast = { { name = 'a', title = 'A', kind = 'foe', x = 1, y = 1 }, { name = "
          "'b', "
          "title = 'B', kind = 'foe', x = 1, y = 1 } }, phases = { { id = 'p', time = 9, run = print, hp = { " MANY
          " } } } })",
          "boss.def: phase \"p\": hp: no member of the cast is named \"za\"" },
        { "bullet.def('x', { " MANY " })", "bullet.def: unknown argument \"za\"" },
        { "score.rule { name = 'x', gain = { ze = '', zd = '', zc = '', zb = '', za = '' } }",
          "score.rule: gain: expected { REGISTER = n, .. }, whole numbers, got \"\"" },
        /* a name with \0 is no name, whatever stands before that */
        { "bullet.def('x', { sprite = 'dot', hit = 'none', ['bank\\0'] = 3 })",
          "bullet.def: unknown argument \"bank\"" },
    };
    char script[4096];

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        snprintf(script, sizeof script, "%s%s", kinds, of[i].text);
        const char *all = said(script, 1);
        if (!strstr(all, of[i].words) || strncmp(all, "main.lua:2: ", 12) != 0)
            fail_msg("%s: %s", of[i].text, all);
    }
}

/* ---- what is meant ---- */

TEST(meant)
{
    SAYS("bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1, angle = 3 }",
         "main.lua:2: bullet.fire: unknown argument \"angle\" (did you mean \"dir\"?)");
    SAYS("bullet.fire { kind = 'dot', x = 1, y = 1, velocity = 1 }",
         "main.lua:2: bullet.fire: unknown argument \"velocity\" (did you mean \"speed\"?)");
    SAYS("bullet.fire { kind = 'dot', x = 1, y = 1, color = 1 }",
         "main.lua:2: bullet.fire: unknown argument \"color\" (did you mean \"bank\"?)");
    SAYS("motion.def { { angle = 3 } }",
         "main.lua:2: motion.def: step 1: unknown argument \"angle\" (did you mean \"dir\"?)");
    SAYS("local b = bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1 } print(b.colour)",
         "main.lua:2: a bullet has no property \"colour\" (did you mean \"bank\"?)");
    SAYS("local b = bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1 } b.rotation = 3",
         "main.lua:2: a bullet has no property \"rotation\" (did you mean \"dir\"?)");
    /* the call's own arguments alone are counted */
    SAYS("local e = enemy.spawn { kind = 'foe', x = 1, y = 1 } e:move(9, 9, 30)",
         "main.lua:2: enemy:move: expected a table of named arguments (enemy:move { ... }), got 3 arguments");
    SAYS("local e = enemy.spawn { kind = 'foe', x = 1, y = 1 } e:move({}, 9)",
         "main.lua:2: enemy:move: expected at most 1 argument, got 2");
    SAYS("local e = enemy.spawn { kind = 'foe', x = 1, y = 1 } e:shift(1, 2, 3)",
         "main.lua:2: enemy:shift: expected at most 2 arguments, got 3");
    SAYS("local e = enemy.spawn { kind = 'foe', x = 1, y = 1 } e:remove(3)",
         "main.lua:2: enemy:remove: expected no arguments, got 1");
    SAYS("board.frame(3)", "main.lua:2: board.frame: expected no arguments, got 1");
    /* a pattern's place is the pattern's */
    SAYS("pattern.ring { n = 3, kind = 'dot', speed = 1, from = nil }",
         "main.lua:2: pattern.ring: place: expected `x` and `y`, or `from` (a thing), got neither");
    SAYS("pattern.scatter { n = 3, spread = 3, speed_to = 1, kind = 'dot', speed = 1, from = nil }",
         "main.lua:2: pattern.scatter: place: expected `x` and `y`, or `from` (a thing), got neither");
    SAYS("pattern.star { n = 10, points = 5, kind = 'dot', speed = 1, x = 1, from = p }",
         "main.lua:2: pattern.star: place: expected either `x` and `y`, or `from`");
    SAYS("pattern.whip { n = 3, speed_to = 2, bend = 9, kind = 'dot', x = 1, y = 1, each = print }",
         "main.lua:2: pattern.whip: speed: expected a number of px/frame, got nil");
    SAYS("pattern.stack { n = 3, speed_to = 2, kind = 'dot', x = 1, y = 1, each = print }",
         "main.lua:2: pattern.stack: speed: expected a number of px/frame, got nil");
    /* only what despawned has a hint */
    SAYS("local t = {} print(t.x + 1)", "main.lua:2: attempt to perform arithmetic on a nil value (field 'x')");
    SAYS("local b = bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1 } b:remove() print(b.x)\n"
         "local t = {} print(t.x + 1)",
         "main.lua:3: attempt to perform arithmetic on a nil value (field 'x')");
    SAYS("local b = bullet.fire { kind = 'dot', x = 1, y = 1, speed = 1 } b:remove() print(b.x + 1)",
         "main.lua:2: attempt to perform arithmetic on a nil value (field 'x') (x is nil once the thing has despawned; "
         "check `alive` first)");
    /* a global that is none */
    SAYS("local counter = 1 print(conter)", "main.lua:2: undeclared global \"conter\" (did you mean \"counter\"?)");
    SAYS("local counter = 1 conter = counter", "main.lua:2: undeclared global \"conter\" (did you mean \"counter\"?)");
    SAYS("count = 0", "main.lua:2: undeclared global \"count\" (scripts cannot create globals; write \"local count\")");
    SAYS("print(bulet)", "main.lua:2: undeclared global \"bulet\" (did you mean \"bullet\"?)");
    /* player 1 where none is given */
    assert_string_equal(
        said("player.def('ship', { sprite = 'dot', hit = { circle = 2 } }) score.rule { name = 'chain', "
             "points = 3 } string.sys.join(1, 'ship') task.go(function() score.count('chain', 2) "
             "print(player.get(1).score) end)",
             9),
        "6\n");
}

/* A kind that is misspelt, where rows of the list of kinds have no name: a cloud's, a picture's. */
TEST(nameless)
{
    assert_string_equal(said("bullet.def('orb', { sprite = 'dot', hit = { circle = 3 }, cloud = 'dot' }) "
                             "bullet.def('rice', { sprite = 'dot', hit = { circle = 3 } }) "
                             "task.go(function() bullet.fire { kind = 'ricee', x = 1, y = 1, speed = 1 } end)",
                             9),
                        "main.lua:1: bullet.fire: unknown bullet kind \"ricee\" (did you mean \"rice\"?)");
    assert_string_equal(said("enemy.def('fly', { sprite = 'dot', hit = 'none', pictures = { hurt = 'dot' } }) "
                             "task.go(function() enemy.spawn { kind = 'flyy', x = 1, y = 1 } end)",
                             9),
                        "main.lua:1: enemy.spawn: unknown enemy kind \"flyy\" (did you mean \"fly\"?)");
}

/* Every word that the help offers is one that the function takes, and so is every default. */
TEST(words)
{
    assert_string_equal(said("spark.def('a', { sprite = 'dot', life = 9, layer = 'back' })", 1),
                        "main.lua:1: spark.def: layer: expected middle or front, got \"back\"");
    for (int i = 0; i < api_count_entries(&api_table); i++)
        for (int k = 0; k < api_get_entry(&api_table, i)->count; k++) {
            const struct api_param *p = &api_get_entry(&api_table, i)->params[k];
            struct api_value v = { 0 };
            int n;
            const char *const *words = api_get_type_words(p->type, &n);
            if (!words || !p->def)
                continue;
            api_fill_default(p, &v);
            if (v.i >= n || strcmp(words[v.i], p->def) != 0)
                fail_msg("%s: %s: \"%s\" is %s", api_get_entry(&api_table, i)->name, p->name, p->def, words[v.i]);
        }
}

/* ---- mistakes that are found when the game starts ---- */

TEST(late)
{
    static const struct {
        const char *text, *words;
    } of[] = {
        { "score.rule { on = 'graze', points = 'powr' }", "score.rule: unknown register \"powr\" (did" },
        { "score.rule { on = 'graze', gain = { powr = 1 } }", "score.rule: unknown register \"powr\" (did" },
        { "score.tally { { label = 'A', value = 'powr', points = 3 } }",
          "score.tally: unknown register \"powr\" (did" },
        { "stage.def('two', print, { needs = 'x' })", "stage.def: unknown unlock \"x\" (known: none)" },
        { "player.def('two', { sprite = 'dot', hit = { circle = 1 }, needs = 'x' })",
          "player.def: unknown unlock \"x\" (known: none)" },
        { "unlock.def('u', { when = { clear = 'onee' } })", "unlock.def: unknown stage \"onee\" (did" },
        { "unlock.def('u', { when = { ship = 'shi' } })", "unlock.def: unknown player \"shi\" (did" },
        { "unlock.def('u', { when = { spell = 'king/a' } })", "unlock.def: unknown boss \"king\" (known:" },
        { "unlock.def('u', { when = { clear = true } }) stage.def('two', print, { needs = 'x' })",
          "stage.def: unknown unlock \"x\" (known: u)" },
        { "mission.def('m', { title = 'M', stage = 'onee', clear = true })",
          "mission.def: unknown stage \"onee\" (did" },
        { "mission.def('m', { title = 'M', stage = 'one', clear = true, needs = 'x' })",
          "mission.def: unknown unlock \"x\" (known: none)" },
        { "mission.def('m', { title = 'M', stage = 'one', goal = { powr = 3 } })",
          "mission.def: unknown count \"powr\" (did" },
        { "item.def('a', { sprite = 'dot', radius = 1, gives = { powr = 3 } })",
          "item.def: item \"a\": unknown register \"powr\"" },
    };
    char script[4096];

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        char want[200];
        snprintf(script, sizeof script,
                 "%s\n%s\nstage.def('one', print)\nboot.run { players = { 'ship' %s }, stages = { 'one' } }\n"
                 "string.sys.join(1, 'ship')",
                 kinds, of[i].text, strstr(of[i].text, "'two', {") ? ", 'two'" : "");
        snprintf(want, sizeof want, "main.lua:3: %s", of[i].words);
        const char *all = said(script, 1);
        if (strncmp(all, want, strlen(want)) != 0)
            fail_msg("%s: %s", of[i].text, all);
    }
}

RUN_TESTS(NULL, NULL)
