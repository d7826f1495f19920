/*
 * command_play.c - see command.h: a game for the cabinet, opened, and opened anew when its files have changed.
 */
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include "../../platform/platform.h"
#include "host/files.h"
#include "host/report.h"
#include "host/version.h"
#include "line/game.h"
#include "play/cab.h"
#include "share/own.h"

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

enum result command_play(const struct args *a, bool named)
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
