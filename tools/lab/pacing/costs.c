/*
 * costs.c - what a composed window costs, and looking a frame ahead.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../../src/demo/demo.h"
#include "../../../src/workbench/pack/pack.h"
#include "../../../src/player/picture/compose.h"
#include "../../../src/player/run/ahead.h"
#include "../report/report.h"
#include "pacing.h"

enum { TIMES = 41, FRAMES = 3600, EVERY = 12 };

static double now_us(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e6 + (double)t.tv_nsec / 1e3;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static double median(double *v, int n)
{
    qsort(v, (size_t)n, sizeof *v, ascending);
    return v[n / 2];
}

/* ---- a window ---- */

static const char *composing(int w, int h, const struct compose_options *options)
{
    static uint8_t pix[1024 * 1024];
    uint32_t rgb[256];
    struct compose c = { 0 };
    double took[TIMES];

    for (int i = 0; i < w * h; i++)
        pix[i] = (uint8_t)(i * 7 + i / w * 13);
    for (uint32_t i = 0; i < 256; i++)
        rgb[i] = i * 0x9E3779 & 0xFFFFFF;
    if (!compose_prepare(&c, options))
        report_fail("out of memory");
    for (int i = 0; i < TIMES; i++) {
        const double from = now_us();
        compose_picture(&c, pix, w, rgb);
        took[i] = now_us() - from;
    }
    compose_close(&c);
    return report_string("%.2f", median(took, TIMES) / 1000);
}

static void windows(void)
{
    static const int pictures[][2] = { { 240, 320 }, { 320, 240 }, { 384, 448 } };
    static const int sizes[][2] = { { 1280, 720 }, { 1920, 1080 }, { 2560, 1440 } };

    report_table("Milliseconds to compose a window, excluding the time the port takes to show it",
                 "picture|window|rotated>|smooth>|CRT>|smooth, CRT>|all, rotated>");
    for (int p = 0; p < 3; p++)
        for (int s = 0; s < 3; s++) {
            const int w = pictures[p][0], h = pictures[p][1];
            const struct place_options plain = { sizes[s][0], sizes[s][1], w, h, ROTATION_NONE, false, false };
            struct place_options smooth = plain, rotated = plain, all = plain;
            smooth.smooth = all.smooth = true;
            rotated.rotation = all.rotation = ROTATION_LEFT;
            report_row(false, report_string("%d x %d", w, h), report_string("%d x %d", sizes[s][0], sizes[s][1]),
                       composing(w, h, &(struct compose_options){ rotated, false, NULL }),
                       composing(w, h, &(struct compose_options){ smooth, false, NULL }),
                       composing(w, h, &(struct compose_options){ plain, true, NULL }),
                       composing(w, h, &(struct compose_options){ smooth, true, NULL }),
                       composing(w, h, &(struct compose_options){ all, true, NULL }), NULL);
        }
    report_table_end();
}

/* ---- looking ahead ---- */

static void read_demo(const char *path, struct demo *demo)
{
    char err[256];
    const long size = plat_file_size(path);
    uint8_t *data = size > 0 ? malloc((size_t)size) : NULL;

    if (!data || plat_load(path, data, (size_t)size) != size || !demo_read(demo, data, (size_t)size, err, sizeof err))
        report_fail(path);
    free(data);
}

static void looking(const char *folder, const char *recording)
{
    struct rom_image image;
    struct demo demo;
    struct guard g;
    struct ahead a = { 0 };
    char err[512];
    static double ticks[FRAMES], looks[FRAMES];
    int n = 0;

    if (!pack_load_game(folder, false, &image, err, sizeof err))
        report_fail(err);
    read_demo(recording, &demo);
    if (!guard_power(&g, &image.rom, &demo.start, err, sizeof err))
        report_fail(err);
    for (uint32_t f = 0; f < FRAMES && f < demo.frames; f++) {
        uint16_t pads[MAX_PLAYERS];
        demo_pads(&demo, f, pads);
        double from = now_us();
        guard_tick(&g, pads);
        ticks[n] = now_us() - from;
        if (f % EVERY)
            continue;
        from = now_us();
        if (!ahead_begin(&a, &g, pads))
            report_fail("a frame cannot be looked at");
        ahead_end(&a, &g);
        looks[n++] = now_us() - from;
    }
    report_row(false, folder, report_count((int64_t)board_snapshot_size(g.board)), report_figure(median(ticks, n)),
               report_figure(median(looks, n)), report_figure(looks[n * 99 / 100]), NULL);
    ahead_close(&a);
    guard_close(&g);
    demo_free(&demo);
    rom_image_free(&image);
}

void section_costs(void)
{
    report_section("Cost");
    report_text("A frame lasts 16.7 ms. The host composes the window itself if it shows anything besides an "
                "integer-scaled\n"
                "picture, such as smooth scaling, the CRT filter, a border, or side panels.");
    windows();
    report_text("Run-ahead (`run_ahead = 1`) adds a snapshot, a tick and a restore to each frame:");
    report_table("Microseconds, medians over a recorded run",
                 "game|snapshot, bytes>|tick>|run-ahead>|99th percentile>");
    looking("roms/glasstide", "roms/glasstide/demos/run.demo");
    report_table_end();
}
