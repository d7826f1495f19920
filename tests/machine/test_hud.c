/*
 * test_hud.c - what the hud writes, and where: margins, side panels, banners over a narrow field, registers as a ship
 * says; their limits; rims.
 */
#include "rig.h"

static struct rig_game g;
static struct rig r;

static void open_with(const struct manifest *m, const char *text)
{
    static char full[8192];

    snprintf(full, sizeof full, "hud.banks.plain, hud.banks.bright = 2, 5\n%s", text);
    rig_with_sys(&g, m, full);
    rig_power(&r, &g, NULL);
}

static void close_it(void)
{
    rig_free(&r);
    rig_game_free(&g);
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

/* 240 px over the whole screen: 30 columns, a cell off each edge. */
TEST(margins)
{
    struct manifest m = rig_manifest();

    m.players = 1;
    open_with(&m, ships);
    rig_run(&r, 1);
    row_is(0, -1, "");
    row_is(1, 1, "000000000       HI 000000000");
    row_is(2, 1, "**                        *0");
    row_is(3, 1, "BOMBS ***");
    row_is(4, 1, "COINS 12");
    row_is(5, 1, "HEAT ====----");
    row_is(6, -1, "");
    assert_int_equal(r.b->fix.bank[31], 2 | FIX_RIM);
    close_it();
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
    close_it();
}

TEST(registers)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    snprintf(text, sizeof text,
             "%s local p = player.get(1) task.go(function() wait(1) p.bombs, p.coins, p.heat = 50, 5000, 0\n"
             "assert(p.bombs == 9 and p.coins == 5000) p.plain = 2000000 p.heat = -4 assert(p.heat == 0) wait(1) "
             "p.bombs = 0 p.heat = 4 end)",
             ships);
    open_with(&m, text);
    rig_run(&r, 3);
    row_is(1, 1, "000000000          000000000");
    row_is(2, 1, "**       000000000        **");
    row_is(3, 1, "BOMBS *x9          BOMBS ***");
    close_it();
    m.players = 1;
    open_with(&m, text);
    rig_run(&r, 3);
    row_is(3, 1, "BOMBS *x9");
    row_is(4, 1, "COINS 5000");
    row_is(5, 1, "HEAT --------");
    rig_run(&r, 1);
    row_is(3, 1, "BOMBS");
    row_is(5, 1, "HEAT ========");
    close_it();
}

/* A field of 192 px and a panel of 15 columns: a cell is left free at each of its edges; nothing is cut. */
TEST(panel)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    m.players = 1;
    m.screen_w = 320;
    m.screen_h = 240;
    m.field_x = 8;
    m.field_w = 192;
    m.field_h = 240;
    snprintf(text, sizeof text,
             "%senemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('b', { title = 'The Quite Unpronounceabilities', kind = 'e', x = 9, y = 9, phases = { { id = "
             "'a', hp = 5, time = 99, run = function() end } } })\n"
             "task.go(function() boss.fight('b') end) hud.banner({ 'A BANNER', 'ITS OTHER LINE THAT IS LONG' }, 50)",
             ships);
    open_with(&m, text);
    rig_run(&r, 90);
    rig_run(&r, 40);
    /* 40 columns; the field takes 1 to 24, the panel begins at 25: text from 26 on, 13 columns */
    row_is(1, 26, "000000000");
    row_is(2, 26, "HI 000000000");
    row_is(3, 26, "**         *0");
    int at;
    bool quite = false, long_word = false, rest = false;
    for (uint32_t row = 4; row < 20; row++) {
        const char *s = row_text(row, &at);
        quite |= !strcmp(s, "The Quite") && at == 26;
        long_word |= !strcmp(s, "Unpronounceab") && at == 26;
        rest |= !strcmp(s, "ilities") && at == 26;
    }
    assert_true(quite && long_word && rest);
    close_it();
    snprintf(text, sizeof text, "%s hud.banner({ 'A BANNER', 'ITS OTHER LINE THAT IS LONG' }, 50)", ships);
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(10, 9, "A BANNER"); /* in the middle of columns 1 to 24 */
    row_is(12, 2, "ITS OTHER LINE THAT IS");
    row_is(13, 11, "LONG");
    rig_run(&r, 60);
    row_is(10, -1, "");
    row_is(12, -1, "");
    close_it();
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
    close_it();
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
        uint32_t row;
        const char *there, *out; /* with player 1, and without */
    } rows[] = { { 1, "HI 000000700", "HI 000000700" },
                 { 2, "", "" },
                 { 3, "1P         **", "1P" },
                 { 4, "000000000", "000000000" },
                 { 5, "BOMBS ***", "" },
                 { 6, "MOON FIRE ==-", "" },
                 { 7, "", "" },
                 { 8, "2P         **", "2P         **" },
                 { 9, "000000700", "000000700" },
                 { 10, "BOMBS ***", "BOMBS ***" },
                 { 11, "MOON FIRE ==-", "MOON FIRE ==-" },
                 { 12, "", "" },
                 { 13, "RANK 4", "RANK 4" },
                 { 14, "", "" } };
    struct manifest m = rig_manifest();

    m.players = 2;
    open_with(&m, text);
    rig_run(&r, 1);
    row_is(2, 1, "**       000000700        **");
    row_is(3, 1, "BOMBS ***          BOMBS ***");
    row_is(4, 1, "MOON FIRE ==-  MOON FIRE ==-");
    row_is(5, 1, "RANK 4");
    close_it();
    m.screen_w = 320;
    m.field_w = 200;
    open_with(&m, text);
    rig_run(&r, 1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(rows[i].row, *rows[i].there ? 26 : -1, rows[i].there);
    rig_run(&r, 3);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        row_is(rows[i].row, *rows[i].out ? 26 : -1, rows[i].out);
    close_it();
}

