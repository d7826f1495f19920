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
    rig_close(&rig);
}

static uint64_t picture_of(const char *words)
{
    char text[100];

    snprintf(text, sizeof text, "text.put { col = 3, row = 3, text = '%s' }", words);
    power(NULL, text, 0);
    const uint64_t picture = rig_picture(&rig);
    rig_close(&rig);
    return picture;
}

/* What stands in a cell and has no picture is a box, as another such character is; a blank is nothing. */
TEST(boxes)
{
    const uint64_t empty = picture_of(""), box = picture_of("\xe5\xbc\xbe");

    assert_true(empty != box);
    assert_true(picture_of("\xc3\xa9") == box);
    assert_true(picture_of(" \xc2\xa0") == empty);
}

/* Columns are characters, not bytes. */
TEST(hud)
{
    power(NULL,
          "hud.centre(0, '\xc3\xa9t\xc3\xa9')\n"
          "hud.put(28, 1, '\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9')\n",
          0);
    row_is(0, 13, "\xe9t\xe9");
    row_is(1, 28, "\xe9\xe9");
    rig_close(&rig);
}

/* A boss's title and spell are as wide as they have characters. */
TEST(boss)
{
    static const char text[] =
        "enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 100 })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
        "boss.def('iris', { title = '\xc3\x89t\xc3\xa9', kind = 'foe', x = 60, y = 60, phases = {\n"
        "  { id = 'a', spell = '\xc3\xa9l\xc3\xa8ve l\xc3\xa0 f\xc3\xaate d\xc3\xa9j\xc3\xa0 "
        "\xc3\xa9t\xc3\xa9 \xc3\xa9toil\xc3\xa9', hp = 100, time = 900, run = function() end } } })\n"
        "stage.def('one', function() boss.fight('iris') end)\n"
        "boot.run { stages = { 'one' }, players = { 'ship' } }\n";
    const struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "iris/a" };

    rig_script(&g, NULL, text);
    rig_power(&rig, &g, &start);
    rig_run(&rig, 140);
    row_is(4, 1,
           "\xe9l\xe8ve l\xe0 f\xeate d\xe9j\xe0 \xe9t\xe9\2\2"
           "1144"); /* and the clock's lower half */
    rig_close(&rig);
}

/* ---- languages ---- */

/* Adds the language "de" to a game. */
static void add_german(struct rig_game *game)
{
    static const char german[] = "Hello = Hallo\nShip %d = Schiff %d\nPRESS START = START DR\xc3\x9c\x43KEN\n";
    struct lang l;
    uint8_t *lump;
    char err[256];

    if (!lang_read(&l, german, sizeof german - 1, "de", err, sizeof err))
        fail_msg("%s", err);
    const size_t size = lang_make(&l, &lump);
    rig_lump(game, "lang/de", lump, size);
    free(lump);
    lang_free(&l);
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
    rig_close(&rig);
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
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)
