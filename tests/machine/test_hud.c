/*
 * test_hud.c - what the HUD writes, and where: over the field, in a side panel, registers, a boss's rows. The first
 * number of row_is is the row's top in px.
 */
#include "rig.h"

static struct rig_game g;
static struct rig r;

static bool large_hud; /* of the next start */

static void open_with(const struct manifest *m, const char *text)
{
    static char full[8192];
    const struct board_start start = { .seed = 1, .difficulty = -1, .large_hud = large_hud };

    rig_close(&r);
    snprintf(full, sizeof full, "hud.banks.plain, hud.banks.bright = 2, 5\n%s", text);
    rig_with_sys(&g, m, full);
    rig_power(&r, &g, &start);
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

static void row_is(int y, int col, const char *want)
{
    const uint32_t row = (uint32_t)y / 8;
    int at;
    const char *got = row_text(row, &at);

    if (strcmp(got, want) || at != col)
        fail_msg("row at y %d: \"%s\" at %d, expected \"%s\" at %d", y, got, at, want, col);
    if (at >= 0)
        assert_int_equal(fix_y(&r.b->fix, row * r.b->fix.cols + (uint32_t)at), y);
}

/* The style without the shift of the cell at a column, in the row whose top is at y px. */
static int style_at(int y, uint32_t col)
{
    return r.b->fix.style[(uint32_t)y / 8 * r.b->fix.cols + col] % FIX_SHIFT_X;
}

static const char ships[] =
    "player.def('p', { sprite = 'dot', hit = { circle = 2 }, lives = 3, registers = {\n"
    "  bombs = { start = 3, max = 9, show = 'icons' }, heat = { start = 2, max = 4, show = 'bar' },\n"
    "  coins = { start = 12, show = 'number' }, plain = 1, secret = { start = 5, show = 'none' } } })\n"
    "for i = 1, string.sys.players() do string.sys.join(i, 'p') end\n"
    "hud.start(string.sys.scope(), string.sys.players())\n";

/* A field that fills the screen: rows are 10 px apart and a cell off the edges. Many icons are an icon and a number. */
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
    row_is(4, 1, "1P 000000000    HI 000000000");
    row_is(14, 1, "**                   GRAZE 0");
    row_is(24, 1, "BOMBS ***           COINS 12");
    row_is(34, 1, "HEAT ====----");
    row_is(44, -1, "");
    assert_int_equal(style_at(4, 1), 2 | FIX_RIM);
    rig_run(&r, 2);
    row_is(24, 1, "BOMBS *x9         COINS 5000");
    row_is(34, 1, "HEAT --------");
    rig_run(&r, 1);
    row_is(24, 1, "BOMBS             COINS 5000");
    row_is(34, 1, "HEAT ========");
}

/* Rows at the lower edge, above hud.low rows: each player's at their side; a factor in hundredths; 0 is not shown; a
 * register is bright from its mark on. */
TEST(low)
{
    static const char text[] =
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { max = 100, show = 'bar', at = 'low', label = 'GLASS', mark = 50 },\n"
        "  b = { start = 125, show = 'times', at = 'low', label = '' }, c = { show = 'number', at = 'low' },\n"
        "  d = { start = 7, show = 'number', label = 'DEEP' } } })\n"
        "for i = 1, 2 do string.sys.join(i, 'p') end hud.low, hud.shy = 2, 0 hud.start(string.sys.scope(), 2)\n"
        "task.go(function() wait(2) player.get(1).a = 50 player.get(2).c = 12 wait(3) player.get(2).c = 0\n"
        "  wait(1) player.get(1).b = 1000 player.get(1).a = 100 wait(3) string.sys.leave(1) end)";
    struct manifest m = rig_manifest();

    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(44, 1, "DEEP 7                DEEP 7");
    row_is(54, -1, "");
    row_is(284, 1, "GLASS                  GLASS"); /* above its bar, which the ships at their start don't cover */
    row_is(294, 1, "--------            --------");
    row_is(274, 1, "x1.25                  x1.25");
    row_is(264, -1, "");
    assert_int_equal(style_at(294, 1), 2 | FIX_RIM);
    rig_run(&r, 3);
    row_is(294, 1, "====----            --------");
    assert_int_equal(style_at(294, 1), 5 | FIX_RIM);
    row_is(264, 25, "C 12");
    rig_run(&r, 4);
    row_is(274, 1, "x10.00                 x1.25");
    row_is(264, -1, "");
    rig_run(&r, 4);
    row_is(284, 24, "GLASS");
}

