/*
 * main.c - docs/measured/pacing.md: frames, screens, and the way from a switch to the picture.
 */
#include "../report/report.h"
#include "pacing.h"

static const struct report_part SECTIONS[] = {
    { "screens", section_screens },
    { "latency", section_latency },
    { "costs", section_costs },
};
enum { COUNT = sizeof SECTIONS / sizeof *SECTIONS };

static const char ABOUT[] =
    "# Pacing: frames, screens, and the way from a switch to the picture\n"
    "\n"
    "`make pacing` measures this page and writes it; do not edit it. What is simulated is computed again by a test of\n"
    "`make test`, which compares; times are this machine's.\n"
    "\n"
    "A game has 60 ticks a second, always: no screen makes it faster or slower, so a recording is as long as it was\n"
    "played and sound needs no other rate. With `vsync = yes` a picture is handed in so that the screen takes it "
    "whole, "
    "and\n"
    "which refresh has how many ticks follows from the two rates alone (`src/cab/host/pace.h`). With `vsync = no`, "
    "and\n"
    "where the rate of the screen is not known, a tick is due every sixtieth by the host's clock, and shown at once.\n"
    "\n";

int main(int argc, char **argv)
{
    struct report_options o = { .usage = "pacing [--exact] [--out FOLDER]", .takes_exact = true, .folder = "docs" };

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    report_begin(&(struct report){ .program = "pacing", .folder = o.folder, .page = "pacing", .exact = o.exact });
    report_run(&o, SECTIONS, COUNT);
    report_finish(ABOUT, "");
    return 0;
}
