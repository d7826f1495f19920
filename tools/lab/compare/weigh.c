/*
 * weigh.c - what one game costs on this checkout's engine: weigh ROM LOADS FRAMES [START]
 *
 * Powers the ROM's board LOADS times, then plays FRAMES frames from START, a practice start, in which a player flies
 * about, fires and cannot be hit. Prints a line a figure, "NAME VALUE". compare.sh builds it with another commit's
 * sources too, so it keeps to what board.h has had for long.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../fb/fb.h"
#include "../../../src/base/heap.h"
#include "../../../src/base/pads.h"
#include "../../../src/board/board.h"
#if __has_include("../../../src/machine/machine.h")
#include "../../../src/machine/machine.h"
#include "../../../src/rom/rom.h"
#else /* of commits before the tree had layers */
#include "../../../src/rom/rom.h"
#include "../../../src/machine/machine.h"
#endif
#include "names.h"

struct weigh {
    struct rom rom;
    struct board_start start;
    void *ram;
    size_t ram_size;
};

static _Noreturn void fail(const char *what)
{
    fprintf(stderr, "weigh: %s\n", what);
    exit(1);
}

static void *room_for(size_t n)
{
    void *p = aligned_alloc(64, (n + 63) / 64 * 64);

    if (!p)
        fail("out of memory");
    return p;
}

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void open_rom(struct weigh *w, const char *path)
{
    static char err[512];
    FILE *f = fopen(path, "rb");

    if (!f || fseek(f, 0, SEEK_END))
        fail("the ROM cannot be read");
    size_t n = (size_t)ftell(f);
    uint8_t *image = room_for(n);
    rewind(f);
    if (fread(image, 1, n, f) != n)
        fail("the ROM cannot be read");
    fclose(f);
    if (!rom_open(&w->rom, image, n, err, sizeof err) || !board_size(&w->rom, &w->ram_size, err, sizeof err))
        fail(err);
    w->ram = room_for(w->ram_size);
    printf("rom %zu\nram %zu\n", n, w->ram_size);
}

static void check_fault(const struct board *b)
{
    if (board_last_output(b)->fault)
        fail(board_last_output(b)->fault->message);
}

/* The shortest of so many loads is printed: others were interrupted. */
static struct board *load(struct weigh *w, int loads)
{
    static char err[512];
    struct board *b = NULL;
    double best = 1e18;

    for (int i = 0; i < loads; i++) {
        double from = now();
        b = board_power_on(w->ram, w->ram_size, &w->rom, &w->start, err, sizeof err);
        double took = now() - from;
        if (!b)
            fail(err);
        best = took < best ? took : best;
        check_fault(b);
    }
    printf("load_ns %.0f\nheap_loaded %zu\n", best, heap_used(b->vm.heap));
    return b;
}

/* Left, right and half the time slowly, with fire held. */
static uint16_t pads_at(int frame)
{
    int turn = frame / 40 % 4;

    return (uint16_t)(PAD_FIRE | (turn == 1 ? PAD_LEFT : turn == 3 ? PAD_RIGHT : 0) | (turn > 1 ? PAD_FOCUS : 0));
}

static void play(struct board *b, int frames)
{
    int w, h;
    struct fb fb;
    uint32_t rgb[256];

    board_screen_size(b, &w, &h);
    fb_init(&fb, room_for(fb_size(w, h)), w, h);
    void *scratch = room_for(board_scratch_size(b));
    double heap = 0; /* the sum over all frames: what is garbage in one of them depends on where a collection stands */
    double from = now();
    for (int i = 0; i < frames; i++) {
        const uint16_t pads[MAX_PLAYERS] = { pads_at(i), 0 };
        board_tick(b, pads);
        board_draw(b, NULL, &fb, rgb, scratch);
        check_fault(b);
        heap += (double)heap_used(b->vm.heap);
    }
    double took = now() - from;
    if (frames)
        printf("frame_ns %.0f\nheap_played %.0f\nsnapshot %zu\nbullets %lld\n", took / frames, heap / frames,
               board_snapshot_size(b), (long long)board_live_count(b, "bullets"));
}

int main(int argc, char **argv)
{
    struct weigh w = { .start = { .seed = 1, .difficulty = -1 } };

    if (argc < 4 || argc > 5)
        fail("usage: weigh ROM LOADS FRAMES [START]");
    if (argc == 5) {
        snprintf(w.start.practice.section, sizeof w.start.practice.section, "%s", argv[4]);
        w.start.practice.invincible = argv[4][0] != 0;
    }
    int loads = atoi(argv[2]), frames = atoi(argv[3]);
    if (loads < 1 || frames < 0)
        fail("expected at least one load");
    open_rom(&w, argv[1]);
    play(load(&w, loads), frames);
    return 0;
}
