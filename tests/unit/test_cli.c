/*
 * test_cli.c - args.h and cli.h: what a command line means, and how a wrong one is refused; then whole commands on a
 * small game in a temporary folder, with their output and exit codes.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp, dup2 */
#include <unistd.h>
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/base/pads.h"
#include "../../src/player/args/args.h"
#include "../../src/workbench/export/export.h"
#include "../../src/player/cli.h"
#include "../../src/player/game/version.h"
#include "../temp.h"

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

TEST(commands)
{
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
    reads("verify game one two three --verbose");
    assert_int_equal(a.n_words, 4);
    assert_string_equal(a.words[3], "three");
    assert_true(a.verbose);
    reads("render --frames 0");
    assert_int_equal(a.command, COMMAND_RENDER);
    assert_int_equal(a.n_words, 0);
    reads("new game --from first");
    assert_int_equal(a.command, COMMAND_NEW);
    assert_string_equal(a.from, "first");
    reads("export game -o g --keys --desktop");
    assert_true(a.command == COMMAND_EXPORT && a.keys && a.desktop && !a.full && a.export == EXPORT_PROGRAM);
    reads("export game --windows");
    assert_int_equal(a.export, EXPORT_WINDOWS);
    reads("export game --all -o folder");
    assert_true(a.all && a.export == EXPORT_PROGRAM);
    reads("bulletml a.xml b.xml --lua");
    assert_true(a.command == COMMAND_BULLETML && a.lua && a.n_words == 2);
    refuses("play game --lua", "--lua does not work with play (only with bulletml)");
    reads("register");
    assert_true(a.command == COMMAND_REGISTER && !a.remove);
    reads("register --remove");
    assert_true(a.command == COMMAND_REGISTER && a.remove);
    refuses("register game", "register: unexpected argument \"game\" (see curtain help register)");
    refuses("register --mute", "--mute does not work with register (only with play)");
    refuses("play game --remove", "--remove does not work with play (only with register)");
    reads("play game --dialog");
    assert_true(a.dialog && a.n_words == 1);
    refuses("hash game --dialog", "--dialog does not work with hash (only with play)");
    reads("licences --full");
    assert_true(a.command == COMMAND_LICENCES && a.full && !a.keys);
    reads("hash -- --odd");
    assert_string_equal(a.words[0], "--odd");
    static const char *const names[COMMANDS] = { "play",     "render", "capture", "hash",    "verify", "test",
                                                 "pack",     "list",   "unpack",  "new",     "export", "register",
                                                 "check",    "bench",  "survive", "sound",   "art",    "palette",
                                                 "bulletml", "help",   "version", "licences" };
    for (int i = 0; i < COMMANDS; i++)
        assert_int_equal(args_command(names[i]), i);
    assert_int_equal(args_command("Play"), -1);
}

