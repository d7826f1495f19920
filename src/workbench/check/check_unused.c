/*
 * check_unused.c - files, pictures and names that the game does not use.
 *
 * A name counts as used if it is anywhere in the game: as a string, a key, a field, a word of a text, or a DIP switch
 * of rom.lua. It also counts as used if a script may compose it: if it starts with a string before `..`, ends with a
 * string after `..`, or matches a format. A reported name is therefore unused, unless a script composes it letter by
 * letter.
 */
#include "check_parts.h"
#include "../../rom/cart.h"
#include "../pack/pack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool starts_with(const char *s, const char *head)
{
    return strncmp(s, head, strlen(head)) == 0;
}

static bool ends_with(const char *s, const char *tail)
{
    size_t n = strlen(s), m = strlen(tail);

    return n >= m && strcmp(s + n - m, tail) == 0;
}

/* ---- used names ---- */

/* Returns whether the format may produce the name: "bead%d" may produce "bead1". The text before the first conversion
 * or after the last must match. */
static bool matches_format(const char *name, const char *format)
{
    size_t n = strcspn(format, "%");
    const char *last = strrchr(format, '%');

    if (last == NULL)
        return false;
    if (n > 0 && strncmp(name, format, n) == 0)
        return true;
    last += 1 + strspn(last + 1, "-+ #0123456789.");
    return *last != '\0' && last[1] != '\0' && ends_with(name, last + 1);
}

static bool may_produce(const struct symbol_text *t, const char *name)
{
    if (strcmp(t->s, name) == 0)
        return true;
    if (t->how & SYMBOL_KEY || t->s[0] == '\0')
        return false;
    if (t->how == (SYMBOL_FIRST | SYMBOL_LAST))
        return strstr(name, t->s) != NULL;
    return (t->how == SYMBOL_FIRST && starts_with(name, t->s)) || (t->how == SYMBOL_LAST && ends_with(name, t->s)) ||
           matches_format(name, t->s);
}

static bool in_scripts(const struct check *c, const char *name)
{
    for (int i = 0; i < c->n_scripts; i++)
        for (int k = 0; k < c->scripts[i].symbols.n_texts; k++)
            if (may_produce(&c->scripts[i].symbols.texts[k], name))
                return true;
    return false;
}

/* Returns whether the library contains the name as a string, such as "logo". */
static bool in_library(const struct check *c, const char *name)
{
    for (int i = 0; i < c->n_library; i++) {
        const struct symbols *f = &c->library[i].symbols;
        for (int k = 0; k < f->n_texts; k++)
            if (!(f->texts[k].how & SYMBOL_KEY) && strcmp(f->texts[k].s, name) == 0)
                return true;
    }
    return false;
}

static bool word_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

static bool in_texts(const struct check *c, const char *name)
{
    size_t n = strlen(name);

    for (int i = 0; i < c->n_texts; i++) {
        const char *all = (const char *)c->texts[i].bytes;
        for (const char *p = all; (p = strstr(p, name)) != NULL; p++)
            if ((p == all || !word_char(p[-1])) && !word_char(p[n]))
                return true;
    }
    return false;
}

/* Returns whether it is a name that board.dip or board.difficulty returns, or one in `theme`. */
static bool in_manifest(const struct check *c, const char *name)
{
    const struct art_theme *t = &c->art.theme;

    if (strcmp(t->frame, name) == 0)
        return true;
    for (int i = 0; i < THEME_SOUNDS; i++)
        if (strcmp(t->sounds[i], name) == 0)
            return true;
    for (int i = 0; i < c->m.n_difficulties; i++)
        if (strcmp(c->m.difficulties[i], name) == 0)
            return true;
    for (int i = 0; i < c->m.n_dips; i++)
        for (int k = 0; k < c->m.dips[i].n_values; k++)
            if (strcmp(c->m.dips[i].value_name[k], name) == 0)
                return true;
    return false;
}

bool check_is_mentioned(const struct check *c, const char *name)
{
    return in_scripts(c, name) || in_library(c, name) || in_texts(c, name) || in_manifest(c, name);
}

