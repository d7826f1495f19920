/*
 * args_names.c - the names of commands, and suggestions for misspelt words (args.h).
 */
#include "args_parts.h"

#include <string.h>
#include "../../base/edit.h"

const char *args_near(const char *word, const char *const *list, int n)
{
    struct edit_nearest near = { .word = word };

    for (int i = 0; i < n && strlen(word) > 2; i++)
        edit_consider(&near, list[i]);
    return near.found;
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
