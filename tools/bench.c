/*
 * bench.c - how fast the board runs roms/bench: n bullets moved, hit-tested, grazed and drawn through the same tick and
 * draw as any game, and what a bullet that does more than fly straight costs. `bench ROM [prices] [N...]`; figures are
 * medians over slices of frames, with the fastest and slowest slice.
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
    void *ram, *mem, *scratch;
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

/* A board with n bullets of which each does the does-th thing of that DIP. */
static void power(struct run *r, const struct rom *rom, int n, int does)
{
    struct board_start start = { .difficulty = -1 };
    struct cart cart;
    char err[256];
    size_t size;
    int w, h;

    *r = (struct run){ 0 };
    if (!cart_open(&cart, rom, err, sizeof err) || !board_size(rom, &size, err, sizeof err))
        fail(err);
    for (int i = 0; i < cart.m.n_dips; i++) {
        const char *name = cart.m.dips[i].name;
        start.dip[i] = !strcmp(name, "n") ? n : !strcmp(name, "does") ? does : cart.m.dips[i].value;
    }
    r->ram = malloc(size);
    if (!r->ram || !(r->b = board_power(r->ram, size, rom, &start, false, err, sizeof err)))
        fail(r->ram ? err : "out of memory");
    if (board_last(r->b)->fault)
        fail(board_last(r->b)->fault->message);
    board_screen(r->b, &w, &h);
    r->mem = malloc(fb_size(w, h));
    r->scratch = malloc(board_scratch(r->b));
    if (!r->mem || !r->scratch)
        fail("out of memory");
    fb_init(&r->fb, r->mem, w, h);
    frame(r, true); /* fires them all */
}

static void end(struct run *r)
{
    free(r->scratch);
    free(r->mem);
    free(r->ram);
}

static void bench(const struct rom *rom, int n)
{
    struct run r;
    int frames = n > 100000 ? 4 : n > 10000 ? 40 : 200;
    double best, worst, tick_best, tick_worst;

    power(&r, rom, n, 0);
    double tick = measure(&r, false, frames, &tick_best, &tick_worst);
    r.moved = r.tested = r.hit = r.grazed = r.drawn = r.frames = 0;
    double both = measure(&r, true, frames, &best, &worst);
    printf("%8d %10.1f %10.1f %10.1f %8.1f %8.1f %9.2f %10.0f   %llu %llu %llu %llu %llu\n", n, tick, both - tick, both,
           best, worst, both * 1000 / n, 1e6 / both, (unsigned long long)(r.moved / r.frames),
           (unsigned long long)r.tested, (unsigned long long)r.hit, (unsigned long long)r.grazed,
           (unsigned long long)(r.drawn / r.frames));
    end(&r);
}

/* Nanoseconds of a tick that each of n bullets takes for doing a thing, the first being to fly straight. */
static void prices(const struct rom *rom)
{
    static const char *const does[] = { NULL,
                                        "flies straight",
                                        "runs turn and speed",
                                        "runs home",
                                        "is fine, and flies straight",
                                        "is fine, and runs turn and speed",
                                        "is written to through a group",
                                        "is visited by bullet.each, and written to",
                                        "has a task that waits one frame",
                                        "is fired (once)" };
    enum { N = 4096, FRAMES = 20, COUNT = sizeof does / sizeof *does };
    double straight = 0;

    printf("\nns a frame, beyond those of a bullet that flies straight; %d of them\n", N);
    for (int i = 1; i < COUNT; i++) {
        struct run r;
        double best, worst;
        power(&r, rom, N, i);
        double ns = measure(&r, false, FRAMES, &best, &worst) * 1000 / N;
        if (i == 1)
            straight = ns;
        printf("%8.1f  (%.1f to %.1f in all)  %s\n", i == 1 ? ns : ns - straight, best * 1000 / N, worst * 1000 / N,
               does[i]);
        end(&r);
    }
}

int main(int argc, char **argv)
{
    static const int usual[] = { 1024, 4096, 16384, 65536, 262144, 1048576 };
    struct rom_image image;
    char err[256];

    if (argc < 2)
        fail("usage: bench ROM [prices] [N...]");
    if (!rom_image_load(argv[1], false, &image, err, sizeof err))
        fail(err);
    bool priced = argc == 2 || !strcmp(argv[2], "prices");
    if (argc == 2 || !priced || argc > 3)
        printf(
            "       n    tick us    draw us   frame us     best    worst ns/bullet   frames/s   moved, drawn a frame; "
            "tested, hit, grazed in all\n                                                                              "
            "  "
            "    moved tested hit grazed drawn\n");
    for (int i = priced ? 3 : 2; i < argc; i++)
        bench(&image.rom, atoi(argv[i]));
    if (argc == 2)
        for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
            bench(&image.rom, usual[i]);
    if (priced)
        prices(&image.rom);
    rom_image_free(&image);
    return 0;
}
