/*
 * main.c - BulletML documents on the board, beside libbulletml.
 *
 *     bulletml [--out FOLDER] [SECTION...]                   the page docs/measured/bulletml.md; with sections they
 *     are printed bulletml one DOCUMENT [RANK [SEED [FRAMES [loop]]]]    one document
 *     bulletml answers [TEXT]                                what libbulletml makes of those in tests/bulletml
 */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "tool.h"

int main(int argc, char **argv)
{
    signal(SIGPIPE, SIG_IGN);
    if (argc > 2 && !strcmp(argv[1], "one"))
        return tool_one(argc - 2, argv + 2);
    if (argc > 1 && !strcmp(argv[1], "answers"))
        return tool_answers(argc - 2, argv + 2);
    return tool_page(argc, argv);
}