/* ---- scripts ---- */

/* Returns whether space.name (or the global name) is used as a value, or called without a string. */
static bool is_dynamic(const struct check *c, const char *space, const char *name)
{
    int uses = 0, calls = 0;

    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_globals; k++) {
            const struct symbol_global *g = &f->globals[k];
            uses += space != NULL ? symbols_same(g->field, name) && symbols_same(g->name, space)
                                  : g->use == USE_VALUE && symbols_same(g->name, name);
            uses += space != NULL && g->use == USE_VALUE && symbols_same(g->name, space);
        }
        for (int k = 0; k < f->n_calls; k++) {
            const struct symbol_call *call = &f->calls[k];
            calls += symbol_call_is(call, space, name) && call->arg[0] != NULL;
        }
    }
    return uses != calls;
}

static struct check_script *find_script(struct check *c, const char *name)
{
    for (int i = 0; i < c->n_scripts; i++)
        if (strcmp(c->scripts[i].name, name) == 0)
            return &c->scripts[i];
    return NULL;
}

static void mark_reached(struct check *c, struct check_script *s)
{
    if (s == NULL || s->reached)
        return;
    s->reached = true;
    for (int k = 0; k < s->symbols.n_calls; k++) {
        const struct symbol_call *call = &s->symbols.calls[k];
        if (symbol_call_is(call, NULL, "require") && call->arg[0] != NULL)
            mark_reached(c, find_script(c, call->arg[0]));
    }
}

static void find_unused_scripts(struct check *c)
{
    if (is_dynamic(c, NULL, "require"))
        return;
    mark_reached(c, find_script(c, c->m.entry));
    for (int i = 0; i < c->n_scripts; i++)
        if (starts_with(c->scripts[i].path, "std/"))
            mark_reached(c, &c->scripts[i]);
    for (int i = 0; i < c->n_scripts; i++)
        if (!c->scripts[i].reached)
            diagnostics_add(&c->found, c->scripts[i].path, 0, "no script requires it");
}

/* ---- names and files of rom.lua ---- */

static bool is_sheet_used(const struct check *c, int sheet)
{
    for (int i = 0; i < c->art.n_sprites; i++)
        if (c->art.sprites[i].sheet == sheet)
            return true;
    return false;
}

/* Adds a finding for a name in rom.lua that no script mentions. */
static void check_used(struct check *c, const char *section, const char *what, const char *name)
{
    if (!check_is_mentioned(c, name))
        diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, section, name), "%s \"%s\" is not used by any script", what,
                        name);
}

static void find_unused_names(struct check *c)
{
    const struct art *a = &c->art;

    for (int i = 0; i < a->n_sheets; i++)
        if (!is_sheet_used(c, i))
            diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, "sheets", a->sheets[i].name),
                            "sheet \"%s\" has no sprites", a->sheets[i].name);
    for (int i = 0; i < a->n_sprites; i++)
        check_used(c, "sprites", "sprite", a->sprites[i].name);
    for (int i = 0; i < a->n_blends; i++)
        check_used(c, "blends", "blend", a->blends[i].name);
    for (int i = 0; i < a->n_palettes; i++)
        check_used(c, "palettes", "palette", a->palettes[i].name);
    for (int i = 0; i < a->n_maps; i++)
        check_used(c, "maps", "map", a->maps[i].name);
}

/* Returns whether the bytes contain "sample NAME". */
static bool names_sample(const uint8_t *bytes, size_t size, const char *name)
{
    const size_t n = strlen(name);

    for (size_t i = 0; i + 7 + n <= size; i++)
        if (memcmp(bytes + i, "sample ", 7) == 0 && memcmp(bytes + i + 7, name, n) == 0 &&
            (i + 7 + n == size || bytes[i + 7 + n] <= ' '))
            return true;
    return false;
}

