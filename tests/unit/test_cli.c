/*
 * test_cli.c - args.h: what a command line means, and how a wrong one is refused. tests/cli runs whole commands.
 */
#include "../test.h"
#include "../../src/base/pads.h"
#include "../../src/player/args/args.h"
#include "../../src/workbench/export/export.h"

enum { MOST_WORDS = 32 };

static struct args a;
static char err[512], text[512], *words[MOST_WORDS];

/* Parses a line, cut at its blanks; '' is an empty word. */
static bool parse(const char *line)
{
    int n = 1;

    snprintf(text, sizeof text, "%s", line);
    words[0] = "curtain";
    for (char *p = strtok(text, " "); p; p = strtok(NULL, " "))
        words[n++] = strcmp(p, "''") == 0 ? "" : p;
    err[0] = 0;
    return args_parse(&a, n, words, err, sizeof err);
}

static void reads(const char *line)
{
    if (!parse(line))
        fail_msg("%s: %s", line, err);
}

TEST(commands)
{
    static const char *const names[COMMANDS] = { "play",     "render", "capture", "hash",    "verify", "test",
                                                 "pack",     "list",   "unpack",  "new",     "export", "register",
                                                 "check",    "bench",  "survive", "sound",   "art",    "palette",
                                                 "bulletml", "help",   "version", "licences" };

    for (int i = 0; i < COMMANDS; i++)
        assert_int_equal(args_command(names[i]), i);
    assert_int_equal(args_command("Play"), -1);
    reads("");
    assert_true(a.command == COMMAND_PLAY && a.n_words == 0);
    reads("game");
    assert_int_equal(a.command, COMMAND_PLAY);
    assert_string_equal(a.words[0], "game");
    reads("--seed 7 hash --frames 3 game");
    assert_true(a.command == COMMAND_HASH && a.n_words == 1);
    assert_string_equal(a.words[0], "game");
    reads("verify game one two three --verbose");
    assert_true(a.verbose && a.n_words == 4);
    assert_string_equal(a.words[3], "three");
    reads("hash -- --odd");
    assert_string_equal(a.words[0], "--odd");
    reads("--version");
    assert_int_equal(a.command, COMMAND_VERSION);
    reads("-h");
    assert_true(a.command == COMMAND_HELP && a.n_words == 0);
    reads("render --help");
    assert_int_equal(a.command, COMMAND_HELP);
    assert_string_equal(a.words[0], "render");
}

/* Options of each kind, and what is set without them. */
TEST(options)
{
    reads("play game --record r --scale 3 --fullscreen --mute --difficulty=hard");
    assert_string_equal(a.record, "r");
    assert_string_equal(a.difficulty, "hard");
    assert_true(a.scale == 3 && a.fullscreen && a.mute && !a.seeded && !a.dialog);
    reads("play --seed 18446744073709551615");
    assert_true(a.seeded && a.seed == UINT64_MAX);
    reads("play --seed 0xFfffffffffffffff");
    assert_true(a.seed == UINT64_MAX);
    reads("hash game --dip a=1 --dip b=two=3 --trace input --trace=bullets,player --frames 5:9 --traceback");
    assert_true(a.n_dips == 2 && a.n_traces == 2 && a.verbose);
    assert_string_equal(a.dips[1], "b=two=3");
    assert_string_equal(a.traces[1], "bullets,player");
    reads("bench game");
    assert_int_equal(a.machine, 1);
    reads("palette warm.hex -o p.png");
    assert_int_equal(a.bank, -1);
    reads("verify game - -0 --restamp");
    assert_true(a.null && a.restamp && !a.bisect && a.n_words == 2);
    assert_string_equal(a.words[1], "-");
    reads("render game --frames 1 --dim most --flashes soft --colours=deutan");
    assert_true(a.dim == 3 && a.flashes == 1 && a.colours == 2);
    reads("capture game --frames 60-600 --speed 1/4 -o -");
    assert_true(a.faster == 1 && a.slower == 4);
    assert_true(a.n_spans == 1 && a.spans[0].first == 60 && a.spans[0].last == 600 && a.spans[0].step == 1);
    reads("capture game --speed 16 -o a.gif");
    assert_true(a.faster == 16 && a.slower == 1);
    reads("export game -o g --keys --desktop");
    assert_true(a.keys && a.desktop && !a.full && a.export == EXPORT_PROGRAM);
    reads("export game --windows");
    assert_int_equal(a.export, EXPORT_WINDOWS);
}

