/*
 * register.c - see register.h. Windows stores file types in its registry (plat_register_type). Other desktops read the
 * files of freedesktop.org's specifications: a menu entry, MIME types, an icon, and mimeapps.list, which assigns
 * entries to types. They are the files of tools/install.sh, written to the user's data folder, with this program's
 * path. They take precedence over an installation for all users.
 */
#include "register.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../pack/pack.h"
#include "../export/desktop.h"
#include "../../player/game/embedded_rom.h"

/* The first file is the desktop entry; names are paths in the data folder. Made by tools/embed.c. */
extern const struct embedded desktop_files[];
extern const int desktop_file_count;

#define ENTRY "applications/curtain.desktop"
#define EXEC  "Exec=curtain "
#define MARK  "X-Curtain-Registered=true\n" /* at the end of an entry that this command wrote */

enum { TYPES = 2, MAX_TEXT_FILE = 1 << 20, LINE = 128 };

static const struct {
    struct plat_file_type file;
    const char *plural, *mime;
} types[TYPES] = {
    { { "rom", "Curtain.Game", "Curtain game" }, "games", "application/x-curtain-rom" },
    { { "demo", "Curtain.Replay", "Curtain replay" }, "replays", "application/x-curtain-demo" },
};

struct registration {
    char data[FILES_PATH_SIZE - 64]; /* folder */
    char program[FILES_PATH_SIZE];
    bool remove;
    char err[2 * FILES_ERR_SIZE];
};

static void print_type(int i, bool remove, bool second)
{
    if (remove)
        report_print("Curtain %s (.%s) no longer open with this program.\n", types[i].plural, types[i].file.extension);
    else if (second)
        report_print("Another program still opens Curtain %s (.%s). To choose Curtain, right-click a file and "
                     "select \"Open With\".\n",
                     types[i].plural, types[i].file.extension);
    else
        report_print("Curtain %s (.%s) now open with this program.\n", types[i].plural, types[i].file.extension);
}

/* ---- files of the desktop ---- */

static void data_path(const struct registration *r, const char *name, char path[FILES_PATH_SIZE])
{
    snprintf(path, FILES_PATH_SIZE, "%s/%s", r->data, name);
}

/* Returns a text file of the data folder (malloc), or "" if it does not exist; NULL: it cannot be read. */
static char *read_text(struct registration *r, const char *name)
{
    char path[FILES_PATH_SIZE];
    uint8_t *text;
    size_t size;

    data_path(r, name, path);
    if (plat_file_size(path) < 0)
        return calloc(1, 1);
    return files_read(path, path, MAX_TEXT_FILE, &text, &size, r->err, sizeof r->err) ? (char *)text : NULL;
}

static bool save(struct registration *r, const char *name, const void *bytes, size_t size)
{
    char path[FILES_PATH_SIZE];

    data_path(r, name, path);
    return files_save(path, bytes, size, r->err, sizeof r->err);
}

static bool save_entry(struct registration *r, const char *entry)
{
    char quoted[2 * FILES_PATH_SIZE], text[3 * FILES_PATH_SIZE];
    const char *exec = strstr(entry, EXEC);

    desktop_quote(r->program, quoted, sizeof quoted);
    const int n =
        snprintf(text, sizeof text, "%.*sExec=\"%s\" %s" MARK, (int)(exec - entry), entry, quoted, exec + strlen(EXEC));
    return save(r, ENTRY, text, (size_t)n);
}

static bool write_files(struct registration *r)
{
    bool good = save_entry(r, (const char *)desktop_files[0].data);

    for (int i = 1; i < desktop_file_count && good; i++)
        good = save(r, desktop_files[i].name, desktop_files[i].data, desktop_files[i].size);
    return good;
}

static bool remove_files(struct registration *r)
{
    char path[FILES_PATH_SIZE];

    for (int i = desktop_file_count - 1; i >= 0; i--) {
        data_path(r, desktop_files[i].name, path);
        if (!plat_remove(path) && plat_file_size(path) >= 0)
            return result_set_host_error(r->err, sizeof r->err, "%s: cannot be removed", path);
    }
    return true;
}

/* ---- mimeapps.list ---- */

#define DEFAULTS "[Default Applications]\n"

static void type_line(int i, char line[LINE])
{
    snprintf(line, LINE, "%s=curtain.desktop\n", types[i].mime);
}

/* Returns the line that starts with `start`, or NULL. */
static char *find_line(char *text, const char *start)
{
    for (char *at = text; (at = strstr(at, start)) != NULL; at++)
        if (at == text || at[-1] == '\n')
            return at;
    return NULL;
}

static void delete_bytes(char *at, size_t n)
{
    memmove(at, at + n, strlen(at + n) + 1);
}

static void remove_defaults(char *text)
{
    char line[LINE], *at;

    for (int i = 0; i < TYPES; i++) {
        type_line(i, line);
        while ((at = find_line(text, line)) != NULL)
            delete_bytes(at, strlen(line));
    }
    at = find_line(text, DEFAULTS);
    if (at && at[strlen(DEFAULTS)] == 0) /* the section is empty */
        *at = 0;
}

