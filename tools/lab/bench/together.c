/*
 * together.c - section "together": all that a frame of a shooter may have at once, and each part of it alone.
 */
#include "bench.h"

enum { BULLETS = 8192, LASERS = 64, ITEMS = 512, SPARKS = 2048, BURST = 32, WARM = 70, ROUNDS = 15, FRAMES = 10 };

static const struct share {
    const char *dip, *what;
} SHARES[] = {
    { "nothing", "a cleared field and a player" },
    { "only_bullets", "8,192 bullets of 8 px" },
    { "only_lasers", "64 lasers: 56 curves of 64 points and 8 beams, 8 px wide" },
    { "only_items", "512 items of 12 px" },
    { "only_sparks", "2,048 sparks of 12 px with gravity, drag and colours" },
    { "only_scenery", "three layers with shifted lines, and a plane with fog" },
    { "everything", "all together" },
};
enum { COUNT = sizeof SHARES / sizeof *SHARES, ALL = COUNT - 1 };

/* A share of it being measured. */
struct run {
    struct scene scene;
    struct samples tick, draw, frame;
};

/* All parts take turns. */
static void measure(struct run *runs)
{
    bench_own_clock(true);
    for (int round = -1; round < ROUNDS; round++)
        for (int i = 0; i < COUNT; i++)
            for (int f = 0; f < FRAMES; f++) {
                struct run *r = &runs[i];
                if (f == 0 && i == 0)
                    bench_look();
                double from = bench_now();
                bench_tick(&r->scene);
                const double ticked = bench_since(from);
                from = bench_now();
                scene_draw(&r->scene);
                const double drawn = bench_since(from);
                if (round < 0 || f == 0) /* the first fetches its board into the caches */
                    continue;
                samples_add(&r->tick, ticked);
                samples_add(&r->draw, drawn);
                samples_add(&r->frame, ticked + drawn);
            }
    bench_own_clock(false);
}

/* All is there. */
static void check(const struct board *b)
{
    static const struct {
        const char *what;
        int n;
    } there[] = { { "bullets", BULLETS }, { "lasers", LASERS }, { "items", ITEMS }, { "sparks", SPARKS } };

    for (int i = 0; i < (int)(sizeof there / sizeof *there); i++)
        bench_claim(board_live_count(b, there[i].what) == there[i].n ? NULL : "some are gone", there[i].what);
    bench_claim(b->bg.map[0] && b->bg.map[1] && b->bg.map[2] && b->bg.map[BG_PLANE] ? NULL : "it is gone",
                "the background");
}

static void print(struct run *runs)
{
    const double tick = samples_median(&runs[0].tick), draw = samples_median(&runs[0].draw);
    double ticks = tick, draws = draw;

    report_table(NULL, "part | tick> | draw> | both>");
    for (int i = 0; i < COUNT; i++) {
        report_row(i == ALL, SHARES[i].what, report_string("%s", report_figure(samples_median(&runs[i].tick) / 1e3)),
                   report_string("%s", report_figure(samples_median(&runs[i].draw) / 1e3)),
                   samples_figure(&runs[i].frame, 1e3), NULL);
        ticks += i && i < ALL ? samples_median(&runs[i].tick) - tick : 0;
        draws += i && i < ALL ? samples_median(&runs[i].draw) - draw : 0;
    }
    report_table_end();
    report_text("Every row includes the cleared field and the player. If the field and the player are counted only "
                "once, the parts add up to %s µs for the tick and %s µs for the picture.",
                report_string("%s", report_figure(ticks / 1e3)), report_figure(draws / 1e3));
}

void section_together(void)
{
    static struct run runs[COUNT];

    for (int i = 0; i < COUNT; i++) {
        bench_scene(&runs[i].scene, &(struct scene_want){ .does = "together",
                                                          .price = SHARES[i].dip,
                                                          .n = BULLETS,
                                                          .bullets = BULLETS,
                                                          .sparks = SPARKS + BURST,
                                                          .scenery = true });
        for (int f = 0; f < WARM; f++)
            bench_tick(&runs[i].scene);
    }
    measure(runs);
    check(runs[ALL].scene.b);
    report_section("All together");
    report_text("The table shows the microseconds per frame on 320x240 px. The player flies around among everything, "
                "and is constantly grazed and hit.");
    print(runs);
    const double us = samples_median(&runs[ALL].frame) / 1e3;
    bench_target("8,192 bullets, 64 lasers, 512 items, 2,048 sparks, three layers and a plane: tick and draw", "2 ms",
                 report_string("%s ms", report_figure(us / 1e3)), us < 2000);
    for (int i = 0; i < COUNT; i++) {
        samples_free(&runs[i].tick);
        samples_free(&runs[i].draw);
        samples_free(&runs[i].frame);
        scene_close(&runs[i].scene);
    }
}
