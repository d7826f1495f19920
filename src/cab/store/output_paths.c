/*
 * apart.c - see apart.h. A game is made up of what rom.lua names, of scripts, and of files that no command writes.
 */
#include "apart.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../host/files.h"
#include "../pack/tree.h"

/* ---- a game's files ---- */

static bool is_source(const char *path)
{
    static const char *const ends[] = { ".lua", ".mml", ".tmx", ".bdf", ".ase", ".aseprite", ".xml" };
    const char *dot = strrchr(path, '.');

    for (size_t i = 0; dot && i < sizeof ends / sizeof *ends; i++)
        if (strcmp(dot, ends[i]) == 0)
            return plat_size(path) >= 0;
    return false;
}

/* Does one of the texts between quotes lead to the file, from the game's folder on? */
static bool is_named(const char *game, char *rom, const char *path)
{
    char file[TREE_PATH];

    for (char *at = rom, *end; (at = strpbrk(at, "\"'")) != NULL; at = end + 1) {
        end = strchr(at + 1, *at);
        if (!end)
            return false;
        *end = '\0';
        if (at[1] && tree_join(file, game, at + 1) && plat_same(file, path))
            return true;
    }
    return false;
}

static bool is_of_game(const char *game, const char *path)
{
    char rom[TREE_PATH], err[FILES_ERR];
    uint8_t *text;
    size_t size;

    if (is_source(path))
        return true;
    if (!tree_join(rom, game, "rom.lua") || plat_size(path) < 0 ||
        !files_read(rom, rom, TREE_SCRIPT, &text, &size, err, sizeof err))
        return false;
    const bool named = is_named(game, (char *)text, path);
    free(text);
    return named;
}

/* ---- all of them ---- */

static bool check_one(const char *game, const char *demo, const struct apart_out *out, char *err, size_t err_size)
{
    if (game && plat_same(game, out->path))
        return err_set(err, err_size, "%s: %s is the game that is read: name another file", out->option, out->path);
    if (demo && plat_same(demo, out->path))
        return err_set(err, err_size, "%s: %s is the demo that is played: name another file", out->option, out->path);
    if (game && is_of_game(game, out->path))
        return err_set(err, err_size, "%s: %s is a file of the game: name another one", out->option, out->path);
    return true;
}

static bool check_two(const struct apart_out *a, const struct apart_out *b, char *err, size_t err_size)
{
    if (strcmp(a->path, b->path) != 0 && !plat_same(a->path, b->path))
        return true;
    return err_set(err, err_size, "%s: %s is what %s writes: name another file", b->option, b->path, a->option);
}

bool apart_check(const char *game, const char *demo, const struct apart_out *out, int n, char *err, size_t err_size)
{
    for (int i = 0; i < n; i++) {
        if (!out[i].path)
            continue;
        if (!check_one(game, demo, &out[i], err, err_size))
            return false;
        for (int j = 0; j < i; j++)
            if (out[j].path && !check_two(&out[j], &out[i], err, err_size))
                return false;
    }
    return true;
}
