/*
 * export.c - see export.h.
 */
#include "export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../pack/compress.h"
#include "../pack/pack.h"
#include "../../common/output_paths.h"
#include "desktop.h"
#include "image.h"
#include "../../player/licences.h"
#include "../../player/game/mark.h"
#include "../../player/game/embedded_rom.h"
#include "../../player/game/game.h"
#include "pe.h"
#include "readme.h"
#include "retro.h"
#include "web.h"
#include "zip.h"

enum { PROGRAM = 1 << 30, EXPORT_ERR = FILES_ERR_SIZE + 256 };

struct export
{
    const struct args *a;
    enum export_kind kind; /* of the file that is being made */
    struct rom_image image;
    struct cart cart;
    uint8_t *compressed; /* compressed game, malloc; NULL: not smaller */
    const uint8_t *game;
    size_t game_size;
    char name[72]; /* default name of the file */
    const char *out;
    char info[FILES_PATH_SIZE]; /* of a core's .info */
    char from[FILES_PATH_SIZE]; /* path of the player, for messages */
    uint8_t *file;              /* contents of the output file; malloc */
    size_t size;
    char *err;
    size_t err_size;
};

static bool append_game(struct export *e);
static bool make_page(struct export *e);

static const struct kind {
    const char *option;             /* without --; also used in the name of the zip. NULL: none */
    const char *noun;               /* for messages */
    const char *suffix;             /* suffix of the file name, after the game's id */
    const char *player;             /* file to which the game is added */
    const char *program;            /* the same with --keys; NULL: this program */
    bool (*make)(struct export *e); /* into e->file */
    bool runs;                      /* the file is made executable */
    bool crlf;                      /* text files in the zip use CR LF */
} kinds[] = {
    [EXPORT_PROGRAM] = { NULL, "program", "", "curtain-player", NULL, append_game, true, false },
    [EXPORT_LINUX] = { "linux", "program", "", "curtain-player-linux", "curtain-linux", append_game, true, false },
    [EXPORT_WINDOWS] = { "windows", "program", ".exe", "curtain-player.exe", "curtain.exe", append_game, true, true },
    [EXPORT_WEB] = { "web", "page", ".html", "player.html", NULL, make_page, false, false },
    [EXPORT_LIBRETRO] = { "libretro", "core", "_libretro.so", "curtain_libretro.so", NULL, append_game, false, false },
    [EXPORT_ALL] = { "all", "zip file", "-exports", NULL, NULL, NULL, false, false },
};

/* ---- a game in its player ---- */

/* Overwrites this program's built-in game with zeroes: an export has its own game, and zeroes compress well. */
static void blank_builtin(uint8_t *file, size_t size)
{
    if (!builtin_rom_size)
        return;
    for (size_t i = 0; i + builtin_rom_size <= size; i++) {
        const uint8_t *next = memchr(file + i, builtin_rom[0], size - builtin_rom_size + 1 - i);
        if (!next)
            return;
        i = (size_t)(next - file);
        if (memcmp(next, builtin_rom, builtin_rom_size) == 0) {
            memset(file + i, 0, builtin_rom_size);
            return;
        }
    }
}

/* Returns the suffix of this system's programs: .exe on Windows. */
static const char *program_suffix(void)
{
    static const char exe[] = ".exe";
    char name[FILES_PATH_SIZE];

    if (!plat_program_file(name, sizeof name))
        return "";
    const size_t n = strlen(name);
    return n > strlen(exe) && strcmp(name + n - strlen(exe), exe) == 0 ? exe : "";
}

static bool load_program(struct export *e)
{
    char name[FILES_PATH_SIZE];

    snprintf(e->from, sizeof e->from, "export: this program's own file");
    if (!plat_program_file(name, sizeof name))
        return err_set(e->err, e->err_size, "export: cannot find this program's own file");
    return files_read(name, e->from, PROGRAM, &e->file, &e->size, e->err, e->err_size);
}

