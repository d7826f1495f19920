/*
 * test_score.c - what is unlocked and in tables at the next power-on and after whole games. tests/scripts/score.lua has
 * the rules of scoring.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static const char kinds[] = "player.def('ship', { sprite = 'dot', hit = { circle = 3 }, lives = 5, safe = 0,\n"
                            "  registers = { value = 100 } })\n"
                            "player.def('barge', { sprite = 'dot', hit = { circle = 3 }, registers = { value = 7 } })\n"
                            "player.def('tug', { sprite = 'dot', hit = { circle = 3 } })\n"
                            "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9, score = 30 })\n"
                            "local sys = string.sys\n";

static void power(const char *text, const struct board_start *start)
{
    struct manifest m = rig_manifest();
    static char script[8192];

    m.n_difficulties = 2;
    memset(m.difficulties, 0, sizeof m.difficulties);
    strcpy(m.difficulties[0], "easy");
    strcpy(m.difficulties[1], "hard");
    snprintf(script, sizeof script, "%s%s", kinds, text);
    rig_with_sys(&g, &m, script);
    rig_power_any(&rig, &g, start);
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
    rig_close(&rig);
    assert_string_equal(says_from(script, 2, &start), "true\n");
    rig_close(&rig);
}

/* Two players twice through two stages, the first of which opens the second: what results, names and tables are told,
 * and what is kept. An unlock of an easier difficulty is earned too. */
TEST(whole)
{
    static const char script[] =
        "score.rule { on = 'kill', points = 100 }\n"
        "score.tally { { label = 'LIVES', value = 'lives', points = 10, last = true },\n"
        "  { label = 'VALUE', value = 'value', points = 1, stage = true } }\n"
        "unlock.def('more', { when = { clear = 'one', difficulty = 'easy' }, title = 'More' })\n"
        "unlock.def('all', { when = { clear = true, continues = 0, ship = 'barge' } })\n"
        "unlock.def('never', { when = { clear = true, ship = 'tug' } })\n"
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
        "  for _, r in ipairs(score.rows('hard')) do print(r.name, r.score, r.ship, r.stage, r.clear) end "
        "  print(unlock.has('more'), unlock.has('all'), unlock.has('never')) wait(9999) end\n"
        "boot.run { stages = { 'one', 'two', 'three' }, players = { 'ship', 'barge' }, screens = { title = title, "
        "results = "
        "tell,\n"
        "  start = function() return { difficulty = 'hard', ships = { 'ship', 'barge' } } end, name = name,\n"
        "  scores = scores, again = function() end, ending = function() end } }";

    assert_string_equal(
        says_from(script, 1500, NULL),
        "2\tVALUE\t1\t2\n2\tScore\t131\t132\nMore\n2\tLIVES\t40\t20\n2\tVALUE\t0\t0\n2\tScore\t171\t152\n\n"
        "1\t171\t1\n2\t152\t1\nhard\t1\tnil\n"
        "2\tVALUE\t1\t2\n2\tScore\t131\t132\n\n2\tLIVES\t40\t20\n2\tVALUE\t0\t0\n2\tScore\t171\t152\n\n"
        "1\t171\t2\n2\t152\t2\nhard\t1\tnil\n"
        "P1\t171\tship\tnil\ttrue\nP1\t171\tship\tnil\ttrue\nP2\t152\tbarge\tnil\ttrue\nP2\t152\tbarge\tnil\ttrue\n"
        "true\ttrue\tfalse\n");
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)
