/*
 * test_hud.c - what the hud writes, and where: margins, side panels, banners over a narrow field, registers.
 */
#include "rig.h"

static struct rig_game g;
static struct rig r;

static void open_with(const struct manifest *m, const char *text)
{
    static char full[8192];

    rig_close(&r);
    snprintf(full, sizeof full, "hud.banks.plain, hud.banks.bright = 2, 5\n%s", text);
    rig_with_sys(&g, m, full);
    rig_power(&r, &g, NULL);
}

/* A row of the screen, from its first letter to its last; *col is where that first one is, -1: an empty row. */
static const char *row_text(uint32_t row, int *col)
{
    static char text[128];
    const struct fix *f = &r.b->fix;
    int last = -1;

    *col = -1;
    for (uint32_t c = 0; c < f->cols; c++) {
        uint8_t code = f->code[row * f->cols + c];
        if (code <= 32)
            continue;
        *col = *col < 0 ? (int)c : *col;
        last = (int)c;
    }
    for (int c = *col; c >= 0 && c <= last; c++)
        text[c - *col] = (char)(f->code[row * f->cols + (uint32_t)c] > 32 ? f->code[row * f->cols + (uint32_t)c] : ' ');
    text[last < 0 ? 0 : last - *col + 1] = 0;
    return text;
}

static void row_is(uint32_t row, int col, const char *want)
{
    int at;
    const char *got = row_text(row, &at);

    if (strcmp(got, want) || at != col)
        fail_msg("row %u: \"%s\" at %d, expected \"%s\" at %d", row, got, at, want, col);
}

static uint8_t bank_at(uint32_t row, uint32_t col)
{
    return r.b->fix.bank[row * r.b->fix.cols + col];
}

static const char ships[] =
    "player.def('p', { sprite = 'dot', hit = { circle = 2 }, lives = 3, registers = {\n"
    "  bombs = { start = 3, max = 9, show = 'icons' }, heat = { start = 2, max = 4, show = 'bar' },\n"
    "  coins = { start = 12, show = 'number' }, plain = 1, secret = { start = 5, show = 'none' } } })\n"
    "for i = 1, string.sys.players() do string.sys.join(i, 'p') end\n"
    "hud.start(string.sys.scope(), string.sys.players())\n";

/* 240 px over the whole screen: 30 columns, a cell off each edge. Many icons are an icon and a number. */
TEST(margins)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    m.players = 1;
    snprintf(text, sizeof text,
             "%slocal p = player.get(1)\n"
             "task.go(function()\n"
             "  wait(1) p.bombs, p.coins, p.heat = 50, 5000, 0\n"
             "  wait(1) p.bombs, p.heat = 0, 4\n"
             "end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(0, -1, "");
    row_is(1, 1, "000000000       HI 000000000");
    row_is(2, 1, "**                        *0");
    row_is(3, 1, "BOMBS ***");
    row_is(4, 1, "COINS 12");
    row_is(5, 1, "HEAT ====----");
    row_is(6, -1, "");
    assert_int_equal(bank_at(1, 1), 2 | FIX_RIM);
    rig_run(&r, 2);
    row_is(3, 1, "BOMBS *x9");
    row_is(4, 1, "COINS 5000");
    row_is(5, 1, "HEAT --------");
    rig_run(&r, 1);
    row_is(3, 1, "BOMBS");
    row_is(5, 1, "HEAT ========");
}

/* At the lower edge, from below: each player's at their side; a factor in hundredths, a text of its own or none before
 * it; what is 0 is not shown; from its mark on it is bright. */
