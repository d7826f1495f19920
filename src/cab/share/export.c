/*
 * export.c - see export.h.
 */
#include "export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../host/result.h"
#include "../../board/board.h"
#include "../../board/rom/cart.h"
#include "../../../fb/utf8.h"
#include "../host/clean.h"
#include "../host/files.h"
#include "../host/report.h"
#include "../pack/compress.h"
#include "../pack/icon.h"
#include "../pack/pack.h"
#include "../pack/png.h"
#include "../store/output_paths.h"
#include "beside.h"
#include "image.h"
#include "mark.h"
#include "own.h"
#include "retro.h"
#include "web.h"

enum { PROGRAM = 1 << 30, EXPORT_ERR = FILES_ERR + 256 };

struct export
{
    const struct export_want *want;
    struct rom_image image;
    struct cart cart;
    uint8_t *small; /* the game compressed; malloc, NULL: it stays plain */
    const uint8_t *game;
    size_t game_size;
    const char *out;
    char name[72];         /* of the file, where none was given */
    char info[FILES_PATH]; /* of a core's .info */
    char from[FILES_PATH]; /* what the file is a copy of, as messages call it */
    uint8_t *file;         /* what is written; malloc */
    size_t size;
    char *err;
    size_t err_size;
};

/* ---- the program ---- */

/* A game that is built in is not given along: zeroes are, which any archive makes nothing of. */
static void blank_builtin(const struct export_want *w, uint8_t *file, size_t size)
{
    if (!w->builtin_size)
        return;
    for (size_t i = 0; i + w->builtin_size <= size; i++) {
        const uint8_t *next = memchr(file + i, w->builtin[0], size - w->builtin_size + 1 - i);
        if (!next)
            return;
        i = (size_t)(next - file);
        if (memcmp(next, w->builtin, w->builtin_size) == 0) {
            memset(file + i, 0, w->builtin_size);
            return;
        }
    }
}

static bool load_program(struct export *e)
{
    char name[FILES_PATH];

    snprintf(e->from, sizeof e->from, "export: this program's own file");
    if (!plat_program(name, sizeof name))
        return err_set(e->err, e->err_size, "export: cannot find this program's own file");
    return files_read(name, e->from, PROGRAM, &e->file, &e->size, e->err, e->err_size);
}

static bool load_core(struct export *e)
{
    static const struct beside core = { "curtain_libretro.so",
                                        { "curtain_libretro.so", "../lib/libretro/curtain_libretro.so" },
                                        "lib/libretro",
                                        "make library" };
    size_t at;
    struct mark m = { .core = CORE_VERSION };

    if (!beside_read(&core, &e->file, &e->size, e->from, sizeof e->from, e->err, e->err_size))
        return false;
    if (mark_find(e->file, e->size, &at))
        mark_read(e->file + at, &m);
    if (m.core == CORE_VERSION)
        return true;
    return err_set(e->err, e->err_size, "%s: has core version %u, this program has %d; rebuild it with make library",
                   e->from, (unsigned)m.core, CORE_VERSION);
}

static bool make_page(struct export *e)
{
    static const struct beside player = { "player.html",
                                          { "player.html", "web/player.html", "../web/player.html",
                                            "../share/curtain/player.html" },
                                          "share/curtain",
                                          "make web" };
    const struct web_game game = { e->cart.m.title, e->game, e->game_size };
    uint8_t *with;
    size_t size;

    if (!beside_read(&player, &with, &size, e->from, sizeof e->from, e->err, e->err_size))
        return false;
    const bool good = web_make(&game, with, size, e->from, &e->file, &e->size, e->err, e->err_size);
    free(with);
    return good;
}

/* The file: the program or core, its mark, and the game behind. */
static bool build(struct export *e)
{
    struct mark m = { .flags = e->want->keys ? MARK_KEYS : 0, .crc = e->image.rom.crc, .size = e->game_size };
    size_t at, end = image_trim(e->file, e->size);

    m.at = (end + ROM_ALIGN - 1) / ROM_ALIGN * ROM_ALIGN;
    if (!mark_find(e->file, end, &at))
        return err_set(e->err, e->err_size,
                       e->want->kind == EXPORT_CORE ? "%s: not a core that can hold a game; build one with make library"
                                                    : "%s is not the running program",
                       e->from);
    if (e->want->kind == EXPORT_PROGRAM)
        blank_builtin(e->want, e->file, end);
    mark_put(e->file + at, &m);
    uint8_t *more = realloc(e->file, (size_t)m.at + e->game_size);
    if (!more)
        return result_host(e->err, e->err_size, "out of memory");
    e->file = more;
    memset(more + end, 0, (size_t)m.at - end);
    memcpy(more + m.at, e->game, e->game_size);
    e->size = (size_t)m.at + e->game_size;
    return true;
}

