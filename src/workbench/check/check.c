/*
 * check.c - see check.h. The checks are in check_lua.c, check_art.c, check_unused.c, check_run.c and others. Each check
 * does what is possible with the files that could be read; only check_run.c needs a game that can be packed.
 */
#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "check_parts.h"
#include "../../common/clean.h"
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"

/* ---- rom.lua ---- */

static void check_entry(struct check *c)
{
    char path[TREE_PATH];

    snprintf(path, sizeof path, "%s.lua", c->m.entry);
    if (tree_has(&c->files, path))
        return;
    diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, "entry"), "entry: %s does not exist", path);
    c->broken = true;
}

static void check_manifest(struct check *c)
{
    char folder[64], err[512] = "rom.lua: out of memory";
    void *block, *work = tree_work(MANIFEST_SCRATCH_SIZE, &block);
    size_t size;

    if (!check_load(c, "rom.lua", TREE_SCRIPT, &c->rom_text, &size)) {
        free(block);
        return;
    }
    files_strip_bom(c->rom_text, &size);
    tree_id(c->dir, folder);
    symbols_read(&c->rom, (const char *)c->rom_text, size, NULL);
    c->manifest = work != NULL && manifest_read((const char *)c->rom_text, size, "rom.lua", folder, &c->m, &c->art,
                                                work, err, sizeof err);
    if (c->manifest) {
        check_entry(c);
    } else {
        check_rom_sentence(c, err);
        c->broken = true;
    }
    free(block);
}

/* Without an id, the folder's name is the id, and a renamed folder is another game. */
static void check_id(struct check *c)
{
    if (c->manifest && !symbols_returns(&c->rom, "id"))
        diagnostics_add(
            &c->found, "rom.lua", 0,
            "no id, so the folder's name is used: if you rename the folder, the game loses its demos, saves and "
            "scores; add id = \"%s\"",
            c->m.id);
}

/* ---- the folder ---- */

/* Lists the files of the folder. False: it is not a game's folder, and *result is set. */
static bool open_folder(struct check *c, enum result *result)
{
    char err[2 * TREE_PATH];

    *result = RESULT_REFUSED;
    if (files_size(c->dir) >= 0)
        report_line(*result, "%s: expected a game's folder, got a file", c->dir);
    else if (files_count_entries(c->dir) < 0)
        report_line(*result, "%s", files_set_missing_error(c->dir, "folder", err, sizeof err));
    else if (!tree_walk(c->dir, &c->files, err, sizeof err))
        *result = report_error(err);
    else if (!tree_has(&c->files, "rom.lua"))
        report_line(*result, "%s: not a game's folder: it has no rom.lua", c->dir);
    else
        return true;
    return false;
}

static void check_close(struct check *c)
{
    for (int i = 0; i < c->n_scripts; i++) {
        symbols_free(&c->scripts[i].symbols);
        free(c->scripts[i].text);
    }
    for (int i = 0; i < c->n_library; i++)
        symbols_free(&c->library[i].symbols);
    for (int i = 0; i < c->n_texts; i++)
        free(c->texts[i].bytes);
    free(c->scripts);
    free(c->library);
    free(c->texts);
    symbols_free(&c->rom);
    free(c->rom_text);
    name_set_free(&c->builtins);
    name_set_free(&c->open);
    name_set_free(&c->changed);
    diagnostics_close(&c->found);
    tree_close(&c->files);
}

/* ---- the report ---- */

static void print_line(const char *line)
{
    puts(line);
}

/* Writes "2 demos" or "1 demo". */
static void count(char out[32], int n, const char *what)
{
    snprintf(out, 32, "%d %s%s", n, what, n == 1 ? "" : "s");
}

static void print_summary(const struct check *c)
{
    char scripts[32], sprites[32], demos[32], samples[32], sections[32], forced[32], enough[64] = "";
    char line[TREE_PATH + 256];
    size_t room = (size_t)c->m.lua_kib * 1024;
    const int32_t lua_kib = ram_enough_lua_kib(c->lua_peak);

    count(scripts, c->n_scripts, "script");
    count(sprites, c->art.n_sprites, "sprite");
    count(demos, c->demos, "demo");
    snprintf(sections, sizeof sections, c->sections == 1 ? "%d stage or phase" : "%d stages and phases", c->sections);
    count(samples, c->samples, "frame");
    count(forced, c->forced, "forced run");
    if (lua_kib < c->m.lua_kib)
        snprintf(enough, sizeof enough, ", board.lua_kib = %d is enough", (int)lua_kib);
    snprintf(line, sizeof line,
             "%s: no problems: %s, %s; played %s, %s, %s; sampled %s for contrast; theme contrast %d.%02d "
             "(ink), %d.%02d (accent); Lua RAM %d %% of %d KiB%s",
             c->dir, scripts, sprites, demos, sections, forced, samples, c->ink_contrast / 100, c->ink_contrast % 100,
             c->accent_contrast / 100, c->accent_contrast % 100, (int)((c->lua_peak * 100 + room - 1) / room),
             (int)c->m.lua_kib, enough);
    clean_line(line);
    puts(line);
    puts(c->ram);
}

static enum result report(struct check *c)
{
    char problems[32];

    diagnostics_sort(&c->found);
    diagnostics_print(&c->found, print_line);
    const int wrong = c->found.n - c->found.notes;
    count(problems, wrong, "problem");
    if (wrong == 0)
        print_summary(c);
    else
        report_print("%s%s\n", problems, c->broken ? "; the game was not run because it cannot be packed" : "");
    return report_stdout(wrong > 0 ? RESULT_DIFFERS : RESULT_DONE);
}

static enum result check_all(struct check *c)
{
    progress_begin();
    check_manifest(c);
    check_id(c);
    check_scripts(c);
    check_lua(c);
    check_sounds(c);
    check_art(c);
    check_recordings(c);
    check_bulletml(c);
    check_langs(c);
    check_unused(c);
    check_spells(c);
    if (!c->broken)
        check_run(c);
    progress_end();
    if (c->found.failed || c->builtins.failed || c->open.failed || c->changed.failed)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    return report(c);
}

enum result check_game(const char *dir, bool nearest)
{
    struct check *c = calloc(1, sizeof *c);
    enum result result;

    if (c == NULL)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    c->dir = dir;
    c->nearest = nearest;
    if (open_folder(c, &result))
        result = check_all(c);
    check_close(c);
    free(c);
    return result;
}
