/*
 * test_talk.c - dialogue: letters, pages, choices, who answers; what players cannot do meanwhile; skips and stops.
 * tests/scripts/talk.lua has what needs no pads.
 */
#include "rig.h"

enum { BOX_COL = 2, BOX_ROW = 31, NAME_ROW = 28, BOX_COLS = 26 }; /* of the rig's field, 240 x 320 */

static struct rig_game g;
static struct rig r;

/* Two ships that tell what they see of their pads; `lines` runs in a task. */
static const char ships[] =
    "local told, taken, seen = '', 0, { '', '' }\n"
    "function string.told() return told end\n"
    "player.def('p', { sprite = 'dot', hit = { circle = 2 }, speed = 2, run = function(p)\n"
    "  while true do\n"
    "    seen[p.index] = (pad.down('fire', p) and 'f' or '') .. (pad.down('left', p) and 'l' or '')\n"
    "    if pad.take('fire', 60, p) then taken = taken + 1 end\n"
    "    wait(1)\n"
    "  end\n"
    "end })\n"
    "talk.def('iri', { name = 'IRI', faces = { calm = 'dot', cross = 'arrow' } })\n"
    "talk.def('sen', { name = 'SEN', faces = { calm = 'wink' }, side = 'right', bank = 3 })\n"
    "talk.def('voice', { name = 'VOICE' })\n"
    "enemy.def('e', { sprite = 'dot', hit = { circle = 3 } })\n"
    "boss.def('b', { title = '', kind = 'e', x = 100, y = 60, phases = {\n"
    "  { id = 'p', hp = 9, time = 40, run = function() say('sen', 'MINE', { letter = 0 }) end } } })\n"
    "for i = 1, string.sys.players() do string.sys.join(i, 'p') end\n";

static void open_it(const char *lines)
{
    static char text[8192];
    struct manifest m = rig_manifest();

    m.sprites = 32;
    snprintf(text, sizeof text, "%stask.go(function()\n%s\ntold = told .. 'end'\nend)", ships, lines);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
}

static void hold(int frames, uint16_t one, uint16_t two)
{
    const uint16_t pads[MAX_PLAYERS] = { one, two };

    while (frames-- > 0)
        rig_tick(&r, pads);
}

/* A press: a frame down, a frame up. */
static void press(uint16_t one, uint16_t two)
{
    hold(1, one, two);
    hold(1, 0, 0);
}

/* What stands in so many cells of a row, blanks at its end left out. */
static const char *cells(uint32_t row, uint32_t col, uint32_t n)
{
    static char text[64];
    const struct fix *f = &r.b->fix;
    uint32_t end = 0;

    for (uint32_t i = 0; i < n; i++) {
        uint8_t code = f->code[row * f->cols + col + i];
        text[i] = (char)(code ? code : ' ');
        end = code > 32 ? i + 1 : end;
    }
    text[end] = 0;
    return text;
}

static const char *words(int row)
{
    return cells((uint32_t)(BOX_ROW + 2 * row), BOX_COL, BOX_COLS);
}

static bool empty_screen(void)
{
    for (uint32_t i = 0; i < r.b->fix.s.live; i++)
        if (r.b->fix.code[i] > 32)
            return false;
    return r.b->sprites.s.live == 0 && r.b->screen.dim == 0;
}

static void told(const char *want)
{
    assert_string_equal(rig_told(&r), want);
}

/* A letter every second frame, blanks for nothing; the first in the frame in which it is said. */
TEST(letters)
{
    open_it("say(nil, 'AB CD')");
    rig_run(&r, 1);
    assert_string_equal(words(0), "A");
    rig_run(&r, 1);
    assert_string_equal(words(0), "A");
    rig_run(&r, 1);
    assert_string_equal(words(0), "AB");
    rig_run(&r, 2);
    assert_string_equal(words(0), "AB C");
    press(PAD_FIRE, 0); /* shows the rest */
    assert_string_equal(words(0), "AB CD");
    told("");
    int shown = 0;                  /* frames of the arrow */
    for (int i = 0; i < 320; i++) { /* and waits for ever */
        rig_run(&r, 1);
        shown += *cells(BOX_ROW + 5, BOX_COL + BOX_COLS - 1, 1) == 'v';
    }
    assert_int_equal(shown, 220);
    told("");
    press(PAD_FIRE, 0);
    told("end");
    assert_true(empty_screen());
    rig_close(&r);
    open_it("say(nil, 'ABCDE', { letter = 0, limit = 5 })");
    rig_run(&r, 1);
    assert_string_equal(words(0), "ABCDE");
    rig_run(&r, 4);
    told("");
    rig_run(&r, 1);
    told("end");
    rig_close(&r);
}

