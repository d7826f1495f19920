/*
 * cli.c - see cli.h. What the words mean is in args.c; runs without a window are in headless.c and verify.c,
 * with one in cab.c.
 */
#include "cli.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/err.h"
#include "../base/ieee.h"
#include "../board/api_table.h"
#include "../base/host.h"
#include "args.h"
#include "art/art_run.h"
#include "capture.h"
#include "play/cab.h"
#include "check/check.h"
#include "host/config.h"
#include "host/files.h"
#include "editor/annotations.h"
#include "editor/luacheck.h"
#include "game.h"
#include "headless.h"
#include "listen.h"
#include "measure/bench.h"
#include "share/export.h"
#include "share/licences.h"
#include "share/own.h"
#include "host/keys.h"
#include "host/progress.h"
#include "host/report.h"
#include "start/start.h"
#include "store/apart.h"
#include "store/replays_print.h"
#include "testing/testing.h"
#include "survive/survive.h"
#include "verify.h"
#include "host/version.h"

#ifndef CURTAIN_CFLAGS
#define CURTAIN_CFLAGS "unknown"
#endif

#ifdef __clang__
#define COMPILER __VERSION__ /* names itself */
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "unknown"
#endif

/* ---- play ---- */

static void ignore_file(void *user, const struct plat_file *file)
{
    (void)user;
    (void)file;
}

/* A first word that is neither command, file nor folder is more likely a slip than a game. */
static bool is_nothing(const char *word)
{
    return files_size(word) < 0 && plat_list(word, ignore_file, NULL) < 0;
}

static enum result no_such_word(const char *word, bool after_play)
{
    const char *meant = args_near_command(word);
    char err[1024];

    if (after_play)
        return report_line(RESULT_REFUSED, "%s", files_absent(word, "file or folder", err, sizeof err));
    if (meant)
        return report_line(RESULT_REFUSED, "%s: no such command, file or folder (did you mean %s?)", word, meant);
    return report_line(RESULT_REFUSED, "%s: no such command, file or folder (curtain help lists the commands)", word);
}

/* Is it a folder that has, or is to have, a game in it? */
static bool is_games_folder(const char *path)
{
    char rom[2048];

    return path && plat_list(path, ignore_file, NULL) >= 0 &&
           snprintf(rom, sizeof rom, "%s/rom.lua", path) < (int)sizeof rom && plat_size(rom) >= 0;
}

struct play {
    const struct args *a;
    const char *path;
    struct game game;
};

static enum cab_opened open_game(void *user, struct cab_options *o, char *err, size_t err_size)
{
    struct play *p = user;

    game_close(&p->game);
    o->cart = NULL;
    enum game_opened opened = game_try(&p->game, p->path, p->a, err, err_size);
    if (opened != GAME_OPENED)
        return opened == GAME_WRONG ? CAB_WRONG : CAB_REFUSED;
    o->cart = &p->game.cart;
    o->start = p->game.start;
    o->demo = p->game.has_demo ? &p->game.demo : NULL;
    return CAB_OPENED;
}

static enum result play_it(struct play *p)
{
    const struct args *a = p->a;
    char err[1024];
    struct cab_options o = { .path = p->path, .seeded = a->seeded, .record = a->record, .scale = a->scale };

    o.fullscreen = a->fullscreen;
    o.mute = a->mute;
    o.nearest = a->nearest;
    o.verbose = a->verbose;
    o.resume = a->resume;
    o.no_resume = a->no_resume;
    o.version = CURTAIN_VERSION;
    o.sealed = own_sealed();
    o.user = p;
    o.open = is_games_folder(p->path) ? open_game : NULL;
    enum cab_opened opened = open_game(p, &o, err, sizeof err);
    if (opened == CAB_REFUSED || (opened == CAB_WRONG && !o.open))
        return report_error(err);
    o.wrong = err;
    return cab_play(&o);
}

