/*
 * main.c - the accuracy lab's command line: lab [--exact] [--out FOLDER] [SECTION...]
 * floor: tools
 *
 * Writes FOLDER/accuracy.md and FOLDER/accuracy/NAME.svg; FOLDER is docs unless named. --exact takes no times (lab.h).
 * Sections are named as in the list below; without names it is all of them. Exit 1: the figures do not bear out what
 * the engine does, or a claim of the text.
 */
#include <stdio.h>
#include <string.h>
#include "lab.h"

static const struct {
    const char *name;
    void (*run)(void);
} SECTIONS[] = {
    { "functions", section_functions },
    { "collision", section_collision },
    { "positions", section_positions },
    { "angles", section_angles },
    { "acceleration", section_acceleration },
    { "broad", section_broad },
    { "border", section_border },
    { "models", section_models },
};
enum { COUNT = sizeof SECTIONS / sizeof *SECTIONS };

static int section_of(const char *name)
{
    for (int i = 0; i < COUNT; i++)
        if (!strcmp(SECTIONS[i].name, name))
            return i;
    return -1;
}

static int usage(void)
{
    fprintf(stderr, "usage: lab [--exact] [--out FOLDER] [SECTION...]\nsections:");
    for (int i = 0; i < COUNT; i++)
        fprintf(stderr, " %s", SECTIONS[i].name);
    fprintf(stderr, "\n");
    return 2;
}

int main(int argc, char **argv)
{
    bool exact = false, chosen[COUNT] = { false }, all = true;
    const char *folder = "docs";

    for (int i = 1; i < argc; i++) {
        int s = section_of(argv[i]);
        if (!strcmp(argv[i], "--exact"))
            exact = true;
        else if (!strcmp(argv[i], "--out") && i + 1 < argc)
            folder = argv[++i];
        else if (s < 0)
            return usage();
        else
            chosen[s] = true, all = false;
    }
    lab_begin(exact, folder);
    for (int i = 0; i < COUNT; i++)
        if (all || chosen[i])
            SECTIONS[i].run();
    return lab_finish();
}