/* A field of 192 px and a panel of 15 columns, whose edges stay free. The boss's rows are at its lower end. */
TEST(panel)
{
    char text[2048];
    struct manifest m = rig_manifest();

    m.players = 1;
    m.screen_w = 320;
    m.screen_h = 240;
    m.field_x = 8;
    m.field_w = 192;
    m.field_h = 240;
    snprintf(text, sizeof text,
             "%senemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('b', { title = 'The Unspeakable', kind = 'e', x = 9, y = 9, phases = {\n"
             "  { id = 'a', hp = 5, time = 99, run = function() end } } })\n"
             "hud.banner({ 'A BANNER', 'ITS OTHER LINE THAT IS LONG' }, 50)\n"
             "task.go(function() wait(60) hud.centre(14, 'CENTRE') boss.fight('b') end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(80, 9, "A BANNER"); /* in the middle of columns 1 to 24 */
    row_is(96, 6, "ITS OTHER LINE");
    row_is(106, 7, "THAT IS LONG");
    rig_run(&r, 59);
    row_is(80, -1, "");
    row_is(96, -1, "");
    rig_run(&r, 10);
    row_is(112, 10, "CENTRE"); /* in the middle of the same columns */
    rig_run(&r, 120);
    /* 40 columns; the field takes 1 to 24, the panel begins at 25: text from 26 on, 13 columns */
    row_is(8, 26, "HI  000000000");
    row_is(24, 26, "1P  000000000");
    row_is(34, 26, "**    GRAZE 0");
    row_is(44, 26, "BOMBS     ***");
    row_is(136, 37, "11");
    row_is(154, 26, "The");
    row_is(164, 26, "Unspeakable");
    row_is(174, 26, "=============");
}

/* Rows over the field are hidden while a ship is near; and the label of the grazes. */
TEST(shy)
{
    static const char text[] =
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { max = 100, show = 'bar', at = 'low', label = 'GLASS' },\n"
        "  b = { start = 100, show = 'times', at = 'low', label = '' } } })\n"
        "string.sys.join(1, 'p') hud.shy, hud.graze = 8, 'NEAR' hud.start(string.sys.scope(), 1)\n"
        "local p = player.get(1) task.go(function() wait(16) p.x, p.y = 60, 300 wait(16) p.x = 115 wait(16) p.x = 120\n"
        "  wait(16) p.x, p.b = 60, 101 wait(16) p.y = 257 wait(16) p.y = 10 wait(16) p.x = 200 wait(16) p.y = 60 end)";

    open_with(NULL, text);
    rig_run(&r, 15);
    row_is(14, 1, "**                    NEAR 0");
    row_is(294, 1, "--------");
    row_is(284, 1, "GLASS");
    row_is(274, -1, ""); /* a factor of 1 is not shown */
    rig_run(&r, 16);
    row_is(294, -1, "");
    rig_run(&r, 16);
    row_is(294, -1, ""); /* it returns a little later than it is hidden */
    rig_run(&r, 16);
    row_is(294, 1, "--------");
    rig_run(&r, 16);
    row_is(294, -1, "");
    rig_run(&r, 16);
    row_is(294, 1, "--------");
    row_is(274, 1, "x1.01");
    rig_run(&r, 16);
    row_is(4, 17, "HI 000000000");
    row_is(14, 23, "NEAR 0");
    rig_run(&r, 16);
    row_is(4, 1, "1P 000000000");
    row_is(14, 1, "**");
    rig_run(&r, 16);
    row_is(4, 1, "1P 000000000    HI 000000000");
}

/* Two players: side by side over the field, a bar as long as the label leaves; in a panel one below the other, in rows
 * whose places stay the same when a player is out. */
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
        int y;
        const char *both, *second; /* the players in the game */
    } rows[] = { { 8, "HI  000000700", "HI  000000700" },
                 { 24, "1P  000000000", "1P  000000000" },
                 { 34, "**    GRAZE 0", "OUT   GRAZE 0" },
                 { 44, "BOMBS     ***", "" },
                 { 54, "MOON FIRE ==-", "" },
                 { 70, "2P  000000700", "2P  000000700" },
                 { 80, "**    GRAZE 0", "**    GRAZE 0" },
                 { 90, "BOMBS     ***", "BOMBS     ***" },
                 { 100, "MOON FIRE ==-", "MOON FIRE ==-" },
                 { 116, "RANK        4", "RANK        4" } };
    struct manifest m = rig_manifest();

    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(4, 9, "HI 000000700");
    row_is(14, 1, "1P 000000000    2P 000000700");
    row_is(24, 1, "**                        **");
    row_is(34, 1, "GRAZE 0              GRAZE 0");
    row_is(44, 1, "BOMBS ***          BOMBS ***");
    row_is(54, 1, "MOON FIRE ==-  MOON FIRE ==-");
    row_is(64, 12, "RANK 4");
    m.screen_w = 320;
    m.field_w = 200;
    open_with(&m, text);
    rig_run(&r, 1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(rows[i].y, 26, rows[i].both);
    rig_run(&r, 3);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(rows[i].y, *rows[i].second ? 26 : -1, rows[i].second);
}