/* Returns the name of the file that becomes the export; NULL: this program's own file. */
static const char *player_name(const struct export *e)
{
    return e->a->keys ? kinds[e->kind].program : kinds[e->kind].player;
}

/* Finds the player next to this program, in a built tree or in the installation, and loads it. */
static bool load_player(struct export *e)
{
    static const char *const folders[] = { "players/", "../share/curtain/players/" };
    const bool is_here = e->kind == EXPORT_PROGRAM;
    const char *player = player_name(e);
    char name[64];

    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        snprintf(name, sizeof name, "%s%s%s", is_here ? "" : folders[i], player, is_here ? program_suffix() : "");
        if (plat_installed_file(name, e->from, sizeof e->from) && plat_file_size(e->from) >= 0)
            return files_read(e->from, e->from, PROGRAM, &e->file, &e->size, e->err, e->err_size);
    }
    if (is_here)
        return err_set(e->err, e->err_size,
                       "export: cannot find %s, which must be in the same folder as this program; run `make all` in "
                       "Curtain's source tree",
                       name);
    return err_set(e->err, e->err_size,
                   "export: cannot find the player %s in players or ../share/curtain/players, relative to this "
                   "program's folder; run `make players` in Curtain's source tree",
                   player);
}

static bool make_page(struct export *e)
{
    const struct web_game game = { e->cart.manifest.title, e->game, e->game_size };
    uint8_t *player;
    size_t size;

    if (!load_player(e))
        return false;
    player = e->file;
    size = e->size;
    e->file = NULL;
    const bool good = web_make(&game, player, size, e->from, &e->file, &e->size, e->err, e->err_size);
    free(player);
    return good;
}

/* Trims the player to the bytes that the system loads, and finds its mark: *at. */
static bool prepare_player(struct export *e, size_t *at)
{
    const char *player = player_name(e), *make = e->kind == EXPORT_PROGRAM ? "make all" : "make players";
    struct mark m;
    char why[256];

    if (!player)
        blank_builtin(e->file, e->size);
    if (pe_is(e->file, e->size) && !pe_set_resources(&e->file, &e->size, &e->cart, why, sizeof why))
        return err_set(e->err, e->err_size, "%s: %s", e->from, why);
    e->size = image_trim(e->file, e->size);
    if (!mark_find(e->file, e->size, at))
        return err_set(e->err, e->err_size,
                       player ? "%s: not a valid player; rebuild it with `%s`"
                              : "%s does not match the running program",
                       e->from, make);
    mark_read(e->file + *at, &m);
    if (m.core == CORE_VERSION)
        return true;
    return err_set(e->err, e->err_size, "%s: expected core version %d, got %u; rebuild it with `%s`", e->from,
                   CORE_VERSION, (unsigned)m.core, make);
}

/* Makes the player with its mark filled in and the game appended. */
static bool append_game(struct export *e)
{
    struct mark m = { .flags = e->a->keys ? MARK_KEYS : 0, .crc = e->image.rom.crc, .size = e->game_size };
    size_t at;

    if (!(player_name(e) ? load_player(e) : load_program(e)) || !prepare_player(e, &at))
        return false;
    m.at = (e->size + ROM_ALIGN - 1) / ROM_ALIGN * ROM_ALIGN;
    mark_put(e->file + at, &m);
    uint8_t *more = realloc(e->file, (size_t)m.at + e->game_size);
    if (!more)
        return result_set_host_error(e->err, e->err_size, "out of memory");
    e->file = more;
    memset(more + e->size, 0, (size_t)m.at - e->size);
    memcpy(more + m.at, e->game, e->game_size);
    e->size = (size_t)m.at + e->game_size;
    return true;
}

/* ---- files ---- */

static bool is_info(const uint8_t *head, size_t n)
{
    return n >= strlen(RETRO_INFO_FIRST) && memcmp(head, RETRO_INFO_FIRST, strlen(RETRO_INFO_FIRST)) == 0;
}

