/*
 * builtins.c - see builtins.h. The names come from the tables of the sandbox and of the API, and from the text of the
 * library.
 */
#include "builtins.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../base/int.h"
#include "../../script/api/api_table.h"
#include "../../script/script.h"
#include "../../script/std.h"
#include "../pack/pack.h"
#include "../../common/array.h"

static const char *const libraries[] = { "string", "table", "math", "utf8" };
static const char *const extra_globals[] = { "print", "require", "forever", "camera" };
enum { LUA_EXTRA_GLOBALS = 2 }; /* the first of them belong to Lua */
static const char *const rom_fields[] = { "title", "field", "view", "screen" };

bool name_set_has(const struct name_set *s, const char *space, const char *name)
{
    for (int i = 0; i < s->n; i++)
        if (strcmp(s->list[i].name, name) == 0 && symbols_same(s->list[i].space, space))
            return true;
    return false;
}

void name_set_add(struct name_set *s, const char *space, const char *name)
{
    if (name_set_has(s, space, name))
        return;
    if (!array_append(&s->list, (size_t)s->n, sizeof *s->list)) {
        s->failed = true;
        return;
    }
    const char *in = space != NULL ? arena_copy(&s->arena, space, strlen(space)) : NULL;
    s->list[s->n++] = (struct name_set_entry){ in, arena_copy(&s->arena, name, strlen(name)) };
    s->failed = s->failed || s->arena.failed;
}

const char *name_set_nearest(const struct name_set *s, const char *space, const char *name)
{
    int best = (int)strlen(name) < 3 ? 0 : EDIT_TOO_FAR - 1;
    const char *found = NULL;

    for (int i = 0; i < s->n; i++) {
        const struct name_set_entry *n = &s->list[i];
        int distance = symbols_same(n->space, space) ? edit_distance(name, n->name) : EDIT_TOO_FAR;
        if (distance > best || (distance == best && (found == NULL || strcmp(n->name, found) >= 0)))
            continue;
        best = distance;
        found = n->name;
    }
    return found;
}

/* ---- names ---- */

/* Adds the words of a list separated by spaces. */
static void add_words(struct name_set *s, const char *space, const char *words)
{
    for (const char *end; *words != '\0'; words = end + strspn(end, " ")) {
        char word[32];
        end = words + strcspn(words, " ");
        snprintf(word, sizeof word, "%.*s", (int)(end - words), words);
        name_set_add(s, space, word);
    }
}

/* Splits "bullet.fire" into "bullet" and "fire"; false for methods, parts of entries and sys, which games cannot
 * use. */
static bool split(const struct api_entry *e, char space[32], const char **name)
{
    const char *dot = strchr(e->name, '.');

    if (e->flags & API_SYS || strpbrk(e->name, ": ") != NULL)
        return false;
    snprintf(space, 32, "%.*s", dot != NULL ? (int)(dot - e->name) : 0, e->name);
    *name = dot != NULL ? dot + 1 : e->name;
    return true;
}

static void add_entry(struct name_set *s, const struct api_entry *e)
{
    char space[32];
    const char *name;

    if (!split(e, space, &name))
        return;
    name_set_add(s, space[0] != '\0' ? space : NULL, name);
    if (space[0] != '\0')
        name_set_add(s, NULL, space);
}

void builtins_open_lua(struct name_set *s)
{
    *s = (struct name_set){ 0 };
    add_words(s, NULL, api_library_names(""));
    for (size_t i = 0; i < COUNT(libraries); i++)
        add_words(s, libraries[i], api_library_names(libraries[i]));
    for (size_t i = 0; i < LUA_EXTRA_GLOBALS; i++)
        name_set_add(s, NULL, extra_globals[i]);
}

void builtins_open(struct name_set *s)
{
    builtins_open_lua(s);
    for (size_t i = LUA_EXTRA_GLOBALS; i < COUNT(extra_globals); i++)
        name_set_add(s, NULL, extra_globals[i]);
    for (size_t i = 0; i < COUNT(rom_fields); i++)
        name_set_add(s, "rom", rom_fields[i]);
    for (int i = 0; i < api_table.things[H_CAMERA]->n; i++)
        name_set_add(s, "camera", api_table.things[H_CAMERA]->props[i].name);
    for (int i = 0; i < api_count_entries(&api_table); i++)
        add_entry(s, api_get_entry(&api_table, i));
}