/* Three rows a page; fire turns it. What was held before is no press. */
TEST(pages)
{
    open_it("say(nil, 'ONE\\nTWO\\nTHREE\\nFOUR AND THIS GOES ON UNTIL IT DOES NOT FIT', { letter = 0 })");
    hold(9, PAD_FIRE, PAD_FIRE);
    assert_string_equal(words(0), "ONE");
    assert_string_equal(words(2), "THREE");
    hold(1, 0, 0);
    press(0, PAD_FIRE); /* any player's */
    assert_string_equal(words(0), "FOUR AND THIS GOES ON");
    assert_string_equal(words(1), "UNTIL IT DOES NOT FIT");
    assert_string_equal(words(2), "");
    told("");
    press(PAD_FIRE, 0);
    told("end");
    rig_close(&r);
}

/* The sprite in that layer on that half of the field, or -1; and how many sprites, plates too, are seen. */
static int standing(int layer, bool right, int *seen)
{
    int at = -1;

    *seen = 0;
    EACH_LIVE (i, &r.b->sprites.s) {
        *seen += !(r.b->sprites.flags[i] & SPRITE_HIDDEN);
        if (r.b->sprites.layer[i] == layer && (fx_floor(r.b->sprites.x[i]) > 120) == right)
            at = (int)i;
    }
    return at;
}

static void next_line(void)
{
    press(PAD_FIRE, 0);
    rig_run(&r, 40);
}

/* Who speaks is in front, the other dimmed; who has no face has a name; nobody has none. */
TEST(faces)
{
    int seen;

    open_it("talk.run(function()\n"
            "say('iri', 'A') say('sen', 'B') say('iri', 'C', { face = 'cross' }) say('voice', 'D') say(nil, 'E')\n"
            "say('iri', 'F', { side = 'right' }) end)");
    rig_run(&r, 40);
    assert_string_equal(cells(NAME_ROW, BOX_COL, BOX_COLS), " IRI"); /* over the lower edge of the portrait */
    int iri = standing(LAYER_OVER, false, &seen);
    assert_true(iri >= 0 && seen == 3);
    assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), r.b->screen.dim);
    next_line();
    assert_string_equal(cells(NAME_ROW, BOX_COL + BOX_COLS - 7, 7), "   SEN");
    int sen = standing(LAYER_OVER, true, &seen);
    assert_true(sen >= 0 && seen == 4);
    assert_int_equal(r.b->sprites.bank[sen], 3);
    assert_true(r.b->sprites.flags[sen] & SPRITE_FLIP_X);
    assert_int_equal(standing(LAYER_FRONT, false, &seen), iri);
    next_line();
    assert_int_equal(standing(LAYER_OVER, false, &seen), iri);
    assert_int_equal(r.b->sprites.sprite[iri], 0); /* arrow comes before dot */
    assert_int_equal(standing(LAYER_FRONT, true, &seen), sen);
    next_line();
    assert_string_equal(cells(NAME_ROW, BOX_COL, BOX_COLS), " VOICE");
    assert_int_equal(standing(LAYER_OVER, false, &seen), -1);
    next_line();
    assert_string_equal(cells(NAME_ROW, BOX_COL, BOX_COLS), "");
    assert_int_equal(standing(LAYER_OVER, true, &seen), -1);
    assert_int_equal(seen, 3); /* no name's plate */
    next_line();
    assert_true(standing(LAYER_OVER, true, &seen) >= 0 && standing(LAYER_FRONT, false, &seen) < 0);
    assert_int_equal(seen, 3); /* she went round, and the other is gone */
    press(PAD_FIRE, 0);
    assert_true(empty_screen());
    rig_close(&r);
}

