/*
 * test_words.c - texts beyond ASCII: cells, the hud's rows, and what is drawn of them.
 */
#include "../../src/workbench/pack/lang.h"
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static void power(const struct manifest *m, const char *text, int frames)
{
    rig_script(&g, m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, frames);
}

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

/* A row's characters, \1 for those that no cell can hold, \2 for an empty one; the rest of the row is empty. */
static void row_is(uint32_t row, uint32_t col, const char *want)
{
    const struct fix *f = &rig.b->fix;
    const uint8_t *at = f->code + row * f->cols;
    const uint32_t n = (uint32_t)strlen(want);

    for (uint32_t i = 0; i < f->cols; i++)
        if (at[i] != (i >= col && i < col + n && want[i - col] != 2 ? (uint8_t)want[i - col] : 0))
            fail_msg("row %u, column %u: %d", row, i, at[i]);
}

TEST(cells)
{
    power(NULL,
          "text.put { col = 0, row = 0, text = '\xe5\xbc\xbe\xe5\xb9\x95 \xc3\xa9t\xc3\xa9 \xc3\x9f' }\n"
          "text.put { col = 10, row = 1, text = '\xc3\xa9t\xc3\xa9s', align = 'center' }\n"
          "text.put { col = 10, row = 2, text = '\xc3\xa9t\xc3\xa9s', align = 'right' }\n"
          "text.put { col = 0, row = 3, text = '\\137\xe9' }\n"
          "text.put { col = -1000, row = 4, text = ('\xc3\xa9'):rep(1024) }\n"
          "text.put { col = 1000, row = 5, text = ('\xc3\xa9'):rep(20000), align = 'right' }\n",
          0);
    row_is(0, 0, "\1\1 \xe9t\xe9 \xdf");
    row_is(1, 8, "\xe9t\xe9s");
    row_is(2, 6, "\xe9t\xe9s");
    row_is(3, 0, "\x89\xe9");
    row_is(4, 0, "\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9");
    row_is(5, 0,
           "\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9\xe9"
           "\xe9\xe9\xe9\xe9");
    end();
}

/* What stands in a cell and has no picture is a box, as another such character is; a blank is nothing. */
TEST(boxes)
{
    uint64_t empty, box, other;

    power(NULL, "", 0);
    empty = rig_picture(&rig);
    end();
    power(NULL, "text.put { col = 3, row = 3, text = '\xe5\xbc\xbe' }", 0);
    box = rig_picture(&rig);
    end();
    power(NULL, "text.put { col = 3, row = 3, text = '\xc3\xa9' }", 0);
    other = rig_picture(&rig);
    end();
    assert_true(empty != box && box == other);
    power(NULL, "text.put { col = 3, row = 3, text = ' \xc2\xa0' }", 0);
    assert_true(rig_picture(&rig) == empty);
    end();
}

/* Rows of characters, not of bytes; none begins with a sign that closes. */
TEST(hud)
{
    power(NULL,
          "hud.centre(0, '\xc3\xa9t\xc3\xa9')\n"
          "hud.put(28, 1, '\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9')\n"
          "local l = hud.wrap('\xc3\xa9t\xc3\xa9 \xc3\xa9t\xc3\xa9 et', 7)\n"
          "assert(#l == 2 and l[1] == '\xc3\xa9t\xc3\xa9 \xc3\xa9t\xc3\xa9' and l[2] == 'et')\n"
          "l = hud.wrap('\xe5\xbc\xbe\xe5\xb9\x95\xe5\xbc\xbe\xe5\xb9\x95\xe5\xbc\xbe a', 2)\n"
          "assert(#l == 4 and l[2] == '\xe5\xbc\xbe\xe5\xb9\x95' and l[3] == '\xe5\xbc\xbe' and l[4] == 'a')\n"
          "l = hud.wrap('\xe5\xbc\xbe\xe5\xb9\x95\xe5\xbc\xbe\xe3\x80\x82\xe5\xb9\x95', 3)\n"
          "assert(utf8.len(l[1]) == 2 and utf8.len(l[2]) == 3)\n"
          "assert(#hud.wrap('abc def', 7) == 1 and #hud.wrap('abc defg', 7) == 2)\n",
          0);
    row_is(0, 13, "\xe9t\xe9");
    row_is(1, 28, "\xe9\xe9");
    end();
}

