/*
 * test_lines.c - lines of text as they are drawn: places, rows, boxes, fonts and their fallbacks; cells with space for
 * any character. tests/scripts/lines.lua has the rest.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static void power_with(const struct manifest *m, const char *text, int frames)
{
    rig_close(&rig);
    rig_script(&g, m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, frames);
}

static struct manifest with_lines(void)
{
    struct manifest m = rig_manifest();

    m.lines = 8;
    m.has_wide_text = 1;
    return m;
}

static void power(const char *text, int frames)
{
    const struct manifest m = with_lines();

    power_with(&m, text, frames);
}

TEST(letters)
{
    power("text.line { x = 0, y = 0, text = 'abcd', letter = 3 }", 0);
    for (uint32_t frame = 0; frame < 14; frame++, rig_run(&rig, 1))
        assert_int_equal(lines_visible_letters(&rig.b->lines, 0, rig.b->core.clock), frame < 12 ? frame / 3 : 4);
    for (int k = 4; k < LINE_MAX_TEXT; k++) /* what was there before is no part of the state */
        assert_int_equal(rig.b->lines.code[k], 0);
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
    draw("text.line { x = 20, y = 30, text = 'AAA', font = 'tiny', align = 'right' }", 1);
    assert_true(is_a(8, 30, 0) && is_a(16, 30, 0) && pixel(20, 31) == 0);
    draw("text.line { x = 20, y = 30, text = 'AA\\nAAAA', font = 'tiny', align = 'center' }", 1);
    assert_true(is_a(16, 30, 0) && is_a(20, 30, 0) && pixel(12, 31) == 0);
    assert_true(is_a(12, 36, 0) && is_a(24, 36, 0) && pixel(28, 37) == 0);
    draw("local l = text.line { x = 20.75, y = 30, text = 'A', font = 'tiny' } l.dx, l.dy = -3, 5.5", 1);
    assert_true(is_a(17, 35, 0));
    draw("text.line { x = 20, y = 30, text = 'A', font = 'tiny', hidden = true }", 1);
    assert_true(pixel(20, 31) == 0);
    draw("text.line { x = 20, y = 30, text = 'AAA', font = 'tiny', letter = 2 }", 4);
    assert_true(is_a(20, 30, 0) && is_a(24, 30, 0) && pixel(28, 31) == 0);
}

TEST(rows)
{
    /* a blank is 2 px, an A 4: three of them and two blanks are 16 */
    draw("text.line { x = 0, y = 0, text = 'A A A A', font = 'tiny', width = 16 }", 1);
    assert_true(is_a(0, 0, 0) && is_a(6, 0, 0) && is_a(12, 0, 0) && is_a(0, 6, 0) && pixel(18, 1) == 0);
    draw("text.line { x = 0, y = 0, text = 'A AA AA', font = 'tiny', width = 15 }", 1);
    assert_true(is_a(0, 0, 0) && is_a(6, 0, 0) && is_a(10, 0, 0) && is_a(0, 6, 0) && is_a(4, 6, 0));
    draw("text.line { x = 0, y = 0, text = 'AAAAA', font = 'tiny', width = 8 }", 1); /* a word wider than a row */
    assert_true(is_a(4, 0, 0) && pixel(8, 1) == 0 && is_a(0, 6, 0) && is_a(4, 6, 0) && is_a(0, 12, 0));
    /* between characters without blanks, but not before one that closes: 7 px each, the sign a box of 4 */
    draw("text.line { x = 0, y = 0, text = '\xe5\xbc\xbe\xe5\xbc\xbe\xe5\xbc\xbe', font = 'tiny', width = 15 }", 1);
    assert_true(pixel(9, 0) == 3 && pixel(15, 0) == 0 && pixel(2, 6) == 3);
    draw("text.line { x = 0, y = 0, text = '\xe5\xbc\xbe\xe5\xbc\xbe\xe3\x80\x82', font = 'tiny', width = 15 }", 1);
    assert_true(pixel(2, 0) == 3 && pixel(9, 0) == 0 && pixel(2, 6) == 3);
    /* letters that have not come do not change the rows */
    draw("text.line { x = 0, y = 0, text = 'A AA AA', font = 'tiny', width = 15, letter = 1 }", 6);
    assert_true(is_a(10, 0, 0) && is_a(0, 6, 0) && pixel(4, 7) == 0);
}

TEST(box)
{
    draw("text.line { x = 20, y = 30, text = 'A AA', font = 'tiny', box = true, bank = 3, letter = 99 }", 1);
    assert_true(pixel(14, 32) == 49 && pixel(15, 32) == 58 && pixel(16, 32) == 49 && pixel(38, 32) == 58);
    assert_true(pixel(26, 24) == 49 && pixel(26, 25) == 58 && pixel(26, 40) == 58 && pixel(26, 41) == 49);
    assert_true(pixel(14, 24) == 0 && pixel(13, 32) == 0 && pixel(40, 32) == 0 && pixel(26, 42) == 0);
    draw("text.line { x = 20, y = 30, text = 'A AA', font = 'tiny', box = true, width = 50 }", 1);
    assert_true(pixel(15, 32) == 10 && pixel(74, 32) == 10 && pixel(76, 32) == 0);
}