/* A game that was dropped on the window: with what was said of the window, and nothing of the run. */
static enum result play_next(struct play *p, const char *path)
{
    const struct args *was = p->a;
    struct args a = { .command = COMMAND_PLAY, .every = 1, .scale = was->scale, .fullscreen = was->fullscreen };

    a.mute = was->mute;
    a.nearest = was->nearest;
    a.verbose = was->verbose;
    game_close(&p->game);
    p->a = &a;
    p->path = path;
    enum result result = play_it(p);
    p->a = was;
    return result;
}

/* named: the command was. */
static enum result play(const struct args *a, bool named)
{
    const char *path = a->n_words ? a->words[0] : NULL;
    char next[FILES_PATH];

    if (path && is_nothing(path))
        return no_such_word(path, named);
    struct play *p = calloc(1, sizeof *p);
    if (!p)
        return report_line(RESULT_HOST, "out of memory");
    p->a = a;
    p->path = path;
    enum result result = play_it(p);
    while (cab_next(next, sizeof next))
        result = play_next(p, next);
    game_close(&p->game);
    free(p);
    return result;
}

/* ---- ROMs ---- */

/* What is allowed when packing and hardly meant. */
static void warn(void *context, const char *sentence)
{
    (void)context;
    report_line(RESULT_DONE, "%s", sentence);
}

static enum result pack(const struct args *a)
{
    struct rom_image image;
    struct cart cart;
    char err[1024], name[64];
    const char *dir = a->words[0], *out = a->out;

