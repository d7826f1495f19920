/*
 * pictures.c - section "pictures": what drawing a sprite costs by size and by what is done to it, and presenting.
 */
#include <stdlib.h>
#include "bench.h"
#include "../../../platform/platform.h"

enum { ROUNDS = 15 };
static const double PRESENT_US = 20;

static void transforms(struct manifest *m)
{
    m->has_transforms = 1;
}

static const struct way {
    const char *dip, *what;
    void (*manifest)(struct manifest *m);
} WAYS[] = {
    { "plain", "bullets of one kind", NULL },
    { "banks", "each in its own bank", NULL },
    { "turned", "rotated, each showing one of 16 pictures", NULL },
    { "clipped", "half outside the left edge", NULL },
    { "sprite", "free sprites", NULL },
    { "flipped", "free sprites, flipped", NULL },
    { "blended", "bullets of one kind, blended (`add`)", NULL },
    { "blended_banks", "blended, each in its own bank", NULL },
    { "ramp", "blended by a ramp (`{ ramp = \"add\" }`)", NULL },
    { "scaled", "bullets of one kind with `scale = 1.5`", transforms },
    { "scaled_turned", "the same, rotated", transforms },
    { "sprite_turned", "free sprites with `dir`", transforms },
    { "sprite_scaled", "free sprites with `scale = 1.5`", transforms },
    { "alpha", "free sprites with `alpha = 6`, as dots", transforms },
};
enum { COUNT = sizeof WAYS / sizeof *WAYS };
static const int SIDES[] = { 8, 16, 32, 64, 128 };
enum { SIZES = sizeof SIDES / sizeof *SIDES };

static int how_many(int side)
{
    return side <= 16 ? 4096 : side <= 32 ? 1024 : 256;
}

/* Nanoseconds of a picture: each of `samples` is one of n things; all ways of a size take turns. */
static void measure(int side, int n, struct samples samples[COUNT])
{
    struct scene scenes[COUNT];
    double took[COUNT] = { 0 };

    for (int i = 0; i < COUNT; i++)
        bench_scene(&scenes[i], &(struct scene_want){ .does = "pictures",
                                                      .picture = WAYS[i].dip,
                                                      .manifest = WAYS[i].manifest,
                                                      .n = n,
                                                      .bullets = 4096,
                                                      .side = side,
                                                      .seed = (uint64_t)side });
    for (int round = -1; round < ROUNDS; round++)
        for (int i = 0; i < COUNT; i++) {
            bench_clock_for(took[i]);
            if (i == 0)
                bench_look();
            for (int k = 0; k < 3; k++) {
                double from = bench_now();
                scene_draw(&scenes[i]);
                took[i] = bench_since(from);
                if (round >= 0 && k > 0)
                    samples_add(&samples[i], took[i]);
            }
        }
    bench_own_clock(false);
    for (int i = 0; i < COUNT; i++) {
        bench_claim(scenes[i].drawn >= (uint64_t)n ? NULL : "sprites are missing", WAYS[i].what);
        scene_close(&scenes[i]);
    }
}

static void presenting(void)
{
    enum { W = 320, H = 240, TIMES = 200 };
    struct samples ns = { 0 };
    struct scene s;
    uint32_t *out = malloc(W * H * sizeof *out);

    if (!out)
        report_fail("out of memory");
    bench_scene(&s, &(struct scene_want){ .does = "crowd", .n = 4096, .bullets = 4096 });
    scene_draw(&s);
    for (int i = 0; i < TIMES; i++) {
        double from = bench_now();
        plat_convert_to_rgb(out, W, s.fb.pix, s.fb.pitch, W, H, s.rgb);
        samples_add(&ns, bench_since(from));
    }
    double us = samples_median(&ns) / 1e3;
    report_text("**Presenting**: converting 320x240 px from palette indices to 32-bit pixels takes **%s µs**.",
                samples_figure(&ns, 1e3));
    bench_target("converting 320x240 px to 32-bit pixels", "20 µs", report_string("%s µs", report_figure(us)),
                 us < PRESENT_US);
    samples_free(&ns);
    scene_close(&s);
    free(out);
}

void section_pictures(void)
{
    static struct samples ns[SIZES][COUNT], empty[COUNT];
    const char *cells[1 + SIZES];

    measure(8, 0, empty);
    for (int i = 0; i < SIZES; i++)
        measure(SIDES[i], how_many(SIDES[i]), ns[i]);
    report_section("Pictures");
    report_text("The table shows the nanoseconds per sprite, by the size of the sprite in px. In each sprite, 13 of 16 "
                "pixels are opaque, at random positions. The time of an empty picture, %s µs, is subtracted.",
                samples_figure(&empty[0], 1e3));
    report_table(NULL, "| 8x8> | 16x16> | 32x32> | 64x64> | 128x128>");
    for (int w = 0; w < COUNT; w++) {
        cells[0] = WAYS[w].what;
        for (int i = 0; i < SIZES; i++)
            cells[1 + i] = report_figure((samples_median(&ns[i][w]) - samples_median(&empty[w])) / how_many(SIDES[i]));
        report_cells(w == 0, cells, 1 + SIZES);
    }
    report_table_end();
    report_plot(&(struct report_plot){
        "pictures", "Drawing a sprite", "side, px", "ns per sprite", .timed = true,
        .described = "Nanoseconds per sprite by side length, one line for each way of drawing it" });
    for (int w = 0; w < COUNT; w++) {
        double x[SIZES], y[SIZES];
        for (int i = 0; i < SIZES; i++) {
            x[i] = SIDES[i];
            y[i] = (samples_median(&ns[i][w]) - samples_median(&empty[w])) / how_many(SIDES[i]);
        }
        report_plot_line(WAYS[w].dip, w == 0, x, y, SIZES);
    }
    report_plot_end();
    presenting();
    for (int w = 0; w < COUNT; w++) {
        samples_free(&empty[w]);
        for (int i = 0; i < SIZES; i++)
            samples_free(&ns[i][w]);
    }
    scenery_prices();
}
