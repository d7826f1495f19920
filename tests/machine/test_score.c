/*
 * test_score.c - rules of scoring, the tally of a stage, tables of a ship each, and what is unlocked: what scripts see,
 * with RAM spoiled between frames, and what they are told when they are wrong.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static const char kinds[] =
    "player.def('ship', { sprite = 'dot', hit = { circle = 3 }, lives = 5, safe = 0,\n"
    "  registers = { chain = { max = 5 }, best = 0, value = 100 }, collect_line = 100 })\n"
    "player.def('barge', { sprite = 'dot', hit = { circle = 3 }, registers = { chain = 0, value = 7 } })\n"
    "game.def { registers = { rank = { start = 2, max = 9 } } }\n"
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
    "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9, score = 30 })\n"
    "enemy.def('ace', { sprite = 'dot', hit = 'none', hp = 9, score = 500 })\n"
    "item.def('gem', { sprite = 'dot', radius = 5, gives = { score = { 100, 300 } } })\n"
    "local sys = string.sys\n";

static void power(const char *text, const struct board_start *start)
{
    struct manifest m = rig_manifest();
    static char script[8192];

    m.items = 16;
    m.n_difficulties = 2;
    memset(m.difficulties, 0, sizeof m.difficulties);
    strcpy(m.difficulties[0], "easy");
    strcpy(m.difficulties[1], "hard");
    snprintf(script, sizeof script, "%s%s", kinds, text);
    rig_with_sys(&g, &m, script);
    rig_power_any(&rig, &g, start);
}

static void done(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

/* What is printed in so many frames; at the end the fault, if there was one. */
static const char *says_from(const char *text, int frames, const struct board_start *start)
{
    static char said[4096];
    const uint16_t none[MAX_PLAYERS] = { 0 };
    size_t n = 0;

    power(text, start);
    for (int f = 0; f < frames && !rig_fault(&rig); f++) {
        const struct board_out *out = board_tick(rig.b, none);
        for (size_t i = 0; i < out->log_size && n + 1 < sizeof said; i++)
            said[n++] = out->log[i];
        if (!rig_fault(&rig))
            rig_spoil(&rig);
    }
    said[n] = 0;
    if (rig_fault(&rig))
        snprintf(said, sizeof said, "%s", rig_fault(&rig)->message);
    return said;
}

static void says(int frames, const char *text, const char *words)
{
    assert_string_equal(says_from(text, frames, NULL), words);
    done();
}

#define IN         "sys.join(1, 'ship') sys.join(2, 'barge') local p, q = player.get(1), player.get(2) "
#define TASK(text) "task.go(function() " IN text " end)"

/* ---- rules ---- */

/* A kill is one more of the chain, and worth as many times 10 as the chain is then; to the player who did it. */
TEST(chain)
{
    says(3,
         "score.rule { on = 'kill', gain = { chain = 1 }, points = 10, times = 'chain', most = { best = 'chain' } }\n"
         "score.rule { on = 'kill', kind = 'ace', set = { chain = 0 } }\n" TASK(
             "for i = 1, 3 do enemy.spawn { kind = 'foe', x = 50, y = 50 }:hurt(9, p) end "
             "enemy.spawn { kind = 'foe', x = 50, y = 50 }:hurt(9, q) "
             "enemy.spawn { kind = 'foe', x = 50, y = 50 }:kill() wait(1) "
             "print(p.score, p.chain, p.best, q.score, q.chain) "
             "enemy.spawn { kind = 'ace', x = 50, y = 50 }:hurt(9, p) wait(1) print(p.score, p.chain, p.best)"),
         "220\t4\t4\t40\t1\n770\t0\t5\n");
}