/* Checks that the files next to the export can be written. */
static bool check_companions(struct export *e)
{
    if (e->kind == EXPORT_LIBRETRO)
        return output_path_derived(e->a->words[0], e->info, is_info, e->err, e->err_size);
    return !e->a->desktop || desktop_check_writable(e->a->words[0], e->out, e->err, e->err_size);
}

/* Returns whether the file is an export of the kind. */
static bool is_exported(enum export_kind kind, const uint8_t *file, size_t size)
{
    struct mark m = { .size = 0 };
    size_t at;

    if (kind == EXPORT_ALL)
        return zip_is_ours(file, size);
    if (kind == EXPORT_WEB)
        return web_is_page(file, size);
    if (mark_find(file, size, &at))
        mark_read(file + at, &m);
    return m.size > 0;
}

/* Checks that the path doesn't exist or is an export of the kind, which may be replaced. */
static bool check_replaceable(struct export *e, const char *path, enum export_kind kind)
{
    uint8_t *existing;
    size_t size;

    if (plat_file_size(path) < 0 && files_count_entries(path) >= 0)
        return err_set(e->err, e->err_size, "%s: a folder with this name exists; choose another file with -o", path);
    if (plat_file_size(path) < 0)
        return true;
    if (!files_read(path, path, PROGRAM, &existing, &size, e->err, e->err_size))
        return false;
    const bool exported = is_exported(kind, existing, size);
    free(existing);
    return exported ? true
                    : err_set(e->err, e->err_size, "%s: already exists and is not an exported %s; remove it first",
                              path, kinds[kind].noun);
}

static bool save_info(struct export *e)
{
    char text[2048];

    retro_info(&e->cart.manifest, text, sizeof text);
    return files_save(e->info, text, strlen(text), e->err, e->err_size);
}

static bool save(struct export *e)
{
    if (!files_save(e->out, e->file, e->size, e->err, e->err_size))
        return false;
    if (e->kind == EXPORT_LIBRETRO)
        return save_info(e);
    return !kinds[e->kind].runs || plat_make_executable(e->out)
               ? true
               : result_set_host_error(e->err, e->err_size, "%s: cannot be made executable", e->out);
}

/* ---- zip files ---- */

static void zip_text(struct zip *z, const char *name, const struct byte_buffer *text, bool crlf)
{
    struct byte_buffer lines = { 0 };

    for (size_t i = 0; i < text->n; i++) {
        if (crlf && text->bytes[i] == '\n')
            byte_buffer_byte(&lines, '\r');
        byte_buffer_byte(&lines, text->bytes[i]);
    }
    zip_add(z, name, lines.bytes, lines.n, false);
    z->bytes.failed |= text->failed || lines.failed;
    byte_buffer_close(&lines);
}

/* Zips the export, the text files for players and, for a core, its .info. */
static bool make_zip(struct export *e, struct zip *z)
{
    const struct kind *kind = &kinds[e->kind];
    struct byte_buffer readme = { 0 }, licences = { 0 };
    char name[72], info[2048];

    if (!kind->make(e))
        return false;
    snprintf(name, sizeof name, "%s%s", e->cart.manifest.id, kind->suffix);
    zip_add(z, e->kind == EXPORT_WEB ? "index.html" : name, e->file, e->size, kind->runs);
    free(e->file);
    e->file = NULL;
    if (e->kind == EXPORT_LIBRETRO) {
        retro_info(&e->cart.manifest, info, sizeof info);
        snprintf(name, sizeof name, "%s_libretro.info", e->cart.manifest.id);
        zip_add(z, name, info, strlen(info), false);
    }
    readme_write(&readme, e->kind, &e->cart.manifest);
    licences_notices(&licences);
    zip_text(z, "README.txt", &readme, kind->crlf);
    zip_text(z, "licences.txt", &licences, kind->crlf);
    byte_buffer_close(&readme);
    byte_buffer_close(&licences);
    return zip_finish(z) ? true : result_set_host_error(e->err, e->err_size, "out of memory");
}