/* Another font's picture, then the cells' own at the row's foot, then a box. */
TEST(fallback)
{
    draw("text.line { x = 20, y = 30, text = '\xe5\xbc\xbe' }", 1); /* of tiny, at the foot of 8 px */
    assert_true(pixel(22, 32) == 3 && pixel(22, 31) == 0);
    draw("text.line { x = 20, y = 30, text = 'B', font = 'tiny' }", 1); /* 8 px high over a row of 6 */
    uint8_t is = pixel(21, 29);
    draw("text.line { x = 20, y = 28, text = 'B' }", 1);
    assert_int_equal(pixel(21, 29), is);
    draw("text.line { x = 20, y = 30, text = '\xf0\x9f\x98\x80', font = 'tiny', bank = 1 }", 1);
    assert_true(pixel(20, 30) == 31 && pixel(22, 30) == 31 && pixel(20, 34) == 31 && pixel(23, 31) == 17);
}

TEST(clip)
{
    struct manifest m = with_lines();

    m.field_x = 40;
    m.field_w = 100;
    const char *const places[] = { "x = -2", "x = 38, screen = true", "x = 99" };
    const int first[] = { 40, 38, 139 };
    for (int i = 0; i < 3; i++) {
        char text[200];
        snprintf(text, sizeof text, "text.line { %s, y = 10, text = 'AAAA', font = 'tiny' }", places[i]);
        power_with(&m, text, 1);
        rig_picture(&rig);
        int x = 0;
        while (x < 239 && pixel(x, 12) == 0)
            x++;
        assert_int_equal(x, first[i]);
        if (i == 2)
            assert_int_equal(pixel(140, 12), 0);
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
    draw("palette.set(0, 0xffffff) palette.set(200, 0) text.put { col = 2, row = 5, text = 'AA', font = 'tiny', "
         "rim = true, bank = 2 }",
         1);
    int dark = 0;
    for (int i = 1; i < 256; i++)
        dark = rig.b->pal.rgb[i] == 0 && !dark ? i : dark;
    assert_true(dark > 0);
    for (int y = 38; y < 48; y++)
        for (int x = 13; x < 30; x++) {
            bool next = false;
            for (int k = 0; k < 9; k++)
                next |= pixel(x + k % 3 - 1, y + k / 3 - 1) / 16 == 2;
            assert_true(pixel(x, y) / 16 == 2 || pixel(x, y) == (next ? dark : 0));
        }
    assert_int_equal(pixel(17, 41), dark);
    assert_int_equal(pixel(16, 41), 2 * 16 + 15);
}

/* Full-width letters, 12 px each, in the middle of their row. */
TEST(full_width)
{
    struct manifest m = with_lines();

    m.full_width = 12;
    power_with(&m,
               "text.put { col = 2, row = 3, text = '\xe5\xbc\xbe\xe5\xbc\xbe' .. 'A', bank = 1, full_width = true }\n"
               "text.put { col = 2, row = 5, text = '\xe5\xbc\xbe\xe5\xbc\xbe' }\n"
               "text.put { col = 15, row = 7, text = '\xe5\xbc\xbe' .. 'A', full_width = true, align = 'right' }\n"
               "text.line { x = 16, y = 80, text = '\xe5\xbc\xbe\xe5\xbc\xbe', bank = 1, full_width = true }",
               1);
    const struct fix *f = &rig.b->fix;
    assert_true(fix_code(f, 3 * 30 + 2) == 0x5f3e && fix_code(f, 3 * 30 + 3) == 0x5f3e &&
                fix_code(f, 3 * 30 + 5) == 'A');
    assert_true(fix_x(f, 3 * 30 + 3) == 28 && fix_x(f, 5 * 30 + 3) == 24);
    assert_true(f->style[3 * 30 + 2] & FIX_FULL_WIDTH && !(f->style[3 * 30 + 5] & FIX_FULL_WIDTH));
    assert_true(fix_code(f, 7 * 30 + 12) == 0x5f3e && fix_x(f, 7 * 30 + 12) == 100 && fix_x(f, 7 * 30 + 14) == 112);
    rig_picture(&rig);
    assert_true(pixel(20, 81) == 19 && pixel(32, 81) == 19);
    assert_true(pixel(20, 25) == 19 && pixel(32, 25) == 19); /* the glyph's line is 7 px wide and 6 px high */
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
    int i = rom_find(&g.image.rom, "fonts/tiny");
    struct lump l;
    rom_lump(&g.image.rom, i, &l);
    ((uint8_t *)(uintptr_t)l.data)[FACE_HEADER_SIZE + 12] = 60;
    rig_free(&rig);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 9);
    assert_true(board_hash(rig.b) == hash);
}

static int off(void **state)
{
    (void)state;
    rig_close(&rig);
    return 0;
}

RUN_TESTS_EACH(NULL, off)