/* All frames up to `last` and a few more, as a string of 0 and 1. */
static void wants(const char *list, const char *bits)
{
    char line[128], got[64];
    uint32_t n = (uint32_t)strlen(bits);

    snprintf(line, sizeof line, "render game --frames %s", list);
    reads(line);
    for (uint32_t f = 0; f < n; f++)
        got[f] = args_has_frame(&a, f) ? '1' : '0';
    got[n] = 0;
    assert_string_equal(got, bits);
    assert_int_equal(args_last_frame(&a), strrchr(bits, '1') - bits);
}

TEST(frames)
{
    static const char *const bad[] = { "x", "1:", ":1", "1:2:3:4", "1,,2", "1,", "-1", "1:5:0", "8388609", "''" };
    char line[128];

    wants("0", "100");
    wants("1,4,2", "0110100");
    wants("2:4", "0011100");
    wants("0:7:3", "1001001000");
    wants("5:5:9", "0000010");
    wants("1,3:5,7:11:2", "0101110101010");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        snprintf(line, sizeof line, "render game --frames %s", bad[i]);
        assert_false(parse(line));
        assert_non_null(strstr(err, "--frames: expected frames from 0 to 8388608, as in 600"));
    }
    assert_false(parse("render g --frames 5:4"));
    assert_string_equal(err, "--frames: 5:4 ends before it starts");
}

/* What both players hold, the second's shifted by 16. */
static uint32_t pressed(uint32_t frame)
{
    uint16_t pads[MAX_PLAYERS];

    args_held_pads(&a, frame, pads);
    return pads[0] | (uint32_t)pads[1] << 16;
}

TEST(press)
{
    static const char *const bad[] = { "2.", "3.fire", "2.2.fire", "fyre", "fire@", "@3", "fire,,bomb", "fire@1:2:0" };

    reads("hash game --press fire,focus");
    assert_int_equal(pressed(99999), PAD_FIRE | PAD_FOCUS);
    reads("render game --frames 1 --press up,bomb@20,left@60:62,fire@0:600:8");
    assert_int_equal(pressed(20), PAD_UP | PAD_BOMB);
    assert_int_equal(pressed(62), PAD_UP | PAD_LEFT);
    assert_int_equal(pressed(63), PAD_UP);
    assert_int_equal(pressed(16), PAD_UP | PAD_FIRE);
    assert_int_equal(pressed(608), PAD_UP);
    reads("hash game --press 2.fire,left,2.start@7");
    assert_int_equal(pressed(6), PAD_LEFT | PAD_FIRE << 16);
    assert_int_equal(pressed(7), PAD_LEFT | (PAD_FIRE | PAD_START) << 16);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char line[64];
        snprintf(line, sizeof line, "hash game --press %s", bad[i]);
        assert_false(parse(line));
        assert_non_null(strstr(err, "--press: expected buttons, as in fire"));
    }
}