/* ---- files ---- */

static void ignore(void *user, const struct plat_file *file)
{
    (void)user;
    (void)file;
}

#define ENTRY "[Desktop Entry]\nType=Application\n"

static bool is_entry(const uint8_t *head, size_t n)
{
    return n >= strlen(ENTRY) && memcmp(head, ENTRY, strlen(ENTRY)) == 0;
}

static bool is_info(const uint8_t *head, size_t n)
{
    return n >= strlen(RETRO_INFO_FIRST) && memcmp(head, RETRO_INFO_FIRST, strlen(RETRO_INFO_FIRST)) == 0;
}

/* May what is written beside the file be? */
static bool free_beside(struct export *e)
{
    char entry[FILES_PATH + 16], icon[FILES_PATH + 16];

    if (e->want->kind == EXPORT_CORE && !output_path_derived(e->want->rom, e->info, is_info, e->err, e->err_size))
        return false;
    if (!e->want->desktop)
        return true;
    snprintf(entry, sizeof entry, "%s.desktop", e->out);
    snprintf(icon, sizeof icon, "%s.png", e->out);
    return output_path_derived(e->want->rom, entry, is_entry, e->err, e->err_size) &&
           output_path_derived(e->want->rom, icon, png_is_signed, e->err, e->err_size);
}

/* An entry is lines of text: in a path, what would end one is nothing it can hold. */
static bool entry_holds(struct export *e)
{
    char path[FILES_PATH];

    if (!e->want->desktop || !plat_path(e->out, path, sizeof path))
        return true;
    for (const char *p = path, *end = path + strlen(path); p < end;)
        if (!utf8_may_show(utf8_next(&p, end)))
            return err_set(e->err, e->err_size,
                           "--desktop: %s: a desktop entry cannot contain line ends or control characters", e->out);
    return true;
}

/* Is it a file that was exported, of the kind that is to be written? */
static bool is_exported(struct export *e, const uint8_t *file, size_t size)
{
    struct mark m = { .size = 0 };
    size_t at;

    if (e->want->kind == EXPORT_PAGE)
        return web_is_page(file, size);
    if (mark_find(file, size, &at))
        mark_read(file + at, &m);
    return m.size > 0;
}

/* What stands there already is replaced only if it was exported. */
static bool may_write(struct export *e)
{
    static const char *const kinds[] = { "program", "page", "core" };
    uint8_t *there;
    size_t size;

    if (!entry_holds(e))
        return false;
    if (plat_size(e->out) < 0 && plat_list(e->out, ignore, NULL) >= 0)
        return err_set(e->err, e->err_size, "%s: is a folder; name the output file with -o", e->out);
    if (!free_beside(e))
        return false;
    if (plat_size(e->out) < 0)
        return true;
    if (!files_read(e->out, e->out, PROGRAM, &there, &size, e->err, e->err_size))
        return false;
    const bool exported = is_exported(e, there, size);
    free(there);
    return exported ? true
                    : err_set(e->err, e->err_size, "%s: already exists and is not an exported %s; remove it first",
                              e->out, kinds[e->want->kind]);
}

static bool save_info(struct export *e)
{
    char text[2048];

    retro_info(&e->cart.m, text, sizeof text);
    return files_save(e->info, text, strlen(text), e->err, e->err_size);
}

static bool save(struct export *e)
{
    if (!files_save(e->out, e->file, e->size, e->err, e->err_size))
        return false;
    if (e->want->kind == EXPORT_PAGE)
        return true;
    if (e->want->kind == EXPORT_CORE)
        return save_info(e);
    return plat_runnable(e->out) ? true : result_host(e->err, e->err_size, "%s: cannot be made executable", e->out);
}

/* A path in double quotes, as the line Exec of an entry wants it: the file's own escapes on top of the shell's. */
static void quoted(const char *path, char *out, size_t size)
{
    size_t n = 0;

    for (; *path && n + 8 < size; path++) {
        if (strchr("\"`$\\", *path)) {
            out[n++] = '\\';
            out[n++] = '\\';
            out[n++] = *path == '\\' ? '\\' : *path;
            if (*path == '\\')
                out[n++] = '\\';
            continue;
        }
        if (*path == '%')
            out[n++] = '%';
        out[n++] = *path;
    }
    out[n] = '\0';
}

/* A line of an entry: \ is two of them. */
static void escaped(const char *line, char *out)
{
    for (; *line; line++) {
        if (*line == '\\')
            *out++ = '\\';
        *out++ = *line;
    }
    *out = '\0';
}

