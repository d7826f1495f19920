/*
 * answer.c - what libbulletml makes of a document: of each frame all bullets, to six digits.
 */
#include <stdio.h>
#include <stdlib.h>
#include "tool.h"

static int print_frames(struct side *s, int32_t frames)
{
    const struct side_bullet *b;

    for (int32_t f = 0; f < frames; f++) {
        const int32_t n = s->frame(s, 0, 80, &b);
        if (n < 0) {
            printf("%s\n", s->error);
            return 1;
        }
        printf("frame %d\n", f);
        for (int32_t i = 0; i < n; i++)
            printf("%d %.6f %.6f %.6f %.6f\n", b[i].id, b[i].x, b[i].y, b[i].dir, b[i].speed);
        s->leave(s, NULL, 0);
    }
    return 0;
}

int tool_answer(int argc, char **argv)
{
    const struct side_setup setup = {
        .file = argv[0],
        .rank = argc > 2 ? atof(argv[2]) : 0.5,
        .seed = argc > 3 ? (uint32_t)strtoul(argv[3], NULL, 10) : TOOL_SEED,
        .loop = argc > 4,
    };
    struct side s;
    int failed;

    if (!side_apart(&s, &setup, ROUND_NEAREST)) {
        fprintf(stderr, "bulletml: %s\n", s.error);
        return 2;
    }
    failed = print_frames(&s, argc > 1 ? atoi(argv[1]) : 60);
    s.close(&s);
    return failed;
}
