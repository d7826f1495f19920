/*
 * pack_commands.c - see pack_commands.h.
 */
#include "pack_commands.h"

#include <stdio.h>
#include <stdlib.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../player/game/game.h"
#include "../bench/ram.h"
#include "compress.h"
#include "pack.h"
#include "../../common/output_paths.h"
#include "../../player/replays/replays_print.h"

/* Prints a warning of the packer. */
static void warn(void *context, const char *sentence)
{
    (void)context;
    report_line(RESULT_DONE, "%s", sentence);
}

/* Saves the ROM, compressed if that is smaller. */
static bool save_packed(const struct rom_image *image, const char *out, bool plain, char *err, size_t err_size)
{
    uint8_t *small = NULL;
    size_t size = 0;

    if (!plain && !compress_rom(image->bytes, image->size, &small, &size))
        return result_set_host_error(err, err_size, "out of memory");
    const bool good = files_save(out, small ? small : image->bytes, small ? size : image->size, err, err_size);
    free(small);
    return good;
}

static bool is_rom(const uint8_t *head, size_t n)
{
    return n >= 7 && memcmp(head, "CURTAIN", 7) == 0; /* packed or plain */
}

enum result pack_command(const struct args *a)
{
    struct rom_image image;
    struct cart cart;
    char err[1024], name[64], ram[RAM_TEXT_SIZE];
    const char *dir = a->words[0], *out = a->out;

    if (plat_file_size(dir) >= 0)
        return report_line(RESULT_REFUSED, "%s: expected a game's folder, got a file", dir);
    progress_begin();
    const bool loaded = pack_load_game_warn(dir, a->nearest, warn, NULL, &image, err, sizeof err);
    progress_end();
    if (!loaded)
        return report_error(err);
    enum result result = RESULT_DONE;
    if (!cart_open(&cart, &image.rom, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s: %s", dir, err);
    if (result == RESULT_DONE && !out) {
        snprintf(name, sizeof name, "%s.rom", cart.manifest.id);
        out = name;
        if (!output_path_derived(dir, out, is_rom, err, sizeof err))
            result = report_line(RESULT_REFUSED, "%s", err);
    }
    if (result == RESULT_DONE && !save_packed(&image, out, a->plain, err, sizeof err))
        result = report_line(RESULT_HOST_FAILED, "%s", err);
    if (result == RESULT_DONE) {
        ram_describe(&cart, ram);
        report_print("%s: %s\n", out, ram);
        result = report_stdout(result);
    }
    rom_image_free(&image);
    return result;
}

static void print_line(void *user, const char *line)
{
    (void)user;
    puts(line);
}

static enum result list_replays(const struct args *a, struct rom_image *image)
{
    struct cart cart;
    char err[512];
    enum result result = RESULT_DONE;

    if (!cart_open(&cart, &image->rom, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s: %s", a->words[0], err);
    else if (!replays_print(cart.manifest.id, a->json))
        result = report_line(RESULT_HOST_FAILED, "out of memory");
    rom_image_free(image);
    return report_stdout(result);
}

enum result pack_command_list(const struct args *a)
{
    struct rom_image image;
    char err[1024];

    if (!pack_load_game(a->words[0], a->nearest, &image, err, sizeof err))
        return report_error(err);
    if (a->replays)
        return list_replays(a, &image);
    pack_list(&image.rom, print_line, NULL);
    printf("game %016llx\nrom %016llx\n", (unsigned long long)rom_game_hash(&image.rom),
           (unsigned long long)rom_hash(&image.rom));
    rom_image_free(&image);
    return report_stdout(RESULT_DONE);
}

enum result pack_command_unpack(const struct args *a)
{
    struct rom_image image;
    char err[1024];
    enum result result = RESULT_DONE;

    if (!pack_load_game(a->words[0], a->nearest, &image, err, sizeof err))
        return report_error(err);
    if (!pack_unpack(&image.rom, a->words[1], err, sizeof err))
        result = report_error(err);
    rom_image_free(&image);
    return result;
}
