/*
 * game.c - sections "game", the built-in game as its demo plays it, "games", all its whole games, and "memory", what
 * boards and bullets take.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum { RUNS = 3, WINDOW = 600, SECOND = 60 };

/* A board that plays the demo. */
struct player_piano {
    const struct demo *demo;
    struct board *b;
    void *ram, *mem, *scratch;
    struct fb fb;
    uint32_t rgb[256];
};

static void piano_open(struct player_piano *p, const struct rom *rom, const struct demo *demo)
{
    char err[256];
    size_t size;
    int w, h;

    p->demo = demo;
    if (!board_size(rom, &size, err, sizeof err))
        report_fail(err);
    p->ram = aligned_alloc(64, (size + 63) / 64 * 64);
    if (!p->ram || !(p->b = board_power_on(p->ram, size, rom, &demo->start, err, sizeof err)))
        report_fail(p->ram ? err : "out of memory");
    board_screen_size(p->b, &w, &h);
    p->mem = malloc(fb_size(w, h));
    p->scratch = malloc(board_scratch_size(p->b));
    if (!p->mem || !p->scratch)
        report_fail("out of memory");
    fb_init(&p->fb, p->mem, w, h);
}

static void piano_close(struct player_piano *p)
{
    free(p->scratch);
    free(p->mem);
    free(p->ram);
}

/* The next frame; its nanoseconds. */
static double piano_frame(struct player_piano *p, bool draw)
{
    uint16_t pads[MAX_PLAYERS];
    double from = bench_now();

    demo_pads(p->demo, board_frame(p->b), pads);
    if (board_tick(p->b, pads)->fault)
        report_fail(board_last_output(p->b)->fault->message);
    if (draw)
        board_draw(p->b, NULL, &p->fb, p->rgb, p->scratch);
    return bench_since(from);
}

/* The state at the end is the one that was recorded. */
static void piano_check(const struct player_piano *p)
{
    const struct demo *d = p->demo;
    uint64_t hashes[MAX_PARTS];
    const uint64_t *row = d->rows + (size_t)(d->n_rows - 1) * (size_t)d->n_parts;

    board_hashes(p->b, hashes);
    bench_claim(d->n_parts == board_part_count(p->b) && !memcmp(hashes, row, (size_t)d->n_parts * sizeof *row)
                    ? NULL
                    : "the demo did not hold",
                BENCH_DEMO);
}

/* Nanoseconds of each frame, run by run: ns[(run * frames + f) * 2 + drawn]. The two boards take turns, a second
 * each. */
static void play(const struct rom *rom, const struct demo *d, double *ns)
{
    for (int run = 0; run < RUNS; run++) {
        struct player_piano p[2];
        for (int k = 0; k < 2; k++)
            piano_open(&p[k], rom, d);
        for (uint32_t f = 0; f < d->frames; f += SECOND)
            for (int k = 0; k < 2; k++)
                for (uint32_t i = f; i < f + SECOND && i < d->frames; i++)
                    ns[((size_t)run * d->frames + i) * 2 + (size_t)k] = piano_frame(&p[k], k);
        for (int k = 0; k < 2; k++) {
            piano_check(&p[k]);
            piano_close(&p[k]);
        }
    }
}

/* A frame's median over the runs. */
static double middle(const double *ns, uint32_t frames, uint32_t f, int drawn)
{
    double v[RUNS];

    for (int run = 0; run < RUNS; run++)
        v[run] = ns[((size_t)run * frames + f) * 2 + (size_t)drawn];
    double low = v[0] < v[1] ? v[0] : v[1], high = v[0] < v[1] ? v[1] : v[0];
    return v[2] < low ? low : v[2] > high ? high : v[2];
}

/* Frames a second over the whole run, in its slowest window of WINDOW frames, and where that begins. */
struct pace {
    double all, slowest;
    uint32_t at;
};

static struct pace pace_of(const double *ns, uint32_t frames, int drawn)
{
    struct pace p = { 0 };
    double sum = 0, window = 0, most = 0;

    for (uint32_t f = 0; f < frames; f++) {
        double t = middle(ns, frames, f, drawn);
        sum += t;
        window += t - (f >= WINDOW ? middle(ns, frames, f - WINDOW, drawn) : 0);
        if (f >= WINDOW - 1 && window > most) {
            most = window;
            p.at = f - (WINDOW - 1);
        }
    }
    p.all = 1e9 * frames / sum;
    p.slowest = 1e9 * WINDOW / most;
    return p;
}

static void plot_run(const double *ns, uint32_t frames)
{
    static const char *const names[] = { "tick alone", "tick and draw" };
    static double x[512], y[512];

    report_plot(&(struct report_plot){
        "run", "The built-in game, second by second", "seconds into the run", "frames a second", .x_linear = true,
        .timed = true, .described = "Frames a second over the built-in game's run, with and without drawing" });
    for (int k = 0; k < 2; k++) {
        uint32_t step = (frames / SECOND / 512 + 1) * SECOND;
        int n = 0;
        for (uint32_t f = 0; f + step <= frames && n < 512; f += step) {
            double sum = 0;
            for (uint32_t i = f; i < f + step; i++)
                sum += middle(ns, frames, i, k);
            x[n] = (double)f / SECOND;
            y[n++] = 1e9 * step / sum;
        }
        report_plot_line(names[k], k == 1, x, y, n);
    }
    report_plot_end();
}

