/*
 * pack_load.c - see pack.h: a game from a .rom file or a folder.
 */
#include "pack.h"

#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/files.h"

static void ignore_entry(void *user, const struct plat_folder_entry *file)
{
    (void)user;
    (void)file;
}

bool pack_load_game(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size)
{
    return pack_load_game_told(path, nearest, NULL, NULL, out, err, err_size);
}

bool pack_load_game_told(const char *path, bool nearest, void (*warn)(void *context, const char *sentence),
                         void *context, struct rom_image *out, char *err, size_t err_size)
{
    char why[FILES_PATH_SIZE + 256];

    memset(out, 0, sizeof *out);
    if (files_size(path) >= 0)
        return rom_image_read(path, nearest, out, err, err_size);
    if (plat_list(path, ignore_entry, NULL) < 0) {
        files_set_missing_error(path, "file or folder", err, err_size);
        return false;
    }
    if (!pack_folder_told(path, nearest, warn, context, &out->bytes, &out->size, why, sizeof why)) {
        memset(out, 0, sizeof *out);
        return err_set(err, err_size, "%s: %s", path, why);
    }
    return rom_open(&out->rom, out->bytes, out->size, err, err_size);
}
