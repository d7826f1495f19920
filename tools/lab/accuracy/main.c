/*
 * main.c - the accuracy lab's command line: lab [--exact] [--out FOLDER] [SECTION...]
 *
 * Writes FOLDER/accuracy.md and FOLDER/accuracy/NAME.svg; FOLDER is docs unless named. --exact takes no times (lab.h).
 * Sections are named as in the list below; without names it is all of them. Exit 1: the figures do not bear out what
 * the engine does, or a claim of the text.
 */
#include <stdio.h>
#include "lab.h"

static const struct report_part SECTIONS[] = {
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

int main(int argc, char **argv)
{
    struct report_options o = { .usage = "lab [--exact] [--out FOLDER]",
                                .takes_exact = true,
                                .folder = "docs/measured" };

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    lab_begin(o.exact, o.folder);
    report_run(&o, SECTIONS, COUNT);
    return lab_finish();
}