TEST(low)
{
    static const char text[] =
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { max = 100, show = 'bar', at = 'low', label = 'GLASS', mark = 50 },\n"
        "  b = { start = 125, show = 'times', at = 'low', label = '' }, c = { show = 'number', at = 'low' },\n"
        "  d = { start = 7, show = 'number', label = 'DEEP' } } })\n"
        "for i = 1, 2 do string.sys.join(i, 'p') end hud.low = 2 hud.start(string.sys.scope(), 2)\n"
        "task.go(function() wait(2) player.get(1).a = 50 player.get(2).c = 12 wait(3) player.get(2).c = 0\n"
        "  wait(1) player.get(1).b = 1000 player.get(1).a = 100 wait(3) string.sys.leave(1) end)";
    struct manifest m = rig_manifest();

    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(3, 1, "DEEP 7                DEEP 7");
    row_is(4, -1, "");
    row_is(37, 1, "GLASS -----      GLASS -----");
    row_is(36, 1, "x1.25                  x1.25");
    row_is(35, -1, "");
    assert_int_equal(bank_at(37, 1), 2 | FIX_RIM);
    rig_run(&r, 3);
    row_is(37, 1, "GLASS ===--      GLASS -----");
    assert_int_equal(bank_at(37, 1), 5 | FIX_RIM);
    row_is(35, 25, "C 12");
    rig_run(&r, 4);
    row_is(36, 1, "x10.00                 x1.25");
    row_is(35, -1, "");
    rig_run(&r, 4);
    row_is(37, 18, "GLASS -----");
}

