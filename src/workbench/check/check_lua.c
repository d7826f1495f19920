/*
 * check_lua.c - mistakes in scripts, found without running them.
 *
 * All scripts are read first, because a field that one script adds to a table of the API exists for all. A missing name
 * is reported only if no script can have added it: if a table of the API, or _G, is used as a value, any name may be in
 * it.
 */
#include "check_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../script/api/api_table.h"
#include "../../script/script.h"
#include "../../common/files.h"
#include "../pack/pack.h"

/* ---- reading ---- */

static void scan(struct check *c, const struct check_script *s, size_t size)
{
    struct script_position place = { 0, 1 };
    const char *what;
    int line;

    while (!script_scan_from((const char *)s->text, size, &place, &line, &what)) {
        diagnostics_add(&c->found, s->path, line, "%s", what);
        c->broken = true;
    }
}

static void compile(struct check *c, const struct check_script *s, size_t size)
{
    void *block, *work = tree_work(TREE_WORK, &block);
    char chunk[TREE_PATH], err[512] = "out of memory";

    snprintf(chunk, sizeof chunk, "@%s", s->path);
    if (work == NULL || !script_compile((const char *)s->text, size, chunk, work, TREE_WORK, err, sizeof err)) {
        diagnostics_add_sentence(&c->found, s->path, err);
        c->broken = true;
    }
    free(block);
}

static void read_script(struct check *c, const char *path)
{
    struct check_script *s = &c->scripts[c->n_scripts];
    size_t size;

    if (!manifest_path_ok(path)) {
        check_add_broken(c, path, 0, "expected a name of letters, digits, _ - and . only");
        return;
    }
    if (strncmp(path, "std/", 4) == 0 && !pack_is_std(path)) {
        check_add_broken(c, path, 0, "the standard library has no script with this name");
        return;
    }
    *s = (struct check_script){ .path = path };
    if (!check_load(c, path, TREE_SCRIPT, &s->text, &size))
        return;
    c->n_scripts++;
    files_strip_bom(s->text, &size);
    snprintf(s->name, sizeof s->name, "%.*s", (int)(strlen(path) - strlen(".lua")), path);
    scan(c, s, size);
    compile(c, s, size);
    symbols_read(&s->symbols, (const char *)s->text, size, builtins_global);
}

static bool is_replaced(const struct check *c, const char *name)
{
    char path[64];

    snprintf(path, sizeof path, "std/%s.lua", name);
    return tree_has(&c->files, path);
}

static void read_library(struct check *c)
{
    for (int i = 0; i < std_script_count; i++) {
        struct check_script *s = &c->library[c->n_library];
        if (is_replaced(c, std_scripts[i].name))
            continue;
        c->n_library++;
        snprintf(s->name, sizeof s->name, "std/%s", std_scripts[i].name);
        symbols_read(&s->symbols, (const char *)std_scripts[i].data, std_scripts[i].size, builtins_global);
    }
}

void check_scripts(struct check *c)
{
    c->scripts = calloc((size_t)c->files.n + 1, sizeof *c->scripts);
    c->library = calloc((size_t)std_script_count + 1, sizeof *c->library);
    if (c->scripts == NULL || c->library == NULL) {
        c->found.failed = true;
        return;
    }
    for (int i = 0; i < c->files.n; i++)
        if (files_has_suffix(c->files.name[i], ".lua") && strcmp(c->files.name[i], "rom.lua") != 0)
            read_script(c, c->files.name[i]);
    read_library(c);
}

/* ---- known names ---- */

static void add_library(struct check *c, const struct check_script *s)
{
    const char *name = s->name + strlen("std/");

    if (strncmp(s->name, "std/", 4) == 0 && !builtins_add_library(&c->builtins, name, &s->symbols))
        name_set_add(&c->open, NULL, name);
}

