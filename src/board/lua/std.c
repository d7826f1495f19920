/*
 * std.c - see std.h.
 */
#include "../std.h"

#include <string.h>
#include "../script.h"

enum { ALL = (1 << STD_MODULES) - 1 };

/* The globals are those that the module's table is bound to: its name, or for the prelude each of its entries. */
static const struct {
    const char *name, *globals;
} modules[STD_MODULES] = {
    { "prelude", " wait_until wait_for by_difficulty " },
    { "pattern", " pattern " },
    { "path", " path " },
    { "stage", " stage " },
    { "boss", " boss " },
    { "hud", " hud " },
    { "menu", " menu " },
    { "boot", " boot " },
};

static const char computing[] = " _G _ENV load ";

const char *std_module(int i)
{
    return modules[i].name;
}

/* Is the word one of the list, each with blanks around it? */
static int in_list(const char *list, const char *word, size_t n)
{
    for (const char *p = list; (p = strchr(p, ' ')) != NULL && *++p != '\0';)
        if (strncmp(p, word, n) == 0 && p[n] == ' ')
            return 1;
    return 0;
}

static int module_of(const char *name, size_t n)
{
    for (int i = 0; i < STD_MODULES; i++)
        if (in_list(modules[i].globals, name, n))
            return i;
    return -1;
}

int std_of(const char *name)
{
    return module_of(name, strlen(name));
}

uint64_t std_named(const char *text, size_t n)
{
    uint64_t named = 0;
    size_t at = 0, size;
    const char *name;

    while (script_next_read(text, n, &at, &name, &size)) {
        int i = module_of(name, size);
        if (in_list(computing, name, size))
            named = ALL;
        if (i >= 0)
            named |= (uint64_t)1 << i;
    }
    return named;
}