TEST(values)
{
    reads("art game --atlas a.png --nearest");
    assert_string_equal(a.atlas, "a.png");
    assert_int_equal(a.bank, -1);
    reads("palette warm.hex --bank 15 -o p.png");
    assert_int_equal(a.bank, 15);
    refuses("palette warm.hex --bank -1", "--bank: expected a whole number from 0 to 15, got \"-1\"");
    refuses("palette", "palette: expected FILE (see curtain help palette)");
    reads("play game --record r --scale 3 --fullscreen --mute --stage one:mark --difficulty=hard --lang de");
    assert_string_equal(a.record, "r");
    assert_int_equal(a.scale, 3);
    assert_true(a.fullscreen && a.mute && !a.seeded);
    assert_string_equal(a.stage, "one:mark");
    assert_string_equal(a.difficulty, "hard");
    assert_string_equal(a.lang, "de");
    reads("test game one --update --tap --junit j.xml --jobs 3");
    assert_true(a.update && a.tap && a.jobs == 3);
    assert_string_equal(a.junit, "j.xml");
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
    reads("hash game --trace input --trace=bullets,player --frames 5:9 --traceback");
    assert_int_equal(a.n_traces, 2);
    assert_string_equal(a.traces[1], "bullets,player");
    assert_true(a.verbose);
    reads("bench game --slower 12 --json --stage one");
    assert_true(a.machine == 12 && a.json && a.command == COMMAND_BENCH);
    reads("bench game");
    assert_int_equal(a.machine, 1);
    reads("verify game - -0 --restamp");
    assert_true(a.null && a.restamp && !a.bisect && a.n_words == 2);
    assert_string_equal(a.words[1], "-");
    reads("verify game a --rerecord -v");
    assert_true(a.rerecord && a.verbose && !a.restamp && !a.bisect && a.n_words == 2);
    reads("verify --bisect - b");
    assert_true(a.bisect && !a.restamp);
    assert_string_equal(a.words[0], "-");
    reads("render game --frames 1 -o out --sheet s.png --nearest -v");
    assert_string_equal(a.out, "out");
    assert_string_equal(a.sheet, "s.png");
    assert_true(a.nearest && a.verbose);
    assert_true(a.dim == 0 && a.flashes == 0 && a.colours == 0);
    reads("render game --frames 1 --dim most --flashes soft --colours=deutan");
    assert_true(a.dim == 3 && a.flashes == 1 && a.colours == 2);
    reads("capture game --frames 60-600 --scale 2 --speed 1/4 --format gif -o -");
    assert_true(a.command == COMMAND_CAPTURE && a.scale == 2 && a.faster == 1 && a.slower == 4);
    assert_true(a.n_spans == 1 && a.spans[0].first == 60 && a.spans[0].last == 600 && a.spans[0].step == 1);
    assert_string_equal(a.format, "gif");
    assert_string_equal(a.out, "-");
    reads("capture game --speed 16 -o a.gif");
    assert_true(a.faster == 16 && a.slower == 1);
    reads("render game --frames 1 --dim none --flashes full --colours normal");
    assert_true(a.dim == 0 && a.flashes == 0 && a.colours == 0);
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
    wants("0", "100");
    wants("3", "000100");
    wants("1,4,2", "0110100");
    wants("2:4", "0011100");
    wants("0:6:3", "100100100");
    wants("0:7:3", "1001001000");
    wants("5:5:9", "0000010");
    wants("1,3:5,7:11:2", "0101110101010");
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
    reads("hash game --press fire,focus");
    assert_int_equal(pressed(0), PAD_FIRE | PAD_FOCUS);
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
    static const char *const wrong[] = { "2.",     "3.fire", "2.2.fire",   "fyre",       "fire@",
                                         "fire@x", "@3",     "fire,,bomb", "fire@1:2:0", "fire@1:2:3:4" };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char line[64];
        snprintf(line, sizeof line, "hash game --press %s", wrong[i]);
        assert_false(parse(line));
        assert_non_null(strstr(err, "--press: expected buttons, as in fire"));
    }
    refuses("hash game --demo d --press fire", "--press cannot be combined with --demo: the demo sets it");
    refuses("play game --press fire", "--press does not work with play (only with render, capture, hash)");
}