/* Records which names the use of a global may change. */
static void add_use(struct check *c, const struct symbol_global *g)
{
    bool all = strcmp(g->name, "_G") == 0 || strcmp(g->name, "_ENV") == 0;

    if (g->use == USE_MEMBER || g->use == USE_SELF) {
        name_set_add(&c->builtins, g->name, g->field);
        name_set_add(&c->changed, g->name, g->field);
    }
    if (g->use == USE_WRITE)
        name_set_add(&c->changed, NULL, g->name);
    if (g->use != USE_VALUE && g->use != USE_WRITE && g->use != USE_SELF)
        return;
    c->any_global = c->any_global || all;
    name_set_add(&c->open, NULL, g->name);
}

static void collect_names(struct check *c)
{
    builtins_open(&c->builtins);
    for (int i = 0; i < c->n_library; i++)
        add_library(c, &c->library[i]);
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        add_library(c, &c->scripts[i]);
        for (int k = 0; k < f->n_globals; k++)
            add_use(c, &f->globals[k]);
    }
}

/* Returns whether a script of the game may have replaced the function. */
static bool is_changed(const struct check *c, const char *space, const char *name)
{
    return (space != NULL && name_set_has(&c->open, NULL, space)) || name_set_has(&c->changed, space, name);
}

/* ---- names ---- */

/* Writes " (did you mean "speed"?)", or "". */
static void make_hint(char out[96], const char *word, const char *near, const char *local)
{
    bool use_local = local != NULL && (near == NULL || edit_distance(word, local) <= edit_distance(word, near));
    const char *meant = use_local ? local : near;

    out[0] = '\0';
    if (meant != NULL)
        snprintf(out, 96, " (did you mean \"%s\"?)", meant);
}

static void report_unknown_global(struct check *c, const char *path, const struct symbol_global *g)
{
    const char *instead = api_replacement(NULL, g->name);
    char meant[96];

    if (instead != NULL && g->use != USE_WRITE) {
        diagnostics_add(&c->found, path, g->line, "%s is not available (%s)", g->name, instead);
        return;
    }
    const char *near = g->use == USE_WRITE ? NULL : name_set_nearest(&c->builtins, NULL, g->name);
    make_hint(meant, g->name, near, g->local);
    if (api_is_reserved(g->name) && g->use != USE_WRITE)
        diagnostics_add(&c->found, path, g->line, "undeclared global \"%s\" (%s %s)%s", g->name, g->name,
                        RESERVED_MESSAGE, g->local != NULL ? meant : "");
    else if (g->use == USE_WRITE && meant[0] == '\0')
        diagnostics_add(&c->found, path, g->line,
                        "undeclared global \"%s\" (scripts cannot create globals; write \"local %s\")", g->name,
                        g->name);
    else
        diagnostics_add(&c->found, path, g->line, "undeclared global \"%s\"%s", g->name, meant);
}

static void report_unknown_field(struct check *c, const char *path, const struct symbol_global *g)
{
    const char *instead = api_replacement(g->name, g->field);
    char meant[96];

    make_hint(meant, g->field, name_set_nearest(&c->builtins, g->name, g->field), NULL);
    if (instead != NULL)
        diagnostics_add(&c->found, path, g->line, "%s.%s is not available (%s)", g->name, g->field, instead);
    else
        diagnostics_add(&c->found, path, g->line, "%s has no \"%s\"%s", g->name, g->field, meant);
}

/* Returns whether a script that cannot be parsed contains the word: it may declare it. */
static bool in_broken_script(const struct check *c, const char *word)
{
    for (int i = 0; i < c->n_scripts; i++)
        if (!c->scripts[i].symbols.complete && strstr((const char *)c->scripts[i].text, word) != NULL)
            return true;
    return false;
}

static bool has_fields(const struct check *c, const char *space)
{
    for (int i = 0; i < c->builtins.n; i++)
        if (symbols_same(c->builtins.list[i].space, space))
            return true;
    return false;
}

