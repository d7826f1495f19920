/*
 * rounding.c - which documents do otherwise when libbulletml's own doubles are rounded otherwise.
 */
#include <stdio.h>
#include <string.h>
#include "all.h"
#include "tool.h"

static void print_one(const char *path, const struct all_result *r)
{
    for (int i = 0; i < ALL_RANKS; i++)
        for (int k = 1; k < SIDE_ROUNDINGS; k++) {
            const struct compared *c = &r->rounding[i][k];
            if (!compared_alike(c) || c->broke)
                printf("%s: rank %g, rounded %s: greatest %.6f in frame %d; %s\n", list_name(path), all_rank[i],
                       side_rounding_name[k], c->greatest, c->at_frame, c->what);
        }
}

int tool_rounding(int argc, char **argv)
{
    char err[256];
    struct list documents;
    double greatest = 0;

    if (!list_read(&documents, TOOL_DOCUMENTS, err, sizeof err)) {
        fprintf(stderr, "bulletml: %s\n", err);
        return 2;
    }
    const struct all_setup setup = { ALL_ROUNDINGS, &documents, NULL, argc > 0 ? argv[0] : NULL, TOOL_SEED, false, 3 };
    struct all_result *r = all_compare(&setup);
    for (int i = 0; r && i < documents.n; i++) {
        print_one(documents.path[i], &r[i]);
        for (int k = 0; k < ALL_RANKS; k++)
            for (int j = 1; j < SIDE_ROUNDINGS; j++)
                if (compared_alike(&r[i].rounding[k][j]) && r[i].rounding[k][j].greatest > greatest)
                    greatest = r[i].rounding[k][j].greatest;
    }
    printf("greatest distance of those that do not: %.9f px\n", greatest);
    return r ? 0 : 2;
}
