/*
 * everything.c - `bulletml all`: the documents of the list beside libbulletml.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "all.h"
#include "tool.h"

static void print_one(const char *path, const struct all_result *r)
{
    for (int i = 0; i < ALL_RANKS; i++) {
        const struct compared *c = &r->board[i];
        if (!compared_alike(c) || c->broke)
            printf("%s: rank %g: greatest %.6f in frame %d; %s\n", list_name(path), all_rank[i], c->greatest,
                   c->at_frame, c->what);
    }
}

int tool_all(int argc, char **argv)
{
    char err[256];
    struct list documents, exceptions;

    if (!list_read(&documents, TOOL_DOCUMENTS, err, sizeof err) ||
        !list_read(&exceptions, TOOL_EXCEPTIONS, err, sizeof err)) {
        fprintf(stderr, "bulletml: %s\n", err);
        return 2;
    }
    const struct all_setup setup = { ALL_BOARD,
                                     &documents,
                                     &exceptions,
                                     argc > 0 ? argv[0] : NULL,
                                     argc > 2 ? (uint32_t)atoi(argv[2]) : TOOL_SEED,
                                     argc > 1 && *argv[1],
                                     3 };
    struct all_result *r = all_compare(&setup);
    int alike = 0, ran = 0;
    for (int i = 0; r && i < documents.n; i++) {
        if (setup.only && !strstr(documents.path[i], setup.only))
            continue;
        print_one(documents.path[i], &r[i]);
        alike += all_alike(&r[i]);
        ran++;
    }
    printf("%d of %d alike\n", alike, ran);
    return 0;
}
