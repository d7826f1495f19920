/*
 * speed.c - what the library costs beside the board itself, in one process and in turns; and what a compressed ROM
 * costs to open.
 *
 *     speed ROM SECTION          ROM compressed; lines in Markdown, for docs/measured/ports.md
 *
 * The board runs as the program has it: its tick, picture and sound, endless loops found by an alarm. The library does
 * the same by its calls. Both are in this program, for the library hides its names. The middle one of the turns counts.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../src/board/board.h"
#include "../../../src/rom/cart.h"
#include "../../../src/rom/compressed.h"
#include "../../../src/lib/curtain.h"

enum { TURNS = 61, FRAMES = 120, OPENINGS = 15 };

static char err[512];

static void fail(const char *what)
{
    fprintf(stderr, "speed: %s\n", what);
    exit(1);
}

static void *room_for(size_t size)
{
    void *p = aligned_alloc(64, (size + 63) / 64 * 64 + 64);

    if (!p)
        fail("out of memory");
    return p;
}

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec / 1e6;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

static double middle(double *times, int n)
{
    qsort(times, (size_t)n, sizeof *times, by_size);
    return times[n / 2];
}

static void *read_file(const char *name, size_t *size)
{
    FILE *f = fopen(name, "rb");
    void *bytes;

    if (!f || fseek(f, 0, SEEK_END))
        fail("the ROM cannot be read");
    *size = (size_t)ftell(f);
    rewind(f);
    bytes = room_for(*size);
    if (fread(bytes, 1, *size, f) != *size)
        fail("the ROM cannot be read");
    fclose(f);
    return bytes;
}

/* ---- a frame ---- */

struct embedded_rom {
    struct rom rom;
    struct cart cart;
    struct board *b;
    void *scratch, *tables;
    struct fb fb;
    uint32_t rgb[256];
    int16_t lr[2 * BOARD_SOUND_FRAMES];
};

static void open_own(struct embedded_rom *o, const void *rom, size_t size, const char *section)
{
    struct board_start start = { .seed = 1, .difficulty = -1 };
    size_t ram;

    if (!rom_open(&o->rom, rom, size, err, sizeof err) || !cart_open(&o->cart, &o->rom, err, sizeof err) ||
        !board_size(&o->rom, &ram, err, sizeof err))
        fail(err);
    const struct manifest *m = &o->cart.manifest;
    for (int i = 0; i < m->n_dips; i++)
        start.dip[i] = m->dips[i].default_value;
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    start.practice.invincible = true;
    o->b = board_power_on(room_for(ram), ram, &o->rom, &start, err, sizeof err);
    if (!o->b)
        fail(err);
    o->scratch = room_for(board_scratch_size(o->b));
    o->tables = room_for(board_sound_tables_size());
    board_sound_init_tables(o->tables);
    fb_init(&o->fb, room_for(fb_size(m->screen_w, m->screen_h)), m->screen_w, m->screen_h);
}

static double own_frames(struct embedded_rom *o)
{
    const uint16_t pads[MAX_PLAYERS] = { PAD_FIRE };
    const double from = now();

    for (int i = 0; i < FRAMES; i++) {
        board_tick(o->b, pads);
        board_draw(o->b, NULL, &o->fb, o->rgb, o->scratch);
        board_mix_sound(o->b, o->tables, o->lr);
    }
    return now() - from;
}

static double library_frames(struct curtain *c)
{
    static int16_t lr[2 * BOARD_SOUND_FRAMES];
    const uint16_t pads[CURTAIN_PADS] = { CURTAIN_FIRE };
    const double from = now();

    for (int i = 0; i < FRAMES; i++) {
        curtain_frame(c, pads);
        curtain_picture(c);
        curtain_sound(c, lr, BOARD_SOUND_FRAMES);
    }
    return now() - from;
}

static struct curtain *open_library(const struct curtain_config *how, void **memory)
{
    const size_t size = curtain_memory(how, err, sizeof err);

    *memory = size ? room_for(size) : NULL;
    struct curtain *c = size ? curtain_open(how, *memory, size, err, sizeof err) : NULL;
    if (!c)
        fail(err);
    return c;
}

static void frames(const void *plain, size_t size, const char *section)
{
    struct curtain_config how = { .rom = plain, .rom_size = size, .seed = 1, .section = section };
    static struct embedded_rom own;
    double mine[TURNS], its[TURNS], ratio[TURNS];
    void *memory;
    struct curtain *c;

    how.invincible = true;
    c = open_library(&how, &memory);
    open_own(&own, plain, size, section);
    for (int i = 0; i < TURNS; i++) { /* who is first changes, for the second finds caches cold or warm */
        if (i % 2)
            its[i] = library_frames(c);
        mine[i] = own_frames(&own);
        if (i % 2 == 0)
            its[i] = library_frames(c);
        ratio[i] = its[i] / mine[i];
    }
    if (curtain_hash(c) != board_hash(own.b))
        fail("the two are not the same run");
    printf("| a frame with picture and sound, %d frames | %.3f ms | %.3f ms | %.3f |\n", TURNS * FRAMES,
           middle(mine, TURNS) / FRAMES, middle(its, TURNS) / FRAMES, middle(ratio, TURNS));
    curtain_close(c);
    free(memory);
}

/* ---- opening ---- */

static double opening(const void *rom, size_t size)
{
    const struct curtain_config how = { .rom = rom, .rom_size = size, .seed = 1 };
    const double from = now();
    void *memory;

    curtain_close(open_library(&how, &memory));
    free(memory);
    return now() - from;
}

int main(int argc, char **argv)
{
    size_t size, plain_size;

    if (argc != 3)
        fail("expected ROM SECTION");
    const void *rom = read_file(argv[1], &size);
    if (!compressed_has_magic(rom, size) || (plain_size = curtain_plain(rom, size, NULL, 0, err, sizeof err)) == 0)
        fail("expected a compressed ROM");
    void *plain = room_for(plain_size);
    if (curtain_plain(rom, size, plain, plain_size, err, sizeof err) == 0)
        fail(err);
    frames(plain, plain_size, argv[2]);
    double open[OPENINGS], open_small[OPENINGS], ratio[OPENINGS];
    for (int i = 0; i < OPENINGS; i++) {
        open[i] = opening(plain, plain_size);
        open_small[i] = opening(rom, size);
        ratio[i] = open_small[i] / open[i];
    }
    printf("| opening an uncompressed ROM of %zu KiB and a compressed one of %zu KiB | %.1f ms | %.1f ms | %.2f |\n",
           plain_size >> 10, size >> 10, middle(open, OPENINGS), middle(open_small, OPENINGS), middle(ratio, OPENINGS));
    return 0;
}
