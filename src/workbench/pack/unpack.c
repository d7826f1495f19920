/*
 * unpack.c - see pack.h: lists the lumps of a ROM, and writes them to files.
 */
#include "pack_parts.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../base/hash.h"
#include "../../common/files.h"

void pack_list(const struct rom *rom, void (*each)(void *user, const char *line), void *user)
{
    for (uint32_t i = 0; i < rom->count; i++) {
        char line[ROM_MAX_NAME + 32];
        struct lump l;
        rom_lump(rom, (int)i, &l);
        snprintf(line, sizeof line, "%s %" PRIu32 " %08" PRIx32, l.name, l.size, hash_crc32(l.data, l.size));
        each(user, line);
    }
}

/* ---- files ---- */

/* Writes the path of a lump's file in the folder. */
static void file_name(const char *name, char out[PATH])
{
    if (pack_starts_with(name, "script/@std/"))
        snprintf(out, PATH, "std/%s", name + strlen("script/@std/"));
    else if (pack_starts_with(name, "script/"))
        snprintf(out, PATH, "%s", name + strlen("script/"));
    else if (pack_starts_with(name, "data/"))
        snprintf(out, PATH, "%s", name + strlen("data/"));
    else if (pack_starts_with(name, "demo/"))
        snprintf(out, PATH, "demos/%s.demo", name + strlen("demo/"));
    else
        snprintf(out, PATH, "lumps/%s", name);
}

/* Checks that no folder of the path is a file, in the ROM or on disk. */
static bool check_folders(const struct tree *files, const char *name, const char *dir, char *err, size_t err_size)
{
    char folder[PATH], path[PATH];

    snprintf(folder, sizeof folder, "%s", name);
    for (char *slash = folder; (slash = strchr(slash, '/')) != NULL; *slash++ = '/') {
        *slash = '\0';
        if (tree_has(files, folder))
            return err_set(err, err_size, "%s would be both a file and a folder (for %s)", folder, name);
        if (tree_join(path, dir, folder) && plat_file_size(path) >= 0)
            return err_set(err, err_size, "%s: a file with this name exists, but %s needs a folder there", path, name);
    }
    return true;
}

/* Checks that all files can be written. files: sorted. */
static bool check_files(const struct tree *files, const char *dir, char *err, size_t err_size)
{
    char path[PATH];

    for (int i = 0; i < files->n; i++) {
        const char *name = files->name[i];
        if (!tree_join(path, dir, name))
            return err_set(err, err_size, "%s: path too long", name);
        if (!manifest_path_ok(name))
            return err_set(err, err_size, "\"%s\" is not a valid file name", name);
        if (i > 0 && strcmp(files->name[i - 1], name) == 0)
            return err_set(err, err_size, "two lumps would be written to %s", name);
        if (plat_file_size(path) >= 0)
            return err_set(err, err_size, "%s: already exists", path);
        if (!check_folders(files, name, dir, err, err_size))
            return false;
    }
    return true;
}

/* Removes the files of the first n lumps. */
static void remove_lumps(const struct rom *rom, uint32_t n, const char *dir)
{
    char name[PATH], path[PATH];

    while (n-- > 0) {
        struct lump l;
        rom_lump(rom, (int)n, &l);
        file_name(l.name, name);
        if (tree_join(path, dir, name))
            plat_remove(path);
    }
}

static bool save_lumps(const struct rom *rom, const char *dir, char *err, size_t err_size)
{
    char name[PATH], path[PATH];

    for (uint32_t i = 0; i < rom->count; i++) {
        struct lump l;
        rom_lump(rom, (int)i, &l);
        file_name(l.name, name);
        bool named = tree_join(path, dir, name);
        if (named && files_save(path, l.data, l.size, err, err_size))
            continue;
        remove_lumps(rom, i, dir);
        return named ? false : err_set(err, err_size, "%s: path too long", name);
    }
    return true;
}

bool pack_unpack(const struct rom *rom, const char *dir, char *err, size_t err_size)
{
    struct tree files = { 0 };
    char name[PATH];

    for (uint32_t i = 0; i < rom->count; i++) {
        struct lump l;
        rom_lump(rom, (int)i, &l);
        file_name(l.name, name);
        tree_add(&files, "", name);
    }
    tree_sort(&files);
    bool good =
        !files.failed ? check_files(&files, dir, err, err_size) : err_set(err, err_size, "%s", tree_failed(&files));
    tree_close(&files);
    return good && save_lumps(rom, dir, err, err_size);
}