/* After the bar comes a pip for each phase to come; below it is the title, as much of it as fits. */
TEST(title)
{
    static const struct {
        const char *title, *bar, *below;
        int phases;
    } rows[] = {
        { "NINE", "=================== ***   11", "NINE                      11", 4 },
        { "A TITLE THAT GOES OVER TWO OF THEM", "===================== *   11", "A TITLE THAT GOES OVER    11", 2 },
        { "THE FOURTH OF ALL: TITLES", "=======================   11", "TITLES                    11", 1 },
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
        row_is(24, 1, rows[i].bar);
        row_is(34, 1, rows[i].below);
        row_is(44, -1, "");
    }
}

/* A fight: the clock in letters of size 2, the bar, a spell that is declared in the middle and slides to its place
 * below the title, its bonus in a row below, and the verdict. */
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
    row_is(24, 1, "===------------------ * 1111"); /* it fills */
    row_is(34, 1, "NINE                    1111");
    assert_int_equal(style_at(24, 25), 2 | FIX_RIM | FIX_DOUBLE);
    assert_int_equal(style_at(32, 28), 2 | FIX_RIM | 4 * FIX_DOUBLE);
    row_is(200, 5, "GGLLAASSSS"); /* large letters fit */
    rig_run(&r, 22);
    row_is(200, 5, "GGLLAASSSS  SSIIGGNN");
    rig_run(&r, 22);
    row_is(24, 1, "======--------------- * 1111");
    assert_int_equal(style_at(24, 1) & FIX_BANK, 5);
    row_is(200, -1, "");
    row_is(24, 1, "======--------------- * 1111");
    row_is(76, 3, "GLASS SIGN");
    rig_run(&r, 18);
    row_is(76, -1, "");
    row_is(34, 1, "GLASS SIGN              1100");
    row_is(44, 1, "CAPTURED 0/1      BONUS 5910");
    assert_int_equal(style_at(24, 28) & FIX_BANK, 7); /* ten seconds are left */
    rig_run(&r, 115);
    row_is(44, 1, "CAPTURED 0/1      BONUS 4760");
    assert_int_equal(style_at(34, 1) & FIX_BANK, 6); /* name and history leave */
    rig_run(&r, 155);
    row_is(34, 1, "NINE                      66"); /* the boss's name has returned */
    row_is(44, -1, "");                            /* so has the bonus */
    rig_run(&r, 215);
    row_is(24, 23, "*");
    row_is(34, 1, "NINE");
    row_is(44, -1, "");
    row_is(144, 11, "CAPTURED");
    row_is(160, 13, "1090");
    rig_run(&r, 250);
    row_is(34, -1, "");
    row_is(144, -1, "");
}

