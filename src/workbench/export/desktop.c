/*
 * desktop.c - see desktop.h, and freedesktop.org's "Desktop Entry Specification".
 */
#include "desktop.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/clean.h"
#include "../../common/files.h"
#include "../../player/picture/icon.h"
#include "../../player/picture/png.h"
#include "../../common/output_paths.h"

#define ENTRY "[Desktop Entry]\nType=Application\n"

static bool is_entry(const uint8_t *head, size_t n)
{
    return n >= strlen(ENTRY) && memcmp(head, ENTRY, strlen(ENTRY)) == 0;
}

bool desktop_can_name(const char *path)
{
    for (const char *p = path, *end = path + strlen(path); p < end;)
        if (!utf8_may_show(utf8_next(&p, end)))
            return false;
    return true;
}

bool desktop_check_writable(const char *rom, const char *program, char *err, size_t err_size)
{
    char path[FILES_PATH_SIZE + 16];

    if (plat_path(program, path, FILES_PATH_SIZE) && !desktop_can_name(path))
        return err_set(err, err_size,
                       "--desktop: %s: the program's path must not contain line breaks or control characters", program);
    snprintf(path, sizeof path, "%s.desktop", program);
    if (!output_path_derived(rom, path, is_entry, err, err_size))
        return false;
    snprintf(path, sizeof path, "%s.png", program);
    return output_path_derived(rom, path, png_is_signed, err, err_size);
}

/* Escapes first for the shell, then for the file format. */
void desktop_quote(const char *path, char *out, size_t size)
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

/* Doubles each backslash, for a value of an entry. */
static void double_backslashes(const char *line, char *out)
{
    for (; *line; line++) {
        if (*line == '\\')
            *out++ = '\\';
        *out++ = *line;
    }
    *out = '\0';
}

bool desktop_write(const char *program, const struct cart *cart, char *err, size_t err_size)
{
    char path[FILES_PATH_SIZE], exec[2 * FILES_PATH_SIZE], line[sizeof cart->manifest.title], title[2 * sizeof line];
    char shown[2 * FILES_PATH_SIZE], name[FILES_PATH_SIZE + 16], text[8 * FILES_PATH_SIZE];
    uint8_t *rgba, *png = NULL;
    size_t size = 0;
    int side;

    if (!plat_path(program, path, sizeof path - sizeof ".desktop"))
        return err_set(err, err_size, "%s: path too long", program);
    desktop_quote(path, exec, sizeof exec);
    snprintf(line, sizeof line, "%s", cart->manifest.title);
    clean_line(line);
    double_backslashes(line, title);
    double_backslashes(path, shown);
    rgba = icon_make(cart, ICON_FILE_SIDE, &side);
    const bool icon = rgba && png_write_rgba(rgba, side, side, &png, &size);
    free(rgba);
    snprintf(text, sizeof text,
             ENTRY "Name=%s\nExec=\"%s\"\nIcon=%s%s\nTerminal=false\n"
                   "Categories=Game;ArcadeGame;\n",
             title, exec, icon ? shown : "applications-games", icon ? ".png" : "");
    snprintf(name, sizeof name, "%s.desktop", path);
    bool good = files_save(name, text, strlen(text), err, err_size);
    snprintf(name, sizeof name, "%s.png", path);
    good = good && (!icon || files_save(name, png, size, err, err_size));
    free(png);
    return good;
}
