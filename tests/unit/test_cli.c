/* test_cli.c - args.h and cli.h: what a command line means, and how a wrong one is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/cab/args.h"
#include "../../src/cab/cli.h"

enum { MOST_WORDS = 32 };

static struct args a;
static char err[512], text[512], *words[MOST_WORDS];

/* Cuts a line at its blanks; '' is an empty word. */
static int cut(const char *line)
{
    int n = 1;

    snprintf(text, sizeof text, "%s", line);
    words[0] = "curtain";
    for (char *p = strtok(text, " "); p; p = strtok(NULL, " "))
        words[n++] = strcmp(p, "''") == 0 ? "" : p;
    return n;
}

static bool parse(const char *line)
{
    err[0] = 0;
    return args_parse(&a, cut(line), words, err, sizeof err);
}

static void reads(const char *line)
{
    if (!parse(line))
        fail_msg("%s: %s", line, err);
}

static void refuses(const char *line, const char *sentence)
{
    assert_false(parse(line));
    assert_string_equal(err, sentence);
}

static void test_commands(void **state)
{
    (void)state;
    reads("");
    assert_int_equal(a.command, COMMAND_PLAY);
    assert_int_equal(a.n_words, 0);
    reads("game");
    assert_int_equal(a.command, COMMAND_PLAY);
    assert_string_equal(a.words[0], "game");
    reads("play game");
    assert_int_equal(a.command, COMMAND_PLAY);
    assert_string_equal(a.words[0], "game");
    reads("--seed 7 hash --frames 3 game");
    assert_int_equal(a.command, COMMAND_HASH);
    assert_int_equal(a.n_words, 1);
    assert_string_equal(a.words[0], "game");
    reads("verify game one two three --trace");
    assert_int_equal(a.n_words, 4);
    assert_string_equal(a.words[3], "three");
    assert_true(a.trace);
    reads("hash -- --odd");
    assert_string_equal(a.words[0], "--odd");
    for (int i = 0; i < COMMANDS; i++)
        assert_int_equal(args_command((const char *[]){ "play", "render", "hash", "verify", "pack", "list", "unpack",
                                                        "help", "version" }[i]),
                         i);
    assert_int_equal(args_command("Play"), -1);
}

static void test_values(void **state)
{
    (void)state;
    reads("play game --record r --scale 3 --fullscreen --mute --stage one:mark --difficulty=hard");
    assert_string_equal(a.record, "r");
    assert_int_equal(a.scale, 3);
    assert_true(a.fullscreen && a.mute && !a.seeded);
    assert_string_equal(a.stage, "one:mark");
    assert_string_equal(a.difficulty, "hard");
    reads("play --seed 18446744073709551615");
    assert_true(a.seeded && a.seed == UINT64_MAX);
    reads("play --seed 0xFfffffffffffffff");
    assert_true(a.seed == UINT64_MAX);
    reads("play --seed=0");
    assert_true(a.seeded && a.seed == 0);
    reads("hash game --dip a=1 --dip b=two=3");
    assert_int_equal(a.n_dips, 2);
    assert_string_equal(a.dips[1], "b=two=3");
    reads("hash game --every 60 --parts --demo d");
    assert_int_equal(a.every, 60);
    assert_true(a.parts);
    assert_string_equal(a.demo, "d");
    reads("render game --frames 1 -o out --sheet s.png --nearest -v");
    assert_string_equal(a.out, "out");
    assert_string_equal(a.sheet, "s.png");
    assert_true(a.nearest && a.trace);
}

/* All frames up to `last` and a few more, as a string of 0 and 1. */
static void wants(const char *list, const char *bits)
{
    char line[128], got[64];
    uint32_t n = (uint32_t)strlen(bits);

    snprintf(line, sizeof line, "render game --frames %s", list);
    reads(line);
    for (uint32_t f = 0; f < n; f++)
        got[f] = args_wants(&a, f) ? '1' : '0';
    got[n] = 0;
    assert_string_equal(got, bits);
    assert_int_equal(args_last_frame(&a), strrchr(bits, '1') - bits);
}

static void test_frames(void **state)
{
    (void)state;
    wants("0", "100");
    wants("3", "000100");
    wants("1,4,2", "0110100");
    wants("2:4", "0011100");
    wants("0:6:3", "100100100");
    wants("0:7:3", "1001001000");
    wants("5:5:9", "0000010");
    wants("1,3:5,7:11:2", "0101110101010");
}

