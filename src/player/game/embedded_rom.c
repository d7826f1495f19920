/*
 * embedded_rom.c - reads the embedded game (embedded_rom.h). The whole file is read, as it has only a few megabytes,
 * and the ROM is moved to the start of the block, which malloc aligns.
 */
#include "embedded_rom.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../rom/rom.h"
#include "../../common/files.h"
#include "version.h"
#include "rom_image.h"
#include "mark.h"

enum { MAX_FILE_BYTES = 1 << 30 /* bytes of a program's file */ };

static struct embedded_rom own;

static const char itself[] = "this program's own file";

/* Replaces the file's bytes in *in with the ROM in it. */
static enum result extract_rom(uint8_t **in, size_t size, const struct mark *m, char *err, size_t err_size)
{
    uint8_t *file = *in;
    struct rom rom;
    struct lump lump;
    char why[256];

    if (size < m->at || size - m->at < m->size) {
        err_set(err, err_size, "%s is truncated: %zu bytes, expected %" PRIu64 " including its game", itself, size,
                m->at + m->size);
        return RESULT_REFUSED;
    }
    own.size = (size_t)m->size; /* which fits, as the file does */
    memmove(file, file + (size_t)m->at, own.size);
    const bool whole = rom_image_plain(in, &own.size, why, sizeof why);
    file = *in;
    if (!whole || !rom_open(&rom, file, own.size, why, sizeof why) || rom.crc != m->crc ||
        rom_find(&rom, "manifest") < 0) {
        err_set(err, err_size, "%s is damaged: the game in it is corrupt", itself);
        return RESULT_REFUSED;
    }
    rom_lump(&rom, rom_find(&rom, "manifest"), &lump);
    if (!manifest_unpack(lump.data, lump.size, &own.m, why, sizeof why)) {
        err_set(err, err_size, "%s: invalid game manifest: %s", itself, why);
        return RESULT_REFUSED;
    }
    own.rom = file;
    own.keys = m->flags & MARK_KEYS;
    return RESULT_DONE;
}

enum result embedded_rom_open(char *err, size_t err_size)
{
    const struct mark m = mark_own();
    char name[FILES_PATH_SIZE];
    uint8_t *file;
    size_t size;

    if (!m.size || own.rom)
        return RESULT_DONE;
    if (!plat_program_file(name, sizeof name)) {
        err_set(err, err_size, "%s, which contains the game, cannot be found on this system", itself);
        return RESULT_HOST_FAILED;
    }
    if (!files_read(name, itself, MAX_FILE_BYTES, &file, &size, err, err_size))
        return RESULT_HOST_FAILED;
    enum result result = extract_rom(&file, size, &m, err, err_size);
    if (result == RESULT_DONE)
        plat_set_name(own.m.id);
    else
        free(file);
    return result;
}

const struct embedded_rom *embedded_rom_game(void)
{
    return &own;
}

bool embedded_rom_has_window(void)
{
    char about[128];

    plat_describe_build(about, sizeof about);
    return strcmp(about, "no window") != 0;
}

bool embedded_rom_sealed(void)
{
    return own.rom && !own.keys;
}

void embedded_rom_help(void (*line)(const char *))
{
    char text[256];

    snprintf(text, sizeof text,
             "%s%s%s, made with Curtain %s. Run it without arguments to play. Commands:", own.m.title,
             own.m.author[0] ? ", by " : "", own.m.author, CURTAIN_VERSION);
    line(text);
    line("");
    line("  licences [--full]     print the authors and licences of the included software");
    line("  version               print the version and build");
    line("  help [config]         print this help, or help for the settings and their file");
    line("");
    line("Options:");
}
