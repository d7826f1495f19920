/*
 * looks.c - of section "prices": what sparks, trails and sprites cost.
 */
#include "bench.h"

enum { N = 512, ROUNDS = 25, FRAMES = 8 };

/* DIP price_look of roms/bench, which says what N things are, and the row that they are beyond. */
static const struct look {
    const char *dip, *what;
    int beyond;
    bool seen;
} LOOKS[] = {
    { "none", NULL, 0, false },
    { "dots", NULL, 0, false },
    { "sparks_fly", "a spark of 12 px that flies, with gravity, drag and colours", 0, true },
    { "sparks_burst", "a spark that spawns at a point, with 63 others", 0, false },
    { "sparks_ring", "a spark that spawns on a ring", 0, false },
    { "sparks_row", "a spark that spawns on a line", 0, false },
    { "trails", "a trail that emits a spark in every frame", 1, false },
    { "stand", "a stationary sprite of 12 px", 1, true },
    { "follow", "a sprite that follows a bullet", 1, true },
};
enum { COUNT = sizeof LOOKS / sizeof *LOOKS };

static struct run {
    struct scene scene;
    struct samples tick, draw;
} runs[COUNT];

static void measure(void)
{
    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < COUNT; i++)
            for (int f = 0; f < FRAMES; f++) {
                double from = bench_now();
                bench_tick(&runs[i].scene);
                const double ticked = bench_since(from);
                from = bench_now();
                scene_draw(&runs[i].scene);
                const double drawn = bench_since(from);
                if (round < 0 || f == 0)
                    continue;
                samples_add(&runs[i].tick, ticked);
                samples_add(&runs[i].draw, drawn);
            }
}

void looks_prices(void)
{
    for (int i = 0; i < COUNT; i++)
        bench_scene(&runs[i].scene,
                    &(struct scene_want){ .does = "looks", .price = LOOKS[i].dip, .n = N, .bullets = N, .sparks = N });
    measure();
    report_text("**Effects.** The next table shows how many nanoseconds each of %s visual effects adds to a frame.",
                report_count(N));
    report_table(NULL, "an effect | tick> | draw>");
    for (int i = 0; i < COUNT; i++) {
        struct run *r = &runs[i], *b = &runs[LOOKS[i].beyond];
        if (!LOOKS[i].what)
            continue;
        const double tick = samples_median(&r->tick) - samples_median(&b->tick),
                     draw = samples_median(&r->draw) - samples_median(&b->draw);
        report_row(i == 2, LOOKS[i].what, report_string("%s", report_figure(tick / N)),
                   LOOKS[i].seen ? report_figure(draw / N) : "", NULL);
    }
    report_table_end();
    for (int i = 0; i < COUNT; i++) {
        samples_free(&runs[i].tick);
        samples_free(&runs[i].draw);
        scene_close(&runs[i].scene);
    }
}
