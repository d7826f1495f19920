/*
 * guards.c - section "guards": how long the worst operations run before the guard of endless loops stops them.
 */
#include <string.h>
#include "bench.h"
#include "worst.h"

/* Seconds until a frame's limit is reached, at the pace of WORST_LIMIT; *rounds: how often it ran until that. */
static double seconds(const struct worst *w, uint64_t *rounds)
{
    struct scene s;
    const char *fault;

    bench_scene(&s, &(struct scene_want){ .does = "prices", .price = "straight", .n = 4096, .bullets = 4096 });
    double from = bench_now();
    *rounds = worst_run(s.b, w, &fault);
    double took = bench_since(from);
    if (!fault || !strstr(fault, "endless loop"))
        report_fail(report_string("%s: %s", w->what, fault ? fault : "it ended"));
    scene_close(&s);
    return took / 1e9 * ((double)WORK_LIMIT / WORST_LIMIT);
}

void section_guards(void)
{
    double worst = 0;
    const char *what = "";

    report_section("Endless loops");
    report_text("A frame that runs for ever ends in the fault that it has more than %s instructions. Some operations "
                "take longer than others for what they count; these are the ones known to. Seconds until the fault.",
                report_count(WORK_LIMIT));
    report_table(NULL, "a loop of | seconds> | instructions counted for each>");
    bench_own_clock(true);
    for (int i = 0; i < WORST_COUNT; i++) {
        uint64_t rounds;
        double s = seconds(&WORST[i], &rounds);
        report_row(false, WORST[i].what, report_figure(s), report_count((int64_t)(WORST_LIMIT / (rounds ? rounds : 1))),
                   NULL);
        if (s > worst)
            worst = s, what = WORST[i].what;
    }
    bench_own_clock(false);
    report_table_end();
    bench_target("the slowest endless loop until it is found", "30 s",
                 report_string("%s s: %s", report_figure(worst), what), worst < 30);
}
