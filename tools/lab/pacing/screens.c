/*
 * screens.c - ten minutes of pace.h on screens of many rates.
 */
#include <stdlib.h>
#include "../report/report.h"
#include "pacing.h"
#include "simulate.h"

enum { SECONDS = 600, JITTER = 1000 };

static const double rates[] = { 50, 59.94, 60, 75, 120, 144 };

static void row(double hz, bool waits, int stalls)
{
    const struct simulate s = { .hz = hz,
                                .told = hz,
                                .waits = waits,
                                .seconds = SECONDS,
                                .work = { 2000, 5000 },
                                .late = JITTER,
                                .stalls = stalls,
                                .seed = (uint64_t)(hz * 100) };
    const struct simulated r = simulate(&s);

    report_row(false, report_string("%g Hz", hz), waits ? "yes" : "no", report_count(r.ticks), report_count(r.with[0]),
               report_count(r.with[1]), report_count(r.with[2] + r.with[3]), report_count(llabs(r.least)),
               report_count(llabs(simulated_uneven(&r))), report_string("%.1f", r.off),
               report_string("%.1f ms", r.mean / 1000), NULL);
}

void section_screens(void)
{
    report_section("Screens");
    report_text("Each screen is simulated for ten minutes, in which 36,000 ticks are due. A frame takes 2 to 5 ms to "
                "compute, and\n"
                "whenever the host waits, it resumes up to 1 ms late. The columns are:\n"
                "\n"
                "* *none*, *one* and *two*: how many refreshes show no new tick, one new tick, and two new ticks\n"
                "* *required*: how many refreshes must show no new tick or two because the rates differ\n"
                "* *extra*: how many more refreshes than required show no new tick or two\n"
                "* *off*: the largest deviation of the ticks from the clock\n"
                "* *to the screen*: the average time that a tick waits for its refresh");
    report_table(NULL, "screen|vsync|ticks>|none>|one>|two>|required>|extra>|off, ticks>|to the screen>");
    for (int waits = 1; waits >= 0; waits--)
        for (unsigned i = 0; i < sizeof rates / sizeof *rates; i++)
            row(rates[i], waits, 0);
    report_table_end();
    report_text("In the next table, one frame in 600 takes 25 ms:");
    report_table(NULL, "screen|vsync|ticks>|none>|one>|two>|required>|extra>|off, ticks>|to the screen>");
    row(60, true, 600);
    row(144, true, 600);
    report_table_end();
}
