/*
 * test_lines.c - lines of text: what a script makes and reads of them, with whom they go, when letters come, where what
 * is drawn; fonts and their fallbacks; cells with room for any character.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

#define WORDS                                                                                                          \
    "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"                                                            \
    "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 5 })\n"

static struct manifest with_lines(int n)
{
    struct manifest m = rig_manifest();

    m.lines = n;
    m.has_wide_text = 1;
    return m;
}

static void power(const char *text, int frames)
{
    struct manifest m = with_lines(8);

    rig_script(&g, &m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, frames);
}

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

/* Its asserts are the test. */
static void holds(const char *text, int frames)
{
    power(text, frames);
    end();
}

static void faults(const char *text, const char *want)
{
    struct manifest m = with_lines(8);

    rig_script(&g, &m, text);
    rig_power_any(&rig, &g, NULL);
    assert_non_null(rig_fault(&rig));
    assert_string_equal(rig_fault(&rig)->message, want);
    end();
}

TEST(properties)
{
    holds("task.go(function()\n"
          "  local l = text.line { x = 3.5, y = -7, text = '\xc3\xa9t\xc3\xa9', bank = 4 }\n"
          "  assert(l.alive and l.x == 3.5 and l.y == -7 and l.dx == 0 and l.dy == 0 and l.bank == 4 and l.done)\n"
          "  assert(l.text == '\xc3\xa9t\xc3\xa9' and not l.hidden)\n"
          "  l.text, l.x, l.dy, l.hidden, l.bank = '\\233', 9, 2.25, true, 15\n"
          "  assert(l.text == '\xc3\xa9' and l.x == 9 and l.dy == 2.25 and l.hidden and l.bank == 15)\n"
          "  l.text = ('\xe5\xbc\xbe'):rep(240) assert(#l.text == 720)\n"
          "  l.text = '' assert(l.text == '' and l.done)\n"
          "  l:remove() assert(not l.alive and l.text == nil) l.text = 'x' l:remove()\n"
          "  local n = text.line { x = 0, y = 0, text = 12 } assert(n.text == '12')\n"
          "end)",
          2);
    faults("text.line { x = 1, y = 1, text = ('x'):rep(241) }",
           "main.lua:1: text.line: text: expected at most 240 characters, got 241");
    faults("text.line { x = 1, y = 1, text = 0/0 }", "main.lua:1: text.line: text: expected a finite number");
    faults("text.line { x = 1, y = 1, text = {} }",
           "main.lua:1: text.line: text: expected a string or a number, got a table");
    faults("text.line { x = 1, y = 1, text = 'a', font = 'tinny' }",
           "main.lua:1: text.line: unknown font \"tinny\" (did you mean \"tiny\"?)");
    faults("local s = sprite.put { sprite = 'dot', x = 1, y = 1 } text.line { follow = s, x = 1, text = 'a' }",
           "main.lua:1: text.line: `follow` cannot be combined with `x`, `y` or `from`");
    faults("local s = sprite.put { sprite = 'dot', x = 1, y = 1 } text.line { follow = s, screen = true, text = 'a' }",
           "main.lua:1: text.line: `screen` cannot be combined with `follow`");
    faults("text.line { x = 1, y = 1, text = 'a', width = 7 }",
           "main.lua:1: text.line: width: expected a whole number from 8 to 1024 px, got 7");
}

TEST(letters)
{
    power("text.line { x = 0, y = 0, text = 'abcd', letter = 3 }", 0);
    const uint32_t want[] = { 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4 };
    for (int f = 0; f < 14; f++, rig_run(&rig, 1))
        assert_int_equal(lines_visible_letters(&rig.b->lines, 0, rig.b->core.clock), want[f]);
    for (int k = 4; k < LINE_MAX_TEXT; k++) /* what stood there before is no part of the state */
        assert_int_equal(rig.b->lines.code[k], 0);
    end();
    holds("task.go(function()\n"
          "  local l = text.line { x = 0, y = 0, text = 'abcd', letter = 3 }\n"
          "  for i = 0, 14 do assert(l.done == (i >= 12)) wait(1) end\n"
          "  l.text = 'ab' for i = 0, 7 do assert(l.done == (i >= 6)) wait(1) end\n"
          "end)",
          30);
}