static const struct api_entry *find_api_entry(const char *space, const char *name)
{
    char full[96];

    snprintf(full, sizeof full, "%s%s%s", space != NULL ? space : "", space != NULL ? "." : "", name);
    return api_find_entry(&api_table, full);
}

/* Returns whether a table may have unknown fields. Code that `load` runs may change any table. */
static bool is_open(const struct check *c, const char *space)
{
    return c->any_global || name_set_has(&c->open, NULL, space) || name_set_has(&c->open, NULL, "load");
}

static void check_global(struct check *c, const char *path, const struct symbol_global *g)
{
    const char *line = c->manifest ? api_disabled_reason(&c->m, g->name) : NULL;

    if (strcmp(g->name, "_G") == 0 || strcmp(g->name, "_ENV") == 0)
        return;
    if (line && !api_is_reserved(g->name)) {
        diagnostics_add(&c->found, path, g->line, "%s: " API_DISABLED_FORMAT, g->name, line);
        return;
    }
    if (!name_set_has(&c->builtins, NULL, g->name)) {
        if (!c->any_global)
            report_unknown_global(c, path, g);
        return;
    }
    bool read = g->use == USE_FIELD || g->use == USE_METHOD;
    if (!read || is_open(c, g->name) || !has_fields(c, g->name) || in_broken_script(c, g->field))
        return;
    if (!name_set_has(&c->builtins, g->name, g->field))
        report_unknown_field(c, path, g);
    else if (g->use == USE_METHOD && find_api_entry(g->name, g->field) != NULL && !is_changed(c, g->name, g->field))
        diagnostics_add(&c->found, path, g->line, "%s:%s: call it with a dot, as %s.%s", g->name, g->field, g->name,
                        g->field);
}

/* ---- values ---- */

static void check_iteration(struct check *c, const char *path, const struct symbol_iteration *w)
{
    const char *space = w->origin.space, *dot = space != NULL ? "." : "";
    const char *handle = w->origin.arg == 0 ? builtins_handle(space, w->origin.name) : NULL;
    bool handed = w->origin.arg > 0 && builtins_is_handle_param(&w->origin);

    if ((handle == NULL && !handed) || is_changed(c, space, w->origin.name) || is_changed(c, NULL, w->operation))
        return;
    space = space != NULL ? space : "";
    bool group = handle != NULL && strcmp(handle, "group") == 0;
    if (handed)
        diagnostics_add(&c->found, path, w->line, "%s: %s%s%s passes a handle to its function, not a table",
                        w->operation, space, dot, w->origin.name);
    else
        diagnostics_add(&c->found, path, w->line, "%s: %s%s%s returns a handle of kind %s, not a table%s%s%s",
                        w->operation, space, dot, w->origin.name, handle, group ? " (" : "", group ? space : "",
                        group ? ".each visits each member)" : "");
}

static void check_division(struct check *c, const char *path, const struct symbol_division *z)
{
    if (strcmp(z->operation, "/") != 0)
        diagnostics_add(&c->found, path, z->line, "%s 0 is an error when both operands are integers", z->operation);
    else if (z->left_is_zero)
        diagnostics_add(&c->found, path, z->line, "0/0 is NaN: it equals nothing, and the board rejects it");
    else if (z->left_is_number)
        diagnostics_add(&c->found, path, z->line,
                        "division by 0: the board rejects infinite values (use math.huge to compare)");
    else
        diagnostics_add(&c->found, path, z->line, "division by 0: the result is infinite or NaN");
}

static void check_format(struct check *c, const struct check_script *s, const struct symbol_text *t)
{
    for (const char *p = t->s; (p = strchr(p, '%')) != NULL; p++) {
        p += 1 + strspn(p + 1, "-+ #0123456789.");
        if (*p == 'p')
            diagnostics_add(&c->found, s->path, t->line, "%%p is not available (addresses differ between runs)");
        if (*p == 'a' || *p == 'A')
            diagnostics_add(&c->found, s->path, t->line,
                            "%%%c is not available (its output differs between machines; use %%.17g)", *p);
        if (*p == '\0')
            return;
    }
}

