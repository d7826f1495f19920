/*
 * output_paths.c - checks the files that a command writes (output_paths.h).
 */
#include "output_paths.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/err.h"
#include "files.h"

enum { HEAD = 512 /* bytes read to recognise a file */ };

/* ---- a game's files ---- */

static bool is_source(const char *path)
{
    static const char *const ends[] = { ".lua", ".mml", ".tmx", ".tsx", ".bdf", ".ase", ".aseprite", ".xml" };
    const char *dot = strrchr(path, '.');

    for (size_t i = 0; dot && i < sizeof ends / sizeof *ends; i++)
        if (strcmp(dot, ends[i]) == 0)
            return true;
    return false;
}

/* Adds each quoted text in rom.lua that is the path of a file, relative to the game's folder. */
static void add_named(struct game_files *g, const char *game, char *rom)
{
    char path[TREE_PATH];

    for (char *at = rom, *end; (at = strpbrk(at, "\"'")) != NULL; at = end + 1) {
        end = strchr(at + 1, *at);
        if (!end)
            return;
        *end = '\0';
        if (at[1] && tree_join(path, game, at + 1) && plat_file_size(path) >= 0)
            tree_add(&g->paths, "", path);
    }
}

/* Adds the sources in a folder. For a game's folder, tree_walk skips tests/. */
static void add_sources(struct game_files *g, const char *folder)
{
    struct tree all = { 0 };
    char path[TREE_PATH], err[FILES_ERR_SIZE];

    if (tree_walk(folder, &all, err, sizeof err))
        for (int i = 0; i < all.n; i++)
            if (is_source(all.name[i]) && tree_join(path, folder, all.name[i]))
                tree_add(&g->paths, "", path);
    tree_close(&all);
}

void game_files_open(struct game_files *g, const char *game)
{
    char rom[TREE_PATH], tests[TREE_PATH], err[FILES_ERR_SIZE];
    uint8_t *text;
    size_t size;

    *g = (struct game_files){ 0 };
    if (!game || !tree_join(rom, game, "rom.lua") || plat_file_size(rom) < 0)
        return;
    add_sources(g, game);
    if (tree_join(tests, game, "tests"))
        add_sources(g, tests);
    if (files_read_text(rom, rom, TREE_SCRIPT, &text, &size, err, sizeof err)) {
        add_named(g, game, (char *)text);
        free(text);
    }
}

bool game_files_have(const struct game_files *g, const char *path)
{
    for (int i = 0; i < g->paths.n; i++)
        if (plat_is_same_file(g->paths.name[i], path))
            return true;
    return false;
}

void game_files_close(struct game_files *g)
{
    tree_close(&g->paths);
}

static bool is_ours(const char *path, output_ours *ours)
{
    uint8_t head[HEAD];
    const long n = plat_load(path, head, sizeof head);

    return n >= 0 && ours(head, (size_t)n);
}

bool output_is_junit(const uint8_t *head, size_t n)
{
    return n >= strlen(JUNIT_HEAD) && memcmp(head, JUNIT_HEAD, strlen(JUNIT_HEAD)) == 0;
}

/* ---- outputs named on the command line ---- */

static bool check_one(const struct game_files *files, const char *game, const char *demo, const struct output_path *out,
                      char *err, size_t err_size)
{
    if (game && plat_is_same_file(game, out->path))
        return err_set(err, err_size, "%s: %s is the game being read; choose another file", out->option, out->path);
    if (demo && plat_is_same_file(demo, out->path))
        return err_set(err, err_size, "%s: %s is the demo being played; choose another file", out->option, out->path);
    if (game_files_have(files, out->path) && !(out->ours && is_ours(out->path, out->ours)))
        return err_set(err, err_size, "%s: %s is one of the game's files; choose another one", out->option, out->path);
    return true;
}

static bool check_two(const struct output_path *a, const struct output_path *b, char *err, size_t err_size)
{
    if (strcmp(a->path, b->path) != 0 && !plat_is_same_file(a->path, b->path))
        return true;
    return err_set(err, err_size, "%s: %s is also written by %s; choose another file", b->option, b->path, a->option);
}

bool output_paths_check(const char *game, const char *demo, const struct output_path *out, int n, char *err,
                        size_t err_size)
{
    struct game_files files;
    bool good = true;

    game_files_open(&files, game);
    for (int i = 0; i < n && good; i++) {
        good = !out[i].path || check_one(&files, game, demo, &out[i], err, err_size);
        for (int j = 0; j < i && good && out[i].path; j++)
            good = !out[j].path || check_two(&out[j], &out[i], err, err_size);
    }
    game_files_close(&files);
    return good;
}

/* ---- derived names ---- */

bool output_path_available(const char *path, output_ours *ours)
{
    return plat_file_size(path) < 0 || is_ours(path, ours);
}

bool output_path_derived(const char *game, const char *path, output_ours *ours, char *err, size_t err_size)
{
    const struct output_path out = { .option = "-o", .path = path };

    if (!output_paths_check(game, NULL, &out, 1, err, err_size))
        return false;
    if (output_path_available(path, ours))
        return true;
    return err_set(err, err_size, "%s: already exists; remove it, or choose another file with -o", path);
}

bool output_path_temporary(const char *path, const char *ending, char *out, size_t size)
{
    int n = snprintf(out, size, "%s%s", path, ending);

    for (int i = 2; n < (int)size && plat_file_size(out) >= 0; i++)
        n = snprintf(out, size, "%s-%d%s", path, i, ending);
    return n < (int)size;
}