/* A death costs the bonus; a ship hides the rows below the bar; and the names of a cast, with a bar each. */
TEST(failed)
{
    static const struct {
        int col;
        const char *text;
    } rows[2][5] = { { { 1, "IRIS       ======------ 8833" },
                       { 1, "OPAL THE   =========--- 8833" },
                       { -1, "" }, /* the title would say the same */
                       { -1, "" },
                       { -1, "" } },
                     { { 26, "8833" }, { 21, "IRIS" }, { 21, "=====----" }, { 21, "OPAL THE" }, { 21, "=======--" } } };
    static char text[2048];
    struct manifest m = rig_manifest();

    open_spell(NULL, "local p = player.get(1) p.x, p.y = e.x, e.y wait(1) p.x, p.y = 20, 28 wait(60) p.y = 90");
    rig_run(&r, 170); /* the ship is over the boss's rows */
    row_is(24, 1, "======--------------- * 1100");
    row_is(34, 25, "1100");
    row_is(44, -1, "");
    rig_run(&r, 60);
    row_is(34, 1, "GLASS SIGN                99");
    row_is(44, 1, "CAPTURED 0/1    BONUS FAILED"); /* this is the first try */
    assert_int_equal(style_at(44, 23), 6 | FIX_RIM);
    rig_run(&r, 460);
    row_is(144, 9, "BONUS FAILED");
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
            row_is((panel ? 214 : 24) + 10 * (int)i, rows[panel][i].col, rows[panel][i].text);
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
    row_is(104, 11, "A STAGE");
    rig_run(&r, 8);
    row_is(104, -1, "");           /* the card needs the place */
    row_is(96, 9, "------------"); /* a line grows from its middle */
    rig_run(&r, 40);
    row_is(72, 2, "WARNING  WARNING  WARNING  W");
    row_is(96, 3, "------------------------");
    row_is(112, 10, "OF TWO DOZ");
    row_is(128, 11, "NNIINNEE");
    row_is(136, 11, "NNIINNEE");
    row_is(152, 3, "------------------------");
    row_is(176, 0, "RNING  WARNING  WARNING  WARNI");
    assert_int_equal(style_at(128, 11), 5 | FIX_RIM | FIX_DOUBLE);
    assert_int_equal(style_at(72, 3), 7 | FIX_RIM);
    rig_run(&r, 44);
    for (uint32_t row = 0; row < r.b->fix.rows; row++)
        row_is(8 * (int)row, -1, "");
}

/* Rows are written again only when their values change, and after hud.refresh. */
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
    rig_run(&r, 15); /* another heat, and only its row is written */
    row_is(4, -1, "");
    row_is(34, 1, "HEAT ==------");
    rig_run(&r, 10); /* refreshed */
    row_is(4, 1, "1P 000000000    HI 000000000");
    row_is(24, 1, "BOMBS ***           COINS 12");
    rig_run(&r, 10);
    row_is(4, 1, "1P 000000007    HI 000000007");
}

/* A pixel of the font's letter; 0 outside of it. */
static int ink(int code, int x, int y)
{
    return x < 0 || y < 0 || x > 7 || y > 7 ? 0 : g.cart.glyphs[(code - 32) * 64 + y * 8 + x];
}

/* Checks that the letters K and A at (x0, y0) px are what the scale2x rule makes of them; at size 3, its corners.
 * Returns how many pixels the rule changed. */