/* Without points, what a thing gave itself comes `times` times in place of once, at any height. */
TEST(times)
{
    says(3,
         "score.rule { on = 'kill', times = 3 }\n"
         "score.rule { on = 'take', kind = 'gem', times = function(p, i) return p.value / 200 end }\n" TASK(
             "enemy.spawn { kind = 'ace', x = 50, y = 50 }:hurt(9, p) "
             "q.x, q.y = 30, 300 p.x, p.y = 100, 50 item.drop { kind = 'gem', from = p, speed = 0 } wait(1) "
             "print(p.score, q.score) "),
         "1650\t0\n");
    says(3,
         "score.rule { on = 'graze', points = 'value', gain = { value = 10 } }\n" TASK(
             "bullet.fire { kind = 'dot', from = p, dx = 12, dir = 0, speed = 0 } wait(1) print(p.score, p.value)"),
         "110\t110\n");
}

/* A register may be the run's, which both players count on. */
TEST(run)
{
    says(
        2,
        "score.rule { on = 'kill', gain = { rank = 3 }, points = 10, times = 'rank', most = { best = 'rank' } }\n" TASK(
            "sys.start(task.scope()) for i = 1, 2 do enemy.spawn { kind = 'foe', x = 50, y = 50 }:hurt(9, p) end "
            "enemy.spawn { kind = 'foe', x = 50, y = 50 }:hurt(9, q) wait(1) print(p.score, q.score, game.rank, "
            "p.best)"),
        "190\t120\t9\t8\n");
}

/* A rule with a name of its own counts when it is told, n deeds at once; a register stops at its max. */
TEST(count)
{
    says(2,
         "score.rule { name = 'cancel', gain = { chain = 2 }, points = 5, times = 'chain' }\n" TASK(
             "for i = 1, 4 do bullet.fire { kind = 'dot', x = 60 + i, y = 40, dir = 0, speed = 0 } end "
             "score.count('cancel', bullet.clear(), 2) score.count('cancel', 0, p) print(p.score, q.score, q.chain) "
             "score.count('cancel', 1000000, p) print(p.score, p.chain) score.count('cancel', 3, player.get(2)) "
             "sys.leave(2) score.count('cancel', 3, q) print(q.score)"),
         "0\t160\t8\n25000000\t5\n370\n");
}

/* ---- the tally ---- */

TEST(tally)
{
    says(4,
         "score.tally { { label = 'GRAZE', value = 'value', points = 2, stage = true },\n"
         "  { label = 'BEST', value = 'best', points = 10 }, { label = 'NONE', value = function() end, points = 1 },\n"
         "  { label = 'FIRST', value = function(p) return p.index == 1 end, points = 5 },\n"
         "  { label = 'LIVES', value = 'lives', points = 1000, last = true } }\n" TASK(
             "sys.emit('stage', 'one', 'start') wait(1) p.value, p.best, q.value = 150, 7, 7 "
             "for _, last in ipairs { false, true } do for _, w in ipairs { p, q } do "
             "  for _, l in ipairs(sys.scoring.tally(w, last)) do print(w.index, l.label, l.value, l.points) end "
             "  print(w.score) end end"),
         "1\tGRAZE\t50\t100\n1\tBEST\t7\t70\n1\tFIRST\tnil\t5\n175\n2\tGRAZE\t0\t0\n2\tBEST\t0\t0\n0\n"
         "1\tGRAZE\t50\t100\n1\tBEST\t7\t70\n1\tFIRST\tnil\t5\n1\tLIVES\t4\t4000\n4350\n2\tGRAZE\t0\t0\n2\tBEST\t0\t0\n"
         "2\tLIVES\t2\t2000\n"
         "2000\n");
}

/* ---- tables ---- */

TEST(rows)
{
    says(2,
         "local function show(...) for i, r in ipairs(score.rows(...)) do "
         "print(i, r.name, r.score, r.ship, r.stage, r.clear, r.continues) end end " TASK(
             "print(score.enter('hard', { name = 'A', score = 9, ship = 'ship', stage = 2, continues = 1 })) "
             "print(score.enter('hard', { name = 'B', score = 12, ship = 'barge', stage = 3, clear = true })) "
             "print(score.enter('hard', { name = 'C', score = 12 })) show('hard') show('hard', 'ship') show('easy')"),
         "1\n1\n1\n1\tB\t12\tbarge\tnil\ttrue\t0\n2\tC\t12\tnil\tnil\tfalse\t0\n3\tA\t9\tship\t2\tfalse\t1\n"
         "1\tA\t9\tship\t2\tfalse\t1\n");
}