static bool zip_path(struct export *e, enum export_kind kind, char path[FILES_PATH_SIZE])
{
    const int n = snprintf(path, FILES_PATH_SIZE, "%s/%s-%s.zip", e->out, e->cart.manifest.id, kinds[kind].option);

    return n < FILES_PATH_SIZE ? true : err_set(e->err, e->err_size, "%s: path too long", e->out);
}

/* Makes all zips before the first is written. */
static bool export_all(struct export *e)
{
    struct zip zips[EXPORT_ALL] = { 0 };
    char path[FILES_PATH_SIZE];
    bool good = true;

    for (e->kind = EXPORT_LINUX; good && e->kind < EXPORT_ALL; e->kind++)
        good = make_zip(e, &zips[e->kind]) && zip_path(e, e->kind, path) && check_replaceable(e, path, EXPORT_ALL);
    for (enum export_kind k = EXPORT_LINUX; good && k < EXPORT_ALL; k++)
        good = zip_path(e, k, path) && files_save(path, zips[k].bytes.bytes, zips[k].bytes.n, e->err, e->err_size);
    for (enum export_kind k = EXPORT_LINUX; k < EXPORT_ALL; k++)
        zip_free(&zips[k]);
    return good;
}

/* ---- the command ---- */

/* Chooses the names of the output files. */
static bool choose_names(struct export *e)
{
    size_t n;

    snprintf(e->name, sizeof e->name, "%s%s", e->cart.manifest.id,
             e->kind == EXPORT_PROGRAM ? program_suffix() : kinds[e->kind].suffix);
    e->out = e->a->out ? e->a->out : e->name;
    n = strlen(e->out);
    if (e->kind != EXPORT_LIBRETRO)
        return true;
    if (n < 4 || n + 3 > sizeof e->info || strcmp(e->out + n - 3, ".so") != 0)
        return err_set(e->err, e->err_size, "--libretro: expected a file name ending in .so after -o, got \"%s\"",
                       e->out);
    snprintf(e->info, sizeof e->info, "%.*s.info", (int)(n - 3), e->out);
    return true;
}

static bool load_game(struct export *e)
{
    char why[256];

    if (!pack_load_game(e->a->words[0], e->a->nearest, &e->image, e->err, e->err_size))
        return false;
    if (!cart_open(&e->cart, &e->image.rom, why, sizeof why))
        return err_set(e->err, e->err_size, "%s: %s", e->a->words[0], why);
    if (!compress_rom(e->image.bytes, e->image.size, &e->compressed, &e->game_size))
        return result_set_host_error(e->err, e->err_size, "out of memory");
    e->game = e->compressed ? e->compressed : e->image.bytes;
    e->game_size = e->compressed ? e->game_size : e->image.size;
    return choose_names(e);
}

static bool check_allowed(struct export *e)
{
    if (embedded_rom_game()->rom)
        return err_set(e->err, e->err_size, "export: this program is the exported game %s; use curtain to export games",
                       embedded_rom_game()->m.title);
    if (e->kind == EXPORT_PROGRAM && e->a->keys && !embedded_rom_has_window())
        return err_set(e->err, e->err_size,
                       "export: a copy of this program would have no window; use curtain, or add --linux or --windows");
    return true;
}

static bool export_one(struct export *e)
{
    return check_replaceable(e, e->out, e->kind) && check_companions(e) && kinds[e->kind].make(e) && save(e) &&
           (!e->a->desktop || desktop_write(e->out, &e->cart, e->err, e->err_size));
}

enum result export_command(const struct args *a)
{
    char err[EXPORT_ERR];
    struct export e = { .a = a, .err = err, .err_size = sizeof err };

    e.kind = a->all ? EXPORT_ALL : (enum export_kind)a->export;
    const bool good = check_allowed(&e) && load_game(&e) && (a->all ? export_all(&e) : export_one(&e));
    free(e.file);
    free(e.compressed);
    rom_image_free(&e.image);
    return good ? RESULT_DONE : report_error(err);
}
