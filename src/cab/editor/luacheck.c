/*
 * luacheck.c - see luacheck.h. Lua's names are those the sandbox keeps, the API's are its table's. Two standards: games
 * have "curtain", in which nothing of the API can be set; the library, and what a game has in its place, std/NAME.lua,
 * "curtain_library": its modules make tables of the API, and have fields for each other. Scripts in tests/ are no
 * game's: theirs is "curtain_test", Lua's names and `test`.
 */
#include "luacheck.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "../../board/api_table.h"
#include "../../board/std.h"
#include "../../board/trial/trial.h"
#include "../check/builtins.h"
#include "../host/version.h"

/* Tables whose fields a game sets. */
static bool is_written(const char *full)
{
    return !strcmp(full, "hud.banks") || !strcmp(full, "hud.low") || !strcmp(full, "hud.shy") ||
           !strcmp(full, "hud.graze") || !strcmp(full, "talk.look");
}

/* One that has more than the table knows, to read and to set: the registers that game.def declares. luacheck cannot
 * keep game.stage from being set there; the board does. */
static bool is_open(const char *space)
{
    return !strcmp(space, "game");
}

static void add_plain(struct name_set *s)
{
    const char *name, *help;

    for (int i = 0; (name = api_plain(i, &help)); i++) {
        char space[32], field[32];
        const size_t n = strcspn(name, ".(");
        if (name[n] != '.' || name[n + 1] == '.')
            continue;
        snprintf(space, sizeof space, "%.*s", (int)n, name);
        snprintf(field, sizeof field, "%.*s", (int)strcspn(name + n + 1, "("), name + n + 1);
        name_set_add(s, NULL, space);
        name_set_add(s, space, field);
    }
}

/* Modules of the library whose functions have no entries: a global of their own. */
static void add_modules(struct name_set *s)
{
    for (int i = 1; i < STD_MODULES; i++)
        if (!std_adds_to(i))
            name_set_add(s, NULL, std_module(i));
}

static bool has_fields(const struct name_set *s, const char *space)
{
    for (int i = 0; i < s->n; i++)
        if (s->list[i].space && !strcmp(s->list[i].space, space))
            return true;
    return false;
}

/* Do files of the library make that table, or add to it? */
static bool is_librarys(const char *space)
{
    if (std_of(space) > 0)
        return true;
    for (int i = 0; i < STD_MODULES; i++)
        if (std_adds_to(i) && !strcmp(std_adds_to(i), space))
            return true;
    return false;
}

/* Is it a value, no function? It may be a text or a table, which have fields. */
static bool is_value(const char *full)
{
    const char *name, *help;

    for (int i = 0; (name = api_plain(i, &help)); i++)
        if (!strcmp(name, full))
            return true;
    return false;
}

static void field(const char *space, const char *name)
{
    char full[80];

    snprintf(full, sizeof full, "%s.%s", space, name);
    if (is_written(full))
        printf("      %s = { read_only = false, other_fields = true },\n", name);
    else
        printf("      %s = {%s},\n", name, is_value(full) ? " other_fields = true " : "");
}

static void global(const struct name_set *s, const char *name, bool library)
{
    if (library && is_librarys(name)) {
        printf("    %s = { read_only = false, other_fields = true },\n", name);
        return;
    }
    if (!has_fields(s, name)) {
        printf("    %s = {%s},\n", name, std_of(name) > 0 ? " other_fields = true " : "");
        return;
    }
    printf("    %s = { %sfields = {\n", name, is_open(name) ? "read_only = false, other_fields = true, " : "");
    for (int i = 0; i < s->n; i++)
        if (s->list[i].space && !strcmp(s->list[i].space, name))
            field(name, s->list[i].name);
    printf("    } },\n");
}

static void standard(const struct name_set *s, const char *name, bool library)
{
    printf("stds.%s = {\n  read_globals = {\n", name);
    for (int i = 0; i < s->n; i++)
        if (!s->list[i].space)
            global(s, s->list[i].name, library);
    printf("  },\n}\n");
}

/* Lua's names, and the table `test`. */
static void add_test_names(struct name_set *s)
{
    struct trial_entry e;

    builtins_open_lua(s);
    name_set_add(s, NULL, "test");
    for (int i = 0; trial_entry(i, &e); i++)
        if (strncmp(e.name, "test.", 5) == 0)
            name_set_add(s, "test", e.name + 5);
}

static void test_standard(void)
{
    struct name_set s;

    add_test_names(&s);
    standard(&s, "curtain_test", false);
    name_set_close(&s);
}

void luacheck_print(void)
{
    struct name_set s;

    builtins_open(&s);
    add_plain(&s);
    add_modules(&s);
    printf("-- Curtain %s: what a game may name, for luacheck. Made by curtain help lua --luacheck.\n",
           CURTAIN_VERSION);
    standard(&s, "curtain", false);
    standard(&s, "curtain_library", true);
    test_standard();
    printf("std = \"curtain\"\n");
    printf("max_line_length = false\n");
    printf("unused_args = false -- a task's function gets its owner, whatever it needs\n");
    printf("files[\"**/std/**\"] = { std = \"curtain_library\" } -- in place of the library\n");
    printf("files[\"**/tests/**\"] = { std = \"curtain_test\" } -- curtain test runs them\n");
    name_set_close(&s);
}
