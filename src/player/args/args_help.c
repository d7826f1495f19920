/*
 * args_help.c - prints the help from the tables (args.h).
 */
#include "args_parts.h"

#include <stdio.h>

enum { LINE = 640 }; /* bytes of the longest line */

static void help_options(unsigned set_of, void (*line)(const char *))
{
    char text[LINE], name[48];

    for (int o = 0; o < OPTIONS; o++) {
        if (!(args_options[o].commands & set_of))
            continue;
        snprintf(name, sizeof name, "%s%s%s", args_options[o].name, args_options[o].value ? " " : "",
                 args_options[o].value ? args_options[o].value : "");
        snprintf(text, sizeof text, "  %-21s %s", name, args_options[o].help);
        line(text);
    }
}

static void help_all(unsigned commands, void (*line)(const char *))
{
    char text[LINE], name[48];

    line("curtain plays bullet-hell games. A ROM is a game's folder or a .rom file.");
    line("");
    for (int i = 0; i < COMMANDS; i++) {
        if (!(commands >> i & 1))
            continue;
        snprintf(name, sizeof name, "%s %s", args_commands[i].name, args_commands[i].words);
        snprintf(text, sizeof text, "  curtain %-28s  %s", name, args_commands[i].help);
        line(text);
    }
    line("");
    line("`play` is the default command. Options (curtain help COMMAND describes them for a command):");
    help_options((FOR_ALL | FOR_NEW | FOR_REGISTER) & commands, line);
    line("");
    line("Exit codes: 0 success, 1 a demo differs or check found a mistake, 2 bad input or a script error, 3 a system "
         "error.");
}

void args_help(int command, bool is_player, void (*line)(const char *))
{
    char text[LINE];

    if (command < 0) {
        help_all(is_player ? FOR_PLAYER : ~0u, line);
        return;
    }
    snprintf(text, sizeof text, "curtain %s %s%s", args_commands[command].name, args_commands[command].words,
             FOR_ALL >> command & 1 ? " [OPTIONS]" : "");
    line(text);
    snprintf(text, sizeof text, "  %s", args_commands[command].help);
    line(text);
    if (!((FOR_ALL | FOR_HELP | FOR_NEW | FOR_LICENCES | FOR_REGISTER) >> command & 1))
        return;
    line("");
    help_options(1u << command, line);
}