static void test_bad_values(void **state)
{
    static const char *const frames[] = {
        "x",  "1:", ":1", "1:2:", "1:2:3:4", "1,,2", ",", "1,", "-1", "1:5:0", "1.5", "8388609", "99999999999999999999",
        "''", "0x"
    };
    char line[128];

    (void)state;
    for (size_t i = 0; i < sizeof frames / sizeof frames[0]; i++) {
        snprintf(line, sizeof line, "render game --frames %s", frames[i]);
        assert_false(parse(line));
        assert_non_null(strstr(err, "--frames: expected frames from 0 to 8388608 like 600"));
        assert_non_null(strstr(err, "got \""));
    }
    refuses("render game --frames 5:4", "--frames: 5:4 ends before it starts");
    refuses("play --seed 18446744073709551616",
            "--seed: expected a whole number from 0 to 18446744073709551615, got \"18446744073709551616\"");
    refuses("play --seed 12a", "--seed: expected a whole number from 0 to 18446744073709551615, got \"12a\"");
    refuses("play --seed -1", "--seed: expected a whole number from 0 to 18446744073709551615, got \"-1\"");
    refuses("play --scale 0", "--scale: expected a whole number from 1 to 16, got \"0\"");
    refuses("play --scale 17", "--scale: expected a whole number from 1 to 16, got \"17\"");
    refuses("hash game --every 0", "--every: expected a whole number from 1 to 8388608, got \"0\"");
    refuses("play --dip lives", "--dip: expected NAME=VALUE, got \"lives\"");
    refuses("play --dip =3", "--dip: expected NAME=VALUE, got \"=3\"");
    refuses("play --dip lives=", "--dip: expected NAME=VALUE, got \"lives=\"");
    refuses("play --record ''", "--record: expected F, got nothing");
    refuses("play --record", "--record: expected F, got nothing");
    refuses("play --mute=1", "--mute takes no value, got \"1\"");
    refuses("play --seed 1 --seed 2", "--seed is given twice");
}

static void test_misfits(void **state)
{
    (void)state;
    refuses("render g --framse 3", "unknown option --framse (did you mean --frames?)");
    refuses("render g --frame=3", "unknown option --frame (did you mean --frames?)");
    refuses("hash g --xyzzy", "unknown option --xyzzy (curtain help lists them)");
    refuses("play -q", "unknown option -q (curtain help lists them)");
    refuses("play g --every 3", "--every does not go with play (it goes with hash)");
    refuses("pack g --frames 3", "--frames does not go with pack (it goes with render, hash)");
    refuses("hash g --demo d --stage one", "--stage does not go with --demo, which holds its own");
    refuses("hash g --seed 1 --demo d", "--seed does not go with --demo, which holds its own");
    refuses("rendr g --frames 1", "unknown command \"rendr\" (did you mean render?)");
    refuses("rendr --frames 1", "unknown command \"rendr\" (did you mean render?)");
    refuses("mygame other", "unknown command \"mygame\" (curtain help lists them)");
    refuses("hash", "hash: expected ROM (curtain help hash)");
    refuses("verify g", "verify: expected ROM DEMO... (curtain help verify)");
    refuses("hash g h", "hash: \"h\" is one argument too many (curtain help hash)");
}

static void test_near(void **state)
{
    static const char *const list[] = { "play", "render", "hash", "verify" };

    (void)state;
    assert_string_equal(args_near("rendre", list, 4), "render");
    assert_string_equal(args_near("hahs", list, 4), "hash");
    assert_string_equal(args_near("pay", list, 4), "play");
    assert_null(args_near("boss", list, 4));
    assert_null(args_near("", list, 4));
    assert_null(args_near("a-word-of-more-than-thirty-one-letters", list, 4));
}

static void test_help_and_version(void **state)
{
    (void)state;
    reads("--version");
    assert_int_equal(a.command, COMMAND_VERSION);
    reads("-h");
    assert_int_equal(a.command, COMMAND_HELP);
    assert_int_equal(a.n_words, 0);
    reads("render --help");
    assert_int_equal(a.command, COMMAND_HELP);
    assert_string_equal(a.words[0], "render");
    reads("help lua bullet.fire");
    assert_int_equal(a.n_words, 2);
}

static char help[16384];

static void collect(const char *line)
{
    size_t n = strlen(help);

    snprintf(help + n, sizeof help - n, "%s\n", line);
}

/* Help comes from the tables: whatever a command takes is in its help, and nothing else. */
static void test_help_text(void **state)
{
    (void)state;
    help[0] = 0;
    args_help(COMMAND_HASH, collect);
    assert_non_null(strstr(help, "--every N"));
    assert_non_null(strstr(help, "--parts"));
    assert_null(strstr(help, "--scale"));
    help[0] = 0;
    args_help(-1, collect);
    assert_non_null(strstr(help, "curtain verify ROM DEMO..."));
    assert_non_null(strstr(help, "--scale N"));
}

static void test_exit_codes(void **state)
{
    static const char *const bad[] = {
        "hash",         "hash /nowhere/at-all.rom", "verify /nowhere/a.rom d", "/nowhere/game", "render g",
        "help nothing", "pack /nowhere/dir",        "play --scale x"
    };

    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int n = cut(bad[i]);
        assert_int_equal(cli_main(n, words), EXIT_INPUT);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_commands),         cmocka_unit_test(test_values),    cmocka_unit_test(test_frames),
        cmocka_unit_test(test_bad_values),       cmocka_unit_test(test_misfits),   cmocka_unit_test(test_near),
        cmocka_unit_test(test_help_and_version), cmocka_unit_test(test_help_text), cmocka_unit_test(test_exit_codes),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