/* Adds the lines to a text with enough memory. A type that has a default keeps it. */
static void add_defaults(char *text, bool second[TYPES])
{
    char line[LINE];

    if (!find_line(text, DEFAULTS)) {
        const size_t n = strlen(text);
        sprintf(text + n, "%s" DEFAULTS, n && text[n - 1] != '\n' ? "\n" : "");
    }
    for (int i = 0; i < TYPES; i++) {
        char *section = find_line(text, DEFAULTS) + strlen(DEFAULTS), *end = find_line(section, "[");
        snprintf(line, sizeof line, "%s=", types[i].mime);
        const char *other = find_line(section, line);
        second[i] = other && (!end || other < end);
        if (second[i])
            continue;
        type_line(i, line);
        memmove(section + strlen(line), section, strlen(section) + 1);
        memcpy(section, line, strlen(line));
    }
}

static bool set_defaults(struct registration *r, bool second[TYPES])
{
    static const char list[] = "applications/mimeapps.list";
    char path[FILES_PATH_SIZE], *old = read_text(r, list),
                                *text = old ? malloc(strlen(old) + sizeof DEFAULTS + 3 * LINE) : NULL;
    bool good = true;

    if (text) {
        memcpy(text, old, strlen(old) + 1);
        remove_defaults(text);
        if (!r->remove)
            add_defaults(text, second);
        data_path(r, list, path);
        if (text[0] == 0 && old[0] != 0)
            good = plat_remove(path) || result_set_host_error(r->err, sizeof r->err, "%s: cannot be removed", path);
        else if (strcmp(text, old) != 0)
            good = save(r, list, text, strlen(text));
    }
    good = good && text;
    free(old);
    free(text);
    return good;
}

/* ---- desktops ---- */

/* Runs a tool of the desktop that compiles a folder's files into an index. */
static bool run_tool(const struct registration *r, const char *tool, const char *folder)
{
    char path[FILES_PATH_SIZE];
    const char *const words[] = { tool, path, NULL };

    data_path(r, folder, path);
    FILE *f = plat_has_command(tool) ? plat_command_open(words) : NULL;
    return f && plat_command_close(f);
}

/* Finds the data folder, which is the parent of `user:`, and the program. */
static bool find_folders(struct registration *r)
{
    static const char own[] = "/curtain/";

    if (!plat_path("user:", r->data, sizeof r->data) || strlen(r->data) < sizeof own)
        return result_set_host_error(r->err, sizeof r->err, "cannot find your data folder; set HOME or XDG_DATA_HOME");
    r->data[strlen(r->data) - strlen(own)] = 0;
    if (!plat_program_path(r->program, sizeof r->program))
        return result_set_host_error(r->err, sizeof r->err, "cannot find this program's own file");
    if (desktop_can_name(r->program) && !strchr(r->program, '%')) /* GLib doesn't find a program with % in its path */
        return true;
    return err_set(r->err, sizeof r->err,
                   "register: %s: the program's path must not contain %%, line breaks or control characters",
                   r->program);
}

/* Registers with a desktop. If another command wrote the entry (make install PREFIX=~/.local), nothing is changed. */
static enum result register_desktop(struct registration *r)
{
    bool second[TYPES] = { false };
    char *entry = find_folders(r) ? read_text(r, ENTRY) : NULL;

    if (!entry)
        return report_error(r->err);
    const bool exists = entry[0], ours = strstr(entry, "\n" MARK) != NULL;
    free(entry);
    if (!ours && (exists || r->remove)) {
        report_print(exists ? "%s/%s was not written by curtain register; nothing was changed.\n"
                            : "Nothing to remove: %s/%s does not exist.\n",
                     r->data, ENTRY);
        return report_stdout(RESULT_DONE);
    }
    if (!set_defaults(r, second) || !(r->remove ? remove_files(r) : write_files(r)))
        return report_error(r->err);
    const bool known = run_tool(r, "update-mime-database", "mime");
    run_tool(r, "update-desktop-database", "applications");
    if (!known && !r->remove)
        return report_line(RESULT_HOST_FAILED,
                           "register: update-mime-database failed or is not installed (Debian package: "
                           "shared-mime-info); install it and run this command again");
    for (int i = 0; i < TYPES; i++)
        print_type(i, r->remove, second[i]);
    return report_stdout(RESULT_DONE);
}

enum result register_command(bool remove)
{
    struct registration r = { .remove = remove };

    if (embedded_rom_game()->rom)
        return report_line(RESULT_REFUSED, "register: this program is the exported game %s; use curtain",
                           embedded_rom_game()->m.title);
    if (!embedded_rom_has_window())
        return report_line(RESULT_REFUSED, "register: this program has no window; use curtain");
    for (int i = 0; i < TYPES; i++) {
        const enum plat_register_result is = plat_register_type(&types[i].file, !remove);
        if (is == PLAT_NO_REGISTRY)
            return register_desktop(&r);
        if (is == PLAT_NOT_REGISTERED)
            return report_line(RESULT_HOST_FAILED, "register: .%s: the registry cannot be changed",
                               types[i].file.extension);
        print_type(i, remove, is == PLAT_NOT_DEFAULT);
    }
    return report_stdout(RESULT_DONE);
}