/* ---- names of files and of rom.lua ---- */

static void check_require(struct check *c, const struct check_script *s, const struct symbol_call *call)
{
    const char *name = call->arg[0];
    char path[TREE_PATH], there[TREE_PATH], meant[SCRIPT_NAME_BYTES];

    if (!symbol_call_is(call, NULL, "require") || name == NULL || name[0] == '@')
        return;
    snprintf(path, sizeof path, "%s.lua", name);
    if (tree_has(&c->files, path))
        return;
    const bool other = script_normalize_name(name, meant);
    snprintf(there, sizeof there, "%s.lua", other ? meant : name);
    if (other && tree_has(&c->files, there))
        diagnostics_add(&c->found, s->path, call->line, "require: no script %s in the game; write require \"%s\"", path,
                        meant);
    else
        diagnostics_add(&c->found, s->path, call->line, "require: no script %s in the game", path);
}

static void check_demo_exists(struct check *c, const struct check_script *s, int line, const char *how,
                              const char *name)
{
    char path[TREE_PATH];

    snprintf(path, sizeof path, "demos/%s.demo", name);
    if (!tree_has(&c->files, path))
        diagnostics_add(&c->found, s->path, line, "%s: %s does not exist", how, path);
}

/* Returns whether a script calls rom.has for the name, so the name is optional. */
static bool is_optional(const struct check *c, const char *name)
{
    for (int i = 0; i < c->n_scripts; i++) {
        const struct symbols *f = &c->scripts[i].symbols;
        for (int k = 0; k < f->n_calls; k++)
            if (symbol_call_is(&f->calls[k], "rom", "has") && symbols_same(f->calls[k].arg[0], name))
                return true;
    }
    return false;
}

/* The names of one kind in rom.lua. */
struct names {
    const char *what, *first; /* the next name is `stride` bytes after the first */
    size_t stride;
    int n;
};

#define NAMES(what, list, n) ((struct names){ what, (list)[0].name, sizeof(list)[0], n })

static void check_name(struct check *c, const struct check_script *s, int line, struct names have, const char *name)
{
    struct edit_nearest near = { .word = name };
    const char *at = have.first;
    char meant[96];

    if (!c->manifest || is_optional(c, name))
        return;
    for (int i = 0; i < have.n; i++, at += have.stride) {
        if (strcmp(name, at) == 0)
            return;
        edit_consider(&near, at);
    }
    make_hint(meant, name, near.found, NULL);
    diagnostics_add(&c->found, s->path, line, "unknown %s \"%s\"%s", have.what, name, meant);
}

static void check_palette_name(struct check *c, const struct check_script *s, int line, const char *name)
{
    if (strcmp(name, "main") != 0)
        check_name(c, s, line, NAMES("palette", c->art.palettes, c->art.n_palettes), name);
}

static enum api_type parameter_type(const struct api_entry *e, const char *param)
{
    for (int i = 0; e != NULL && i < e->count; i++)
        if (strcmp(e->params[i].name, param) == 0)
            return e->params[i].type;
    return A_ANY;
}

/* Checks a key with a string value in the table that is the argument of an API function. */
static void check_key(struct check *c, const struct check_script *s, const struct symbol_key *k)
{
    const struct symbol_table *t = &s->symbols.tables[k->table];

    if (k->value == NULL || t->space == NULL || t->key >= 0 || is_changed(c, t->space, t->name))
        return;
    enum api_type type = parameter_type(find_api_entry(t->space, t->name), k->name);
    if (type == A_SPRITE)
        check_name(c, s, k->line, NAMES("sprite", c->art.sprites, c->art.n_sprites), k->value);
    else if (type == A_BLEND)
        check_name(c, s, k->line, NAMES("blend", c->art.blends, c->art.n_blends), k->value);
    else if (type == A_FONT)
        check_name(c, s, k->line, NAMES("font", c->art.fonts, c->art.n_fonts), k->value);
    else if (symbols_same(t->space, "palette") && symbols_same(t->name, "fade") && symbols_same(k->name, "to"))
        check_palette_name(c, s, k->line, k->value);
    else if (symbols_same(t->space, "boot") && symbols_same(t->name, "run") && symbols_same(k->name, "demo"))
        check_demo_exists(c, s, k->line, "boot.run: demo", k->value);
}