static int count_smoothed(int x0, int y0, int size)
{
    int smoothed = 0;

    for (int y = 0; y < 8 * size; y++)
        for (int x = 0; x < 16 * size; x++) {
            const int code = "KA"[x / (8 * size)], u = x % (8 * size) / size, v = y / size, at = ink(code, u, v);
            const int up = ink(code, u, v - 1), down = ink(code, u, v + 1);
            const int left = ink(code, u - 1, v), right = ink(code, u + 1, v);
            const int side = x % size ? right : left, over = y % size ? down : up;
            const bool corner = size == 2 || (x % 3 != 1 && y % 3 != 1);
            const int want = corner && side == over && up != down && left != right ? over : at;
            const int got = r.fb.pix[(y0 + y) * r.fb.pitch + x0 + x];
            if (got != (want ? 16 + want : got) || (!want && got >= 16 && got < 32))
                fail_msg("size %d, pixel %d,%d is %d, expected %d", size, x, y, got, want);
            smoothed += want != at;
        }
    return smoothed;
}

/* Larger letters, and text between cells. */
TEST(large)
{
    uint32_t rgb[256];

    open_with(NULL, "text.put { col = 3, row = 3, text = 'KA', bank = 1, size = 2 }\n"
                    "text.put { col = 3.5, row = 8.25, text = 'KA', bank = 1, size = 3 }");
    rig_run(&r, 1);
    for (int i = 0; i < 64; i++) /* the rig's own has no slant */
        ((uint8_t *)(uintptr_t)g.cart.glyphs)[('K' - 32) * 64 + i] = (i % 8 * 5 + i / 8 * (i / 8 + 3)) % 7 < 3 ? 3 : 0;
    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    assert_true(count_smoothed(24, 24, 2) > 10);
    assert_true(count_smoothed(28, 66, 3) > 10);
}

/* A page hides all rows, a dialogue those at the lower edge or, in a panel, all; pages outside play use the whole
 * screen. */
TEST(hidden)
{
    static const char text[] =
        "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { max = 100, show = 'bar', at = 'low', label = 'GLASS' } } })\n"
        "string.sys.join(1, 'p') string.sys.read('menu/page') string.sys.wipe() local owner = string.sys.scope()\n"
        "task.go(function() wait(1) hud.start(owner, 1) wait(4) string.sys.hide_rows() wait(4)\n"
        "  string.sys.hide_rows(false, true) string.sys.hide_rows(true) wait(4) string.sys.hide_rows(true, true)\n"
        "  wait(4) task.stop(owner) end)";
    struct manifest m = rig_manifest();

    m.players = 1;
    for (int panel = 0; panel < 2; panel++) {
        const int y = panel ? 24 : 4, col = panel ? 21 : 1;
        const char *score = panel ? "1P 000000" : "1P 000000000    HI 000000000";
        m.field_w = panel ? 160 : 240;
        open_with(&m, text);
        assert_int_equal(r.b->screen.shows_whole, panel);
        rig_run(&r, 3);
        assert_int_equal(r.b->screen.shows_whole, 0);
        row_is(y, col, score);
        row_is(panel ? 44 : 294, col, panel ? "GLASS ---" : "--------");
        rig_run(&r, 4);
        row_is(y, panel ? -1 : col, panel ? "" : score);
        row_is(panel ? 44 : 294, -1, "");
        rig_run(&r, 4);
        row_is(y, -1, "");
        rig_run(&r, 4);
        row_is(y, col, score);
        rig_run(&r, 4);
        assert_int_equal(r.b->screen.shows_whole, panel);
    }
}

/* ---- no row overlaps another ---- */

/* The size of the letter whose top-left cell is i; 0: the cell is blank or another part of a letter. */
static int letter_size(uint32_t i)
{
    const int part = r.b->fix.style[i] & FIX_PART;

    if (r.b->fix.code[i] <= 32)
        return 0;
    return !part ? 1 : part == FIX_DOUBLE ? 2 : part == FIX_TRIPLE ? 3 : 0;
}