void name_set_free(struct name_set *s)
{
    free(s->list);
    arena_close(&s->arena);
    *s = (struct name_set){ 0 };
}

/* Returns whether the script only extends a table of another module or of the board. */
static bool only_extends(const char *script)
{
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (strcmp(script, std_modules[i].name) == 0)
            return std_modules[i].extended_table != NULL;
    return std_module_of_file(script) >= 0;
}

bool builtins_add_library(struct name_set *s, const char *script, const struct symbols *f)
{
    const char *space = strcmp(script, "prelude") == 0 ? NULL : script;

    if (only_extends(script))
        return true;
    if (space != NULL)
        name_set_add(s, NULL, space);
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].table == f->result_table)
            name_set_add(s, space, f->keys[i].name);
    for (int i = 0; i < f->n_members; i++)
        if (f->members[i].local == f->result_local)
            name_set_add(s, space, f->members[i].field);
    return f->complete && f->result_table >= 0 && !f->result_open;
}

bool builtins_global(const char *name)
{
    size_t n = strlen(name);

    if (script_list_has(api_library_names(""), name, n))
        return true;
    for (size_t i = 0; i < COUNT(extra_globals); i++)
        if (strcmp(extra_globals[i], name) == 0)
            return true;
    for (int i = 0; i < std_script_count; i++)
        if (strcmp(std_scripts[i].name, name) == 0 && !only_extends(name))
            return true;
    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (strncmp(api_get_entry(&api_table, i)->name, name, n) == 0 &&
            strchr(".", api_get_entry(&api_table, i)->name[n]) != NULL)
            return true;
    return false;
}

/* ---- handles ---- */

static bool is_handle(const char *returns)
{
    static const char *const words[] = { "bullet", "group", "shot",  "enemy",  "player",
                                         "sprite", "task",  "scope", "motion", "laser" };

    for (size_t i = 0; returns != NULL && i < COUNT(words); i++)
        if (strcmp(words[i], returns) == 0)
            return true;
    return false;
}

const char *builtins_handle(const char *space, const char *name)
{
    char full[64];

    snprintf(full, sizeof full, "%s%s%s", space != NULL ? space : "", space != NULL ? "." : "", name);
    const struct api_entry *e = api_find_entry(&api_table, full);
    return e && is_handle(e->returns) ? e->returns : NULL;
}

bool builtins_is_handle_param(const struct symbol_origin *of)
{
    static const struct {
        const char *space, *name, *key;
        int arg, params; /* the first `params` parameters are handles */
    } callbacks[] = {
        { "enemy", "def", "run", 2, 1 },       { "enemy", "def", "on_hit", 2, 1 },
        { "enemy", "def", "on_death", 2, 1 },  { "enemy", "spawn", "run", 1, 1 },
        { "stage", "wave", "run", 1, 1 },      { "enemy", "spawn", "on_death", 1, 1 },
        { "player", "def", "run", 2, 1 },      { "boss", "def", "run", 2, 8 },
        { "bullet", "each", NULL, 2, 1 },      { "enemy", "each", NULL, 2, 1 },
        { "player", "each", NULL, 1, 1 },      { "on", "graze", NULL, 1, 2 },
        { "on", "hit", NULL, 1, 2 },           { "on", "death", NULL, 1, 1 },
        { "on", "kill", NULL, 1, 1 },          { "on", "leave", NULL, 1, 1 },
        { "on", "extend", NULL, 1, 1 },        { "on", "phase", NULL, 1, 1 },
        { "bullet", "meet", "on_meet", 3, 2 }, { "on", "take", NULL, 1, 2 },
        { "item", "def", "on_take", 2, 2 },    { "item", "each", NULL, 2, 1 },
        { "laser", "each", NULL, 2, 1 },       { "boss", "def", "talk", 2, 1 },
    };

    for (size_t i = 0; i < COUNT(callbacks); i++)
        if (symbols_same(callbacks[i].space, of->space) && symbols_same(callbacks[i].name, of->name) &&
            symbols_same(callbacks[i].key, of->key) && callbacks[i].arg == of->arg && of->param <= callbacks[i].params)
            return true;
    return false;
}
