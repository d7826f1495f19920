/*
 * cli.c - see cli.h, and platform.h for the program by calls. What the words mean is in line/; what is done is in each
 * command's room, and in the files here.
 */
#include "cli.h"

#include <stdio.h>
#include <stdlib.h>
#include "../../platform/platform.h"
#include "../base/host.h"
#include "../base/ieee.h"
#include "art/art_run.h"
#include "bulletml/command.h"
#include "capture.h"
#include "check/check.h"
#include "command.h"
#include "headless.h"
#include "host/report.h"
#include "line/args.h"
#include "line/demo_game.h"
#include "listen/listen.h"
#include "measure/bench.h"
#include "share/licences.h"
#include "share/own.h"
#include "share/register.h"
#include "start/start.h"
#include "store/output_paths.h"
#include "survive/survive.h"
#include "testing/testing.h"
#include "testing/told.h"
#include "verify.h"

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

/* Can the outputs be written without overwriting an input? For render, -o is a directory. */
static bool outputs(const struct args *a, char *err, size_t err_size)
{
    const struct output_path out[] = { { "-o", a->out, NULL },
                                       { "--record", a->record, NULL },
                                       { "--sheet", a->sheet, NULL },
                                       { "--wav", a->wav, NULL },
                                       { "--atlas", a->atlas, NULL },
                                       { "--map", a->map, NULL },
                                       { "--junit", a->junit, told_is_junit },
                                       { "--page", a->page, NULL } };

    return output_paths_check(a->n_words ? a->words[0] : NULL, a->demo, out, sizeof out / sizeof *out, err, err_size);
}

struct program {
    struct args args;
    struct demo_game demo_game; /* of args */
    struct frame_command running;
    enum result result; /* of what is not running */
};

static enum result run(struct program *p, int argc, char **argv)
{
    struct args *a = &p->args;
    char err[1536];

    enum result own = own_open(err, sizeof err);
    if (own != RESULT_DONE)
        return report_line(own, "%s", err);
    if (!args_parse(a, argc, argv, err, sizeof err) || !demo_game_find(a, &p->demo_game, err, sizeof err) ||
        !allowed(a, err, sizeof err) || !outputs(a, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    const char *wrong = ieee_find_fault();
    if (wrong && a->command != COMMAND_HELP && a->command != COMMAND_VERSION)
        return report_line(RESULT_HOST_FAILED, "%s", wrong);
    switch (a->command) {
    case COMMAND_RENDER:
        return headless_render(a);
    case COMMAND_CAPTURE:
        return capture_run(a);
    case COMMAND_HASH:
        return headless_hash(a);
    case COMMAND_VERIFY:
        return verify_run(a);
    case COMMAND_TEST:
        return testing_command(a);
    case COMMAND_PACK:
        return command_pack(a);
    case COMMAND_LIST:
        return command_list(a);
    case COMMAND_UNPACK:
        return command_unpack(a);
    case COMMAND_NEW:
        return start_new(a->words[0], a->from);
    case COMMAND_EXPORT:
        return command_export(a);
    case COMMAND_REGISTER:
        return register_command(a->remove);
    case COMMAND_LICENCES:
        return licences_run(a->full);
    case COMMAND_CHECK:
        return check_game(a->words[0], a->nearest);
    case COMMAND_BENCH:
        return bench_command(a);
    case COMMAND_SURVIVE:
        return survive_command(a);
    case COMMAND_SOUND:
        return listen_run(a, &p->running);
    case COMMAND_ART:
        return art_run(a->words[0], a->nearest, a->atlas);
    case COMMAND_PALETTE:
        return art_run_palette(a->words[0], a->bank, a->out);
    case COMMAND_BULLETML:
        return bulletml_command(a->words, a->n_words, a->lua);
    case COMMAND_HELP:
        return command_help(a);
    case COMMAND_VERSION:
        return command_version();
    default:
        return command_play(a, a->words != argv, &p->running);
    }
}

/* The exit codes of docs/reference/command-line.md. */
static int exit_code(enum result result)
{
    static const int codes[] = {
        [RESULT_DONE] = EXIT_DONE,
        [RESULT_DIFFERS] = EXIT_DIFFERS,
        [RESULT_REFUSED] = EXIT_INPUT,
        [RESULT_HOST_FAILED] = EXIT_HOST,
    };

    return codes[result];
}

/* What it prints is the same everywhere, too: so each of the calls is in the board's settings of the thread. */

struct program *program_open(int argc, char **argv)
{
    struct program *p = calloc(1, sizeof *p);
    struct host host;

    if (!p)
        return NULL;
    host_enter(&host);
    (void)result_take_cause(); /* forget a failure of the program that ran before in this process */
    p->result = run(p, argc, argv);
    host_leave(&host);
    return p;
}

bool program_run_frame(struct program *p)
{
    struct host host;

    if (!p->running.run_frame)
        return false;
    host_enter(&host);
    const bool goes_on = p->running.run_frame(p->running.context);
    host_leave(&host);
    return goes_on;
}

enum { BOX = 64 /* columns */ };

/* Boxes of SDL do not break lines. */
static void show_error(void)
{
    char text[2048], *blank = NULL;
    int column = 0;

    snprintf(text, sizeof text, "%s", report_last());
    for (char *p = text; *p; p++) {
        blank = *p == ' ' ? p : blank;
        column += (*p & 0xc0) != 0x80; /* bytes that continue a character of UTF-8 have no column */
        if (column <= BOX || !blank)
            continue;
        *blank = '\n';
        column = (int)(p - blank);
        blank = NULL;
    }
    plat_alert(text);
}

int program_close(struct program *p)
{
    struct host host;

    host_enter(&host);
    const enum result result = p->running.run_frame ? p->running.close(p->running.context) : p->result;
    host_leave(&host);
    if (p->args.dialog && result != RESULT_DONE)
        show_error();
    free(p);
    return exit_code(result);
}

int cli_main(int argc, char **argv)
{
    struct program *p = program_open(argc, argv);

    if (!p) {
        plat_log("curtain: out of memory");
        return EXIT_HOST;
    }
    while (program_run_frame(p))
        ;
    return program_close(p);
}