/* ---- unlocks ---- */

TEST(unlock)
{
    static const char script[] =
        "unlock.def('all', { when = { clear = true } })\n"
        "unlock.def('half', { when = { clear = 'one', continues = 1 }, title = 'Half of It' })\n"
        "unlock.def('ace', { when = { difficulty = 'hard', ship = 'barge', score = 900 } })\n"
        "unlock.def('mild', { when = { difficulty = 'easy', score = 9000 } })\n"
        "unlock.def('odd', { when = function(run) return run.scores[1] == 7 end, hint = 'Be odd' })\n"
        "local base = { cleared = {}, difficulty = 'easy', continues = 0, ships = { 'ship' }, scores = { 5 } }\n"
        "local function earn(run)\n"
        "  for k, v in pairs(base) do if run[k] == nil then run[k] = v end end\n"
        "  print(table.concat(sys.unlock.earn(run), ' ')) end\n"
        "task.go(function()\n"
        "earn { stage = 'one' }\n"
        "earn { stage = 'one', cleared = { one = true }, continues = 2 }\n"
        "earn { stage = 'one', cleared = { one = true }, continues = 1 }\n"
        "earn { clear = true }\n"
        "print(unlock.has('all'), unlock.has('ace'))\n"
        "local two = { 'ship', 'barge' }\n"
        "earn { difficulty = 'hard', ships = two, scores = { 9000, 899 } }\n"
        "earn { difficulty = 'easy', ships = two, scores = { 9000, 900 } }\n"
        "earn { difficulty = 'hard', ships = two, scores = { 9000, 900 } }\n"
        "print(sys.unlock.closed('odd'), sys.unlock.closed('ace'))\n"
        "earn { scores = { 7 }, stage = 'one' }\n"
        "earn { scores = { 7 } }\n"
        "earn { clear = true }\n"
        "print(save.get('unlock/odd'), unlock.has('odd')) end)";

    says(2, script, "\n\nHalf of It\nALL\ntrue\tfalse\nMILD\n\nACE\nBe odd\tnil\n\nODD\n\ntrue\ttrue\n");
}

/* What was kept is there at the next power-on; a practice start is given none of it. */
TEST(unlock_kept)
{
    static const char script[] = "unlock.def('x', { when = { clear = true } })\n"
                                 "task.go(function() print(unlock.has('x')) save.set('unlock/x', true) end)";
    static uint8_t image[1024];
    struct board_start start = { .difficulty = -1, .nvram = image };
    uint32_t changed;

    assert_string_equal(says_from(script, 2, NULL), "false\n");
    const uint8_t *bytes = board_nvram(rig.b, &start.nvram_size, &changed);
    memcpy(image, bytes, start.nvram_size);
    done();
    assert_string_equal(says_from(script, 2, &start), "true\n");
    done();
}

/* ---- mistakes ---- */

