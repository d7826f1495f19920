/*
 * new.c - see new.h.
 */
#include "new.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../help/annotations.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../../player/settings/views.h"
#include "../../common/tree.h"
#include "game_name.h"
#include "../../common/result.h"

static const char LUARC[] = "{\n"
                            "  \"runtime.version\": \"Lua 5.4\",\n"
                            "  \"runtime.path\": [\"?.lua\"],\n"
                            "  \"runtime.builtin\": {\n"
                            "    \"coroutine\": \"disable\", \"debug\": \"disable\", \"io\": \"disable\", \"os\": "
                            "\"disable\", \"package\": \"disable\"\n"
                            "  },\n"
                            "  \"workspace.library\": [\".curtain.lua\", \".curtain-test.lua\"]\n"
                            "}\n";

enum { GAMES = 16 /* listed in an error */ };

struct new_game_files {
    const char *dir, *from;
    char name[GAME_TITLE_SIZE], id[GAME_ID_SIZE];
    char *path[256]; /* of written files, relative to dir */
    int n;
};

/* ---- files ---- */

/* Returns the path in the game's folder; NULL: the file belongs to another game. */
static const char *path_in_game(const char *from, const char *name)
{
    const size_t n = strlen(from);

    return strncmp(name, from, n) == 0 && name[n] == '/' ? name + n + 1 : NULL;
}

static bool is_known_game(const char *from)
{
    for (int i = 0; i < start_file_count; i++)
        if (path_in_game(from, start_files[i].name))
            return true;
    return false;
}

/* Writes the names of the games: "bulletml, first or shooter". */
static void list_games(char *out, size_t size)
{
    char names[GAMES][32];
    const char *list[GAMES + 1] = { NULL };
    int n = 0;

    for (int i = 0; i < start_file_count && n < GAMES; i++) {
        const char *name = start_files[i].name;
        if (n > 0 && path_in_game(list[n - 1], name))
            continue;
        snprintf(names[n], sizeof names[n], "%.*s", (int)strcspn(name, "/"), name);
        list[n] = names[n];
        n++;
    }
    views_list(list, out, size);
}

/* Removes the written files and their folders; folders with other files remain. */
static void remove_written(const struct new_game_files *s, bool existed)
{
    char path[TREE_PATH];

    for (int i = s->n - 1; i >= 0; i--) {
        if (!tree_join(path, s->dir, s->path[i]))
            continue;
        plat_remove(path);
        for (char *slash; (slash = strrchr(path, '/')) != NULL && (size_t)(slash - path) > strlen(s->dir);) {
            *slash = '\0';
            plat_remove(path);
        }
    }
    if (!existed && files_count_entries(s->dir) >= 0) /* a dangling link is the user's */
        plat_remove(s->dir);
}

static bool save(struct new_game_files *s, const char *name, const void *data, size_t size, char *err, size_t err_size)
{
    char path[TREE_PATH];

    if (!tree_join(path, s->dir, name) || s->n == (int)(sizeof s->path / sizeof *s->path)) {
        snprintf(err, err_size, "%s: path too long", s->dir);
        return false;
    }
    s->path[s->n++] = (char *)name;
    return files_save(path, data, size, err, err_size);
}

/* ---- names in the files ---- */