/* With a thing, with the phase or the task's scene that made it, with the field. */
TEST(gone)
{
    holds(WORDS "task.go(function()\n"
                "  local b = bullet.fire { kind = 'dot', x = 50, y = 50, dir = 0, speed = 2 }\n"
                "  local l = text.line { follow = b, dx = 3, dy = -4.5, text = 'x' }\n"
                "  assert(l.x == 50 and l.y == 50 and l.dx == 3 and l.dy == -4.5)\n"
                "  wait(5) assert(l.x == b.x and l.x > 50) l.x = 7 assert(l.x == b.x)\n"
                "  l.dx = 8 assert(l.dx == 8)\n"
                "  b:remove() wait(1) assert(not l.alive)\n"
                "  assert(not text.line { follow = b, text = 'x' }.alive)\n"
                "  assert(not text.line { from = b, text = 'x' }.alive)\n"
                "  local e = enemy.spawn { kind = 'foe', x = 9, y = 9 }\n"
                "  l = text.line { follow = e, text = 'x' } local k = text.line { from = e, dx = 2, text = 'x' }\n"
                "  e:kill() wait(1) assert(not l.alive and k.alive and k.x == 11 and k.dx == 0)\n"
                "  local s = sprite.put { sprite = 'dot', x = 1, y = 1 } l = text.line { follow = s, text = 'x' }\n"
                "  wait(1) assert(l.alive) s:remove() wait(1) assert(not l.alive)\n"
                "  for i = 1, 9 do l = text.line { x = i, y = i, text = i } assert(l.alive == (i < 8)) end\n"
                "  assert(board.refused('lines') == 2)\n"
                "end)",
          20);
    holds("enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 10 })\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
          "local kept, lost\n"
          "boss.def('iris', { title = 'Iris', kind = 'foe', x = 60, y = 60, phases = {\n"
          "  { id = 'a', hp = 10, time = 20, run = function()\n"
          "    lost = text.line { x = 1, y = 1, text = 'lost' }\n"
          "    kept = text.line { x = 1, y = 1, text = 'kept', stay = true } end },\n"
          "  { id = 'b', hp = 10, time = 20, run = function() assert(kept.alive and not lost.alive) end } } })\n"
          "stage.def('one', function() boss.fight('iris') end)\n"
          "boot.run { stages = { 'one' }, players = { 'ship' } }\n",
          5);
}

/* ---- what is drawn ---- */

static uint8_t pixel(int x, int y)
{
    return rig.fb.pix[y * rig.fb.pitch + x];
}

/* Is the face "tiny"'s A, 3 x 4 px below its line's top by one, there and in that bank? */
static bool is_a(int x, int y, int bank)
{
    return pixel(x, y + 1) == bank * 16 + 15 && pixel(x + 2, y + 1) == bank * 16 + 15 && pixel(x + 1, y + 1) == 0 &&
           pixel(x, y + 2) == bank * 16 + 3 && pixel(x + 1, y + 2) == bank * 16 + 3;
}

static void draw(const char *text, int frames)
{
    power(text, frames);
    rig_picture(&rig);
}

TEST(places)
{
    draw("text.line { x = 20, y = 30, text = 'AAA', font = 'tiny', bank = 2 }", 1);
    assert_true(is_a(20, 30, 2) && is_a(24, 30, 2) && is_a(28, 30, 2) && pixel(19, 31) == 0 && pixel(32, 31) == 0);
    end();
    draw("text.line { x = 20, y = 30, text = 'AAA', font = 'tiny', align = 'right' }", 1);
    assert_true(is_a(8, 30, 0) && is_a(16, 30, 0) && pixel(20, 31) == 0);
    end();
    draw("text.line { x = 20, y = 30, text = 'AA\\nAAAA', font = 'tiny', align = 'center' }", 1);
    assert_true(is_a(16, 30, 0) && is_a(20, 30, 0) && pixel(12, 31) == 0);
    assert_true(is_a(12, 36, 0) && is_a(24, 36, 0) && pixel(28, 37) == 0);
    end();
    draw("local l = text.line { x = 20.75, y = 30, text = 'A', font = 'tiny' } l.dx, l.dy = -3, 5.5", 1);
    assert_true(is_a(17, 35, 0));
    end();
    draw("text.line { x = 20, y = 30, text = 'A', font = 'tiny', hidden = true }", 1);
    assert_true(pixel(20, 31) == 0);
    end();
    draw("text.line { x = 20, y = 30, text = 'AAA', font = 'tiny', letter = 2 }", 4);
    assert_true(is_a(20, 30, 0) && is_a(24, 30, 0) && pixel(28, 31) == 0);
    end();
}