TEST(mistakes)
{
    static const char *const wrong[][2] = {
        { "score.rule { on = 'kil', points = 1 }", "score.rule: unknown event \"kil\" (did you mean \"kill\"?)" },
        { "score.rule { points = 1 }", "score.rule: expected either on (an event) or name (for score.count)" },
        { "score.rule { on = 'kill', name = 'x', points = 1 }",
          "score.rule: expected either on (an event) or name (for score.count)" },
        { "score.rule { name = 'kill', points = 1 }", "score.rule: name: \"kill\" is an event; write on = \"kill\"" },
        { "score.rule { on = 'kill', kind = 'fow', points = 1 }",
          "score.rule: unknown enemy kind \"fow\" (did you mean \"foe\"?)" },
        { "score.rule { on = 'death', kind = 'foe', points = 1 }", "score.rule: kind: only for kill, graze and take" },
        { "score.rule { on = 'graze', times = 2 }",
          "score.rule: points: a required argument is missing (the event has none of its own)" },
        { "score.rule { on = 'kill', points = true }",
          "score.rule: points: expected a number, a register or a function, got boolean" },
        { "score.rule { on = 'kill', gain = { chain = 0.5 } }",
          "score.rule: gain: expected { REGISTER = n, .. }, whole numbers, got float" },
        { "score.rule { on = 'kill', gain = { 'chain' } }",
          "score.rule: gain: expected { REGISTER = n, .. }, whole numbers, got integer" },
        { "score.rule { on = 'kill' }", "score.rule: expected one of points, times, gain, most, set" },
        { "score.rule { on = 'kill', gains = { chain = 1 } }",
          "score.rule: unknown argument \"gains\" (did you mean \"gain\"?)" },
        { "score.rule { on = 'kill', gain = { chian = 1 } } sys.scoring.expect()",
          "score.rule: unknown register \"chian\" (did you mean \"chain\"?)" },
        { "score.rule { on = 'kill', points = 'vlaue' } sys.scoring.expect()",
          "score.rule: unknown register \"vlaue\" (did you mean \"value\"?)" },
        { "score.tally { { label = 'A', value = 'graze', points = 1 } } sys.scoring.expect()",
          "score.tally: unknown register \"graze\" (did you mean \"grazes\"?)" },
        { "score.tally { { label = 'A', points = 1 } }", "score.tally line: value: expected a value, got nil" },
        { "score.tally { { label = 'A', value = 3, points = 1 } }",
          "score.tally: line 1: value: expected a property, a register or a function, got number" },
        { "score.tally {}",
          "score.tally: expected at least one line, such as { label = \"BOMBS\", value = \"bombs\", points = 1000 }" },
        { "score.rule { name = 'cancel', points = 1 } score.count('cancle', 1)",
          "score.count: unknown rule \"cancle\" (did you mean \"cancel\"?)" },
        { "unlock.def('a', { when = true })", "unlock.def: when: expected a table or a function, got boolean" },
        { "unlock.def('a', { when = { cleared = true } })",
          "unlock.def when: unknown argument \"cleared\" (did you mean \"clear\"?)" },
        { "unlock.def('a', { when = { clear = true } }) unlock.has('b')",
          "unlock.has: unknown unlock \"b\" (known: a)" },
        { "unlock.def('a', { when = {} }) unlock.def('a', { when = {} })",
          "unlock.def: unlock \"a\" is declared twice" },
        { "unlock.def('a name of five and twenty', { when = {} })",
          "unlock.def: name: expected a string of 1 to 24 bytes, got \"a name of five and twenty\"" },
        { "score.enter('t', { name = 'A', score = 1, stages = 3 })",
          "score.enter: unknown argument \"stages\" (did you mean \"stage\"?)" },
        { "score.enter('t', { name = 'A', score = 1, stage = 15 })",
          "score.enter: stage: expected a whole number from 1 to 14, got 15" },
    };

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char want[300];
        power(wrong[i][0], NULL);
        snprintf(want, sizeof want, "main.lua:10: %s", wrong[i][1]);
        if (!rig_fault(&rig))
            fail_msg("no fault: %s", wrong[i][0]);
        assert_string_equal(rig_fault(&rig)->message, want);
        done();
    }
}

/* What boot.run finds when all is declared. */
TEST(expected)
{
    static const char *const wrong[][2] = {
        { "unlock.def('a', { when = { clear = 'too' } })",
          "unlock.def: unknown stage \"too\" (did you mean \"two\"?)" },
        { "unlock.def('a', { when = { difficulty = 'herd' } })",
          "unlock.def: unknown difficulty \"herd\" (did you mean \"hard\"?)" },
        { "unlock.def('a', { when = { ship = 'shop' } })",
          "unlock.def: unknown player \"shop\" (did you mean \"ship\"?)" },
        { "unlock.def('a', { when = { spell = 'iris' } })",
          "unlock.def: spell: expected \"boss/id\", a boss and the id of its phase, got \"iris\"" },
        { "unlock.def('a', { when = { spell = 'iris/rain' } })", "unlock.def: unknown boss \"iris\" (known: none)" },
        { "unlock.def('a', { when = {} })\n"
          "stage.def('three', function() end, { needs = 'b' })",
          "stage.def: unknown unlock \"b\" (known: a)" },
        { "unlock.def('a', { when = {} })\n"
          "player.def('x', { sprite = 'dot', hit = { circle = 1 }, needs = 'c' })",
          "player.def: unknown unlock \"c\" (known: a)" },
    };

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[1000];
        snprintf(text, sizeof text,
                 "stage.def('two', function() end)\n%s\nboot.run { stages = { 'two' }, players = sys.kinds('player') }",
                 wrong[i][0]);
        power(text, NULL);
        if (!rig_fault(&rig))
            fail_msg("no fault: %s", wrong[i][0]);
        assert_string_equal(strchr(rig_fault(&rig)->message, ' ') + 1, wrong[i][1]);
        done();
    }
}

