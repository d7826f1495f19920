/*
 * bench.c - how fast the board runs roms/bench: n bullets moved, hit-tested, grazed and drawn through the same tick and
 * draw as any game. `bench ROM [N...]`; figures are medians over slices of frames, with the fastest and slowest slice.
 * floor: tools
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../platform/platform.h"
#include "../src/board/board.h"
#include "../src/board/cart.h"
#include "../src/cab/pack.h"

enum { SLICES = 15 };

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static void fail(const char *what)
{
    fprintf(stderr, "bench: %s\n", what);
    exit(2);
}

struct run {
    struct board *b;
    struct fb fb;
    void *scratch;
    uint32_t rgb[256];
    uint64_t moved, tested, hit, grazed, drawn, frames;
};

static void frame(struct run *r, bool draw)
{
    static const uint16_t way[] = { PAD_LEFT, PAD_UP, PAD_RIGHT, PAD_RIGHT | PAD_DOWN, PAD_UP | PAD_LEFT, PAD_DOWN };
    const uint16_t pads[PADS] = { way[r->frames / 37 % 6], 0 };
    const struct board_out *out = board_tick(r->b, pads);

    if (out->fault)
        fail(out->fault->message);
    struct board_counts c = board_counts(r->b);
    r->moved += c.moved;
    r->tested += c.tested;
    r->hit += c.hit;
    r->grazed += c.grazed;
    r->frames++;
    if (draw)
        r->drawn += board_draw(r->b, &r->fb, r->rgb, r->scratch);
}

/* Microseconds a frame: median, fastest and slowest slice. */
static double measure(struct run *r, bool draw, int frames, double *best, double *worst)
{
    double us[SLICES];

    for (int s = 0; s < SLICES; s++) {
        uint64_t start = plat_usec();
        for (int f = 0; f < frames; f++)
            frame(r, draw);
        us[s] = (double)(plat_usec() - start) / frames;
    }
    qsort(us, SLICES, sizeof *us, by_value);
    *best = us[0];
    *worst = us[SLICES - 1];
    return us[SLICES / 2];
}

static void bench(const struct rom *rom, int n)
{
    struct board_start start = { .difficulty = -1 };
    struct cart cart;
    char err[256];
    size_t size;
    struct run r = { 0 };
    int w, h;

    if (!cart_open(&cart, rom, err, sizeof err) || !board_size(rom, &size, err, sizeof err))
        fail(err);
    for (int i = 0; i < cart.m.n_dips; i++)
        start.dip[i] = strcmp(cart.m.dips[i].name, "n") ? cart.m.dips[i].value : n;
    void *ram = malloc(size);
    if (!ram || !(r.b = board_power(ram, size, rom, &start, false, err, sizeof err)))
        fail(ram ? err : "out of memory");
    if (board_last(r.b)->fault)
        fail(board_last(r.b)->fault->message);
    board_screen(r.b, &w, &h);
    void *mem = malloc(fb_size(w, h));
    r.scratch = malloc(board_scratch(r.b));
    if (!mem || !r.scratch)
        fail("out of memory");
    fb_init(&r.fb, mem, w, h);
    frame(&r, true); /* fires them all */
    int frames = n > 100000 ? 4 : n > 10000 ? 40 : 200;
    double best, worst, tick_best, tick_worst;
    double tick = measure(&r, false, frames, &tick_best, &tick_worst);
    r.moved = r.tested = r.hit = r.grazed = r.drawn = r.frames = 0;
    double both = measure(&r, true, frames, &best, &worst);
    printf("%8d %10.1f %10.1f %10.1f %8.1f %8.1f %9.2f %10.0f   %llu %llu %llu %llu %llu\n", n, tick, both - tick, both,
           best, worst, both * 1000 / n, 1e6 / both, (unsigned long long)(r.moved / r.frames),
           (unsigned long long)r.tested, (unsigned long long)r.hit, (unsigned long long)r.grazed,
           (unsigned long long)(r.drawn / r.frames));
    free(r.scratch);
    free(mem);
    free(ram);
}

int main(int argc, char **argv)
{
    static const int usual[] = { 1024, 4096, 16384, 65536, 262144, 1048576 };
    struct rom_image image;
    char err[256];

    if (argc < 2)
        fail("usage: bench ROM [N...]");
    if (!rom_image_load(argv[1], false, &image, err, sizeof err))
        fail(err);
    printf(
        "       n    tick us    draw us   frame us     best    worst ns/bullet   frames/s   moved, drawn a frame; "
        "tested, hit, grazed in all\n                                                                                "
        "    moved tested hit grazed drawn\n");
    if (argc > 2)
        for (int i = 2; i < argc; i++)
            bench(&image.rom, atoi(argv[i]));
    else
        for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
            bench(&image.rom, usual[i]);
    rom_image_free(&image);
    return 0;
}