/* What ship 2 sees of fire and left, both held, in a talk that holds like this. */
static void sees(const char *how, const char *want)
{
    static char lines[256];

    snprintf(lines, sizeof lines, "talk.run(function() wait(20) told = seen[2] .. '.' end%s)", how);
    open_it(lines);
    const fx x = r.b->player.x[1];
    hold(19, 0, PAD_FIRE | PAD_LEFT);
    assert_true((r.b->player.x[1] < x) == (strchr(want, 'l') != NULL));
    hold(3, 0, PAD_FIRE | PAD_LEFT);
    told(want);
    rig_close(&r);
}

/* What the ships see of fire and left, by hold. */
TEST(hold)
{
    sees("", "l.end");
    sees(", { hold = 'fire' }", "l.end");
    sees(", { hold = 'all' }", ".end");
    sees(", { hold = 'none' }", "fl.end");
}

/* A press of the time that ships do not see is nobody's afterwards. */
TEST(presses)
{
    open_it("say(nil, 'A', { letter = 0 }) told = tostring(taken) wait(9) told = told .. taken");
    hold(1, 0, 0);
    press(PAD_FIRE, 0);
    rig_run(&r, 12);
    told("00end");
    rig_close(&r);
}

/* Special held for a third of a second: no say, wait or choose takes time, but the talk goes through. */
TEST(skip)
{
    open_it(
        "talk.run(function() say(nil, 'A') wait(600) told = told .. choose({ 'X', 'Y' }, { chosen = 2 })\n"
        "say('iri', 'B') told = told .. 'all ' end) local f = board.frame() wait(3) told = told .. board.frame() - f");
    hold(10, 0, PAD_SPECIAL);
    hold(5, 0, 0);
    told("");
    hold(19, 0, PAD_SPECIAL);
    told("");
    hold(2, 0, PAD_SPECIAL);
    told("2all ");
    rig_run(&r, 3);
    told("2all 3end");
    assert_true(empty_screen());
    rig_close(&r);
    open_it("talk.run(function() wait(600) end)"); /* in a wait, too */
    hold(25, PAD_SPECIAL, 0);
    told("end");
    rig_close(&r);
    open_it("talk.run(function() say(nil, 'A') end, { skip = false })");
    hold(99, PAD_SPECIAL, PAD_SPECIAL);
    told("");
    rig_close(&r);
}

TEST(choose)
{
    open_it("told = choose({ 'ONE', 'TWO', 'THREE' }, { title = 'WHICH?' }) .. ''");
    fx y = r.b->player.y[0];
    rig_run(&r, 1);
    press(PAD_DOWN, 0);
    press(0, PAD_DOWN);
    press(PAD_DOWN, 0); /* round */
    press(PAD_UP, 0);
    press(PAD_BOMB, 0); /* nothing */
    told("");
    assert_int_equal(r.b->player.y[0], y); /* the ships stand */
    press(PAD_FIRE, 0);
    told("3end");
    assert_true(empty_screen());
    rig_close(&r);
    open_it("told = choose({ 'ONE', 'TWO' }, { p = 2, chosen = 2, back = 1 }) .. ''");
    rig_run(&r, 1);
    press(PAD_UP | PAD_FIRE, 0); /* not asked */
    press(PAD_BOMB, 0);
    told("");
    press(0, PAD_BOMB);
    told("1end");
    rig_close(&r);
    open_it("told = choose({ 'ONE', 'TWO' }, { limit = 9 }) .. ''");
    rig_run(&r, 2);
    press(PAD_DOWN, 0);
    rig_run(&r, 9);
    told("2end");
    rig_close(&r);
}

/* In a talk the words stay behind the list; afterwards ships see what they saw. */
TEST(choose_in_talk)
{
    open_it("talk.run(function() say('iri', 'A', { letter = 0 }) told = choose({ 'X', 'Y' }) .. ''\n"
            "say(nil, 'B', { letter = 0 }) end)");
    rig_run(&r, 1);
    press(PAD_FIRE, 0);
    assert_string_equal(words(0), "A");
    hold(3, PAD_LEFT, 0);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0) & PAD_LEFT, PAD_LEFT);
    press(PAD_FIRE, 0);
    told("1");
    assert_string_equal(words(0), "B");
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), PAD_FIRE | PAD_BOMB | PAD_SPECIAL);
    press(PAD_FIRE, 0);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_close(&r);
}