void section_game(void)
{
    static struct demo demo;
    struct rom_image image;

    bench_game(&image, &demo);
    double *ns = malloc((size_t)demo.frames * RUNS * 2 * sizeof *ns);
    if (!ns)
        report_fail("out of memory");
    play(&image.rom, &demo, ns);

    struct pace tick = pace_of(ns, demo.frames, 0), both = pace_of(ns, demo.frames, 1);
    report_section("The built-in game");
    report_text("The demo of a complete run (`%s`) has %s frames (%s minutes). The time of each frame is the median of "
                "%d runs. At the end of each run, the hashes match those in the demo.",
                BENCH_DEMO, report_count(demo.frames), report_figure(demo.frames / 3600.0), RUNS);
    report_table(
        NULL,
        "| frames a second> | frames a second in the slowest 600 frames> | second in which these 600 frames start>");
    report_row(0, "tick alone", report_count((int64_t)tick.all), report_count((int64_t)tick.slowest),
               report_count(tick.at / SECOND), NULL);
    report_row(0, "tick and draw", report_count((int64_t)both.all), report_count((int64_t)both.slowest),
               report_count(both.at / SECOND), NULL);
    report_table_end();
    plot_run(ns, demo.frames);
    bench_target("a complete run of the built-in game, with drawing", "2,000 frames a second",
                 report_string("%s frames a second", report_count((int64_t)both.all)), both.all >= 2000);
    bench_target("... in its slowest 600 frames", "1,000 frames a second",
                 report_string("%s frames a second", report_count((int64_t)both.slowest)), both.slowest >= 1000);
    free(ns);
    demo_free(&demo);
    rom_image_free(&image);
}

/* ---- whole games ---- */

/* A row: one of tests/demos/glasstide. Returns frames a second, drawn, in its slowest window. */
static double whole_game(const struct rom *rom, const char *name)
{
    static struct demo demo;
    char path[256], err[512];

    snprintf(path, sizeof path, "tests/demos/glasstide/%s.demo", name);
    if (!demo_load(&demo, path, err, sizeof err))
        report_fail(err);
    double *ns = malloc((size_t)demo.frames * RUNS * 2 * sizeof *ns);
    if (!ns)
        report_fail("out of memory");
    play(rom, &demo, ns);
    const struct pace tick = pace_of(ns, demo.frames, 0), both = pace_of(ns, demo.frames, 1);
    report_row(0, name, report_count(demo.frames), report_count((int64_t)tick.all), report_count((int64_t)both.all),
               report_count((int64_t)both.slowest), report_count(both.at / SECOND), NULL);
    free(ns);
    demo_free(&demo);
    return both.slowest;
}

void section_games(void)
{
    static const char *const names[] = { "clear-easy",  "clear-normal", "clear-hard",
                                         "clear-abyss", "two-players",  "lose" };
    double slowest = INFINITY;
    struct rom_image image;
    char err[512];

    if (!pack_load_game(BENCH_GAME, false, &image, err, sizeof err))
        report_fail(err);
    report_section("Whole games");
    report_text("The table shows the recorded games of `tests/demos/glasstide`. The time of each frame is the median "
                "of %d runs. Two boards, one with and one without drawing, alternate every second.",
                RUNS);
    report_table(NULL,
                 "| frames> | ticks a second> | with drawing> | in the slowest 600 frames> | starting at second>");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const double now = whole_game(&image.rom, names[i]);
        slowest = now < slowest ? now : slowest;
    }
    report_table_end();
    bench_target("the slowest 600 frames of all whole games, with drawing", "3,000 frames a second",
                 report_count((int64_t)slowest), slowest >= 3000);
    rom_image_free(&image);
}

/* ---- memory ---- */

/* Bytes a snapshot grows by with each live bullet, what Lua keeps of having fired them left out. */
static double live_bytes(void)
{
    enum { N = 65536 };
    double bytes[2];

    for (int i = 0; i < 2; i++) {
        struct scene s;
        bench_scene(&s, &(struct scene_want){ .does = "creep", .n = i * N, .bullets = N });
        bytes[i] = (double)board_snapshot_size(s.b) - (double)heap_save(s.b->vm.heap, NULL);
        scene_close(&s);
    }
    return (bytes[1] - bytes[0]) / N;
}

static size_t ram_of(const char *folder)
{
    struct rom_image image;
    char err[512];
    size_t size;

    if (!pack_load_game(folder, false, &image, err, sizeof err) || !board_size(&image.rom, &size, err, sizeof err))
        report_fail(err);
    rom_image_free(&image);
    return size;
}

void section_memory(void)
{
    enum { MANY = 1 << 20 };
    double reserved = ((double)scene_ram(bench_rom(), 2 * MANY) - (double)scene_ram(bench_rom(), MANY)) / MANY;
    double usual = (double)ram_of("examples/first") / (1 << 20), game = (double)ram_of(BENCH_GAME) / (1 << 20);

    report_section("Memory");
    report_text("A bullet slot takes **%s bytes** of RAM: its columns, and the events it can raise in one frame. A "
                "snapshot copies %s bytes for each live bullet and nothing for free slots. A board with the default "
                "capacities, such as that of `examples/first`, has **%s MiB** of RAM, including 4 MiB for Lua. The "
                "built-in game's board takes %s MiB.",
                report_figure(reserved), report_figure(live_bytes()), report_figure(usual), report_figure(game));
    bench_target("RAM of a board with the default capacities", "8 MiB", report_string("%s MiB", report_figure(usual)),
                 usual < 8);
}