TEST(rows)
{
    /* a blank is 2 px, an A 4: three of them and two blanks are 16 */
    draw("text.line { x = 0, y = 0, text = 'A A A A', font = 'tiny', width = 16 }", 1);
    assert_true(is_a(0, 0, 0) && is_a(6, 0, 0) && is_a(12, 0, 0) && is_a(0, 6, 0) && pixel(18, 1) == 0);
    end();
    draw("text.line { x = 0, y = 0, text = 'A AA AA', font = 'tiny', width = 15 }", 1);
    assert_true(is_a(0, 0, 0) && is_a(6, 0, 0) && is_a(10, 0, 0) && is_a(0, 6, 0) && is_a(4, 6, 0));
    end();
    draw("text.line { x = 0, y = 0, text = 'AAAAA', font = 'tiny', width = 8 }", 1); /* a word wider than a row */
    assert_true(is_a(4, 0, 0) && pixel(8, 1) == 0 && is_a(0, 6, 0) && is_a(4, 6, 0) && is_a(0, 12, 0));
    end();
    /* between characters without blanks, but not before one that closes: 7 px each, the sign a box of 4 */
    draw("text.line { x = 0, y = 0, text = '\xe5\xbc\xbe\xe5\xbc\xbe\xe5\xbc\xbe', font = 'tiny', width = 15 }", 1);
    assert_true(pixel(9, 0) == 3 && pixel(15, 0) == 0 && pixel(2, 6) == 3);
    end();
    draw("text.line { x = 0, y = 0, text = '\xe5\xbc\xbe\xe5\xbc\xbe\xe3\x80\x82', font = 'tiny', width = 15 }", 1);
    assert_true(pixel(2, 0) == 3 && pixel(9, 0) == 0 && pixel(2, 6) == 3);
    end();
    /* letters that have not come do not change the rows */
    draw("text.line { x = 0, y = 0, text = 'A AA AA', font = 'tiny', width = 15, letter = 1 }", 6);
    assert_true(is_a(10, 0, 0) && is_a(0, 6, 0) && pixel(4, 7) == 0);
    end();
}

TEST(box)
{
    draw("text.line { x = 20, y = 30, text = 'A AA', font = 'tiny', box = true, bank = 3, letter = 99 }", 1);
    assert_true(pixel(14, 32) == 49 && pixel(15, 32) == 58 && pixel(16, 32) == 49 && pixel(38, 32) == 58);
    assert_true(pixel(26, 24) == 49 && pixel(26, 25) == 58 && pixel(26, 40) == 58 && pixel(26, 41) == 49);
    assert_true(pixel(14, 24) == 0 && pixel(13, 32) == 0 && pixel(40, 32) == 0 && pixel(26, 42) == 0);
    end();
    draw("text.line { x = 20, y = 30, text = 'A AA', font = 'tiny', box = true, width = 50 }", 1);
    assert_true(pixel(15, 32) == 10 && pixel(74, 32) == 10 && pixel(76, 32) == 0);
    end();
}

/* Another font's picture, then the cells' own at the row's foot, then a box. */
TEST(fallback)
{
    draw("text.line { x = 20, y = 30, text = '\xe5\xbc\xbe' }", 1); /* of tiny, at the foot of 8 px */
    assert_true(pixel(22, 32) == 3 && pixel(22, 31) == 0);
    end();
    draw("text.line { x = 20, y = 30, text = 'B', font = 'tiny' }", 1); /* 8 px high over a row of 6 */
    uint8_t is = pixel(21, 29);
    end();
    draw("text.line { x = 20, y = 28, text = 'B' }", 1);
    assert_int_equal(pixel(21, 29), is);
    end();
    draw("text.line { x = 20, y = 30, text = '\xf0\x9f\x98\x80', font = 'tiny', bank = 1 }", 1);
    assert_true(pixel(20, 30) == 31 && pixel(22, 30) == 31 && pixel(20, 34) == 31 && pixel(23, 31) == 17);
    end();
}

