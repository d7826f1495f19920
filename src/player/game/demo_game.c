/*
 * demo_game.c - finds the game of a demo (demo_game.h). Games are compared by the hash of everything that a tick can
 * read (rom_game_hash), which the demo's header contains.
 */
#include "demo_game.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../demo/demo.h"
#include "../../common/report.h"
#include "embedded_rom.h"
#include "../replays/roms.h"
#include "game.h"

enum { ROM_LUA = 1 << 20 /* most bytes of a rom.lua that is searched */ };

enum match { NO_GAME, OTHER_VERSION, SAME_GAME };

struct search {
    const struct demo *demo;
    enum match match;
    char path[FILES_PATH_SIZE]; /* of the match; "": the built-in game */
    char title[64];
    uint64_t hash;
    char folder[FILES_PATH_SIZE]; /* the folder being searched */
    struct args plain;
    struct game game;
};

/* Compares a game with the demo's; path NULL: the built-in game. */
static void try_game(struct search *s, const char *path)
{
    char err[1024];

    if (s->match == SAME_GAME || !game_open(&s->game, path, &s->plain, err, sizeof err))
        return;
    const uint64_t hash = rom_game_hash(&s->game.rom);
    const bool same = hash == s->demo->game_hash;
    if (same || (s->match == NO_GAME && strcmp(s->game.cart.manifest.id, s->demo->id) == 0)) {
        s->match = same ? SAME_GAME : OTHER_VERSION;
        s->hash = hash;
        snprintf(s->path, sizeof s->path, "%s", path ? path : "");
        snprintf(s->title, sizeof s->title, "%s", s->game.cart.manifest.title);
    }
    game_close(&s->game);
}

/* Packing a folder takes a second, so only folders whose rom.lua names the game's id are packed. */
static bool may_be_game(const struct search *s, const char *path)
{
    static const char magic[] = { 'C', 'U', 'R', 'T', 'A', 'I', 'N' }; /* plain and compressed ROMs */
    char head[sizeof magic], file[FILES_PATH_SIZE + 16], err[FILES_ERR_SIZE];
    uint8_t *text;
    size_t size;

    if (plat_file_size(path) >= 0)
        return plat_load(path, head, sizeof head) == sizeof head && memcmp(head, magic, sizeof head) == 0;
    snprintf(file, sizeof file, "%s/rom.lua", path);
    if (plat_file_size(file) < 0 || !files_read_text(file, file, ROM_LUA, &text, &size, err, sizeof err))
        return false;
    const bool names = strstr((const char *)text, s->demo->id) != NULL;
    free(text);
    return names;
}

static void try_path(struct search *s, const char *path)
{
    if (s->match != SAME_GAME && may_be_game(s, path))
        try_game(s, path);
}

static void try_entry(void *context, const struct plat_folder_entry *file)
{
    struct search *s = context;
    char path[FILES_PATH_SIZE];

    if (snprintf(path, sizeof path, "%s/%s", s->folder, file->name) < (int)sizeof path)
        try_path(s, path);
}

/* Removes the last name of an absolute path, but not a root ("/", "C:/"). */
static void to_parent(char *path)
{
    char *slash = strrchr(path, '/');

    if (slash)
        slash[slash == path || slash[-1] == ':'] = 0;
}

static void search(struct search *s, const char *file)
{
    char rom[ROMS_PATH], path[FILES_PATH_SIZE];

    try_game(s, NULL);
    if (embedded_rom_sealed() || !plat_path(file, s->folder, sizeof s->folder))
        return;
    for (int i = 0; i < 2 && s->match != SAME_GAME; i++) {
        to_parent(s->folder);
        try_path(s, s->folder);
        plat_list(s->folder, try_entry, s);
    }
    roms_path(rom, s->demo->id, s->demo->rom_hash);
    if (plat_path(rom, path, sizeof path))
        try_path(s, path);
    (void)result_take_cause(); /* games that could not be opened are of no interest */
}

static bool refuse(const struct search *s, const char *file, char *err, size_t err_size)
{
    const struct demo *d = s->demo;

    if (s->match == OTHER_VERSION && s->path[0])
        return err_set(err, err_size,
                       "%s: recorded with another version of %s (checksum %016" PRIx64 "; %s has %016" PRIx64
                       "); to play it anyway: curtain play \"%s\" --demo \"%s\"",
                       file, s->title, d->game_hash, s->path, s->hash, s->path, file);
    if (s->match == OTHER_VERSION)
        return err_set(err, err_size,
                       "%s: recorded with another version of %s (checksum %016" PRIx64 "; the built-in game has "
                       "%016" PRIx64 "); to play it anyway, start this program with --demo \"%s\"",
                       file, s->title, d->game_hash, s->hash, file);
    if (embedded_rom_sealed())
        return err_set(err, err_size, "%s: recorded with the game \"%s\"; this program only plays %s", file, d->id,
                       embedded_rom_game()->m.title);
    return err_set(err, err_size,
                   "%s: recorded with the game \"%s\" (checksum %016" PRIx64
                   "), which was not found; put the game next "
                   "to the replay, or name it: curtain play GAME --demo \"%s\"",
                   file, d->id, d->game_hash, file);
}

/* Recognises a demo by its first bytes, or by its name, so that a damaged demo is reported as such. */
static bool is_demo(const char *file)
{
    const char *dot = strrchr(file, '.');
    char head[4];

    return (plat_load(file, head, sizeof head) == sizeof head && memcmp(head, DEMO_MAGIC, sizeof head) == 0) ||
           (dot && strcmp(dot, ".demo") == 0 && plat_file_size(file) >= 0);
}

/* Returns a given option that the demo sets too, or NULL. */
static const char *start_option(const struct args *a)
{
    return a->seeded       ? "--seed"
           : a->n_dips     ? "--dip"
           : a->stage      ? "--stage"
           : a->difficulty ? "--difficulty"
           : a->lang       ? "--lang"
           : a->large_hud  ? "--large-hud"
           : a->resume     ? "--resume"
                           : NULL;
}

static bool find(struct args *a, struct demo_game *found, char *err, size_t err_size)
{
    struct search *s = calloc(1, sizeof *s);
    struct demo demo;

    if (!s)
        return err_set(err, err_size, "out of memory");
    s->demo = &demo;
    s->plain.workbench = a->workbench;
    bool good = demo_load(&demo, a->demo, err, err_size);
    if (good) {
        search(s, a->demo);
        good = s->match == SAME_GAME || refuse(s, a->demo, err, err_size);
        snprintf(found->path, sizeof found->path, "%s", s->path);
        demo_free(&demo);
    }
    free(s);
    return good;
}

bool demo_game_find(struct args *a, struct demo_game *found, char *err, size_t err_size)
{
    if (a->command != COMMAND_PLAY || a->n_words != 1 || a->demo || !is_demo(a->words[0]))
        return true;
    if (start_option(a))
        return err_set(err, err_size, "%s cannot be combined with %s: the demo sets it", start_option(a), a->words[0]);
    a->demo = a->words[0];
    if (!find(a, found, err, err_size))
        return false;
    found->word = found->path;
    a->words = &found->word;
    a->n_words = found->path[0] != 0;
    return true;
}