/* A boss's title and spell: as wide as they have characters, in a wide row and in a narrow panel. */
static void boss_with(const struct manifest *m, const char *title)
{
    char text[2048];

    snprintf(text, sizeof text,
             "enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 100 })\n"
             "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
             "boss.def('iris', { title = '%s', kind = 'foe', x = 60, y = 60, phases = {\n"
             "  { id = 'a', spell = '\xc3\xa9l\xc3\xa8ve l\xc3\xa0 f\xc3\xaate d\xc3\xa9j\xc3\xa0 "
             "\xc3\xa9t\xc3\xa9 \xc3\xa9toil\xc3\xa9', hp = 100, time = 900, run = function() end } } })\n"
             "stage.def('one', function() boss.fight('iris') end)\n"
             "boot.run { stages = { 'one' }, players = { 'ship' } }\n",
             title);
    rig_script(&g, m, text);
    struct board_start start = { .seed = 1, .difficulty = -1 };
    snprintf(start.practice.section, sizeof start.practice.section, "iris/a");
    rig_power(&rig, &g, &start);
    rig_run(&rig, 140);
}

TEST(boss)
{
    struct manifest m = rig_manifest();

    boss_with(&m, "\xc3\x89t\xc3\xa9");
    row_is(4, 1,
           "\xc9t\xe9\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2\2"
           "1144"); /* and the clock's lower half */
    row_is(5, 1, "\xe9l\xe8ve l\xe0 f\xeate d\xe9j\xe0 \xe9t\xe9");
    end();
    m.field_w = 160;
    boss_with(&m, "\xc3\x89t\xc3\xa9 \xc3\x89t\xc3\xa9 \xc3\x89t\xc3\xa9 \xc3\x89t\xc3\xa9");
    row_is(8, 21, "\xc9t\xe9 \xc9t\xe9");
    row_is(9, 21, "\xc9t\xe9 \xc9t\xe9");
    /* over the field, to its right edge but one cell, beside the panel's rows */
    row_is(1, 1,
           "\xe9l\xe8ve l\xe0 f\xeate d\xe9j\xe0\2\2"
           "000000000");
    row_is(2, 21, "HI       ");
    end();
}

/* ---- languages ---- */

/* The game with a language "de" besides. */
static void add_german(struct rig_game *game)
{
    static const char german[] = "Hello = Hallo\nShip %d = Schiff %d\nPRESS START = START DR\xc3\x9c\x43KEN\n";
    struct rig_game had = *game;
    struct lump lumps[RIG_LUMPS];
    int n = (int)had.image.rom.count;
    struct lang l;
    uint8_t *lump;
    char err[256];

    assert_true(n <= RIG_LUMPS);
    if (!lang_read(&l, german, sizeof german - 1, "de", err, sizeof err))
        fail_msg("%s", err);
    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    lumps[n++] = (struct lump){ "lang/de", NULL, (uint32_t)lang_make(&l, &lump) };
    lumps[n - 1].data = lump;
    rig_write(game, lumps, n);
    free(lump);
    lang_free(&l);
    free(had.image.bytes);
}

static void say_in(const char *lang)
{
    struct board_start start = { .seed = 1, .difficulty = -1 };

    rig_script(&g, NULL,
               "text.put { col = 0, row = 0, text = text.lang('Hello') .. text.lang('Other') }\n"
               "text.put { col = 0, row = 1, text = text.lang('Ship %d'):format(3) }\n"
               "assert(text.lang == text.lang and rawget(text, 'lang') and text.more == nil)\n"
               "hud.centre(2, 'PRESS START')");
    add_german(&g);
    snprintf(start.lang, sizeof start.lang, "%s", lang);
    rig_power(&rig, &g, &start);
    rig_run(&rig, 2);
}

TEST(lang)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .lang = "fr" };
    uint64_t hash;
    char err[256];

    say_in("");
    row_is(0, 0, "HelloOther");
    row_is(1, 0, "Ship 3");
    row_is(2, 9, "PRESS START");
    hash = board_hash(rig.b);
    end();
    say_in("de");
    row_is(0, 0, "HalloOther");
    row_is(1, 0, "Schiff 3");
    row_is(2, 8, "START DR\xdc\x43KEN");
    assert_true(board_hash(rig.b) != hash);
    hash = board_hash(rig.b);
    rig_spoil(&rig);
    assert_true(board_hash(rig.b) == hash);
    assert_null(board_power_on(rig.ram, rig.ram_size, &g.image.rom, &start, err, sizeof err));
    assert_string_equal(err, "language \"fr\": no lang/fr.txt in the game");
    end();
}

RUN_TESTS(NULL, NULL)
