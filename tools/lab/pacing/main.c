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
    "# Pacing: frames, screens and input latency\n"
    "\n"
    "`make pacing` takes the measurements and writes this page; do not edit it. `make test` repeats the simulations "
    "and\n"
    "compares the results, but not the times under [Cost](#cost), which depend on the machine.\n"
    "\n"
    "A game always runs at 60 ticks a second, whatever the screen's refresh rate. A replay therefore takes as long as "
    "the\n"
    "original run, and sound needs no resampling. With `vsync = yes`, the host presents each frame in sync with the "
    "refresh,\n"
    "without tearing. The number of ticks per refresh then depends only on the tick rate and the refresh rate\n"
    "(`src/player/play/pace.h`). With `vsync = no`, or when the refresh rate is unknown, a tick is due every 1/60 s of "
    "the\n"
    "host's clock, and its frame is shown immediately.\n"
    "\n";

int main(int argc, char **argv)
{
    struct report_options o = { .usage = "pacing [--exact] [--out FOLDER]",
                                .takes_exact = true,
                                .folder = "docs/measured" };

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    report_begin(&(struct report){ .program = "pacing", .folder = o.folder, .page = "pacing", .exact = o.exact });
    report_run(&o, SECTIONS, COUNT);
    report_finish(ABOUT, "");
    return 0;
}
