/*
 * std.c - see std.h.
 */
#include "std.h"

#include <string.h>
#include "script.h"

enum { ALL_MODULES = (1 << STD_MODULE_COUNT) - 1 };

/* globals: the global variables through which scripts reach the module: the one bound to its table or, for the prelude,
 * one for each of its functions. A module with `fields` has no variable of its own: it adds those fields to the table
 * `extended_table`, and its `globals` is that table. */
static const struct {
    const char *name, *globals, *fields, *extended_table;
} modules[STD_MODULE_COUNT] = {
    { "prelude", "wait_until wait_for by_difficulty", NULL, NULL },
    { "pattern", "pattern", NULL, NULL },
    { "figure", "pattern", "whip scatter rose polygon star ellipse points picture", "pattern" },
    { "sweep", "bullet", "sweep", "bullet" },
    { "trail", "spark", "trail", "spark" },
    { "scoring", "score", "rule count tally", "score" },
    { "unlock", "unlock", NULL, NULL },
    { "mission", "mission", NULL, NULL },
    { "path", "path", NULL, NULL },
    { "stage", "stage", NULL, NULL },
    { "game", "game", NULL, NULL },
    { "boss", "boss", NULL, NULL },
    { "bg", "bg", "def show", "bg" },
    { "hud", "hud", NULL, NULL },
    { "menu", "menu", NULL, NULL },
    { "talk", "talk", NULL, NULL },
    { "say", "say", NULL, NULL },
    { "choose", "choose", NULL, NULL },
    { "boot", "boot", NULL, NULL },
};

static const char dynamic_globals[] = "_G _ENV load";

const char *std_module_name(int i)
{
    return modules[i].name;
}

int std_module_of_file(const char *name)
{
    const size_t n = strcspn(name, "/");

    if (name[n] == '\0')
        return -1;
    if (script_list_has("screens", name, n))
        return std_module_of_global("boot");
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (script_list_has(modules[i].name, name, n))
            return i;
    return -1;
}

const char *std_extended_table(int i)
{
    return modules[i].extended_table;
}

uint64_t std_find_needed_modules(int i, const char *text, size_t n)
{
    uint64_t others = std_find_used_modules(text, n);

    for (int k = 0; k < STD_MODULE_COUNT; k++)
        if (modules[k].extended_table && strcmp(modules[k].extended_table, modules[i].name) == 0)
            others &= ~((uint64_t)1 << k);
    others &= ~((uint64_t)1 << std_module_of_global("game")); /* no module needs it, and many locals have its name */
    return others;
}

int std_module_of_global(const char *name)
{
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (!modules[i].fields && script_list_has(modules[i].globals, name, strlen(name)))
            return i;
    return -1;
}

int std_module_of_field(const char *table, const char *field)
{
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (modules[i].extended_table && strcmp(modules[i].extended_table, table) == 0 &&
            script_list_has(modules[i].fields, field, strlen(field)))
            return i;
    return -1;
}

/* Returns the modules needed to read this field of this global; field NULL: any field may be read. */
static uint64_t modules_of_field(const char *name, size_t n, const char *field, size_t field_n)
{
    uint64_t m = 0;

    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (script_list_has(modules[i].globals, name, n) &&
            (!modules[i].fields || !field || script_list_has(modules[i].fields, field, field_n)))
            m |= (uint64_t)1 << i;
    return m;
}

uint64_t std_find_used_modules(const char *text, size_t n)
{
    uint64_t used = 0;
    size_t at = 0, size, field_size;
    const char *name, *field;

    while (script_next_global(text, n, &at, &name, &size)) {
        field = script_find_field(text, n, at, &field_size);
        used |= script_list_has(dynamic_globals, name, size) ? ALL_MODULES
                                                             : modules_of_field(name, size, field, field_size);
    }
    return used;
}
