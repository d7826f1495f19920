/*
 * one.c - one document, told at length.
 */
#include <stdio.h>
#include <stdlib.h>
#include "compare.h"
#include "tool.h"

int tool_one(int argc, char **argv)
{
    const struct side_setup setup = {
        .file = argv[0],
        .rank = argc > 1 ? atof(argv[1]) : 0.5,
        .seed = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : TOOL_SEED,
        .loop = argc > 4,
    };
    struct compared c;
    struct side a, b;

    if (!side_apart(&a, &setup, ROUND_NEAREST) || !side_board(&b, &setup)) {
        fprintf(stderr, "bulletml: %s%s\n", a.error, b.error);
        return 2;
    }
    compare_sides(&a, &b, argc > 3 ? atoi(argv[3]) : 1500, &c);
    printf("%d frames, %d bullets, %lld places, greatest distance %.6f px (frame %d, bullet %d), most %d; %s\n",
           c.frames, c.bullets, (long long)c.places, c.greatest, c.at_frame, c.at_bullet, c.most, c.what);
    return !compared_alike(&c);
}
