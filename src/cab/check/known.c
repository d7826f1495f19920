/*
 * known.c - see known.h. Nothing is listed twice: Lua's names are those the sandbox keeps, the API's are its
 * table's, the library's are read from its text.
 */
#include "known.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../board/api_table.h"
#include "../pack/pack.h"

static const char *const libraries[] = { "string", "table", "math", "utf8" };
static const char *const others[] = { "forever", "print", "require" };
static const char *const rom_fields[] = { "title", "field", "screen" };

#define COUNT(list) (sizeof(list) / sizeof(list)[0])

static bool same(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

bool known_has(const struct known *k, const char *space, const char *name)
{
    for (int i = 0; i < k->n; i++)
        if (strcmp(k->list[i].name, name) == 0 && same(k->list[i].space, space))
            return true;
    return false;
}

void known_add(struct known *k, const char *space, const char *name)
{
    if (known_has(k, space, name))
        return;
    if (k->n == k->room) {
        int room = k->room == 0 ? 512 : k->room * 2;
        struct known_name *more = realloc(k->list, (size_t)room * sizeof *more);
        k->failed = k->failed || more == NULL;
        if (more == NULL)
            return;
        k->list = more;
        k->room = room;
    }
    const char *in = space != NULL ? arena_copy(&k->arena, space, strlen(space)) : NULL;
    k->list[k->n++] = (struct known_name){ in, arena_copy(&k->arena, name, strlen(name)) };
    k->failed = k->failed || k->arena.failed;
}

const char *known_near(const struct known *k, const char *space, const char *name)
{
    int best = (int)strlen(name) < 3 ? 0 : EDIT_FAR - 1;
    const char *found = NULL;

    for (int i = 0; i < k->n; i++) {
        const struct known_name *n = &k->list[i];
        int distance = same(n->space, space) ? edit_distance(name, n->name) : EDIT_FAR;
        if (distance > best || (distance == best && (found == NULL || strcmp(n->name, found) >= 0)))
            continue;
        best = distance;
        found = n->name;
    }
    return found;
}

/* ---- what there is ---- */

/* The words of a list with blanks between. */
static void add_words(struct known *k, const char *space, const char *words)
{
    for (const char *end; *words != '\0'; words = end + strspn(end, " ")) {
        char word[32];
        end = words + strcspn(words, " ");
        snprintf(word, sizeof word, "%.*s", (int)(end - words), words);
        known_add(k, space, word);
    }
}

/* "bullet.fire" as "bullet" and "fire"; false for what is no name of a game's: a method, a part of an entry, sys. */
static bool split(const struct api_entry *e, char space[32], const char **name)
{
    const char *dot = strchr(e->name, '.');

    if (e->flags & API_SYS || strpbrk(e->name, ": ") != NULL)
        return false;
    snprintf(space, 32, "%.*s", dot != NULL ? (int)(dot - e->name) : 0, e->name);
    *name = dot != NULL ? dot + 1 : e->name;
    return true;
}

static void add_entry(struct known *k, const struct api_entry *e)
{
    char space[32];
    const char *name;

    if (!split(e, space, &name))
        return;
    known_add(k, space[0] != '\0' ? space : NULL, name);
    if (space[0] != '\0')
        known_add(k, NULL, space);
}

void known_open(struct known *k)
{
    *k = (struct known){ 0 };
    add_words(k, NULL, api_library_names(""));
    for (size_t i = 0; i < COUNT(libraries); i++)
        add_words(k, libraries[i], api_library_names(libraries[i]));
    for (size_t i = 0; i < COUNT(others); i++)
        known_add(k, NULL, others[i]);
    for (size_t i = 0; i < COUNT(rom_fields); i++)
        known_add(k, "rom", rom_fields[i]);
    for (int i = 0; i < api_count(); i++)
        add_entry(k, api_entry(i));
}

void known_close(struct known *k)
{
    free(k->list);
    arena_close(&k->arena);
    *k = (struct known){ 0 };
}

bool known_add_library(struct known *k, const char *script, const struct facts *f)
{
    const char *space = strcmp(script, "prelude") == 0 ? NULL : script;

    if (space != NULL)
        known_add(k, NULL, space);
    for (int i = 0; i < f->n_keys; i++)
        if (f->keys[i].table == f->result_table)
            known_add(k, space, f->keys[i].name);
    for (int i = 0; i < f->n_members; i++)
        if (f->members[i].local == f->result_local)
            known_add(k, space, f->members[i].field);
    return f->whole && f->result_table >= 0 && !f->result_open;
}

static bool in_words(const char *words, const char *name)
{
    size_t n = strlen(name);

    for (const char *p = words; n > 0 && (p = strstr(p, name)) != NULL; p++)
        if ((p == words || p[-1] == ' ') && (p[n] == ' ' || p[n] == '\0'))
            return true;
    return false;
}

bool known_global(const char *name)
{
    size_t n = strlen(name);

    if (in_words(api_library_names(""), name))
        return true;
    for (size_t i = 0; i < COUNT(others); i++)
        if (strcmp(others[i], name) == 0)
            return true;
    for (int i = 0; i < std_script_count; i++)
        if (strcmp(std_scripts[i].name, name) == 0)
            return true;
    for (int i = 0; i < api_count(); i++)
        if (strncmp(api_entry(i)->name, name, n) == 0 && strchr(".", api_entry(i)->name[n]) != NULL)
            return true;
    return false;
}

/* ---- what there is not ---- */

const char *known_instead(const char *space, const char *name)
{
    static const struct {
        const char *space, *name, *instead;
    } gone[] = {
        { NULL, "os", "board.frame() tells the time, save.set keeps things" },
        { NULL, "io", "rom.text reads a text of the game, print writes to the log" },
        { NULL, "debug", "print and board.note tell what happens" },
        { NULL, "package", "require loads the game's scripts" },
        { NULL, "coroutine", "task.go starts a task, wait(n) lets frames pass" },
        { NULL, "next", "pairs visits a table in an order that is always the same" },
        { NULL, "dofile", "require runs another script" },
        { NULL, "loadfile", "require runs another script" },
        { NULL, "loadstring", "load takes a text" },
        { NULL, "collectgarbage", "the board collects between frames" },
        { NULL, "xpcall", "pcall catches what error raises" },
        { NULL, "unpack", "it is table.unpack" },
        { NULL, "setfenv", "load takes an environment" },
        { NULL, "getfenv", "load takes an environment" },
        { NULL, "module", "a script returns what it shares" },
        { "math", "random", "rng.int, rng.number, rng.pick or rng.chance" },
        { "math", "randomseed", "the run has a seed: --seed" },
        { "math", "exp", "results differ between machines" },
        { "math", "log", "results differ between machines" },
        { "math", "log10", "results differ between machines" },
        { "math", "pow", "x * x, or math.sqrt" },
        { "math", "ldexp", "x * 2.0 and so on" },
        { "math", "frexp", "math.modf splits a number" },
        { "math", "mod", "it is math.fmod" },
        { "string", "dump", "compiled Lua does not run here" },
        { "string", "pack", "its bytes differ between machines; string.char makes bytes" },
        { "string", "packsize", "sizes differ between machines" },
        { "string", "unpack", "its bytes differ between machines; string.byte reads bytes" },
        { "string", "gfind", "it is string.gmatch" },
        { "table", "getn", "#t is the length of t" },
        { "table", "maxn", "#t is the length of t" },
        { "table", "foreach", "for key, value in pairs(t) do" },
        { "table", "foreachi", "for i, value in ipairs(t) do" },
    };

    for (size_t i = 0; i < COUNT(gone); i++)
        if (same(gone[i].space, space) && strcmp(gone[i].name, name) == 0)
            return gone[i].instead;
    return NULL;
}

/* ---- handles ---- */

static bool is_handle(const char *returns)
{
    static const char *const words[] = { "bullet", "group", "shot",  "enemy", "player",
                                         "sprite", "task",  "scope", "motion" };

    for (size_t i = 0; returns != NULL && i < COUNT(words); i++)
        if (strcmp(words[i], returns) == 0)
            return true;
    return false;
}

const char *known_handle(const char *space, const char *name)
{
    char full[64];

    snprintf(full, sizeof full, "%s%s%s", space != NULL ? space : "", space != NULL ? "." : "", name);
    for (int i = 0; i < api_count(); i++)
        if (strcmp(api_entry(i)->name, full) == 0)
            return is_handle(api_entry(i)->returns) ? api_entry(i)->returns : NULL;
    return NULL;
}

bool known_handed(const struct fact_origin *of)
{
    static const struct {
        const char *space, *name, *key;
        int arg, params; /* the first so many are handles */
    } handed[] = {
        { "enemy", "def", "run", 2, 1 },   { "enemy", "def", "on_hit", 2, 1 }, { "enemy", "def", "on_death", 2, 1 },
        { "enemy", "spawn", "run", 1, 1 }, { "stage", "wave", "run", 1, 1 },   { "enemy", "spawn", "on_death", 1, 1 },
        { "player", "def", "run", 2, 1 },  { "boss", "def", "run", 2, 1 },     { "bullet", "each", NULL, 2, 1 },
        { "enemy", "each", NULL, 2, 1 },   { "player", "each", NULL, 1, 1 },   { "on", "graze", NULL, 1, 2 },
        { "on", "hit", NULL, 1, 2 },       { "on", "death", NULL, 1, 1 },      { "on", "kill", NULL, 1, 1 },
        { "on", "leave", NULL, 1, 1 },     { "on", "extend", NULL, 1, 1 },     { "on", "phase", NULL, 1, 1 },
    };

    for (size_t i = 0; i < COUNT(handed); i++)
        if (same(handed[i].space, of->space) && same(handed[i].name, of->name) && same(handed[i].key, of->key) &&
            handed[i].arg == of->arg && of->param <= handed[i].params)
            return true;
    return false;
}
