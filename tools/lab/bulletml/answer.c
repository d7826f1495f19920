/*
 * answer.c - what libbulletml makes of the documents of tests/bulletml: NAME.out beside NAME.xml. Its first line says
 * for how many frames, and whether the root begins anew; then comes a line a bullet and frame: frame, number, place,
 * direction, speed. The last line is a sentence where libbulletml gave up.
 */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tool.h"

enum { FRAMES = 12, PATH = 512 };

static void write_frames(FILE *out, struct side *s, int frames)
{
    const struct side_bullet *b;

    for (int f = 0; f < frames; f++) {
        const int32_t n = s->frame(s, side_player_x(f), side_player_y(f), &b);
        if (n < 0) {
            fprintf(out, "%s\n", s->error);
            return;
        }
        for (int32_t i = 0; i < n; i++)
            fprintf(out, "%d %d %.6f %.6f %.6f %.6f\n", f, b[i].id, b[i].x, b[i].y, b[i].dir, b[i].speed);
        s->leave(s, NULL, 0);
    }
}

static bool answer(const struct side_setup *setup, int frames, const char *path)
{
    struct side s;
    FILE *out = fopen(path, "w");

    if (!out)
        return false;
    fprintf(out, "%d frames%s\n", frames, setup->loop ? ", looped" : "");
    if (side_apart(&s, setup, ROUND_NEAREST)) {
        write_frames(out, &s, frames);
        s.close(&s);
    }
    return fclose(out) == 0;
}

static bool answer_one(const char *name)
{
    char document[PATH], path[PATH], first[64] = "";
    FILE *had;

    snprintf(document, sizeof document, "%s/%s.xml", TOOL_TESTS, name);
    snprintf(path, sizeof path, "%s/%s.out", TOOL_TESTS, name);
    had = fopen(path, "r");
    if (had && !fgets(first, sizeof first, had))
        *first = 0;
    if (had)
        fclose(had);
    const int frames = atoi(first);
    const struct side_setup setup = { document, 0.5, TOOL_SEED, strstr(first, "looped") };
    return answer(&setup, frames > 0 ? frames : FRAMES, path);
}

int tool_answers(int argc, char **argv)
{
    DIR *dir = opendir(TOOL_TESTS);
    struct dirent *e;
    int n = 0;

    while (dir && (e = readdir(dir))) {
        char *end = strstr(e->d_name, ".xml");
        if (!end || end[4] || (argc > 0 && !strstr(e->d_name, argv[0])))
            continue;
        *end = 0;
        if (!answer_one(e->d_name)) {
            fprintf(stderr, "bulletml: %s/%s.out: cannot be written\n", TOOL_TESTS, e->d_name);
            return 2;
        }
        n++;
    }
    if (dir)
        closedir(dir);
    printf("%d documents of %s\n", n, TOOL_TESTS);
    return n ? 0 : 2;
}