static void boss_text(char *text, size_t size, const char *title, int phases)
{
    static const char phase[] = "{ id = 'a%d', hp = 5, time = 99, rest = 0, run = function() end }, ";
    char list[1024] = "";

    for (int i = 0; i < phases; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), phase, i);
    snprintf(text, size,
             "player.def('p', { sprite = 'dot', hit = { circle = 2 } }) string.sys.join(1, 'p')\n"
             "hud.start(string.sys.scope(), 1)\n"
             "enemy.def('e', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('b', { title = '%s', kind = 'e', x = 9, y = 9, phases = { %s } })\n"
             "task.go(function() boss.fight('b') end)",
             title, list);
}

/* A star for each phase to come stands behind the bar, and the title in one row below, whatever of it has room. */
TEST(title)
{
    static char text[2048];
    static const struct {
        const char *title, *row[2];
        int phases;
    } rows[] = {
        { "NINE", { "================== ***    11", "NINE                      11" }, 4 },
        { "A TITLE OF TWENTY-THREE", { "================== ***    11", "A TITLE OF TWENTY-THREE   11" }, 4 },
        { "A TITLE THAT GOES OVER TWO OF THEM", { "==================== *    11", "A TITLE THAT GOES OVER    11" }, 2 },
        { "THE FOURTH OF ALL: TITLES", { "======================    11", "TITLES                    11" }, 1 },
        { "NINE", { "=============== ******    11", "NINE                      11" }, 9 },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        boss_text(text, sizeof text, rows[i].title, rows[i].phases);
        open_with(NULL, text);
        rig_run(&r, 120);
        for (uint32_t k = 0; k < 2; k++)
            row_is(3 + k, 1, rows[i].row[k]);
        row_is(5, -1, "");
        close_it();
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
    close_it();
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
    close_it();
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
        close_it();
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
    close_it();
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
    rig_run(&r, 5);
    row_is(1, -1, "");
    row_is(5, -1, "");
    rig_run(&r, 10); /* another heat, and only its row is another */
    row_is(1, -1, "");
    row_is(5, 1, "HEAT ==------");
    rig_run(&r, 10); /* refreshed */
    row_is(1, 1, "000000000       HI 000000000");
    row_is(3, 1, "BOMBS ***");
    rig_run(&r, 10);
    row_is(1, 1, "000000007       HI 000000007");
    close_it();
}

/* A letter's rim is the darkest colour next to each of its pixels, and under every letter. */
TEST(rim)
{
    uint32_t rgb[256];
    int dark = 0, rims = 0;

    open_with(NULL, "text.put { col = 3, row = 3, text = 'AB', bank = 1, rim = true } text.put { col = 3, row = 9, "
                    "text = 'AB', bank = 1 }\n"
                    "for i = 0, 9 do sprite.put { sprite = 'arrow', x = 8 + 8 * i, y = 28, bank = 9 } sprite.put { "
                    "sprite = 'arrow', x = 8 + 8 * i, y = 76, bank = 9 } end");
    rig_run(&r, 1);
    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    for (int i = 0; i < 256; i++) {
        uint32_t a = rgb[i], b = rgb[dark];
        dark = (a >> 16) + (a >> 8 & 255) + (a & 255) < (b >> 16) + (b >> 8 & 255) + (b & 255) ? i : dark;
    }
    for (int y = 20; y < 36; y++)
        for (int x = 16; x < 48; x++) {
            bool letter = false, next = false;
            for (int v = -1; v <= 1; v++)
                for (int u = -1; u <= 1; u++) {
                    int cx = x + u - 24, cy = y + v - 24;
                    if (cx < 0 || cx >= 16 || cy < 0 || cy >= 8)
                        continue;
                    bool is = g.cart.glyphs[('A' - 32 + cx / 8) * 64 + cy * 8 + cx % 8] != 0;
                    letter |= is && !u && !v;
                    next |= is;
                }
            int got = r.fb.pix[y * r.fb.pitch + x], plain = r.fb.pix[(y + 48) * r.fb.pitch + x];
            int want = !letter && next ? dark : plain;
            if (got != want)
                fail_msg("pixel %d,%d is %d, expected %d", x, y, got, want);
            rims += !letter && next;
        }
    assert_true(rims > 10);
    close_it();
}

/* A pixel of the font's letter; 0 outside of it. */
static int ink(int code, int x, int y)
{
    return x < 0 || y < 0 || x > 7 || y > 7 ? 0 : g.cart.glyphs[(code - 32) * 64 + y * 8 + x];
}

/* A letter twice as large is what scale2x makes of the letter; half of one at the screen's edge is that half. */
TEST(large)
{
    uint32_t rgb[256];
    int other = 0;

    open_with(NULL, "text.put { col = 3, row = 3, text = 'KA', bank = 1, size = 2 }\n"
                    "text.put { col = 29, row = 9, text = 'A', bank = 1, size = 2, rim = true }");
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
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 8; x++)
            if (r.fb.pix[(24 + y) * r.fb.pitch + 40 + x] != 0)
                assert_int_equal(r.fb.pix[(72 + y) * r.fb.pitch + 232 + x], r.fb.pix[(24 + y) * r.fb.pitch + 40 + x]);
    close_it();
}