TEST(refusals)
{
    static const struct {
        const char *line, *sentence;
    } rows[] = {
        { "play --seed 18446744073709551616",
          "--seed: expected a whole number from 0 to 18446744073709551615, got \"18446744073709551616\"" },
        { "play --seed 12a", "--seed: expected a whole number from 0 to 18446744073709551615, got \"12a\"" },
        { "play --scale 0", "--scale: expected a whole number from 1 to 16, got \"0\"" },
        { "palette warm.hex --bank -1", "--bank: expected a whole number from 0 to 15, got \"-1\"" },
        { "capture g --speed 1.5", "--speed: expected a whole number from 1 to 16, or 1/2 to 1/16, got \"1.5\"" },
        { "capture g --speed 1/", "--speed: expected a whole number from 1 to 16, or 1/2 to 1/16, got \"1/\"" },
        { "play --dip lives", "--dip: expected NAME=VALUE, got \"lives\"" },
        { "play --dip =3", "--dip: expected NAME=VALUE, got \"=3\"" },
        { "play --dip lives=", "--dip: expected NAME=VALUE, got \"lives=\"" },
        { "play --record ''", "--record: expected F, got nothing" },
        { "play --record", "--record: expected F, got nothing" },
        { "play --mute=1", "--mute takes no value, got \"1\"" },
        { "render g --dim 2", "--dim: expected none, quarter, half or most, got \"2\"" },
        { "render g --colours", "--colours: expected WORD, got nothing" },
        { "render g --dim half --dim half", "--dim is given twice" },
        { "render g --framse 3", "unknown option --framse (did you mean --frames?)" },
        { "hash g --xyzzy", "unknown option --xyzzy (see curtain help)" },
        { "play -q", "unknown option -q (see curtain help)" },
        { "play g --every 3", "--every does not work with play (only with hash)" },
        { "pack g --frames 3", "--frames does not work with pack (only with render, capture, hash, survive)" },
        { "hash g --demo d --stage one", "--stage cannot be combined with --demo: the demo sets it" },
        { "hash g --demo d --press fire", "--press cannot be combined with --demo: the demo sets it" },
        { "rendr g --frames 1", "unknown command \"rendr\" (did you mean render?)" },
        { "mygame other", "unknown command \"mygame\" (see curtain help)" },
        { "pack", "pack: expected DIR (see curtain help pack)" },
        { "verify g", "verify: expected ROM DEMO... (see curtain help verify)" },
        { "verify g d --restamp --rerecord", "--rerecord cannot be combined with --restamp" },
        { "verify --restamp a b --bisect", "--restamp cannot be combined with --bisect" },
        { "export g --web --linux", "--web cannot be combined with --linux" },
        { "export g --all --keys", "--keys cannot be combined with --all" },
        { "licences g", "licences: unexpected argument \"g\" (see curtain help licences)" },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (parse(rows[i].line))
            fail_msg("%s: accepted", rows[i].line);
        assert_string_equal(err, rows[i].sentence);
    }
}

TEST(near)
{
    static const char *const list[] = { "play", "render", "hash", "verify" };

    assert_string_equal(args_near("rendre", list, 4), "render");
    assert_string_equal(args_near("hahs", list, 4), "hash");
    assert_string_equal(args_near("pay", list, 4), "play");
    assert_null(args_near("boss", list, 4));
    assert_null(args_near("", list, 4));
    assert_null(args_near("a-word-of-more-than-thirty-one-letters", list, 4));
}

static char help[16384];

static void collect(const char *line)
{
    size_t n = strlen(help);

    snprintf(help + n, sizeof help - n, "%s\n", line);
}

/* No line of help is cut short. */
static void is_whole(const char *line)
{
    assert_true(strlen(line) < 600);
}

/* Help comes from the tables: whatever a command takes is in its help, and nothing else. */
TEST(help_text)
{
    args_help(-1, false, is_whole);
    for (int i = 0; i < COMMANDS; i++)
        args_help(i, false, is_whole);
    help[0] = 0;
    args_help(COMMAND_HASH, false, collect);
    assert_non_null(strstr(help, "--every N"));
    assert_non_null(strstr(help, "--parts"));
    assert_null(strstr(help, "--scale"));
    help[0] = 0;
    args_help(-1, false, collect);
    assert_non_null(strstr(help, "curtain verify ROM DEMO..."));
    assert_non_null(strstr(help, "--scale N"));
    assert_non_null(strstr(help, "--from NAME"));
}

RUN_TESTS(NULL, NULL)
