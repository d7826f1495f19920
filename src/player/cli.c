/*
 * cli.c - the program as calls (cli.h, platform.h). args/ parses the command line. The player's commands run here; the
 * workbench, if the program contains it, runs the others.
 */
#include "cli.h"

#include <stdio.h>
#include <stdlib.h>
#include "../../platform/platform.h"
#include "../base/err.h"
#include "../base/host.h"
#include "../base/ieee.h"
#include "command.h"
#include "../common/report.h"
#include "args/args.h"
#include "game/demo_game.h"
#include "licences.h"
#include "game/embedded_rom.h"
#include "../common/output_paths.h"
#include "verify.h"
#include "game/workbench.h"

/* Checks that a program with an embedded game supports the command. */
static bool check_allowed(const struct args *a, char *err, size_t err_size)
{
    const bool prints = a->command == COMMAND_HELP || a->command == COMMAND_VERSION || a->command == COMMAND_LICENCES;
    const char *title = embedded_rom_game()->m.title;

    if (!embedded_rom_sealed() || prints || (a->command == COMMAND_PLAY && !a->n_words))
        return true;
    if (a->command == COMMAND_PLAY)
        return err_set(err, err_size, "%s: cannot be opened; this program only plays %s (see --help)", a->words[0],
                       title);
    return err_set(err, err_size, "%s: not available; this program only plays %s (see --help)", args_name(a->command),
                   title);
}

/* Checks that writing the outputs doesn't overwrite an input. For render, -o is a directory. */
static bool check_outputs(const struct args *a, char *err, size_t err_size)
{
    const struct output_path out[] = { { "-o", a->out, NULL },
                                       { "--record", a->record, NULL },
                                       { "--sheet", a->sheet, NULL },
                                       { "--wav", a->wav, NULL },
                                       { "--atlas", a->atlas, NULL },
                                       { "--map", a->map, NULL },
                                       { "--junit", a->junit, output_is_junit } };

    return output_paths_check(a->n_words ? a->words[0] : NULL, a->demo, out, sizeof out / sizeof *out, err, err_size);
}

struct program {
    struct args args;
    struct demo_game demo_game; /* args.words points into it */
    struct frame_command running;
    enum result result; /* of a command that doesn't run frame by frame */
};

static enum result run_player(const struct args *a, bool is_named, struct frame_command *running)
{
    switch (a->command) {
    case COMMAND_PLAY:
        return command_play(a, is_named, running);
    case COMMAND_VERIFY:
        return verify_run(a);
    case COMMAND_LICENCES:
        return licences_run(a->full);
    case COMMAND_HELP:
        return command_help(a);
    case COMMAND_VERSION:
        return command_version();
    default:
        return report_line(RESULT_REFUSED, "%s: not available in curtain-player; use curtain", args_name(a->command));
    }
}

static enum result run(struct program *p, int argc, char **argv, const struct workbench *workbench)
{
    struct args *a = &p->args;
    char err[1536];

    enum result result = embedded_rom_open(err, sizeof err);
    if (result != RESULT_DONE)
        return report_line(result, "%s", err);
    if (!args_parse(a, argc, argv, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    a->workbench = workbench;
    if (!demo_game_find(a, &p->demo_game, err, sizeof err) || !check_allowed(a, err, sizeof err) ||
        !check_outputs(a, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    const char *wrong = ieee_find_fault();
    if (wrong && a->command != COMMAND_HELP && a->command != COMMAND_VERSION)
        return report_line(RESULT_HOST_FAILED, "%s", wrong);
    if (workbench && workbench->run(a, &p->running, &result))
        return result;
    return run_player(a, a->words != argv, &p->running);
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

/* Each call uses the thread settings of boards (host.h), so printed numbers are the same on every system. */

struct program *cli_open(int argc, char **argv, const struct workbench *workbench)
{
    struct program *p = calloc(1, sizeof *p);
    struct host host;

    if (!p)
        return NULL;
    host_enter(&host);
    (void)result_take_cause(); /* forget a failure of the program that ran before in this process */
    p->result = run(p, argc, argv, workbench);
    host_leave(&host);
    return p;
}

bool program_run_frame(struct program *p)
{
    struct host host;

    if (!p->running.run_frame)
        return false;
    host_enter(&host);
    const bool continues = p->running.run_frame(p->running.context);
    host_leave(&host);
    return continues;
}

enum { BOX_COLUMNS = 64 /* columns */ };

/* Shows the last error in a message box. SDL's boxes don't break lines, so this does. */
static void show_error(void)
{
    char text[2048], *blank = NULL;
    int column = 0;

    snprintf(text, sizeof text, "%s", report_last());
    for (char *p = text; *p; p++) {
        blank = *p == ' ' ? p : blank;
        column += (*p & 0xc0) != 0x80; /* bytes that continue a character of UTF-8 have no column */
        if (column <= BOX_COLUMNS || !blank)
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

int cli_run(struct program *p)
{
    if (!p) {
        plat_log("curtain: out of memory");
        return EXIT_HOST;
    }
    while (program_run_frame(p))
        ;
    return program_close(p);
}
