/*
 * export.c - see export.h.
 */
#include "export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../board/rom/cart.h"
#include "../host/files.h"
#include "../host/report.h"
#include "../pack/compress.h"
#include "../pack/icon.h"
#include "../pack/pack.h"
#include "image.h"
#include "mark.h"
#include "own.h"

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
    uint8_t *file; /* what is written; malloc */
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

    if (!plat_program(name, sizeof name))
        return err_set(e->err, e->err_size, "export: this system does not say where the program's own file is");
    return files_read(name, "export: this program's own file", PROGRAM, &e->file, &e->size, e->err, e->err_size);
}

/* The file: the program, its mark, and the game behind. */
static bool build(struct export *e)
{
    struct mark m = { .flags = e->want->keys ? MARK_KEYS : 0, .crc = e->image.rom.crc, .size = e->game_size };
    size_t at, end = image_trim(e->file, e->size);

    m.at = (end + ROM_ALIGN - 1) / ROM_ALIGN * ROM_ALIGN;
    if (!mark_find(e->file, end, &at))
        return err_set(e->err, e->err_size, "export: this program's own file is not the one that runs");
    blank_builtin(e->want, e->file, end);
    mark_put(e->file + at, &m);
    uint8_t *more = realloc(e->file, (size_t)m.at + e->game_size);
    if (!more)
        return err_set(e->err, e->err_size, "out of memory");
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

/* What would be written beside a new program is nobody's yet. */
static bool nothing_beside(struct export *e)
{
    static const char *const ends[] = { ".desktop", ".png" };
    char name[FILES_PATH + 16];

    for (int i = 0; e->want->desktop && i < 2; i++) {
        snprintf(name, sizeof name, "%s%s", e->out, ends[i]);
        if (plat_size(name) >= 0)
            return err_set(e->err, e->err_size, "%s: is already there: remove it first", name);
    }
    return true;
}

/* An entry is lines of text: in a path, what would end one is nothing it can hold. */
static bool entry_holds(struct export *e)
{
    char path[FILES_PATH];

    if (!e->want->desktop || !plat_path(e->out, path, sizeof path))
        return true;
    for (const char *p = path; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127)
            return err_set(e->err, e->err_size, "--desktop: %s: an entry cannot hold the end of a line and its like",
                           e->out);
    return true;
}

/* What stands there already is replaced only if it is a program that was exported. */
static bool may_write(struct export *e)
{
    uint8_t *there;
    size_t size, at;
    struct mark m = { .size = 0 };

    if (!entry_holds(e))
        return false;
    if (plat_size(e->out) < 0 && plat_list(e->out, ignore, NULL) >= 0)
        return err_set(e->err, e->err_size, "%s: is a folder; -o names the file to be written", e->out);
    if (plat_size(e->out) < 0)
        return nothing_beside(e);
    if (!files_read(e->out, e->out, PROGRAM, &there, &size, e->err, e->err_size))
        return false;
    if (mark_find(there, size, &at))
        mark_read(there + at, &m);
    free(there);
    return m.size ? true
                  : err_set(e->err, e->err_size, "%s: is already there, and is no exported program: remove it first",
                            e->out);
}

static bool save(struct export *e)
{
    if (!files_save(e->out, e->file, e->size, e->err, e->err_size))
        return false;
    return plat_runnable(e->out) ? true : err_set(e->err, e->err_size, "%s: cannot be made a program", e->out);
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
        return err_set(e->err, e->err_size, "%s: the path is too long", e->out);
    quoted(path, exec, sizeof exec);
    escaped(e->cart.m.title, title);
    escaped(path, shown);
    const bool icon = icon_png(&e->cart, ICON_SAVED, &png, &size);
    snprintf(text, sizeof text,
             "[Desktop Entry]\nType=Application\nName=%s\nExec=\"%s\"\nIcon=%s%s\nTerminal=false\n"
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

static bool load_game(struct export *e)
{
    char why[256];

    if (!rom_image_load(e->want->rom, e->want->nearest, &e->image, e->err, e->err_size))
        return false;
    if (!cart_open(&e->cart, &e->image.rom, why, sizeof why))
        return err_set(e->err, e->err_size, "%s: %s", e->want->rom, why);
    e->out = e->want->out ? e->want->out : e->cart.m.id;
    if (!compress_rom(e->image.bytes, e->image.size, &e->small, &e->game_size))
        return err_set(e->err, e->err_size, "out of memory");
    e->game = e->small ? e->small : e->image.bytes;
    e->game_size = e->small ? e->game_size : e->image.size;
    return true;
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
        return err_set(e->err, e->err_size, "export: this program is %s, exported already: export with curtain",
                       own_game()->m.title);
    if (!has_window())
        return err_set(e->err, e->err_size,
                       "export: this program has no window to play in: export with curtain, not "
                       "with curtain-null");
    return true;
}

enum result export_run(const struct export_want *want)
{
    char err[EXPORT_ERR];
    struct export e = { .want = want, .err = err, .err_size = sizeof err };

    bool good = may_export(&e) && load_game(&e) && may_write(&e) && load_program(&e) && build(&e) && save(&e) &&
                (!want->desktop || save_entry(&e));
    free(e.file);
    free(e.small);
    rom_image_free(&e.image);
    return good ? RESULT_DONE : report_error(err);
}
