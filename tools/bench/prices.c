/*
 * prices.c - section "prices": what a bullet costs that does more than fly straight, and what an item does. One board a
 * price, all run in turns.
 */
#include <stdlib.h>
#include "bench.h"

enum { N = 4096, ROUNDS = 25, FRAMES = 8, ITEMS = 512 };

static const struct price {
    const char *dip, *what;
} PRICES[] = {
    { "straight", "flies straight" },
    { "accel", "runs `accel`" },
    { "turn", "runs `turn`" },
    { "drive", "runs `turn` and `speed`" },
    { "aim", "runs `aim`" },
    { "home", "runs `home`" },
    { "mixed",
      "runs a program: ten, one an op (`wait kind bank dir aim turn home speed accel loop`), equally many of each" },
    { "fine", "is `fine`, and flies straight" },
    { "fine_drive", "is `fine`, and runs `turn` and `speed`" },
    { "polar", "runs `polar` (`orbit` and `go_to` are like it)" },
    { "wave", "runs `wave`" },
    { "group", "is written to through a group" },
    { "each", "is visited by `bullet.each`, and written to" },
    { "task", "has a Lua task that waits one frame" },
    { "fire", "is fired, once, and gone in the same frame" },
    { "half", NULL },
};
enum { COUNT = sizeof PRICES / sizeof *PRICES, HALF = COUNT - 1 };

/* What an item costs: a tick with so many more of them, and their pictures. */
static void item_prices(void)
{
    static const struct {
        const char *does, *what;
        int n;
    } rows[] = { { "straight", NULL, 0 }, { "straight", "falls", ITEMS }, { "home", "flies to the ship", ITEMS } };
    enum { ROWS = sizeof rows / sizeof *rows };
    struct scene s[ROWS];
    struct samples tick[ROWS] = { { 0 } }, draw[ROWS] = { { 0 } };

    for (int i = 0; i < ROWS; i++)
        bench_scene(&s[i],
                    &(struct scene_want){ .does = "items", .price = rows[i].does, .n = rows[i].n, .bullets = 64 });
    for (int round = -2; round < ROUNDS; round++)
        for (int i = 0; i < ROWS; i++)
            for (int f = 0; f < FRAMES; f++) {
                double from = bench_now();
                bench_tick(&s[i]);
                double ticked = bench_now();
                scene_draw(&s[i]);
                if (round < 0 || f == 0)
                    continue;
                samples_add(&tick[i], ticked - from);
                samples_add(&draw[i], bench_now() - ticked);
            }
    report_text("Nanoseconds for each of %s items of 12 px, beyond a board without any.", report_count(ITEMS));
    report_table(NULL, "an item that | tick> | draw>");
    for (int i = 1; i < ROWS; i++)
        report_row(i == 1, rows[i].what, report_figure((samples_median(&tick[i]) - samples_median(&tick[0])) / ITEMS),
                   report_figure((samples_median(&draw[i]) - samples_median(&draw[0])) / ITEMS), NULL);
    report_table_end();
    for (int i = 0; i < ROWS; i++) {
        samples_free(&tick[i]);
        samples_free(&draw[i]);
        scene_close(&s[i]);
    }
}

void section_prices(void)
{
    struct scene *scenes = calloc(COUNT, sizeof *scenes);
    struct samples ns[COUNT] = { { 0 } };
    double took[COUNT] = { 0 };

    if (!scenes)
        report_fail("out of memory");
    for (int i = 0; i < COUNT; i++)
        bench_scene(&scenes[i], &(struct scene_want){ .does = "prices", .price = PRICES[i].dip, .n = N, .bullets = N });
    for (int round = -1; round < ROUNDS; round++) /* the first warms up */
        for (int i = 0; i < COUNT; i++) {
            bench_clock_for(took[i]);
            for (int f = 0; f < FRAMES; f++) {
                double from = bench_now();
                bench_tick(&scenes[i]);
                took[i] = bench_since(from);
                if (round >= 0 && f > 0) /* the first fetches its board into the caches */
                    samples_add(&ns[i], took[i]);
            }
        }
    bench_own_clock(false);

    double straight = samples_median(&ns[0]);
    report_section("What a bullet costs");
    report_text(
        "Nanoseconds of a tick for each of %s bullets that all do the same in every frame, and what that is beyond "
        "those of one that flies straight. Nothing is drawn; no bullet comes near the player.",
        report_count(N));
    report_table(NULL, "a bullet that | in all> | beyond straight>");
    for (int i = 0; i < HALF; i++)
        report_row(i == 0, PRICES[i].what, samples_figure(&ns[i], N),
                   i ? report_figure((samples_median(&ns[i]) - straight) / N) : "", NULL);
    report_table_end();

    double half = samples_median(&ns[HALF]) / 1e3;
    report_text("Of %s bullets every other one runs one of those ten programs, each with an op active in every frame, "
                "equally many of each: the tick takes **%s µs**.",
                report_count(N), samples_figure(&ns[HALF], 1e3));
    bench_target("4,096 bullets, half of them running programs, all ops in equal parts: the tick", "60 µs",
                 report_string("%s µs", report_figure(half)), half < 60);
    for (int i = 0; i < COUNT; i++) {
        samples_free(&ns[i]);
        scene_close(&scenes[i]);
    }
    free(scenes);
    item_prices();
}