/* Fails if two letters overlap, or one is less than 2 px above another. */
static void check_letters(int frame, int w, int players)
{
    const struct fix *f = &r.b->fix;
    const uint32_t cells = f->cols * f->rows;

    for (uint32_t i = 0; i < cells; i++)
        for (uint32_t k = i + 1; letter_size(i) && k < cells && k < i + 6 * f->cols; k++) {
            const int a = 8 * letter_size(i), b = 8 * letter_size(k);
            const int dx = fix_x(f, k) - fix_x(f, i), dy = fix_y(f, k) - fix_y(f, i);
            const bool beside = dx >= a || -dx >= b, same_row = dy == 0;
            if (b && !beside && (same_row || (dy < a + 2 && -dy < b + 2)))
                fail_msg("%d px, %d players, frame %d: '%c' at %d,%d and '%c' at %d,%d", w, players, frame, f->code[i],
                         fix_x(f, i), fix_y(f, i), f->code[k], fix_x(f, k), fix_y(f, k));
        }
}

/* Reads the script hud_rows.lua after a line that sets the number of players. */
static const char *every_row(int players)
{
    static char text[8192];
    int n = snprintf(text, sizeof text, "string.many = %d\n", players);
    FILE *file = fopen("tests/machine/hud_rows.lua", "rb");

    assert_non_null(file);
    n += (int)fread(text + n, 1, sizeof text - (size_t)n - 1, file);
    text[n] = 0;
    fclose(file);
    return text;
}

/* Every row at its longest, in all frames of two fights: a banner, the rows of a boss, a spell on its way to its place,
 * a cast. */
TEST(places)
{
    static const struct {
        int w, h, field_w, most_players;
    } sizes[] = {
        { 240, 320, 240, 2 }, { 320, 240, 320, 2 }, { 320, 240, 200, 2 }, { 384, 288, 240, 2 }, { 160, 240, 160, 1 }
    };

    for (size_t i = 0; i < 2 * sizeof sizes / sizeof *sizes; i++)
        for (int players = 1; players <= sizes[i / 2].most_players; players++) {
            struct manifest m = rig_manifest();
            large_hud = i % 2;
            m.players = players;
            m.screen_w = sizes[i / 2].w;
            m.screen_h = m.field_h = sizes[i / 2].h;
            m.field_w = sizes[i / 2].field_w;
            open_with(&m, every_row(players));
            for (int frame = 0; frame < 600; frame++) {
                rig_run(&r, 1);
                check_letters(frame, m.screen_w, players);
            }
        }
}

/* A larger HUD: scores, lives and icons twice as large, over the field and in a panel; a value that is too long for its
 * place, and rows that do not all fit, have their usual size. */
TEST(larger)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    large_hud = true;
    m.players = 1;
    snprintf(text, sizeof text, "%s task.go(function() wait(5) player.get(1).bombs = 9 score.add(7654321, 1) end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(4, 1, "HHII  000000000000000000");
    row_is(22, 1, "11PP  000000000000000000");
    assert_int_equal(style_at(22, 1), 2 | FIX_RIM | FIX_DOUBLE);
    row_is(40, 1, "****          GGRRAAZZEE  00");
    row_is(58, 1, "BBOOMMBBSS  ******");
    row_is(76, 1, "COINS 12       HEAT ====----");
    rig_run(&r, 8);
    row_is(58, 1, "BBOOMMBBSS  **xx99");
    m.screen_w = 320;
    m.screen_h = m.field_h = 240;
    m.field_w = 200;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(8, 26, "HI  000000000");
    row_is(28, 26, "1P       ****");
    row_is(42, 37, "00");
    rig_run(&r, 8);
    row_is(42, 32, "7654321");
    assert_int_equal(style_at(42, 32), 2 | FIX_RIM);
    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(8, 26, "HI  000000000");
    row_is(24, 26, "1P  000000000");
    row_is(80, 26, "2P  000000000");
}

static int off(void **state)
{
    (void)state;
    large_hud = false;
    rig_close(&r);
    return 0;
}

RUN_TESTS_EACH(NULL, off)
