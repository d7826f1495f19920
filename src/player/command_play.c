/*
 * command_play.c - the command `play` (command.h).
 */
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include "../../platform/platform.h"
#include "../common/files.h"
#include "../common/report.h"
#include "game/version.h"
#include "game/game.h"
#include "game/workbench.h"
#include "play/play.h"
#include "game/embedded_rom.h"

/* Returns whether a word names neither a file nor a folder; it is then more likely a misspelt command than a game. */
static bool does_not_exist(const char *word)
{
    return files_size(word) < 0 && files_count_entries(word) < 0;
}

static enum result report_missing(const char *word, bool after_play)
{
    const char *meant = args_near_command(word);
    char err[1024];

    if (after_play)
        return report_line(RESULT_REFUSED, "%s", files_set_missing_error(word, "file or folder", err, sizeof err));
    if (meant)
        return report_line(RESULT_REFUSED, "%s: no such command, file or folder (did you mean %s?)", word, meant);
    return report_line(RESULT_REFUSED, "%s: no such command, file or folder (see curtain help)", word);
}

/* Returns whether a path is a folder with a game. */
static bool is_games_folder(const char *path)
{
    char rom[2048];

    return path && files_count_entries(path) >= 0 && snprintf(rom, sizeof rom, "%s/rom.lua", path) < (int)sizeof rom &&
           plat_file_size(rom) >= 0;
}

struct play_command {
    const struct args *a;
    struct args next; /* for a game that was dropped on the window */
    char dropped[FILES_PATH_SIZE];
    const char *path;
    struct game game;
    struct play *window; /* NULL: there is no window, and `result` is valid */
    enum result result;
    char wrong[1024];
};

static enum play_opened open_game(void *user, struct play_options *o, char *err, size_t err_size)
{
    struct play_command *p = user;

    game_close(&p->game);
    o->cart = NULL;
    enum game_opened opened = game_try(&p->game, p->path, p->a, err, err_size);
    if (opened != GAME_OPENED)
        return opened == GAME_BAD_FILES ? PLAY_BROKEN_FOLDER : PLAY_BAD_ARGUMENTS;
    o->cart = &p->game.cart;
    o->start = p->game.start;
    o->demo = p->game.has_demo ? &p->game.demo : NULL;
    return PLAY_OPENED;
}

/* Opens a window for the game. On failure, sets p->result and returns false. */
static bool open_window(struct play_command *p)
{
    const struct args *a = p->a;
    struct play_options o = { .path = p->path, .seeded = a->seeded, .record = a->record, .scale = a->scale };

    o.fullscreen = a->fullscreen;
    o.mute = a->mute;
    o.load = workbench_loader(a->workbench);
    o.nearest = a->nearest;
    o.verbose = a->verbose;
    o.resume = a->resume;
    o.no_resume = a->no_resume;
    o.version = CURTAIN_VERSION;
    o.sealed = embedded_rom_sealed();
    o.user = p;
    o.open = a->workbench && is_games_folder(p->path) ? open_game : NULL;
    enum play_opened opened = open_game(p, &o, p->wrong, sizeof p->wrong);
    if (opened == PLAY_BAD_ARGUMENTS || (opened == PLAY_BROKEN_FOLDER && !o.open)) {
        p->result = report_error(p->wrong);
        return false;
    }
    o.wrong = p->wrong;
    p->window = play_open(&o);
    if (!p->window)
        p->result = report_line(RESULT_HOST_FAILED, "out of memory");
    return p->window != NULL;
}

/* Plays a game that was dropped on the window, with the options for the window but not those for the run. Returns false
 * if there is none, or it cannot be played. */
static bool play_next(struct play_command *p)
{
    const struct args *was = p->a;
    struct args a = { .command = COMMAND_PLAY, .every = 1, .scale = was->scale, .fullscreen = was->fullscreen };
    const bool has_next = play_dropped_game(p->window, p->dropped, sizeof p->dropped);

    a.workbench = was->workbench;
    a.mute = was->mute;
    a.nearest = was->nearest;
    a.verbose = was->verbose;
    p->result = play_close(p->window);
    p->window = NULL;
    if (!has_next)
        return false;
    game_close(&p->game);
    p->next = a;
    p->a = &p->next;
    p->path = p->dropped;
    return open_window(p);
}

static bool run_frame(void *context)
{
    struct play_command *p = context;

    return p->window && (play_frame(p->window) || play_next(p));
}

static enum result close(void *context)
{
    struct play_command *p = context;
    const enum result result = p->window ? play_close(p->window) : p->result;

    game_close(&p->game);
    free(p);
    return result;
}

enum result command_play(const struct args *a, bool named, struct frame_command *running)
{
    const char *path = a->n_words ? a->words[0] : NULL;

    if (path && does_not_exist(path))
        return report_missing(path, named);
    struct play_command *p = calloc(1, sizeof *p);
    if (!p)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    p->a = a;
    p->path = path;
    open_window(p);
    *running = (struct frame_command){ run_frame, close, p };
    return RESULT_DONE;
}