TEST(clip)
{
    struct manifest m = with_lines(8);

    m.field_x = 40;
    m.field_w = 100;
    const char *const places[] = { "x = -2", "x = 38, screen = true", "x = 99" };
    const int first[] = { 40, 38, 139 };
    for (int i = 0; i < 3; i++) {
        char text[200];
        snprintf(text, sizeof text, "text.line { %s, y = 10, text = 'AAAA', font = 'tiny' }", places[i]);
        rig_script(&g, &m, text);
        rig_power(&rig, &g, NULL);
        rig_run(&rig, 1);
        rig_picture(&rig);
        int x = 0;
        while (x < 239 && pixel(x, 12) == 0)
            x++;
        assert_int_equal(x, first[i]);
        if (i == 2)
            assert_int_equal(pixel(140, 12), 0);
        end();
    }
}

TEST(cells)
{
    draw("text.put { col = 2, row = 3, text = '\xe5\xbc\xbe\xf0\x9f\x98\x80', bank = 1 }\n"
         "text.put { col = 2, row = 5, text = 'A', font = 'tiny' }",
         1);
    assert_int_equal(fix_code(&rig.b->fix, 3 * 30 + 2), 0x5f3e);
    assert_int_equal(fix_code(&rig.b->fix, 3 * 30 + 3), 0x1f600);
    assert_true(pixel(18, 26) == 19 && pixel(24, 24) == 31 && is_a(16, 40, 0));
    rig_spoil(&rig);
    assert_int_equal(fix_code(&rig.b->fix, 3 * 30 + 3), 0x1f600);
    end();
    draw("palette.set(0, 0xffffff) palette.set(200, 0) text.put { col = 2, row = 5, text = 'A', font = 'tiny', rim = "
         "true, bank = 2 }",
         1);
    int dark = 0;
    for (int i = 1; i < 256; i++)
        dark = rig.b->pal.rgb[i] == 0 && !dark ? i : dark;
    assert_true(dark > 0);
    for (int y = 38; y < 48; y++)
        for (int x = 13; x < 22; x++) {
            bool next = false;
            for (int k = 0; k < 9; k++)
                next |= pixel(x + k % 3 - 1, y + k / 3 - 1) / 16 == 2;
            assert_true(pixel(x, y) / 16 == 2 || pixel(x, y) == (next ? dark : 0));
        }
    assert_int_equal(pixel(17, 41), dark);
    assert_int_equal(pixel(16, 41), 2 * 16 + 15);
    end();
    struct manifest m = with_lines(0);
    m.has_wide_text = 0;
    rig_script(&g, &m, "text.put { col = 2, row = 3, text = 'A', font = 'tiny' }");
    rig_power_any(&rig, &g, NULL);
    assert_string_equal(
        rig_fault(&rig)->message,
        "main.lua:1: text.put: font: fonts in text cells are disabled; add `wide = true` to `board` in rom.lua");
    end();
    rig_script(&g, &m, "text.line { x = 1, y = 1, text = 'A' }");
    rig_power_any(&rig, &g, NULL);
    assert_string_equal(rig_fault(&rig)->message,
                        "main.lua:1: text.line: text lines are disabled; add `lines = 32` to `board` in rom.lua");
    end();
}

/* The state is the same whatever the fonts look like. */
TEST(no_widths)
{
    const char *script =
        "task.go(function() local l = text.line { x = 9, y = 9, text = 'A A', width = 9, font = 'tiny',"
        " letter = 2 } while true do board.note(l.done and l.x or 3) wait(1) end end)";
    uint64_t hash;

    power(script, 9);
    hash = board_hash(rig.b);
    end();
    struct manifest m = with_lines(8);
    rig_script(&g, &m, script);
    int i = rom_find(&g.image.rom, "fonts/tiny");
    struct lump l;
    rom_lump(&g.image.rom, i, &l);
    ((uint8_t *)(uintptr_t)l.data)[FACE_HEADER_SIZE + 12] = 60;
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 9);
    assert_true(board_hash(rig.b) == hash);
    end();
}

RUN_TESTS(NULL, NULL)