/* Returns whether an instrument in a .mml file plays the sound. */
static bool in_music(struct check *c, const char *name)
{
    bool found = false;

    for (int i = 0; i < c->files.n && !found; i++) {
        uint8_t *bytes;
        size_t size;
        if (!ends_with(c->files.name[i], ".mml") || !check_load(c, c->files.name[i], TREE_FILE, &bytes, &size))
            continue;
        found = names_sample(bytes, size, name);
        free(bytes);
    }
    return found;
}

static bool is_cue(const char *sound)
{
    for (int i = 0; i < CART_CUES; i++)
        if (strcmp(sound, cart_cue_names[i]) == 0)
            return true;
    return false;
}

static void find_unused_sounds(struct check *c)
{
    for (int i = 0; i < c->art.n_sounds; i++)
        if (!is_cue(c->art.sounds[i].name) && !check_is_mentioned(c, c->art.sounds[i].name) &&
            !in_music(c, c->art.sounds[i].name))
            check_used(c, "sounds", "sound", c->art.sounds[i].name);
    for (int i = 0; i < c->art.n_tunes; i++)
        check_used(c, "music", "music", c->art.tunes[i].name);
}

/* Returns whether rom.lua lists the file as a sound or as music. */
static bool is_sound_file(const struct check *c, const char *path)
{
    for (int i = 0; i < c->art.n_sounds; i++)
        if (strcmp(path, c->art.sounds[i].file) == 0)
            return true;
    for (int i = 0; i < c->art.n_tunes; i++)
        if (strcmp(path, c->art.tunes[i].file) == 0)
            return true;
    return false;
}

static bool is_picture_used(const struct check *c, const char *path)
{
    bool used = strcmp(path, c->art.palette) == 0 || strcmp(path, c->art.font) == 0 ||
                strcmp(path, c->art.border) == 0 || strcmp(path, c->art.icon) == 0;

    for (int i = 0; i < c->art.n_palettes; i++)
        used = used || strcmp(path, c->art.palettes[i].file) == 0;
    for (int i = 0; i < c->art.n_fonts; i++)
        used = used || strcmp(path, c->art.fonts[i].file) == 0;
    for (int i = 0; i < c->art.n_sheets; i++)
        used = used || strcmp(path, c->art.sheets[i].file) == 0;
    for (int i = 0; i < c->art.n_maps; i++)
        for (int k = 0; k < c->art.maps[i].n_tile_files; k++)
            used = used || strcmp(path, c->art.maps[i].tile_files[k]) == 0;
    return used;
}

static void find_unused_files(struct check *c, bool texts)
{
    for (int i = 0; i < c->files.n; i++) {
        const char *path = c->files.name[i];
        if ((ends_with(path, ".png") || art_is_ase(path)) && !is_picture_used(c, path))
            diagnostics_add(&c->found, path, 0, "not listed in rom.lua");
        if ((art_is_recording(path) || ends_with(path, ".mml")) && !is_sound_file(c, path))
            diagnostics_add(&c->found, path, 0, "not listed in rom.lua");
        if (texts && ends_with(path, ".txt") && !pack_is_lang(path) && !in_scripts(c, path))
            diagnostics_add(&c->found, path, 0, "packed, but not read by any script");
    }
}

static void read_texts(struct check *c)
{
    c->texts = calloc((size_t)c->files.n + 1, sizeof *c->texts);
    for (int i = 0; c->texts != NULL && i < c->files.n; i++) {
        size_t size;
        struct check_text *t = &c->texts[c->n_texts];
        t->path = c->files.name[i];
        if (ends_with(t->path, ".txt") && check_load(c, t->path, TREE_FILE, &t->bytes, &size))
            c->n_texts++;
    }
}

/* If a script cannot be parsed, most checks are skipped, because it may use anything. */
void check_unused(struct check *c)
{
    bool whole = check_all_parsed(c);

    if (!c->manifest)
        return;
    read_texts(c);
    if (whole) {
        find_unused_scripts(c);
        find_unused_names(c);
        find_unused_sounds(c);
    }
    find_unused_files(c, whole && !is_dynamic(c, "rom", "text"));
}
