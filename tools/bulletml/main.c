/*
 * main.c - BulletML documents on the board, beside libbulletml.
 *
 *     bulletml answers [TEXT]   what libbulletml makes of the documents of tests/bulletml
 *     bulletml rounding [TEXT]                                 documents that the last bit of a double decides
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tool.h"

static const struct command {
    const char *name, *takes;
    int least;
    int (*run)(int argc, char **argv);
} commands[] = {
    { "answers", "[TEXT]", 0, tool_answers },   { "one", "DOCUMENT [RANK [SEED [FRAMES [loop]]]]", 1, tool_one },
    { "all", "[TEXT]", 0, tool_all },           { "speed", "", 0, tool_speed_alone },
    { "rounding", "[TEXT]", 0, tool_rounding },
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int usage(void)
{
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stderr, "%s bulletml %s %s\n", i ? "      " : "usage:", commands[i].name, commands[i].takes);
    return 2;
}

int main(int argc, char **argv)
{
    signal(SIGPIPE, SIG_IGN);
    for (int i = 0; argc > 1 && i < COMMANDS; i++)
        if (!strcmp(argv[1], commands[i].name) && argc - 2 >= commands[i].least)
            return commands[i].run(argc - 2, argv + 2);
    return usage();
}
