/*
 * rom_image.c - loads .rom files (rom_image.h).
 */
#include "rom_image.h"

#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../board/board.h"
#include "../../common/files.h"
#include "../../common/result.h"
#include "../../rom/compressed.h"

enum { MAX_FILE_BYTES = 256 << 20 };

bool rom_image_plain(uint8_t **bytes, size_t *size, char *err, size_t err_size)
{
    if (!compressed_has_magic(*bytes, *size))
        return true;
    const size_t plain_size = compressed_plain_size(*bytes, *size, err, err_size);
    if (plain_size == 0)
        return false;
    uint8_t *plain = malloc(plain_size);
    if (!plain)
        return result_set_host_error(err, err_size, "out of memory");
    if (!compressed_unpack(*bytes, *size, plain, err, err_size)) {
        free(plain);
        return false;
    }
    free(*bytes);
    *bytes = plain;
    *size = plain_size;
    return true;
}

bool rom_image_check(const uint8_t *bytes, size_t size, struct rom *rom, char *err, size_t err_size)
{
    size_t ram;

    return rom_open(rom, bytes, size, err, err_size) && board_size(rom, &ram, err, err_size);
}

bool rom_image_read(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size)
{
    char why[256];

    (void)nearest;
    memset(out, 0, sizeof *out);
    if (files_size(path) < 0 && files_count_entries(path) >= 0)
        return err_set(err, err_size, "%s: is a folder; this program plays .rom files (curtain pack makes one)", path);
    if (!files_read(path, path, MAX_FILE_BYTES, &out->bytes, &out->size, err, err_size))
        return false;
    if (rom_image_plain(&out->bytes, &out->size, why, sizeof why) &&
        rom_image_check(out->bytes, out->size, &out->rom, why, sizeof why))
        return true;
    rom_image_free(out);
    return err_set(err, err_size, "%s: %s", path, why);
}

void rom_image_free(struct rom_image *image)
{
    free(image->bytes);
    memset(image, 0, sizeof *image);
}
