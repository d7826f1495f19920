/*
 * bench_rewind.c - what going back costs: bytes of a key frame, how far a budget reaches, how long a step back takes.
 *
 *     bench_rewind ROM DEMO [FRAMES [SECONDS [MIB]]]     plays the demo to a frame, then steps back through SECONDS of it
 *
 * Every frame that is come back to must have the hash it had.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../platform/platform.h"
#include "../src/cab/demo.h"
#include "../src/cab/guard.h"
#include "../src/cab/pack.h"

static int refuse(const char *what)
{
    fprintf(stderr, "bench_rewind: %s\n", what);
    return 1;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Plays to frame `to`; the hashes of all frames, and the bytes of the largest snapshot in the last `last` frames. */
static size_t play(struct guard *g, const struct demo *d, uint32_t to, uint32_t last, uint64_t *hash)
{
    size_t most = 0;

    for (uint32_t f = 0; f <= to; f++) {
        uint16_t pads[PADS];
        hash[f] = board_hash(g->board);
        if (f + last >= to && board_snapshot_size(g->board) > most)
            most = board_snapshot_size(g->board);
        demo_pads(d, f, pads);
        if (f < to)
            guard_tick(g, pads);
    }
    return most;
}

static int measure(struct guard *g, const struct demo *d, uint32_t to, uint32_t last)
{
    uint64_t *hash = malloc((to + 1) * sizeof *hash);
    double *step = malloc((last + 1) * sizeof *step);
    uint64_t most = 0;
    uint32_t n = 0;

    if (!hash || !step)
        return refuse("out of memory");
    size_t bytes = play(g, d, to, last, hash);
    printf("a key frame at the densest: %zu bytes\n", bytes);
    printf("held: %.1f MiB, %d key frames, frames %u to %u, %.1f s\n", (double)g->past.held / (1 << 20), g->past.n,
           (unsigned)rewind_first(&g->past), (unsigned)rewind_end(&g->past),
           (rewind_end(&g->past) - rewind_first(&g->past)) / 60.0);
    for (uint32_t f = to; f-- > rewind_first(&g->past) && n < last; n++) {
        uint64_t from = plat_usec(), ticks = g->past.again;
        bool good = guard_back(g, f);
        step[n] = (double)(plat_usec() - from) / 1000;
        if (!good || board_hash(g->board) != hash[f])
            return refuse("a frame is not the frame it was");
        most = g->past.again - ticks > most ? g->past.again - ticks : most;
    }
    qsort(step, n, sizeof *step, by_size);
    printf("%u steps back: median %.3f ms, 99 of 100 under %.3f, worst %.3f; %.1f ticks a step, at most %u\n",
           (unsigned)n, step[n / 2], step[n - 1 - n / 100], step[n - 1], (double)g->past.again / n, (unsigned)most);
    free(hash);
    free(step);
    return 0;
}

int main(int argc, char **argv)
{
    struct guard *g = calloc(1, sizeof *g);
    struct rom_image image;
    struct demo demo = { 0 };
    char err[512];

    if (argc < 3 || !g)
        return refuse("ROM DEMO [FRAMES [SECONDS [MIB]]]");
    if (!rom_image_load(argv[1], false, &image, err, sizeof err) || !demo_load(&demo, argv[2], err, sizeof err) ||
        !guard_power(g, &image.rom, &demo.start, err, sizeof err))
        return refuse(err);
    uint32_t to = argc > 3 ? (uint32_t)atoi(argv[3]) : demo.frames,
             last = 60 * (uint32_t)(argc > 4 ? atoi(argv[4]) : 60);
    guard_remember(g, (size_t)(argc > 5 ? atoi(argv[5]) : REWIND_BYTES >> 20) << 20);
    int code = measure(g, &demo, to < demo.frames ? to : demo.frames, last);
    guard_close(g);
    demo_free(&demo);
    rom_image_free(&image);
    free(g);
    return code;
}
