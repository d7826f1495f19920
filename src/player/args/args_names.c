/*
 * args_names.c - see args.h: commands by their names, and what was meant by a name that there is not.
 */
#include "args_parts.h"

#include <string.h>
#include "../../base/edit.h"

const char *args_near(const char *word, const char *const *list, int n)
{
    const char *best = NULL;
    int limit = strlen(word) < 3 ? -1 : 1 + (int)strlen(word) / 4;

    for (int i = 0; i < n; i++) {
        int e = edit_count(word, list[i]);
        if (e > limit || e >= (int)strlen(list[i]))
            continue;
        best = list[i];
        limit = e - 1; /* only a nearer one is better */
    }
    return best;
}

const char *args_near_command(const char *word)
{
    const char *names[COMMANDS];

    for (int i = 0; i < COMMANDS; i++)
        names[i] = args_commands[i].name;
    return args_near(word, names, COMMANDS);
}

int args_command(const char *name)
{
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(name, args_commands[i].name) == 0)
            return i;
    }
    return -1;
}

const char *args_name(enum command command)
{
    return args_commands[command].name;
}