/* A list stands where a banner does: what was there is gone before. */
TEST(banner)
{
    open_it("hud.banner({ 'A STAGE' }, 900) wait(2) talk.run(function() wait(3) end)");
    rig_run(&r, 2);
    assert_string_equal(cells(13, 0, 30), "           A STAGE");
    rig_run(&r, 1);
    assert_string_equal(cells(13, 0, 30), "");
    rig_close(&r);
}

/* A talk whose task is stopped, or whose phase of a boss ends, is taken away: box, faces and what it held. */
TEST(stop)
{
    static const struct {
        const char *lines;
        int shown, over; /* frames with and without it */
    } of[] = {
        { "local t = task.go(function() talk.run(function() say('iri', 'A') end, { hold = 'all' }) end)\n"
          "wait(20) task.stop(t)",
          15, 25 },
        { "boss.fight 'b'", 75, 115 },
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        open_it(of[i].lines);
        rig_run(&r, of[i].shown);
        assert_false(empty_screen());
        rig_run(&r, of[i].over - of[i].shown);
        assert_true(empty_screen());
        assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
        rig_close(&r);
    }
}

/* After a wipe the rows are another's; and a talk that starts before the stopped one is closed stays. */
TEST(stop_late)
{
    open_it("local t = task.go(function() say('iri', 'A') end)\n"
            "wait(20) task.stop(t) string.sys.wipe() text.put { col = 2, row = 31, text = 'SCORES' }");
    rig_run(&r, 25);
    assert_string_equal(words(0), "SCORES");
    assert_int_equal(r.b->screen.dim, 0);
    rig_close(&r);
    open_it("local t = task.go(function() say('iri', 'OLD') end)\n"
            "wait(20) task.stop(t) say('sen', 'NEW', { letter = 0 })");
    rig_run(&r, 25);
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), PAD_FIRE | PAD_BOMB | PAD_SPECIAL);
    press(PAD_FIRE, 0);
    told("end");
    assert_int_equal(player_ignored_buttons(&r.b->player, 0), 0);
    rig_close(&r);
}

/* Fire that is held goes on by itself, quickly, after half a second; not if it was held before the talk, and a list
 * waits for a press. */
TEST(hurry)
{
    open_it("wait(5) for i = 1, 4 do say(nil, 'ABCDEFGHIJ' .. i) end told = told .. 'all '\n"
            "choose { 'YES', 'NO' } say(nil, 'X')");
    hold(200, PAD_FIRE, 0); /* as when it shot at somebody */
    assert_string_equal(words(0), "ABCDEFGHIJ1");
    hold(1, 0, 0);
    press(PAD_FIRE, 0);
    hold(4, 0, 0);
    assert_string_equal(words(0), "ABC");
    hold(25, PAD_FIRE, 0); /* this press shows the rest */
    assert_string_equal(words(0), "ABCDEFGHIJ2");
    hold(10, PAD_FIRE, 0);
    assert_string_equal(words(0), "ABC");
    hold(12, PAD_FIRE, 0);
    assert_true(strlen(words(0)) < 6);
    hold(12, PAD_FIRE, 0);
    told("all ");
    hold(200, PAD_FIRE, 0);
    told("all ");
    press(0, 0);
    press(PAD_FIRE, 0);
    hold(200, 0, 0);
    assert_string_equal(words(0), "X");
    rig_close(&r);
}

/* What freezes the board sees all buttons, and its presses are not the talk's. */
TEST(pause)
{
    open_it("task.go(function() wait(10)\n"
            "  local s = string.sys.scope()\n"
            "  task.own(s, function()\n"
            "    while not pad.take('fire', 0, 1) do wait(1) end told = told .. 'paused ' string.sys.freeze() "
            "task.stop(s)\n"
            "  end)\n"
            "  string.sys.freeze(s)\n"
            "end)\n"
            "say(nil, 'A', { letter = 0 })");
    rig_run(&r, 30);
    press(PAD_FIRE, 0);
    told("paused ");
    rig_run(&r, 30);
    told("paused ");
    press(PAD_FIRE, 0);
    told("paused end");
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