static void says(const char *registers, const char *line)
{
    char text[512];
    struct rig_game game;

    snprintf(text, sizeof text, "player.def('p', { sprite = 'dot', hit = { circle = 2 }, registers = { %s } })",
             registers);
    rig_script(&game, NULL, text);
    assert_string_equal(rig_said(&game, 1, false), line);
    rig_game_free(&game);
}

TEST(errors)
{
    says("a = { strat = 3 }", "player.def: registers.a: unknown argument \"strat\" (did you mean \"start\"?)");
    says("a = { start = 3, max = 2 }", "player.def: registers.a: start 3 is greater than max 2");
    says("a = { at = 'left' }", "player.def: registers.a.at: expected top or low, got \"left\"");
    says("a = { label = 3 }", "player.def: registers.a.label: expected a string, got 3");
    says("a = { show = 'bars' }",
         "player.def: registers.a.show: expected none, number, icons, bar or times, got \"bars\"");
    says("a = { show = 'bar' }", "player.def: registers.a: `show = \"bar\"` requires `max`");
    says("a = { start = -1 }", "player.def: registers.a: start -1 is less than min 0");
    says("a = 1.5", "player.def: registers.a: expected a whole number from 0 to 2147483647, got 1.5");
    says("x = 1", "player.def: registers: \"x\" is already a property of players");
}

RUN_TESTS(NULL, NULL)
