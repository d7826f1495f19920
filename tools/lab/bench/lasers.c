/*
 * lasers.c - section "lasers": 64 curves of 64 points, ticked and drawn, each way that a strip can be drawn.
 */
#include "bench.h"

enum { CURVES = 64, WARM = 70, ROUNDS = 20, FRAMES = 10 };

static const struct way {
    const char *dip, *what;
} WAYS[] = {
    { "plain", "a strip one pixel wide" },
    { "sprite", "a repeating strip of 16 px" },
    { "blended", "a strip one pixel wide, blended" },
};
enum { COUNT = sizeof WAYS / sizeof *WAYS };

static void measure(struct scene *s, struct samples *tick, struct samples *draw)
{
    for (int f = 0; f < WARM; f++)
        bench_tick(s);
    bench_own_clock(true);
    for (int round = -1; round < ROUNDS; round++)
        for (int f = 0; f < FRAMES; f++) {
            if (f == 0)
                bench_look();
            double from = bench_now();
            bench_tick(s);
            const double ticked = bench_since(from);
            from = bench_now();
            scene_draw(s);
            const double drawn = bench_since(from);
            if (round < 0)
                continue;
            samples_add(tick, ticked);
            samples_add(draw, drawn);
        }
    bench_own_clock(false);
}

void section_lasers(void)
{
    struct samples tick[COUNT] = { { 0 } }, draw[COUNT] = { { 0 } }, still = { 0 }, empty = { 0 };
    struct scene s;
    double us = 0;

    bench_scene(&s, &(struct scene_want){ .does = "lasers", .n = 0, .bullets = 64 });
    measure(&s, &still, &empty);
    scene_close(&s);
    report_section("Lasers");
    report_text(
        "The table shows how many microseconds %s circling curved lasers add to a frame. Each laser has 64 points, is "
        "8 px wide and moves at 2.5 px/frame. The player is among the lasers, so the tick includes grazes and hits.",
        report_count(CURVES));
    report_table(NULL, "drawn with | tick> | draw>");
    for (int i = 0; i < COUNT; i++) {
        bench_scene(&s, &(struct scene_want){ .does = "lasers", .picture = WAYS[i].dip, .n = CURVES, .bullets = 64 });
        measure(&s, &tick[i], &draw[i]);
        bench_claim(board_live_count(s.b, "lasers") == CURVES ? NULL : "some curves are gone", "the lasers");
        scene_close(&s);
        const double t = (samples_median(&tick[i]) - samples_median(&still)) / 1e3,
                     d = (samples_median(&draw[i]) - samples_median(&empty)) / 1e3;
        report_row(i == 0, WAYS[i].what, report_string("%s", report_figure(t)), report_figure(d), NULL);
        us = i == 0 ? t + d : us;
    }
    report_table_end();
    bench_target("64 curved lasers of 64 points: tick and draw", "300 µs", report_string("%s µs", report_figure(us)),
                 us < 300);
    for (int i = 0; i < COUNT; i++) {
        samples_free(&tick[i]);
        samples_free(&draw[i]);
    }
    samples_free(&still);
    samples_free(&empty);
}
