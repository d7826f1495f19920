/*
 * test_config.c - settings written back: what their owner wrote stays, the last line of a name is the one that is
 * changed, whatever is written is read as what was meant, and no damage is more than a sentence.
 */
#define _POSIX_C_SOURCE 200809L
#include <sys/stat.h>
#include <unistd.h>
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/base/rng.h"
#include "../../src/player/settings/config.h"
#include "../temp.h"

static char err[512];

/* What the settings are, without what is held at present. */
static bool equal(const struct config *a, const struct config *b)
{
    const struct config_setting *s;

    for (int i = 0; (s = config_setting(i)) != NULL; i++)
        if (config_value(a, s) != config_value(b, s))
            return false;
    return strcmp(a->lang, b->lang) == 0 && memcmp(a->keys.code, b->keys.code, sizeof a->keys.code) == 0;
}

/* Settings of a text, over the defaults. */
static struct config read_text(const char *text)
{
    struct config c;

    config_defaults(&c);
    if (!config_read(&c, "x.conf", text, strlen(text), err, sizeof err))
        fail_msg("%s in: %s", err, text);
    return c;
}

/* `was` edited so that it says what `now` says becomes `want`. */
static void edits(const char *was, const char *now, const char *want)
{
    struct config c = read_text(now);
    char *text = config_edit(&c, was, strlen(was), err, sizeof err);

    if (!text)
        fail_msg("%s", err);
    assert_string_equal(text, want);
    c = read_text(text);
    const struct config meant = read_text(now);
    assert_true(equal(&c, &meant));
    free(text);
}

TEST(what_stands_there_stays)
{
    edits("# mine\n\n  scale=3   # wide\n volume = 40\t# quiet\n", "scale = 4\nvolume = 40",
          "# mine\n\n  scale= 4   # wide\n volume = 40\t# quiet\n");
    edits("volume=40#quiet", "volume = 50", "volume= 50#quiet");
    edits("p1.fire = z # and x\n", "p1.fire = space pad.l2", "p1.fire = space pad.l2 # and x\n");
    edits("# volume = 4\n", "volume = 10", "# volume = 4\nvolume = 10\n");
    edits("fullscreen = yes\n", "", "fullscreen = no\n"); /* back to what is so anyway: the line is not taken away */
}

TEST(the_last_line_counts)
{
    edits("volume = 1\nvolume = 2\nmute = yes\n", "volume = 3\nmute = yes", "volume = 1\nvolume = 3\nmute = yes\n");
    edits("volume = 1\n\rvolume = 2\n", "volume = 3", "volume = 1\n\rvolume = 3\n");
    edits("volume = 1\nvolume\r= 2\n", "volume = 3", "volume = 1\nvolume\r= 3\n");
    edits("p1.up = q\n", "p1.up = q\np1.up = w", "p1.up = w\n");
}

TEST(a_new_line_comes_at_the_end)
{
    edits("", "volume = 70", "volume = 70\n");
    edits("scale = 2\r\nvolume = 5 # low\r\n", "scale = 3\nvolume = 6", "scale = 3\r\nvolume = 6 # low\r\n");
    edits("scale = 2\n", "scale = 2\nspeed = 50\nlang = de", "scale = 2\nspeed = 50\nlang = de\n");
    edits("scale = 2", "scale = 5\np2.bomb = none", "scale = 5\np2.bomb = none\n");
    edits("lang = de\n", "", "lang =\n");
}

/* A comment that leaves no room in its line stays; the value gets a line of its own. */
TEST(a_line_never_gets_too_long)
{
    char was[CONFIG_LINE + 64], want[CONFIG_LINE + 128];
    memset(was, '-', sizeof was);
    memcpy(was, "volume = 5 #", 12);
    was[CONFIG_LINE - 2] = 0;
    strcat(was, "\n");
    snprintf(want, sizeof want, "%s", was);
    want[9] = '7';
    edits(was, "volume = 7", want);
    memcpy(want, was, sizeof was);
    strcat(want, "volume = 77\n");
    was[CONFIG_LINE - 2] = '-';
    memcpy(was + CONFIG_LINE - 1, "\n", 2);
    memcpy(want + CONFIG_LINE - 2, "-\nvolume = 77\n", 15);
    edits(was, "volume = 77", want);
}

static char folder[256], path[400];

/* err is this of the settings file. */
static void says(const char *want)
{
    char whole[600];

    snprintf(whole, sizeof whole, "%s%s", path, want);
    assert_string_equal(err, whole);
}

static void refused(const char *was, size_t n, const char *want)
{
    struct config c = read_text("volume = 7");

    assert_null(config_edit(&c, was, n, err, sizeof err));
    says(want);
}

TEST(what_is_not_right_is_refused)
{
    static char large[CONFIG_BYTES];

    refused("scael = 3\n", 10, ":1: unknown setting \"scael\"");
    refused("mute = no\n\0", 11, ":2: expected a line of text");
    refused("dip.g.coins = free play\n", 24, ":1: dip.g.coins: expected a name or a number, got \"free play\"");
    memset(large, '\n', CONFIG_BYTES);
    refused(large, CONFIG_BYTES, ": the file would be larger than 65536 bytes");
}

/* ---- whatever is set ---- */

static const char *const switches[] = {
    "z", "f12", "kp+", "key100", "alt+enter", "ctrl+key99", "pad.south", "pad2.l3"
};

static int below(struct rng *r, int n)
{
    return (int)rng_below(r, (uint64_t)n);
}