TEST(bad_values)
{
    static const char *const frames[] = {
        "x",  "1:", ":1", "1:2:", "1:2:3:4", "1,,2", ",", "1,", "-1", "1:5:0", "1.5", "8388609", "99999999999999999999",
        "''", "0x"
    };
    char line[128];

    for (size_t i = 0; i < sizeof frames / sizeof frames[0]; i++) {
        snprintf(line, sizeof line, "render game --frames %s", frames[i]);
        assert_false(parse(line));
        assert_non_null(strstr(err, "--frames: expected frames from 0 to 8388608, as in 600"));
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
    refuses("capture g --speed 1.5", "--speed: expected a whole number from 1 to 16, or 1/2 to 1/16, got \"1.5\"");
    refuses("capture g --speed 1/", "--speed: expected a whole number from 1 to 16, or 1/2 to 1/16, got \"1/\"");
    refuses("capture g --speed 17", "--speed: expected a whole number from 1 to 16, or 1/2 to 1/16, got \"17\"");
    refuses("bench g --slower 1001", "--slower: expected a whole number from 1 to 1000, got \"1001\"");
    refuses("hash g --slower 2", "--slower does not work with hash (only with bench)");
    refuses("bench", "bench: expected ROM (see curtain help bench)");
    refuses("render g --speed 2", "--speed does not work with render (only with capture)");
    refuses("play --dip lives", "--dip: expected NAME=VALUE, got \"lives\"");
    refuses("play --dip =3", "--dip: expected NAME=VALUE, got \"=3\"");
    refuses("play --dip lives=", "--dip: expected NAME=VALUE, got \"lives=\"");
    refuses("play --record ''", "--record: expected F, got nothing");
    refuses("play --record", "--record: expected F, got nothing");
    refuses("play --mute=1", "--mute takes no value, got \"1\"");
    refuses("render g --dim 2", "--dim: expected none, quarter, half or most, got \"2\"");
    refuses("render g --flashes=", "--flashes: expected full or soft, got \"\"");
    refuses("render g --colours", "--colours: expected WORD, got nothing");
    refuses("render g --colours red", "--colours: expected normal, protan, deutan or tritan, got \"red\"");
    refuses("render g --dim half --dim half", "--dim is given twice");
    refuses("play --seed 1 --seed 2", "--seed is given twice");
}

TEST(misfits)
{
    refuses("render g --framse 3", "unknown option --framse (did you mean --frames?)");
    refuses("render g --frame=3", "unknown option --frame (did you mean --frames?)");
    refuses("hash g --xyzzy", "unknown option --xyzzy (see curtain help)");
    refuses("play -q", "unknown option -q (see curtain help)");
    refuses("play g --every 3", "--every does not work with play (only with hash)");
    refuses("play g --dim half", "--dim does not work with play (only with render, capture)");
    refuses("pack g --frames 3", "--frames does not work with pack (only with render, capture, hash, survive)");
    refuses("hash g --demo d --stage one", "--stage cannot be combined with --demo: the demo sets it");
    refuses("hash g --seed 1 --demo d", "--seed cannot be combined with --demo: the demo sets it");
    refuses("rendr g --frames 1", "unknown command \"rendr\" (did you mean render?)");
    refuses("rendr --frames 1", "unknown command \"rendr\" (did you mean render?)");
    refuses("mygame other", "unknown command \"mygame\" (see curtain help)");
    refuses("pack", "pack: expected DIR (see curtain help pack)");
    refuses("verify g d --restamp --rerecord", "--rerecord cannot be combined with --restamp");
    refuses("verify --rerecord --bisect a b", "--rerecord cannot be combined with --bisect");
    refuses("verify --restamp a b --bisect", "--restamp cannot be combined with --bisect");
    refuses("play g --rerecord", "--rerecord does not work with play (only with verify)");
    refuses("verify g", "verify: expected ROM DEMO... (see curtain help verify)");
    refuses("export", "export: expected ROM (see curtain help export)");
    refuses("export g --full", "--full does not work with export (only with licences)");
    refuses("export g --web --linux", "--web cannot be combined with --linux");
    refuses("export g --all --keys", "--keys cannot be combined with --all");
    refuses("survive g --all --linux", "--linux does not work with survive (only with export)");
    refuses("pack g --desktop", "--desktop does not work with pack (only with export)");
    refuses("licences --keys", "--keys does not work with licences (only with export)");
    refuses("licences g", "licences: unexpected argument \"g\" (see curtain help licences)");
    refuses("hash g h", "hash: unexpected argument \"h\" (see curtain help hash)");
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

TEST(help_and_version)
{
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
/* No line of help is cut short. */
static void is_whole(const char *line)
{
    assert_true(strlen(line) < 600);
}

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

/* ---- whole commands ---- */

static char dir[256], out[8192], log_text[4096];

/* Takes the place of the port's: errors are kept, not shown. */
void plat_log(const char *line)
{
    size_t n = strlen(log_text);

    snprintf(log_text + n, sizeof log_text - n, "%s\n", line);
}

static void take_output(int from)
{
    char path[300];

    fflush(stdout);
    dup2(from, STDOUT_FILENO);
    close(from);
    snprintf(path, sizeof path, "%s/stdout", dir);
    long n = plat_load(path, out, sizeof out - 1);
    out[n > 0 ? n : 0] = 0;
}

/* Runs a line in which @ stands for the temporary folder; gives the exit code, out and log_text. */
static int run(const char *line)
{
    char full[sizeof text], path[300];
    size_t n = 0;

    for (; *line && n < sizeof full - sizeof dir; line++) {
        if (*line == '@')
            n += (size_t)snprintf(full + n, sizeof full - n, "%s", dir);
        else
            full[n++] = *line;
    }
    full[n] = 0;
    log_text[0] = 0;
    snprintf(path, sizeof path, "%s/stdout", dir);
    fflush(stdout);
    int was = dup(STDOUT_FILENO);
    assert_non_null(freopen(path, "w", stdout));
    int code = cli_run(program_open(cut(full), words));
    take_output(was);
    return code;
}

static void runs(const char *line, int code)
{
    int got = run(line);

    if (got != code)
        fail_msg("%s: exit code %d, not %d: %s", line, got, code, log_text);
    if (code == EXIT_DONE || code == EXIT_DIFFERS)
        assert_string_equal(log_text, "");
    else /* one line, and it says what went wrong */
        assert_ptr_equal(strchr(log_text, '\n'), log_text + strlen(log_text) - 1);
}

static void says(const char *where, const char *what)
{
    if (strstr(where, what) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", where, what);
}

static void write_file(const char *name, const char *content)
{
    char path[300];

    snprintf(path, sizeof path, "%s/%s", dir, name);
    assert_true(plat_save(path, content, strlen(content)));
}

static const char game[] = "task.go(function() while true do wait(1) board.note(board.frame() * %d) end end)\n";

static void write_game(int factor)
{
    char script[256];

    snprintf(script, sizeof script, game, factor);
    write_file("g/main.lua", script);
}

static int setup(void **state)
{
    (void)state;
    if (!temp_folder(dir, sizeof dir, "Cli"))
        return -1;
    write_file("g/rom.lua", "return { id = 'tiny', dip = { coins = { 'free', 'one' }, lives = { min = 1, max = 9 } },\n"
                            "  difficulties = { 'easy', 'hard' }, screen = { w = 64, h = 64 } }\n");
    write_game(1);
    return 0;
}

static void remove_all(void *user, const struct plat_folder_entry *file)
{
    char path[600];

    snprintf(path, sizeof path, "%s/%s", (const char *)user, file->name);
    if (file->is_folder)
        plat_list(path, remove_all, path);
    remove(path);
}

static int teardown(void **state)
{
    (void)state;
    plat_list(dir, remove_all, dir);
    return remove(dir);
}

TEST(exit_codes)
{
    static const char *const bad[] = { "hash",
                                       "hash /nowhere/at-all.rom",
                                       "verify /nowhere/a.rom d",
                                       "/nowhere/game",
                                       "render g",
                                       "help nothing",
                                       "pack /nowhere/dir",
                                       "play --scale x",
                                       "hash @/g --dip coin=one",
                                       "hash @/g --dip coins=two",
                                       "hash @/g --dip lives=10",
                                       "hash @/g --difficulty medium",
                                       "hash @/g --frames 1:2",
                                       "help lua no.such",
                                       "hash @/g --demo @/g/main.lua",
                                       "verify @/g @/none.demo",
                                       "list @/g/main.lua",
                                       "pack @/g/main.lua",
                                       "render @/g --frames 0:8388608 --sheet @/s.png" };

    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        runs(bad[i], EXIT_INPUT);
    runs("hash @/g --dip coin=one", EXIT_INPUT);
    assert_string_equal(log_text, "curtain: --dip: unknown DIP switch \"coin\" (did you mean \"coins\"?)\n");
    runs("hash @/g --dip lives=10", EXIT_INPUT);
    assert_string_equal(log_text, "curtain: --dip: lives: expected a whole number from 1 to 9, got \"10\"\n");
    runs("hash @/g --difficulty medium", EXIT_INPUT);
    assert_string_equal(log_text, "curtain: --difficulty: unknown difficulty \"medium\" (expected easy or hard)\n");
}

TEST(host_failures)
{
    write_file("plain", "x"); /* a file where a folder is asked for */
    runs("render @/g --frames 1 -o @/plain", EXIT_HOST);
    says(log_text, "/plain/000001.png: cannot be written");
    runs("pack @/g -o @/plain/x.rom", EXIT_HOST);
    runs("unpack @/g @/plain", EXIT_HOST);
    runs("hash @/g --record @/plain/x.demo", EXIT_HOST);
    says(log_text, "/plain/x.demo: cannot be written");
}

TEST(hash)
{
    char first[sizeof out];
    unsigned frame;
    int n = 0, at;

    runs("hash @/g --frames 7 --every 3", EXIT_DONE);
    strcpy(first, out);
    for (const char *p = out; sscanf(p, "%u %*16[0-9a-f]\n%n", &frame, &at) == 1; p += at, n++)
        assert_int_equal(frame, 3 * n);
    assert_int_equal(n, 3);
    runs("hash @/g --frames 7 --every 3 --seed 0", EXIT_DONE);
    assert_string_equal(out, first);
    runs("pack @/g -o @/g.rom", EXIT_DONE);
    runs("hash @/g.rom --frames 7 --every 3", EXIT_DONE);
    assert_string_equal(out, first);
    runs("hash @/g --frames 7 --every 3 --seed 1", EXIT_DONE);
    assert_string_not_equal(out, first);
    runs("hash @/g --frames 0 --parts", EXIT_DONE);
    says(out, " script=");
    says(out, " bullets=");
}

/* Record, verify; then the same on a game that acts otherwise from some frame on. */
TEST(verify)
{
    runs("hash @/g --frames 150 --every 150 --record @/a.demo", EXIT_DONE);
    runs("hash @/g --frames 20 --every 20 --seed 9 --dip lives=3 --record @/b.demo", EXIT_DONE);
    runs("verify @/g @/a.demo @/b.demo", EXIT_DONE);
    says(out, "/a.demo: holds, 150 frames\n");
    says(out, "/b.demo: holds, 20 frames\n");
    write_game(2);
    runs("verify @/g @/a.demo @/b.demo", EXIT_DIFFERS);
    says(out, "/a.demo: frame 2: script, board differ (recorded with another game version)\n");
    says(out, "/b.demo: frame 2: script, board differ (recorded with another game version)\n");
    write_game(1);
    runs("verify @/g @/none.demo @/a.demo", EXIT_INPUT); /* the others are looked at all the same */
    says(out, "/a.demo: holds, 150 frames\n");
}

TEST(cut_demo)
{
    char path[300], bytes[8192];

    runs("hash @/g --frames 150 --every 150 --record @/a.demo", EXIT_DONE);
    snprintf(path, sizeof path, "%s/a.demo", dir);
    long n = plat_load(path, bytes, sizeof bytes);
    snprintf(path, sizeof path, "%s/cut.demo", dir);
    assert_true(plat_save(path, bytes, (size_t)n - 20 - 2 * 28 - 1)); /* the end mark, the points, and one byte */
    runs("verify @/g @/cut.demo", EXIT_INPUT);
    says(log_text, "/cut.demo: truncated: 120 frames and no end mark\n");
    assert_int_equal(run("hash @/g --demo @/cut.demo --every 120"), EXIT_DONE);
    says(log_text, "playing the first 120 frames");
    says(out, "\n120 ");
}

/* A fault is one line that names file and line; recorded, it has to happen again. */
TEST(fault)
{
    write_file("g/main.lua", "task.go(function()\n wait(70) error('boom') end)\n");
    runs("hash @/g --every 1000 --record @/f.demo", EXIT_INPUT);
    assert_string_equal(log_text, "main.lua:2: boom\n");
    runs("verify @/g @/f.demo", EXIT_DONE);
    says(out, ", ends in the recorded fault\n");
    assert_int_equal(run("hash @/g --every 1000 --traceback"), EXIT_INPUT);
    says(log_text, "main.lua:2: boom\nstack traceback:\n");
    write_file("g/main.lua", "task.go(function()\n wait(1000) error('boom') end)\n");
    runs("verify @/g @/f.demo", EXIT_DIFFERS);
    write_game(1);
}

TEST(render)
{
    char path[300];

    runs("render @/g --frames 0,3:9:3 -o @/deep/er --sheet @/sheet.png", EXIT_DONE);
    for (int f = 0; f <= 10; f++) {
        snprintf(path, sizeof path, "%s/deep/er/%06d.png", dir, f);
        assert_int_equal(plat_file_size(path) > 0, f % 3 == 0 && f < 10);
    }
    snprintf(path, sizeof path, "%s/sheet.png", dir);
    assert_true(plat_file_size(path) > 0);
}

TEST(rom_commands)
{
    runs("pack @/g -o @/g.rom", EXIT_DONE);
    runs("list @/g.rom", EXIT_DONE);
    says(out, "script/main.lua ");
    says(out, "\nrom ");
    runs("unpack @/g.rom @/un", EXIT_DONE);
    runs("unpack @/g.rom @/un", EXIT_INPUT);
    says(log_text, "already exists");
    runs("--version", EXIT_DONE);
    says(out, "curtain " CURTAIN_VERSION " (core ");
    says(out, ", Lua 5.4.");
    says(out, "-endian\n");
    runs("help play", EXIT_DONE);
    says(out, "p1.fire");
    runs("help lua bullet.fire", EXIT_DONE);
    says(out, "bullet.fire");
}

RUN_TESTS(setup, teardown)