/* Two players through two stages, of which one is opened by the first, twice: what results, names and tables are told,
 * and what is kept. */
TEST(whole)
{
    static const char script[] =
        "score.rule { on = 'kill', points = 100 }\n"
        "score.tally { { label = 'LIVES', value = 'lives', points = 10, last = true },\n"
        "  { label = 'VALUE', value = 'value', points = 1, stage = true } }\n"
        "unlock.def('more', { when = { clear = 'one', difficulty = 'easy' }, title = 'More' })\n"
        "unlock.def('all', { when = { clear = true, continues = 0, ship = 'barge' } })\n"
        "unlock.def('never', { when = { clear = true, difficulty = 'hard' } })\n"
        "stage.def('one', function() wait(2) for i = 1, 2 do local p = player.get(i) p.value = p.value + i\n"
        "  enemy.spawn { kind = 'foe', x = 50, y = 50 }:hurt(9, p) end wait(2) end)\n"
        "stage.def('two', function() wait(2) end, { needs = 'more' })\n"
        "stage.def('three', function() end, { needs = 'never' })\n"
        "local function tell(_, n, _, rows, new)\n"
        "  local function value(v) if type(v) == 'function' then return v() end return v end\n"
        "  for _, r in ipairs(rows) do print(n, r[1], value(r[2]), value(r[3])) end print(table.concat(new, ' ')) end\n"
        "local function name(entries) local list = {}\n"
        "  for i, e in ipairs(entries) do print(e.p, e.points, e.rank) list[i] = 'P' .. e.p end return list end\n"
        "local function scores(difficulty, _, mark, ship) print(difficulty, mark, ship) end\n"
        "local games = 0\n"
        "local function title() wait(1) games = games + 1 if games < 3 then return 'start', 2 end\n"
        "  for _, r in ipairs(score.rows('easy')) do print(r.name, r.score, r.ship, r.stage, r.clear) end "
        "  print(unlock.has('more'), unlock.has('all'), unlock.has('never')) wait(9999) end\n"
        "boot.run { stages = { 'one', 'two', 'three' }, players = { 'ship', 'barge' }, screens = { title = title, "
        "results = "
        "tell,\n"
        "  difficulty = function() return 'easy' end, ship = function() return { 'ship', 'barge' } end, name = name,\n"
        "  scores = scores, ending = function() end } }";

    says(1500, script,
         "2\tVALUE\t1\t2\n2\tSCORE\t131\t132\nMore\n2\tLIVES\t40\t20\n2\tVALUE\t0\t0\n2\tSCORE\t171\t152\n\n"
         "1\t171\t1\n2\t152\t1\neasy\t1\tnil\n"
         "2\tVALUE\t1\t2\n2\tSCORE\t131\t132\n\n2\tLIVES\t40\t20\n2\tVALUE\t0\t0\n2\tSCORE\t171\t152\n\n"
         "1\t171\t2\n2\t152\t2\neasy\t1\tnil\n"
         "P1\t171\tship\tnil\ttrue\nP1\t171\tship\tnil\ttrue\nP2\t152\tbarge\tnil\ttrue\nP2\t152\tbarge\tnil\ttrue\n"
         "true\ttrue\tfalse\n");
}

RUN_TESTS(NULL, NULL)