static void any_settings(struct rng *r, struct config *c)
{
    static const char *const langs[] = { "", "de", "ja", "pt-BR", "a_b" };
    const struct config_setting *s;
    char list[256];

    for (int i = 0; (s = config_setting(i)) != NULL; i++)
        if (below(r, 3) == 0)
            config_put(c, s, s->lo + below(r, s->hi - s->lo + 1));
    if (below(r, 4) == 0)
        snprintf(c->lang, sizeof c->lang, "%s", langs[below(r, 5)]);
    if (below(r, 4) == 0)
        config_put_dip(c, below(r, 2) ? "g" : "glass_tide", "coins", below(r, 2) ? "free" : "-12");
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        size_t n = 0;
        if (below(r, 5) != 0)
            continue;
        list[0] = 0;
        for (int k = below(r, KEYS_PER_ACTION + 1); k > 0; k--)
            n += (size_t)snprintf(list + n, sizeof list - n, "%s ",
                                  switches[below(r, (int)(sizeof switches / sizeof *switches))]);
        assert_true(keys_bind(&c->keys, keys_action_name(i), n ? list : "none", err, sizeof err));
    }
}

/* The text of one round is the file of the next, and none of its comments is lost. */
TEST(what_is_written_is_read)
{
    static const char first[] = "# mine\r\nvolume=3 # low\r\n\r\nmute = no\np1.up = q # far\nlang = fr#x\n\n#end";
    char *text = strdup(first);
    struct rng r;

    rng_seed(&r, 19);
    for (int round = 0; round < 400; round++) {
        struct config c = read_text(text), again;
        any_settings(&r, &c);
        char *next = config_edit(&c, text, strlen(text), err, sizeof err);
        if (!next)
            fail_msg("round %d: %s", round, err);
        again = read_text(next);
        if (!equal(&c, &again))
            fail_msg("round %d: another setting is read:\n%s", round, next);
        assert_memory_equal(next, "# mine\r\nvolume=", 15);
        assert_non_null(strstr(next, " # low\r\n\r\nmute = "));
        assert_non_null(strstr(next, " # far\nlang ="));
        assert_non_null(strstr(next, "#x\n\n#end\n"));
        free(text);
        text = next;
    }
    assert_true(strlen(text) < 8192); /* one line a name */
    free(text);
}

/* Spoilt files, each in memory of its own size: refused in a sentence, or edited into what was meant. */
TEST(no_damage_is_more_than_a_sentence)
{
    static const char good[] = "# mine\nvolume = 40 # low\r\nmute=yes\n\nlang = de\np1.fire = z pad.south\nspeed=half";
    static const char likely[] = "\n\r\t =#\0az.09\xff";
    int edited = 0, refusals = 0;
    struct rng r;

    rng_seed(&r, 20);
    for (int round = 0; round < 20000; round++) {
        const size_t n = (size_t)below(&r, sizeof good);
        char *text = malloc(n + (n == 0));
        struct config c = read_text(""), again = c;
        memcpy(text, good, n);
        for (int k = below(&r, 4); n && k > 0; k--)
            text[below(&r, (int)n)] = likely[below(&r, sizeof likely - 1)];
        if (round % 2)
            any_settings(&r, &c);
        char *next = config_edit(&c, text, n, err, sizeof err);
        if (next) {
            edited++;
            assert_true(config_read(&again, "x.conf", next, strlen(next), err, sizeof err));
            assert_true(equal(&c, &again));
        } else {
            refusals++;
            assert_false(config_read(&again, path, text, n, err, sizeof err));
            assert_memory_equal(err, path, strlen(path));
        }
        free(next);
        free(text);
    }
    assert_true(edited > 2000 && refusals > 2000);
}

/* ---- the file ---- */

static void write_file(const char *text)
{
    assert_true(plat_save(path, text, strlen(text)));
}

static void file_is(const char *want)
{
    char text[4096];
    const long n = plat_load(path, text, sizeof text - 1);

    assert_true(n >= 0);
    text[n] = 0;
    assert_string_equal(text, want);
}

TEST(the_file)
{
    struct config c;

    assert_true(config_load(&c, err, sizeof err));
    assert_true(config_save(&c, err, sizeof err));
    assert_int_not_equal(access(path, F_OK), 0); /* nothing differs, so there is none yet */
    c.music = 30;
    assert_true(config_save(&c, err, sizeof err));
    file_is("music = 30\n");
    write_file("# by hand\nmusic = 60 # so\n");
    c.volume = 90;
    assert_true(config_save(&c, err, sizeof err));
    file_is("# by hand\nmusic = 30 # so\nvolume = 90\n");
    assert_true(config_load(&c, err, sizeof err));
    assert_int_equal(c.music, 30);
    assert_int_equal(c.volume, 90);
    write_file("musik = 60 # so\n");
    assert_false(config_save(&c, err, sizeof err));
    says(":1: unknown setting \"musik\"");
    file_is("musik = 60 # so\n");
    write_file("\xef\xbb\xbfmusic = 60\n"); /* a byte order mark, as editors of Windows write */
    assert_true(config_load(&c, err, sizeof err));
    assert_int_equal(c.music, 60);
    c.music = 20;
    assert_true(config_save(&c, err, sizeof err));
    file_is("music = 20\n");
}

static int open_folder(void **state)
{
    (void)state;
    if (!temp_folder(folder, sizeof folder, "config") || setenv("XDG_DATA_HOME", folder, 1) != 0)
        return -1;
    snprintf(path, sizeof path, "%s/curtain", folder);
    if (mkdir(path, 0700) != 0)
        return -1;
    snprintf(path, sizeof path, "%s/curtain/curtain.conf", folder);
    return 0;
}

static int close_folder(void **state)
{
    (void)state;
    remove(path);
    path[strlen(path) - strlen("/curtain.conf")] = 0;
    return rmdir(path) | rmdir(folder);
}

RUN_TESTS(open_folder, close_folder)