/* Appends a text, escaped for a Lua string. */
static void add_quoted(struct byte_buffer *p, const char *text)
{
    for (; *text != '\0'; text++)
        byte_buffer_print(p, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
}

/* Appends the text, with the part between the first `before` and the next `after` replaced. */
static void add_replaced(struct byte_buffer *p, const char *text, const char *before, char after, const char *with)
{
    const char *at = strstr(text, before), *end = at ? strchr(at + strlen(before), after) : NULL;

    if (end) {
        byte_buffer_print(p, "%.*s", (int)(at - text + (long)strlen(before)), text);
        add_quoted(p, with);
        text = end;
    }
    byte_buffer_print(p, "%s", text);
}

/* Saves rom.lua with the game's id and title, README.md with its title, and any other file unchanged. */
static bool save_named(struct new_game_files *s, const char *name, const struct embedded *file, char *err,
                       size_t err_size)
{
    const bool rom = strcmp(name, "rom.lua") == 0, page = strcmp(name, "README.md") == 0;
    const bool titled = game_name_has_glyphs(s->name);
    struct byte_buffer first = { 0 }, text = { 0 };

    if ((!rom && !page) || (page && !titled))
        return save(s, name, file->data, file->size, err, err_size);
    byte_buffer_print(&first, "%.*s", (int)file->size, (const char *)file->data);
    const char *old = byte_buffer_text(&first);
    if (page) {
        byte_buffer_print(&text, "# %s%s", s->name, old + strcspn(old, "\n"));
    } else {
        struct byte_buffer with_id = { 0 };
        add_replaced(&with_id, old, "id = \"", '"', s->id);
        if (titled)
            add_replaced(&text, byte_buffer_text(&with_id), "title = \"", '"', s->name);
        else
            byte_buffer_print(&text, "%s", byte_buffer_text(&with_id));
        text.failed = text.failed || with_id.failed;
        byte_buffer_close(&with_id);
    }
    bool good = !text.failed && !first.failed;
    if (!good)
        result_set_host_error(err, err_size, "out of memory");
    good = good && save(s, name, text.bytes, text.n, err, err_size);
    free(first.bytes);
    free(text.bytes);
    return good;
}

/* Saves annotations for editors. */
static bool save_api(struct new_game_files *s, const char *name, void (*write)(struct byte_buffer *), char *err,
                     size_t err_size)
{
    struct byte_buffer api = { 0 };

    write(&api);
    if (api.failed)
        result_set_host_error(err, err_size, "out of memory");
    bool good = !api.failed && save(s, name, api.bytes, api.n, err, err_size);
    free(api.bytes);
    return good;
}

static bool save_editors(struct new_game_files *s, char *err, size_t err_size)
{
    return save_api(s, ".curtain.lua", annotations_write, err, err_size) &&
           save_api(s, ".curtain-test.lua", annotations_test_write, err, err_size) &&
           save(s, ".luarc.json", LUARC, sizeof LUARC - 1, err, err_size);
}

static bool save_all(struct new_game_files *s, char *err, size_t err_size)
{
    bool good = true;

    for (int i = 0; i < start_file_count && good; i++) {
        const char *name = path_in_game(s->from, start_files[i].name);
        good = !name || save_named(s, name, &start_files[i], err, err_size);
    }
    return good && save_editors(s, err, err_size);
}

/* ---- the command ---- */

/* Appends dir, quoted for a shell. */
static void add_shell_word(struct byte_buffer *p, const char *dir)
{
    if (dir[0] == '-')
        byte_buffer_print(p, "./");
    if (dir[strspn(dir, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./")] == '\0') {
        byte_buffer_print(p, "%s", dir);
        return;
    }
    byte_buffer_print(p, "'");
    for (; *dir != '\0'; dir++)
        byte_buffer_print(p, *dir == '\'' ? "'\\%c'" : "%c", *dir);
    byte_buffer_print(p, "'");
}

static void print_next_steps(const struct new_game_files *s)
{
    static const struct {
        const char *words, *what;
    } next[] = { { "play", "play it; the game reloads when you save a file" },
                 { "check", "look for mistakes" },
                 { "test", "run its tests" } };
    struct byte_buffer text = { 0 };

    add_shell_word(&text, s->dir);
    if (!text.failed) {
        report_print("%s: new game, %d files; see its README.md. Next:\n", s->dir, s->n);
        for (size_t i = 0; i < sizeof next / sizeof *next; i++)
            report_print("  curtain %-5s %-20s %s\n", next[i].words, text.bytes, next[i].what);
    }
    free(text.bytes);
}

enum result new_game(const char *dir, const char *from)
{
    struct new_game_files s = { .dir = dir, .from = from ? from : "shooter" };
    char games[256];
    char err[FILES_ERR_SIZE];

    if (!is_known_game(s.from)) {
        list_games(games, sizeof games);
        return report_line(RESULT_REFUSED, "--from: expected %s, got \"%s\"", games, s.from);
    }
    if (!game_name_of_folder(dir, s.name))
        return report_line(RESULT_REFUSED, "new: \"%s\" is not a valid game name; expected a folder to create", dir);
    game_name_id(s.name, s.id);
    if (files_size(dir) >= 0)
        return report_line(RESULT_REFUSED, "%s: a file with this name exists; choose another name", dir);
    const int files = files_count_entries(dir);
    if (files > 0)
        return report_line(RESULT_REFUSED, "%s: this folder is not empty; choose a new or empty one", dir);
    if (!save_all(&s, err, sizeof err)) {
        remove_written(&s, files == 0);
        return report_line(RESULT_HOST_FAILED, "%s", err);
    }
    print_next_steps(&s);
    return report_stdout(RESULT_DONE);
}
