/*
 * boss.c - section "boss": a boss fight as games have them, in three sizes, where its frames go, and what its parts
 * take.
 */
#include <stdlib.h>
#include "../../../platform/platform.h"
#include "bench.h"

enum { SIZES = 3, WARM = 400, ROUNDS = 12, FRAMES = 20, SPARKS = 320 };

static const int sizes[SIZES] = { 3000, 10000, 30000 };

/* What the fight of the first size is without: values of DIP price_part of roms/bench. */
static const struct left_out {
    const char *dip, *what;
} LEFT_OUT[] = {
    { "no_scenery", "two scrolling tile layers" },
    { "no_lasers", "8 rotating beams, 220 px long and 8 px wide" },
    { "no_items", "64 items of 12 px" },
    { "no_sparks", "300 sparks of 12 px" },
};
enum { LEFT_OUTS = sizeof LEFT_OUT / sizeof *LEFT_OUT };

struct fight {
    struct scene scene;
    uint32_t *shown;
    struct laps laps;
    struct samples lap[LAPS], frame;
    int64_t live; /* bullets, summed over the frames that count */
};

static void open_fight(struct fight *f, int n, const char *part)
{
    bench_scene(&f->scene,
                &(struct scene_want){
                    .does = "boss", .price = part, .n = n, .bullets = 2 * n, .sparks = SPARKS, .scenery = true });
    f->shown = calloc((size_t)(f->scene.fb.w * f->scene.fb.h), sizeof *f->shown);
    if (!f->shown)
        report_fail("out of memory");
    for (int k = 0; k < WARM; k++)
        bench_tick(&f->scene);
    board_set_phase_callback(f->scene.b, laps_phase, &f->laps);
}

static void close_fight(struct fight *f)
{
    for (int l = 0; l < LAPS; l++)
        samples_free(&f->lap[l]);
    samples_free(&f->frame);
    free(f->shown);
    scene_close(&f->scene);
}

static void frame(struct fight *f, bool counts)
{
    const struct fb *fb = &f->scene.fb;
    double sum = 0;

    laps_begin(&f->laps);
    bench_tick(&f->scene);
    scene_draw(&f->scene);
    laps_end(&f->laps, LAP_DRAW);
    plat_convert_to_rgb(f->shown, fb->w, fb->pix, fb->pitch, fb->w, fb->h, f->scene.rgb);
    laps_end(&f->laps, LAP_PRESENT);
    if (!counts)
        return;
    for (int l = 0; l < LAPS; l++) {
        samples_add(&f->lap[l], f->laps.ns[l]);
        sum += f->laps.ns[l];
    }
    samples_add(&f->frame, sum);
    f->live += board_live_count(f->scene.b, "bullets");
}

static void print_row(struct fight *f)
{
    const char *us[LAPS];

    for (int l = 0; l < LAPS; l++)
        us[l] = report_string("%s", report_figure(samples_median(&f->lap[l]) / 1e3));
    report_row(false, report_count(f->live / f->frame.n), us[LAP_SCRIPTS], us[LAP_MOTION], us[LAP_HITS], us[LAP_EVENTS],
               us[LAP_REST], us[LAP_DRAW], us[LAP_PRESENT], samples_figure(&f->frame, 1e3), NULL);
}

/* The tick, of its parts: the median of each, so that what runs in few frames counts in none. */
static double tick_of(struct fight *f)
{
    double sum = 0;

    for (int l = 0; l < LAP_DRAW; l++)
        sum += samples_median(&f->lap[l]);
    return sum;
}

static void print_part(const char *what, struct fight *with, struct fight *without)
{
    const double tick = tick_of(with) - tick_of(without);
    const double draw = samples_median(&with->lap[LAP_DRAW]) - samples_median(&without->lap[LAP_DRAW]);

    report_row(false, what, report_string("%s", report_figure(tick / 1e3)),
               report_string("%s", report_figure(draw / 1e3)), NULL);
}

/* What the fight takes beyond one without a part of it. */
static void parts(void)
{
    static struct fight whole, without[LEFT_OUTS];

    open_fight(&whole, sizes[0], NULL);
    for (int i = 0; i < LEFT_OUTS; i++)
        open_fight(&without[i], sizes[0], LEFT_OUT[i].dip);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = -1; i < LEFT_OUTS; i++)
            for (int k = 0; k < FRAMES; k++)
                frame(i < 0 ? &whole : &without[i], k > 0);
    report_text("The next table shows the cost of each of the other parts of the fight in microseconds. This cost is "
                "the time of the fight with %s bullets, minus the time of the same fight without that part.",
                report_count(whole.live / whole.frame.n));
    report_table(NULL, "part | tick> | draw>");
    for (int i = 0; i < LEFT_OUTS; i++)
        print_part(LEFT_OUT[i].what, &whole, &without[i]);
    report_table_end();
    close_fight(&whole);
    for (int i = 0; i < LEFT_OUTS; i++)
        close_fight(&without[i]);
}

void section_boss(void)
{
    static struct fight fights[SIZES];

    for (int i = 0; i < SIZES; i++)
        open_fight(&fights[i], sizes[i], NULL);
    for (int round = 0; round < ROUNDS; round++) {
        bench_look();
        for (int i = 0; i < SIZES; i++)
            for (int k = 0; k < FRAMES; k++)
                frame(&fights[i], k > 0); /* the first fetches its board into the caches */
    }
    report_section("A boss fight");
    report_text("The table shows the microseconds per frame of a typical boss fight on 320x240 px. *Live* is the "
                "number of live bullets. The bullets are 8 to 16 px in size and fly in rings of 20 to 200. Four in "
                "five bullets are rotated, one in five is blended, and two in five run a motion program that turns or "
                "accelerates them. The fight also has a boss, 300 sparks, 8 rotating lasers, 64 items, two tile "
                "layers, a row of text, and a player who flies around.");
    report_table(NULL, "live> | scripts> | motion> | hits> | events> | rest> | draw> | present> | sum>");
    for (int i = 0; i < SIZES; i++)
        print_row(&fights[i]);
    report_table_end();
    parts();
    for (int i = 0; i < SIZES; i++) {
        const int64_t live = fights[i].live / fights[i].frame.n;
        bench_claim(live > sizes[i] * 4 / 5 && live < sizes[i] * 6 / 5 ? NULL : "it has another size",
                    "the boss fight");
        close_fight(&fights[i]);
    }
}
