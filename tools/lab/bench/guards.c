/*
 * guards.c - section "guards": how long the worst operations run before the guard of endless loops stops them.
 */
#include <stdio.h>
#include <string.h>
#include "bench.h"
#include "dearest.h"
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
    if (!fault || !strstr(fault, "infinite loop"))
        report_fail(report_string("%s: %s", w->what, fault ? fault : "it ended"));
    scene_close(&s);
    return took / 1e9 * ((double)WORK_LIMIT / WORST_LIMIT);
}

/* Of one of the dearest frames: seconds of its tick and of its picture, the work it counted, and how it ended. */
struct took {
    double tick, draw;
    uint64_t work;
    char end[160];
};

static void time_dearest(const struct dearest *d, struct took *t)
{
    struct scene s;
    char err[256];
    bool fine = true;

    *t = (struct took){ .end = "below the limit" };
    if (!scene_power(&s, bench_rom(), &d->want, err, sizeof err))
        report_fail(report_string("%s: %s", d->what, err));
    for (int i = 0; fine && i < d->frames; i++) {
        double from = bench_now();
        fine = scene_tick(&s);
        const double tick = bench_since(from) / 1e9;
        from = bench_now();
        scene_draw(&s);
        const double draw = bench_since(from) / 1e9;
        t->tick = tick > t->tick ? tick : t->tick;
        t->draw = draw > t->draw ? draw : t->draw;
        t->work = s.b->vm.work > t->work ? s.b->vm.work : t->work;
    }
    if (!fine)
        snprintf(t->end, sizeof t->end, "%.60s...", board_last_output(s.b)->fault->message);
    scene_close(&s);
}

static void dearest_frames(void)
{
    double worst = 0;
    const char *what = "";

    report_section("The most expensive frames");
    report_text(
        "Work done in C is counted like the work of scripts. The table has a frame for each feature whose work the "
        "manifest does not limit, with as much of that work as possible. It shows the units of work counted, and the "
        "seconds that the tick and the picture take. A frame with more than %s units ends in a fault.",
        report_count(WORK_LIMIT));
    report_table(NULL, "a frame of | counted> | tick> | picture> | ends");
    bench_own_clock(true);
    for (int i = 0; i < DEAREST_COUNT; i++) {
        struct took t;
        time_dearest(&DEAREST[i], &t);
        report_row(false, DEAREST[i].what, report_count((int64_t)t.work), report_figure(t.tick), report_figure(t.draw),
                   t.end, NULL);
        if (t.tick + t.draw > worst)
            worst = t.tick + t.draw, what = DEAREST[i].what;
    }
    bench_own_clock(false);
    report_table_end();
    bench_target("the most expensive frame of any feature", "2 s",
                 report_string("%s s, for %s", report_figure(worst), what), worst < 2);
}

void section_guards(void)
{
    double worst = 0;
    const char *what = "";

    report_section("Endless loops");
    report_text(
        "A frame ends in a fault after %s units of [work](../guide/20-determinism.md#how-much-work-a-frame-may-do), so "
        "no script can loop forever. Some operations take longer than their units suggest. The table lists the slowest "
        "known operations, with the seconds until the fault. Each operation runs in an endless loop, in most cases "
        "four times per pass.",
        report_count(WORK_LIMIT));
    report_table(NULL, "operation | seconds> | units of work per pass>");
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
    bench_target("time until the slowest endless loop is stopped", "30 s",
                 report_string("%s s, for %s", report_figure(worst), what), worst < 30);
    dearest_frames();
}