    if (plat_size(dir) >= 0)
        return report_line(RESULT_REFUSED, "%s: is a file; pack takes a game's folder", dir);
    progress_begin();
    const bool loaded = rom_image_load_told(dir, a->nearest, warn, NULL, &image, err, sizeof err);
    progress_end();
    if (!loaded)
        return report_error(err);
    enum result result = RESULT_DONE;
    if (!cart_open(&cart, &image.rom, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s: %s", dir, err);
    if (result == RESULT_DONE && !out) {
        snprintf(name, sizeof name, "%s.rom", cart.m.id);
        out = name;
    }
    if (result == RESULT_DONE && !files_save(out, image.bytes, image.size, err, sizeof err))
        result = report_line(RESULT_HOST, "%s", err);
    rom_image_free(&image);
    return result;
}

static void print_line(void *user, const char *line)
{
    (void)user;
    puts(line);
}

static enum result list_replays(const struct args *a, struct rom_image *image)
{
    struct cart cart;
    char err[512];
    enum result result = RESULT_DONE;

    if (!cart_open(&cart, &image->rom, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s: %s", a->words[0], err);
    else if (!replays_print(cart.m.id, a->json))
        result = report_line(RESULT_HOST, "out of memory");
    rom_image_free(image);
    return report_stdout(result);
}

static enum result list(const struct args *a)
{
    struct rom_image image;
    char err[1024];

    if (!rom_image_load(a->words[0], a->nearest, &image, err, sizeof err))
        return report_error(err);
    if (a->replays)
        return list_replays(a, &image);
    pack_list(&image.rom, print_line, NULL);
    printf("game %016llx\nrom %016llx\n", (unsigned long long)rom_game_hash(&image.rom),
           (unsigned long long)rom_hash(&image.rom));
    rom_image_free(&image);
    return report_stdout(RESULT_DONE);
}

static enum result unpack(const struct args *a)
{
    struct rom_image image;
    char err[1024];
    enum result result = RESULT_DONE;

    if (!rom_image_load(a->words[0], a->nearest, &image, err, sizeof err))
        return report_error(err);
    if (!pack_unpack(&image.rom, a->words[1], err, sizeof err))
        result = report_error(err);
    rom_image_free(&image);
    return result;
}

/* ---- bench ---- */

static enum result bench(const struct args *a)
{
    struct game *g = calloc(1, sizeof *g);
    char err[1024];

    if (!g)
        return report_line(RESULT_HOST, "out of memory");
    enum result result = RESULT_DONE;
    if (!game_open(g, a->words[0], a, err, sizeof err)) {
        result = report_error(err);
    } else {
        const struct bench b = { .path = a->words[0],
                                 .cart = &g->cart,
                                 .start = g->start,
                                 .demo = g->has_demo ? &g->demo : NULL,
                                 .demo_name = a->demo,
                                 .own_start = a->seeded || a->n_dips || a->difficulty || a->lang,
                                 .slower = a->machine,
                                 .json = a->json };
        result = bench_run(&b);
        game_close(g);
    }
    free(g);
    return result;
}

/* ---- survive ---- */

static enum result survive(const struct args *a)
{
    const bool one_frame = a->n_spans == 1 && a->spans[0].first == a->spans[0].last && a->spans[0].last > 0;
    struct game *g = calloc(1, sizeof *g);
    char err[1024];

    if (!g)
        return report_line(RESULT_HOST, "out of memory");
    if ((a->n_spans && !one_frame) || !game_open(g, a->n_words ? a->words[0] : NULL, a, err, sizeof err)) {
        free(g);
        if (a->n_spans && !one_frame)
            return report_line(RESULT_REFUSED, "--frames: survive takes one number, how far to look");
        return report_error(err);
    }
    const struct survive_options o = { .path = g->path ? g->path : "the built-in game",
                                       .rom = &g->rom,
                                       .cart = &g->cart,
                                       .start = g->start,
                                       .all = a->all,
                                       .difficulty = a->difficulty,
                                       .stage = a->stage,
                                       .out = a->out,
                                       .map = a->map,
                                       .frames = a->n_spans ? a->spans[0].last : SURVIVE_FRAMES,
                                       .effort = a->effort ? a->effort : SURVIVE_EFFORT,
                                       .json = a->json,
                                       .verbose = a->verbose };
    const enum result result = survive_run(&o);
    game_close(g);
    free(g);
    return result;
}

/* ---- tests ---- */

struct tested {
    const struct args *a;
    struct game game;
    struct args held[TRIAL_RUNS]; /* the buttons of each run: the presses alone */
};

/* A sentence of the command line, in a script: what it says of --stage is of stage. */
static bool without_dashes(char *err)
{
    if (strncmp(err, "--", 2) == 0)
        memmove(err, err + 2, strlen(err + 2) + 1);
    return false;
}

static bool test_start(void *user, const struct trial_start *want, struct board_start *start, char *err,
                       size_t err_size)
{
    struct tested *t = user;
    struct args a = { .seed = want->seed,
                      .stage = want->stage,
                      .difficulty = want->difficulty,
                      .lang = want->lang,
                      .lives = want->lives,
                      .invincible = want->invincible,
                      .n_dips = want->n_dips,
                      .n_registers = want->n_registers };

    memcpy(a.dips, want->dips, sizeof want->dips);
    memcpy(a.registers, want->registers, sizeof want->registers);
    if (!game_start(&t->game, &a, err, err_size))
        return without_dashes(err);
    *start = t->game.start;
    return true;
}

static bool test_press(void *user, int run, const char *list, char *err, size_t err_size)
{
    struct args *a = &((struct tested *)user)->held[run];

    char why[512];

    a->n_presses = 0;
    if (!list[0] || args_presses(a, list, why, sizeof why))
        return true;
    return err_set(err, err_size, "pads%s", strchr(why, ':')); /* "--press: ..." */
}

static void test_pressed(void *user, int run, uint32_t frame, uint16_t pads[PADS])
{
    args_pressed(&((struct tested *)user)->held[run], frame, pads);
}

static enum result test_game(struct tested *t)
{
    const struct args *a = t->a;
    const struct testing testing = { .dir = a->words[0],
                                     .cart = &t->game.cart,
                                     .names = a->words + 1,
                                     .n_names = a->n_words - 1,
                                     .update = a->update,
                                     .tap = a->tap,
                                     .junit = a->junit,
                                     .page = a->page,
                                     .jobs = a->jobs,
                                     .user = t,
                                     .start = test_start,
                                     .press = test_press,
                                     .pressed = test_pressed };
    char err[1024];

    if (plat_size(a->words[0]) >= 0)
        return report_line(RESULT_REFUSED, "%s: is a file; test takes a game's folder", a->words[0]);
    if (!game_open(&t->game, a->words[0], a, err, sizeof err))
        return report_error(err);
    const enum result result = testing_run(&testing);
    game_close(&t->game);
    return result;
}

static enum result test(const struct args *a)
{
    struct tested *t = calloc(1, sizeof *t);

    if (!t)
        return report_line(RESULT_HOST, "out of memory");
    t->a = a;
    const enum result result = test_game(t);
    free(t);
    return result;
}

/* ---- help ---- */

static void say(const char *line)
{
    puts(line);
}

static void print_prose(void (*write)(struct prose *))
{
    struct prose text = { 0 };

    write(&text);
    fwrite(text.bytes, 1, text.n, stdout);
    free(text.bytes);
}

static enum result help_lua(const char *name)
{
    if (api_help(name, say))
        return report_stdout(RESULT_DONE);
    if (api_help_near(name))
        return report_line(RESULT_REFUSED, "help lua: there is no \"%s\" (did you mean %s?)", name,
                           api_help_near(name));
    return report_line(RESULT_REFUSED, "help lua: there is no \"%s\" (curtain help lua lists all names)", name);
}

/* Of the help of play the options. */
static void say_option(const char *line)
{
    if (strncmp(line, "  -", 3) == 0)
        say(line);
}

static void help_own(void)
{
    own_help(say);
    args_help(COMMAND_PLAY, say_option);
}

static enum result help(const struct args *a)
{
    const char *topic = a->n_words ? a->words[0] : NULL;
    int command = topic ? args_command(topic) : -1;

    if (a->annotations || a->luacheck) {
        if (strcmp(topic, "test") == 0)
            print_prose(annotations_test_write);
        else
            a->annotations ? print_prose(annotations_write) : luacheck_print();
        return report_stdout(RESULT_DONE);
    }
    if (topic && strcmp(topic, "lua") == 0)
        return help_lua(a->n_words > 1 ? a->words[1] : NULL);
    if (topic && strcmp(topic, "config") == 0 && a->n_words == 1) {
        config_guide(say);
        return report_stdout(RESULT_DONE);
    }
    if (topic && command < 0 && strcmp(topic, "config") != 0) {
        const char *meant = args_near_command(topic);
        if (meant)
            return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (did you mean %s?)", topic, meant);
        return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (curtain help lists them)", topic);
    }
    if (a->n_words > 1)
        return report_line(RESULT_REFUSED, "help: \"%s\" is one argument too many", a->words[1]);
    if (own_sealed())
        help_own();
    else
        args_help(command, say);
    if (command == COMMAND_TEST) {
        say("");
        testing_help(say);
    }
    if (command == COMMAND_PLAY || own_sealed()) {
        say("");
        say("Keys, and the names to change them by:");
        keys_help(own_sealed() ? KEYS_INSIDE : 0, say);
        say("");
        say("Controllers: the first that is used plays for player 1, START on another one takes the place of player "
            "2.");
        say("pad. is the player's own, pad1. to pad4. a certain one; south is the lowest of four buttons, east the "
            "right");
        say("one, whatever is printed there.");
        say("");
        say("Settings:");
        config_help(say);
    }
    return report_stdout(RESULT_DONE);
}

static const char *byte_order(void)
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one ? "little" : "big";
}

static enum result version(void)
{
    if (own_game()->rom)
        printf("%s %d (%s)\n", own_game()->m.title, (int)own_game()->m.version, own_game()->m.id);
    printf("curtain %s (core %d, Lua %s)\n", CURTAIN_VERSION, CORE_VERSION, board_lua_release());
    printf("compiler %s\n", COMPILER);
    printf("flags %s\n", CURTAIN_CFLAGS);
    printf("machine %d-bit %s-endian\n", (int)sizeof(void *) * 8, byte_order());
    return report_stdout(RESULT_DONE);
}

/* Is it what an exported game does? */
static bool allowed(const struct args *a, char *err, size_t err_size)
{
    const bool tells = a->command == COMMAND_HELP || a->command == COMMAND_VERSION || a->command == COMMAND_LICENCES;

    if (!own_sealed() || tells || (a->command == COMMAND_PLAY && !a->n_words))
        return true;
    if (a->command == COMMAND_PLAY)
        own_refuses_game(a->words[0], err, err_size);
    else
        own_refuses_command(args_name(a->command), err, err_size);
    return false;
}

/* Does what is to be written leave what is read as it is? -o of unpack and render is a folder. */
static bool apart(const struct args *a, char *err, size_t err_size)
{
    const struct apart_out out[] = { { "-o", a->out },        { "--record", a->record }, { "--sheet", a->sheet },
                                     { "--wav", a->wav },     { "--atlas", a->atlas },   { "--map", a->map },
                                     { "--junit", a->junit }, { "--page", a->page } };
    const bool games = a->n_words && a->command != COMMAND_PALETTE && a->command != COMMAND_HELP;

    return apart_check(games ? a->words[0] : NULL, a->demo, out, sizeof out / sizeof *out, err, err_size);
}

static enum result export(const struct args *a) {
    const struct export_want want = { .rom = a->words[0],
                                      .out = a->out,
                                      .nearest = a->nearest,
                                      .keys = a->keys,
                                      .desktop = a->desktop,
                                      .builtin = builtin_rom,
                                      .builtin_size = builtin_rom_size };

    return export_run(&want);
}

static enum result run(int argc, char **argv)
{
    struct args a;
    char err[1536];

    enum result own = own_open(err, sizeof err);
    if (own != RESULT_DONE)
        return report_line(own, "%s", err);
    if (!args_parse(&a, argc, argv, err, sizeof err) || !allowed(&a, err, sizeof err) || !apart(&a, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    const char *wrong = ieee_fault();
    if (wrong && a.command != COMMAND_HELP && a.command != COMMAND_VERSION)
        return report_line(RESULT_HOST, "%s", wrong);
    switch (a.command) {
    case COMMAND_RENDER:
        return headless_render(&a);
    case COMMAND_CAPTURE:
        return capture_run(&a);
    case COMMAND_HASH:
        return headless_hash(&a);
    case COMMAND_VERIFY:
        return verify_run(&a);
    case COMMAND_TEST:
        return test(&a);
    case COMMAND_PACK:
        return pack(&a);
    case COMMAND_LIST:
        return list(&a);
    case COMMAND_UNPACK:
        return unpack(&a);
    case COMMAND_NEW:
        return start_new(a.words[0], a.from);
    case COMMAND_EXPORT:
        return export(&a);
    case COMMAND_LICENCES:
        return licences_run(a.full);
    case COMMAND_CHECK:
        return check_game(a.words[0], a.nearest);
    case COMMAND_BENCH:
        return bench(&a);
    case COMMAND_SURVIVE:
        return survive(&a);
    case COMMAND_SOUND:
        return listen_run(&a);
    case COMMAND_ART:
        return art_run(a.words[0], a.nearest, a.atlas);
    case COMMAND_PALETTE:
        return art_run_palette(a.words[0], a.bank, a.out);
    case COMMAND_HELP:
        return help(&a);
    case COMMAND_VERSION:
        return version();
    default:
        return play(&a, a.words != argv);
    }
}

/* The exit codes that the manual promises. */
static int exit_code(enum result result)
{
    static const int codes[] = {
        [RESULT_DONE] = EXIT_DONE,
        [RESULT_DIFFERS] = EXIT_DIFFERS,
        [RESULT_REFUSED] = EXIT_INPUT,
        [RESULT_HOST] = EXIT_HOST,
    };

    return codes[result];
}

int cli_main(int argc, char **argv)
{
    struct host host;

    host_enter(&host); /* what it prints is the same everywhere, too */
    enum result result = run(argc, argv);
    host_leave(&host);
    return exit_code(result);
}
