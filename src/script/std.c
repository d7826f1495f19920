/*
 * std.c - see std.h.
 */
#include "std.h"

#include <string.h>
#include "script.h"

enum { ALL_MODULES = (1 << STD_MODULE_COUNT) - 1 };

const struct std_module std_modules[STD_MODULE_COUNT] = {
    { "prelude", "wait_until wait_for by_difficulty", NULL, NULL },
    { "pattern", "pattern", NULL, NULL },
    { "figure", "pattern", "whip scatter rose polygon star ellipse points picture", "pattern" },
    { "sweep", "bullet", "sweep", "bullet" },
    { "trail", "spark", "trail", "spark" },
    { "fx", "fx", NULL, NULL },
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

int std_module_of_file(const char *name)
{
    const size_t n = strcspn(name, "/");

    if (name[n] == '\0')
        return -1;
    if (script_list_has("screens", name, n))
        return std_module_of_global("boot");
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (script_list_has(std_modules[i].name, name, n))
            return i;
    return -1;
}

uint64_t std_find_needed_modules(int i, const char *text, size_t n)
{
    uint64_t others = std_find_used_modules(text, n);

    for (int k = 0; k < STD_MODULE_COUNT; k++)
        if (std_modules[k].extended_table && strcmp(std_modules[k].extended_table, std_modules[i].name) == 0)
            others &= ~((uint64_t)1 << k);
    others &= ~((uint64_t)1 << std_module_of_global("game")); /* no module needs it, and many locals have its name */
    return others;
}

int std_module_of_global(const char *name)
{
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (!std_modules[i].fields && script_list_has(std_modules[i].globals, name, strlen(name)))
            return i;
    return -1;
}

int std_module_of_field(const char *table, const char *field)
{
    for (int i = 0; i < STD_MODULE_COUNT; i++)
        if (std_modules[i].extended_table && strcmp(std_modules[i].extended_table, table) == 0 &&
            script_list_has(std_modules[i].fields, field, strlen(field)))
            return i;
    return -1;
}

uint64_t std_find_used_modules(const char *text, size_t n)
{
    uint64_t used = 0;
    size_t at = 0, size, field_size;
    const char *name;

    while (script_next_global(text, n, &at, &name, &size)) {
        const char *field = script_find_field(text, n, at, &field_size); /* NULL: any field may be read */
        if (script_list_has("_G _ENV load", name, size))
            return ALL_MODULES;
        for (int i = 0; i < STD_MODULE_COUNT; i++)
            if (script_list_has(std_modules[i].globals, name, size) &&
                (!std_modules[i].fields || !field || script_list_has(std_modules[i].fields, field, field_size)))
                used |= (uint64_t)1 << i;
    }
    return used;
}