/* A field of 192 px and a panel of 15 columns: a cell is left free at each of its edges; nothing is cut. */
TEST(panel)
{
    char text[2048], seen[512] = "";
    struct manifest m = rig_manifest();

    m.players = 1;
    m.screen_w = 320;
    m.screen_h = 240;
    m.field_x = 8;
    m.field_w = 192;
    m.field_h = 240;
    snprintf(text, sizeof text,
             "%senemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('b', { title = 'The Quite Unpronounceabilities', kind = 'e', x = 9, y = 9, phases = {\n"
             "  { id = 'a', hp = 5, time = 99, run = function() end } } })\n"
             "hud.banner({ 'A BANNER', 'ITS OTHER LINE THAT IS LONG' }, 50)\n"
             "task.go(function() wait(60) boss.fight('b') end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(10, 9, "A BANNER"); /* in the middle of columns 1 to 24 */
    row_is(12, 2, "ITS OTHER LINE THAT IS");
    row_is(13, 11, "LONG");
    rig_run(&r, 59);
    row_is(10, -1, "");
    row_is(12, -1, "");
    rig_run(&r, 130);
    /* 40 columns; the field takes 1 to 24, the panel begins at 25: text from 26 on, 13 columns */
    row_is(1, 26, "000000000");
    row_is(2, 26, "HI 000000000");
    row_is(3, 26, "**         *0");
    for (uint32_t row = 4; row < 20; row++) {
        int col;
        const char *shown = row_text(row, &col);
        size_t at = strlen(seen);
        if (col == 26)
            snprintf(seen + at, sizeof seen - at, "%s|", shown);
    }
    assert_non_null(strstr(seen, "The Quite|Unpronounceab|ilities|"));
}

/* What stands at the lower edge goes while a craft is near; and a word stands before the grazes. */
TEST(shy)
{
    static const char text[] =
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { max = 100, show = 'bar', at = 'low', label = 'GLASS' },\n"
        "  b = { start = 100, show = 'times', at = 'low', label = '' } } })\n"
        "string.sys.join(1, 'p') hud.shy, hud.graze = 8, 'GRAZE' hud.start(string.sys.scope(), 1)\n"
        "local p = player.get(1) task.go(function() wait(4) p.x, p.y = 60, 300 wait(4) p.x = 107 wait(4) p.x = 113\n"
        "  wait(4) p.x, p.b = 60, 101 wait(4) p.y = 280 end)";

    open_with(NULL, text);
    rig_run(&r, 3);
    row_is(2, 1, "**                   GRAZE 0");
    row_is(38, 1, "GLASS -----");
    row_is(37, -1, ""); /* a factor of 1 says nothing */
    rig_run(&r, 4);
    row_is(38, -1, "");
    rig_run(&r, 4);
    row_is(38, -1, ""); /* it comes back a little later than it goes */
    rig_run(&r, 4);
    row_is(38, 1, "GLASS -----");
    rig_run(&r, 4);
    row_is(38, -1, "");
    rig_run(&r, 4);
    row_is(38, 1, "GLASS -----");
    row_is(37, 1, "x1.01");
}

/* Two players: side by side where there is room, a bar as long as it leaves; in a panel one below the other, in rows
 * that stay where they are when one is out. */
TEST(two)
{
    static const char text[] =
        "game.def { registers = { rank = { start = 4, show = 'number' } } }\n"
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, lives = 3, registers = {\n"
        "  bombs = { start = 3, max = 9, show = 'icons' }, moon_fire = { start = 2, max = 4, show = 'bar' } } })\n"
        "for i = 1, 2 do string.sys.join(i, 'p') end score.add(700, 2) local owner = string.sys.scope()\n"
        "string.sys.start(owner) hud.start(owner, 2)\n"
        "task.go(function() wait(2) string.sys.leave(1) end)";
    static const struct {
        const char *both, *second; /* the players in the game */
    } rows[] = { { "HI 000000700", "HI 000000700" },
                 { "", "" },
                 { "1P         **", "1P" },
                 { "000000000", "000000000" },
                 { "BOMBS ***", "" },
                 { "MOON FIRE ==-", "" },
                 { "", "" },
                 { "2P         **", "2P         **" },
                 { "000000700", "000000700" },
                 { "BOMBS ***", "BOMBS ***" },
                 { "MOON FIRE ==-", "MOON FIRE ==-" },
                 { "", "" },
                 { "RANK 4", "RANK 4" } };
    struct manifest m = rig_manifest();

    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(2, 1, "**       000000700        **");
    row_is(3, 1, "BOMBS ***          BOMBS ***");
    row_is(4, 1, "MOON FIRE ==-  MOON FIRE ==-");
    row_is(5, 1, "RANK 4");
    m.screen_w = 320;
    m.field_w = 200;
    open_with(&m, text);
    rig_run(&r, 1);
    for (uint32_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(1 + i, *rows[i].both ? 26 : -1, rows[i].both);
    rig_run(&r, 3);
    for (uint32_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(1 + i, *rows[i].second ? 26 : -1, rows[i].second);
}

/* A star for each phase to come is behind the bar, and the title in one row below, as much of it as fits. */
TEST(title)
{
    static const struct {
        const char *title, *bar, *below;
        int phases;
    } rows[] = {
        { "NINE", "================== ***    11", "NINE                      11", 4 },
        { "A TITLE THAT GOES OVER TWO OF THEM", "==================== *    11", "A TITLE THAT GOES OVER    11", 2 },
        { "THE FOURTH OF ALL: TITLES", "======================    11", "TITLES                    11", 1 },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "player.def('p', { sprite = 'dot', hit = { circle = 2 } }) string.sys.join(1, 'p')\n"
                 "hud.start(string.sys.scope(), 1)\n"
                 "enemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
                 "local phases = {}\n"
                 "for i = 1, %d do phases[i] = { id = 'a' .. i, hp = 5, time = 99, rest = 0, run = print } end\n"
                 "boss.def('b', { title = '%s', kind = 'e', x = 9, y = 9, phases = phases })\n"
                 "task.go(boss.fight, 'b')",
                 rows[i].phases, rows[i].title);
        open_with(NULL, text);
        rig_run(&r, 120);
        row_is(3, 1, rows[i].bar);
        row_is(4, 1, rows[i].below);
        row_is(5, -1, "");
    }
}

/* A fight as it is shown: the clock in letters of two cells by two, what its bar has lost, a spell that is declared in
 * the middle, slides up and rests below the title, its bonus beside it, and what it came to. */
static const char spell_game[] =
    "player.def('p', { sprite = 'dot', hit = { circle = 2 } }) string.sys.join(1, 'p')\n"
    "hud.banks.alarm, hud.banks.faint = 7, 6 hud.start(string.sys.scope(), 1)\n"
    "enemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
    "boss.def('b', { title = 'NINE', kind = 'e', x = 99, y = 9, phases = {\n"
    "  { id = 'a', hp = 8, time = 660, spell = 'GLASS SIGN', bonus = 6600, bonus_to = 0, rest = 60, run = function(e)\n"
    "    wait(40) e.hp = 2 wait(60) %s wait(450) e.hp = 0 end },\n"
    "  { id = 'l', hp = 8, time = 99, run = function() end } } })\n"
    "task.go(function() boss.fight('b') end)";

static void open_spell(const struct manifest *m, const char *then)
{
    static char text[2048];

    snprintf(text, sizeof text, spell_game, then);
    open_with(m, text);
}

TEST(spell)
{
    open_spell(NULL, "");
    rig_run(&r, 68);
    row_is(3, 1, "===----------------- *  1111"); /* it fills */
    row_is(4, 1, "NINE                    1111");
    assert_int_equal(bank_at(3, 25), 2 | FIX_RIM | FIX_BIG);
    assert_int_equal(bank_at(4, 28), 2 | FIX_RIM | 4 * FIX_BIG);
    row_is(25, 10, "GLASS");
    rig_run(&r, 22);
    row_is(25, 10, "GLASS SIGN");
    rig_run(&r, 22);
    row_is(3, 1, "=====--------------- *  1111");
    assert_int_equal(bank_at(3, 1) & FIX_BANK, 5);
    row_is(25, -1, "");
    row_is(10, 3, "GLASS SIGN");
    rig_run(&r, 18);
    row_is(10, -1, "");
    row_is(5, 1, "GLASS SIGN     BONUS 0005910");
    assert_int_equal(bank_at(3, 28) & FIX_BANK, 7); /* ten seconds are left */
    rig_run(&r, 270);
    row_is(4, 1, "NINE                      66");
    row_is(5, 1, "GLASS SIGN     BONUS 0003210");
    rig_run(&r, 215);
    row_is(3, 22, "*");
    row_is(4, 1, "NINE");
    row_is(5, -1, "");
    row_is(18, 11, "CAPTURED");
    row_is(20, 13, "1090");
    rig_run(&r, 250);
    row_is(4, -1, "");
    row_is(18, -1, "");
}

/* A death, whose bonus it was; and the names of a cast, with a bar each. */
TEST(failed)
{
    static const struct {
        int col;
        const char *text;
    } rows[2][5] = { { { 1, "IRIS    =======-------  8833" },
                       { 1, "OPAL TH ===========---  8833" },
                       { -1, "" }, /* the title would say the same */
                       { -1, "" },
                       { -1, "" } },
                     { { 21, "TWO" }, { 21, "IRIS" }, { 21, "=====----" }, { 21, "OPAL THE" }, { 21, "=======--" } } };
    static char text[2048];
    struct manifest m = rig_manifest();

    open_spell(NULL, "local p = player.get(1) p.x, p.y = e.x, e.y");
    rig_run(&r, 200);
    row_is(5, 1, "GLASS SIGN       0/1  FAILED"); /* this is the first try */
    assert_int_equal(bank_at(5, 23), 6 | FIX_RIM);
    rig_run(&r, 430);
    row_is(18, 9, "BONUS FAILED");
    for (int panel = 0; panel < 2; panel++) {
        m.field_w = panel ? 160 : 240;
        snprintf(
            text, sizeof text,
            "player.def('p', { sprite = 'dot', hit = { circle = 2 } }) string.sys.join(1, 'p')\n"
            "hud.start(string.sys.scope(), 1) enemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
            "boss.def('b', { title = 'TWO', cast = { { name = 'i', title = 'IRIS', kind = 'e', x = 9, y = 9 },\n"
            "  { name = 'o', title = 'OPAL THE LONG', kind = 'e', x = 99, y = 9 } }, phases = { { id = 'a', time = "
            "5000, hp = { i = 8, o = 4 }, run = function(i, o) wait(40) i.hp, o.hp = 4, 3 end } } })\n"
            "task.go(function() boss.fight('b') end)");
        open_with(&m, text);
        rig_run(&r, 120);
        for (uint32_t i = 0; i < 5; i++)
            row_is(panel ? i + 8 : i + 3, rows[panel][i].col, rows[panel][i].text);
    }
}

/* The band before a boss: it opens, runs, closes, and leaves nothing. */
TEST(warning)
{
    open_with(NULL, "hud.banks.alarm = 7\n"
                    "enemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
                    "boss.def('b', { title = 'NINE', epithet = 'OF TWO DOZ', kind = 'e', x = 99, y = 9, warning = 90, "
                    "phases = { { id = 'a', hp = "
                    "5, time = 99, run = function() end } } })\n"
                    "hud.banner({ 'A STAGE' }, 900)\n"
                    "task.go(function() boss.fight('b') end)");
    row_is(13, 11, "A STAGE");
    rig_run(&r, 8);
    row_is(13, -1, "");            /* the card needs the place */
    row_is(12, 9, "------------"); /* a line grows from its middle */
    rig_run(&r, 40);
    row_is(9, 2, "WARNING  WARNING  WARNING  W");
    row_is(12, 3, "------------------------");
    row_is(14, 10, "OF TWO DOZ");
    row_is(16, 11, "NNIINNEE");
    row_is(17, 11, "NNIINNEE");
    row_is(19, 3, "------------------------");
    row_is(22, 0, "RNING  WARNING  WARNING  WARNI");
    assert_int_equal(bank_at(16, 11), 5 | FIX_RIM | FIX_BIG);
    assert_int_equal(bank_at(9, 3), 7 | FIX_RIM);
    rig_run(&r, 44);
    for (uint32_t row = 0; row < r.b->fix.rows; row++)
        row_is(row, -1, "");
}

/* Rows are written again only when what they tell of is another, and after hud.refresh. */
TEST(again)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    m.players = 1;
    snprintf(text, sizeof text,
             "%s task.go(function() wait(19) player.get(1).heat = 1 wait(10) hud.refresh() wait(10) score.add(7, 1) "
             "end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 10);
    fix_clear(&r.b->fix, 0, 0, 30, 20);
    rig_run(&r, 15); /* another heat, and only its row is another */
    row_is(1, -1, "");
    row_is(5, 1, "HEAT ==------");
    rig_run(&r, 10); /* refreshed */
    row_is(1, 1, "000000000       HI 000000000");
    row_is(3, 1, "BOMBS ***");
    rig_run(&r, 10);
    row_is(1, 1, "000000007       HI 000000007");
}

/* A pixel of the font's letter; 0 outside of it. */
static int ink(int code, int x, int y)
{
    return x < 0 || y < 0 || x > 7 || y > 7 ? 0 : g.cart.glyphs[(code - 32) * 64 + y * 8 + x];
}

/* A letter twice as large is what scale2x makes of the letter. */
TEST(large)
{
    uint32_t rgb[256];
    int other = 0;

    open_with(NULL, "text.put { col = 3, row = 3, text = 'KA', bank = 1, size = 2 }");
    rig_run(&r, 1);
    for (int i = 0; i < 64; i++) /* the rig's own has no slant */
        ((uint8_t *)(uintptr_t)g.cart.glyphs)[('K' - 32) * 64 + i] = (i % 8 * 5 + i / 8 * (i / 8 + 3)) % 7 < 3 ? 3 : 0;
    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 32; x++) {
            const int code = "KA"[x / 16], u = x % 16 / 2, v = y / 2, at = ink(code, u, v);
            const int up = ink(code, u, v - 1), down = ink(code, u, v + 1);
            const int left = ink(code, u - 1, v), right = ink(code, u + 1, v);
            const int side = x % 2 ? right : left, over = y % 2 ? down : up;
            const int want = side == over && up != down && left != right ? over : at;
            const int got = r.fb.pix[(24 + y) * r.fb.pitch + 24 + x];
            if (got != (want ? 16 + want : got) || (!want && got >= 16 && got < 32))
                fail_msg("pixel %d,%d is %d, expected %d", x, y, got, want);
            other += want != at;
        }
    assert_true(other > 10);
}

static int off(void **state)
{
    (void)state;
    rig_close(&r);
    return 0;
}

RUN_TESTS_EACH(NULL, off)