/* FILE.desktop and FILE.png: an entry of a menu that starts the file where it is now. */
static bool save_entry(struct export *e)
{
    char path[FILES_PATH], exec[2 * FILES_PATH], title[2 * sizeof e->cart.m.title];
    char shown[2 * FILES_PATH], name[FILES_PATH + 16], text[8 * FILES_PATH];
    uint8_t *png = NULL;
    size_t size = 0;

    if (!plat_path(e->out, path, sizeof path - sizeof ".desktop"))
        return err_set(e->err, e->err_size, "%s: path too long", e->out);
    quoted(path, exec, sizeof exec);
    clean_line(e->cart.m.title);
    escaped(e->cart.m.title, title);
    escaped(path, shown);
    const bool icon = icon_png(&e->cart, ICON_SAVED, &png, &size) && png_sign(&png, &size);
    snprintf(text, sizeof text,
             ENTRY "Name=%s\nExec=\"%s\"\nIcon=%s%s\nTerminal=false\n"
                   "Categories=Game;ArcadeGame;\n",
             title, exec, icon ? shown : "applications-games", icon ? ".png" : "");
    snprintf(name, sizeof name, "%s.desktop", path);
    bool good = files_save(name, text, strlen(text), e->err, e->err_size);
    snprintf(name, sizeof name, "%s.png", path);
    good = good && (!icon || files_save(name, png, size, e->err, e->err_size));
    free(png);
    return good;
}

/* ---- the command ---- */

/* A program is a copy of this one, and ends as it does: Windows runs what ends in .exe. */
static const char *program_ending(void)
{
    static const char exe[] = ".exe";
    char name[FILES_PATH];

    if (!plat_program(name, sizeof name))
        return "";
    const size_t n = strlen(name);
    return n > strlen(exe) && strcmp(name + n - strlen(exe), exe) == 0 ? exe : "";
}

/* The names of what is written. */
static bool name_out(struct export *e)
{
    const char *const ends[] = { program_ending(), ".html", "_libretro.so" };
    size_t n;

    snprintf(e->name, sizeof e->name, "%s%s", e->cart.m.id, ends[e->want->kind]);
    e->out = e->want->out ? e->want->out : e->name;
    n = strlen(e->out);
    if (e->want->kind != EXPORT_CORE)
        return true;
    if (n < 4 || n + 3 > sizeof e->info || strcmp(e->out + n - 3, ".so") != 0)
        return err_set(e->err, e->err_size, "--libretro: expected -o with a name that ends in .so, got \"%s\"", e->out);
    snprintf(e->info, sizeof e->info, "%.*s.info", (int)(n - 3), e->out);
    return true;
}

static bool load_game(struct export *e)
{
    char why[256];

    if (!rom_image_load(e->want->rom, e->want->nearest, &e->image, e->err, e->err_size))
        return false;
    if (!cart_open(&e->cart, &e->image.rom, why, sizeof why))
        return err_set(e->err, e->err_size, "%s: %s", e->want->rom, why);
    if (!compress_rom(e->image.bytes, e->image.size, &e->small, &e->game_size))
        return result_host(e->err, e->err_size, "out of memory");
    e->game = e->small ? e->small : e->image.bytes;
    e->game_size = e->small ? e->game_size : e->image.size;
    return name_out(e);
}

static bool has_window(void)
{
    char about[128];

    plat_about(about, sizeof about);
    return strcmp(about, "no window") != 0;
}

static bool may_export(struct export *e)
{
    if (own_game()->rom)
        return err_set(e->err, e->err_size, "export: this program is an exported game, %s; export with curtain",
                       own_game()->m.title);
    if (e->want->kind == EXPORT_PROGRAM && !has_window())
        return err_set(e->err, e->err_size, "export: this program has no window; use curtain, not curtain-null");
    return true;
}

/* What is to be written, in e->file. */
static bool make(struct export *e)
{
    if (e->want->kind == EXPORT_PAGE)
        return make_page(e);
    return (e->want->kind == EXPORT_CORE ? load_core(e) : load_program(e)) && build(e);
}

enum result export_run(const struct export_want *want)
{
    char err[EXPORT_ERR];
    struct export e = { .want = want, .err = err, .err_size = sizeof err };

    bool good =
        may_export(&e) && load_game(&e) && may_write(&e) && make(&e) && save(&e) && (!want->desktop || save_entry(&e));
    free(e.file);
    free(e.small);
    rom_image_free(&e.image);
    return good ? RESULT_DONE : report_error(err);
}
