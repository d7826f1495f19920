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
#include "../base/ieee.h"
#include "../board/api_table.h"
#include "../base/host.h"
#include "args.h"
#include "play/cab.h"
#include "check/check.h"
#include "host/config.h"
#include "host/files.h"
#include "game.h"
#include "headless.h"
#include "host/keys.h"
#include "verify.h"
#include "version.h"

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

static int stdout_done(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    return game_report(EXIT_HOST, "standard output cannot be written");
}

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

static int no_such_word(const char *word, bool after_play)
{
    const char *meant = args_near_command(word);
    char err[1024];

    if (after_play)
        return game_report(EXIT_INPUT, "%s", files_absent(word, "file or folder", err, sizeof err));
    if (meant)
        return game_report(EXIT_INPUT, "%s: no such command, file or folder (did you mean %s?)", word, meant);
    return game_report(EXIT_INPUT, "%s: no such command, file or folder (curtain help lists the commands)", word);
}

/* named: the command was. */
static int play(const struct args *a, bool named)
{
    char err[1024];
    struct game *g = malloc(sizeof *g);
    const char *path = a->n_words ? a->words[0] : NULL;

    if (!g)
        return game_report(EXIT_HOST, "out of memory");
    if (path && is_nothing(path)) {
        free(g);
        return no_such_word(path, named);
    }
    int code;
    if (!game_open(g, path, a, err, sizeof err)) {
        code = game_refuse(err);
    } else {
        struct cab_options o = { .cart = &g->cart, .path = path, .start = g->start, .seeded = a->seeded };
        o.demo = g->has_demo ? &g->demo : NULL;
        o.record = a->record;
        o.scale = a->scale;
        o.fullscreen = a->fullscreen;
        o.mute = a->mute;
        o.nearest = a->nearest;
        code = cab_play(&o);
        game_close(g);
    }
    free(g);
    return code;
}

/* ---- ROMs ---- */

static int pack(const struct args *a)
{
    struct rom_image image;
    struct cart cart;
    char err[1024], name[64];
    const char *dir = a->words[0], *out = a->out;

    if (plat_size(dir) >= 0)
        return game_report(EXIT_INPUT, "%s: is a file; pack takes a game's folder", dir);
    if (!rom_image_load(dir, a->nearest, &image, err, sizeof err))
        return game_refuse(err);
    int code = EXIT_DONE;
    if (!cart_open(&cart, &image.rom, err, sizeof err))
        code = game_report(EXIT_INPUT, "%s: %s", dir, err);
    if (code == EXIT_DONE && !out) {
        snprintf(name, sizeof name, "%s.rom", cart.m.id);
        out = name;
    }
    if (code == EXIT_DONE && !files_save(out, image.bytes, image.size, err, sizeof err))
        code = game_report(EXIT_HOST, "%s", err);
    rom_image_free(&image);
    return code;
}

static void print_line(void *user, const char *line)
{
    (void)user;
    puts(line);
}

static int list(const struct args *a)
{
    struct rom_image image;
    char err[1024];

    if (!rom_image_load(a->words[0], a->nearest, &image, err, sizeof err))
        return game_refuse(err);
    pack_list(&image.rom, print_line, NULL);
    printf("game %016llx\nrom %016llx\n", (unsigned long long)rom_game_hash(&image.rom),
           (unsigned long long)rom_hash(&image.rom));
    rom_image_free(&image);
    return stdout_done(EXIT_DONE);
}

static int unpack(const struct args *a)
{
    struct rom_image image;
    char err[1024];
    int code = EXIT_DONE;

    if (!rom_image_load(a->words[0], a->nearest, &image, err, sizeof err))
        return game_refuse(err);
    if (!pack_unpack(&image.rom, a->words[1], err, sizeof err))
        code = game_refuse(err);
    rom_image_free(&image);
    return code;
}

/* ---- help ---- */

static void say(const char *line)
{
    puts(line);
}

static int help_lua(const char *name)
{
    if (!api_help(name, say))
        return game_report(EXIT_INPUT, "help lua: there is no \"%s\" (curtain help lua lists all names)", name);
    return stdout_done(EXIT_DONE);
}

static int help(const struct args *a)
{
    const char *topic = a->n_words ? a->words[0] : NULL;
    int command = topic ? args_command(topic) : -1;

    if (topic && strcmp(topic, "lua") == 0)
        return help_lua(a->n_words > 1 ? a->words[1] : NULL);
    if (topic && command < 0) {
        const char *meant = args_near_command(topic);
        if (meant)
            return game_report(EXIT_INPUT, "help: unknown command \"%s\" (did you mean %s?)", topic, meant);
        return game_report(EXIT_INPUT, "help: unknown command \"%s\" (curtain help lists them)", topic);
    }
    if (a->n_words > 1)
        return game_report(EXIT_INPUT, "help: \"%s\" is one argument too many", a->words[1]);
    args_help(command, say);
    if (command == COMMAND_PLAY) {
        say("");
        say("Keys, and the names to change them by:");
        keys_help(say);
        say("");
        say("Settings:");
        config_help(say);
    }
    return stdout_done(EXIT_DONE);
}

static const char *byte_order(void)
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one ? "little" : "big";
}

static int version(void)
{
    printf("curtain %s (core %d, Lua %s)\n", CURTAIN_VERSION, CORE_VERSION, board_lua_release());
    printf("compiler %s\n", COMPILER);
    printf("flags %s\n", CURTAIN_CFLAGS);
    printf("machine %d-bit %s-endian\n", (int)sizeof(void *) * 8, byte_order());
    return stdout_done(EXIT_DONE);
}

static int run(int argc, char **argv)
{
    struct args a;
    char err[512];

    if (!args_parse(&a, argc, argv, err, sizeof err))
        return game_report(EXIT_INPUT, "%s", err);
    const char *wrong = ieee_fault();
    if (wrong && a.command != COMMAND_HELP && a.command != COMMAND_VERSION)
        return game_report(EXIT_HOST, "%s", wrong);
    switch (a.command) {
    case COMMAND_RENDER:
        return headless_render(&a);
    case COMMAND_HASH:
        return headless_hash(&a);
    case COMMAND_VERIFY:
        return verify_run(&a);
    case COMMAND_PACK:
        return pack(&a);
    case COMMAND_LIST:
        return list(&a);
    case COMMAND_UNPACK:
        return unpack(&a);
    case COMMAND_CHECK:
        return check_game(&a);
    case COMMAND_HELP:
        return help(&a);
    case COMMAND_VERSION:
        return version();
    default:
        return play(&a, a.words != argv);
    }
}

int cli_main(int argc, char **argv)
{
    struct host host;

    host_enter(&host); /* what it prints is the same everywhere, too */
    int code = run(argc, argv);
    host_leave(&host);
    return code;
}