static void check_call(struct check *c, const struct check_script *s, const struct symbol_call *call)
{
    const char *arg = call->arg[0];

    check_require(c, s, call);
    if (arg == NULL || call->space == NULL || is_changed(c, call->space, call->name))
        return;
    if (symbol_call_is(call, "palette", "load"))
        check_palette_name(c, s, call->line, arg);
    if (symbol_call_is(call, "board", "attract"))
        check_demo_exists(c, s, call->line, "board.attract", arg);
}

static void check_symbols(struct check *c, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int i = 0; i < f->n_globals; i++)
        check_global(c, s->path, &f->globals[i]);
    for (int i = 0; i < f->n_iterations; i++)
        check_iteration(c, s->path, &f->iterations[i]);
    for (int i = 0; i < f->n_divisions; i++)
        check_division(c, s->path, &f->divisions[i]);
    for (int i = 0; i < f->n_formats; i++)
        check_format(c, s, &f->formats[i]);
    for (int i = 0; i < f->n_calls; i++)
        check_call(c, s, &f->calls[i]);
    for (int i = 0; i < f->n_keys; i++)
        check_key(c, s, &f->keys[i]);
}

void check_lua(struct check *c)
{
    collect_names(c);
    for (int i = 0; i < c->n_scripts; i++)
        if (c->scripts[i].symbols.complete)
            check_symbols(c, &c->scripts[i]);
}

/* ---- spells ---- */

/* Returns the key of that name in table t, or NULL. */
static const struct symbol_key *find_key(const struct symbols *f, int t, const char *name)
{
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].table == t && strcmp(f->keys[i].name, name) == 0)
            return &f->keys[i];
    return NULL;
}

/* Returns the spell of table t if it is a phase with a bonus, or NULL. */
static const struct symbol_key *find_spell(const struct symbols *f, int t)
{
    const struct symbol_table *table = &f->tables[t];
    const bool phase = symbols_same(table->space, "boss") && symbols_same(table->name, "def") && table->key >= 0;

    return phase && find_key(f, t, "bonus") != NULL ? find_key(f, t, "spell") : NULL;
}

static bool any_bonus_decreases(const struct check *c)
{
    for (int i = 0; i < c->n_scripts; i++)
        for (int t = 0; t < c->scripts[i].symbols.n_tables; t++)
            if (find_spell(&c->scripts[i].symbols, t) != NULL &&
                find_key(&c->scripts[i].symbols, t, "bonus_to") != NULL)
                return true;
    return false;
}

static void check_script_spells(struct check *c, const struct check_script *s)
{
    const struct symbols *f = &s->symbols;

    for (int t = 0; t < f->n_tables; t++) {
        const struct symbol_key *spell = find_spell(f, t);
        if (spell != NULL && find_key(f, t, "bonus_to") == NULL && find_key(f, t, "survive") == NULL)
            diagnostics_add(
                &c->found, s->path, spell->line,
                "spell \"%s\": its bonus does not decrease, unlike the bonus of other spells (set bonus_to)",
                spell->value != NULL ? spell->value : "?");
    }
}

/* A constant bonus is a mistake if the bonus of other spells decreases, except in survival phases. */
void check_spells(struct check *c)
{
    if (!any_bonus_decreases(c))
        return;
    for (int i = 0; i < c->n_scripts; i++)
        check_script_spells(c, &c->scripts[i]);
}
