/*
 * need.c - what a machine must have for games, measured: RAM of a board and of what stands beside it, and stack.
 *
 *     need ROM...          tables in Markdown, for docs/measured/ports.md; what a slot costs is of the first ROM
 *
 * Each of power-on, ticks, pictures and sound runs on a stack of its own that was filled with a pattern: what is no
 * longer the pattern was used. The frames are those of the game's demo "attract", or 600 without a button.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/board/board.h"
#include "../../../src/rom/cart.h"
#include "../../../src/demo/demo.h"
#include "../../../src/workbench/pack/pack.h"

enum { STACK_BYTES = 4 << 20, PATTERN = 0xa5, FRAMES = 600, MANY = 1024 };
enum { S_POWER, S_TICK, S_DRAW, S_SOUND, STACKS };

struct need {
    struct rom_image image;
    struct cart cart;
    struct demo demo;
    struct board_start start;
    struct board *board;
    void *ram, *scratch, *tables;
    size_t ram_size;
    struct fb fb;
    uint32_t rgb[256], frame;
    int16_t lr[2 * BOARD_SOUND_FRAMES];
    uint8_t *stack[STACKS];
};

static void fail(const char *what)
{
    fprintf(stderr, "need: %s\n", what);
    exit(1);
}

static void *room_for(size_t size)
{
    void *p = aligned_alloc(64, (size + 63) / 64 * 64 + 64);

    if (!p)
        fail("out of memory");
    return p;
}

/* ---- on a stack of their own ---- */

static void *power(void *of)
{
    struct need *n = of;
    char err[512];

    n->board = board_power_on(n->ram, n->ram_size, &n->image.rom, &n->start, err, sizeof err);
    if (!n->board)
        fail(err);
    return NULL;
}

static void *tick(void *of)
{
    struct need *n = of;
    uint16_t pads[MAX_PLAYERS];

    demo_pads(&n->demo, n->frame, pads);
    board_tick(n->board, pads);
    return NULL;
}

static void *draw(void *of)
{
    struct need *n = of;

    board_draw(n->board, NULL, &n->fb, n->rgb, n->scratch);
    return NULL;
}

static void *sound(void *of)
{
    struct need *n = of;

    board_mix_sound(n->board, n->tables, n->lr);
    return NULL;
}

static void *nothing(void *of)
{
    return of;
}

static void run(struct need *n, int phase, void *(*what)(void *))
{
    pthread_attr_t attr;
    pthread_t thread;

    pthread_attr_init(&attr);
    if (pthread_attr_setstack(&attr, n->stack[phase], STACK_BYTES) || pthread_create(&thread, &attr, what, n) ||
        pthread_join(thread, NULL))
        fail("no thread");
    pthread_attr_destroy(&attr);
}

static size_t used(const uint8_t *stack)
{
    size_t clean = 0;

    while (clean < STACK_BYTES && stack[clean] == PATTERN)
        clean++;
    return STACK_BYTES - clean;
}

/* ---- a game ---- */

static void open_game(struct need *n, const char *path)
{
    char err[512];
    struct lump lump;

    memset(n, 0, sizeof *n);
    if (!pack_load_game(path, false, &n->image, err, sizeof err) ||
        !cart_open(&n->cart, &n->image.rom, err, sizeof err) ||
        !board_size(&n->image.rom, &n->ram_size, err, sizeof err))
        fail(err);
    n->start = (struct board_start){ .difficulty = -1 };
    for (int i = 0; i < n->cart.manifest.n_dips; i++)
        n->start.dip[i] = n->cart.manifest.dips[i].default_value;
    const int at = rom_find(&n->image.rom, "demo/attract");
    if (at < 0)
        return;
    rom_lump(&n->image.rom, at, &lump);
    if (demo_read(&n->demo, lump.data, lump.size, err, sizeof err) &&
        demo_check_cart(&n->demo, &n->cart, err, sizeof err))
        n->start = n->demo.start;
}

static void close_game(struct need *n)
{
    for (int i = 0; i < STACKS; i++)
        free(n->stack[i]);
    free(n->ram);
    free(n->scratch);
    free(n->tables);
    demo_free(&n->demo);
    rom_image_free(&n->image);
}

/* The number of a manifest that has that place. */
static int32_t *number(struct manifest *m, int i)
{
    return (int32_t *)(void *)((char *)m + manifest_numbers[i].offset);
}

static bool is_capacity(int i)
{
    return strncmp(manifest_numbers[i].name, "board.", 6) == 0 && !manifest_numbers[i].is_flag &&
           strcmp(manifest_numbers[i].name, "board.lua_kib") != 0 &&
           strcmp(manifest_numbers[i].name, "board.nvram") != 0;
}

/* Bytes of RAM that one more takes, over MANY of them. */
static double each(const struct need *n, int i)
{
    struct cart cart = n->cart;
    const uint64_t before = board_ram_needed(&cart);

    *number(&cart.manifest, i) += MANY;
    return (double)(board_ram_needed(&cart) - before) / MANY;
}

static void print_slots(const struct need *n)
{
    printf("| capacity | bytes of RAM per unit |\n|---|---|\n");
    for (int i = 0; i < MANIFEST_NUMBERS; i++)
        if (is_capacity(i) && strncmp(manifest_numbers[i].name, "board.values.", 13) != 0 &&
            (*number((struct manifest *)&n->cart.manifest, i) > 0 ||
             strcmp(manifest_numbers[i].name, "board.bulletml") != 0))
            printf("| `%s` | %.0f |\n", manifest_numbers[i].name, each(n, i));
    printf("\n");
}

static void print_game(const char *path)
{
    static struct need need;
    struct need *n = &need;

    open_game(n, path);
    const struct manifest *m = &n->cart.manifest;
    double slots = 0;
    for (int i = 0; i < MANIFEST_NUMBERS; i++)
        if (is_capacity(i))
            slots += *number((struct manifest *)m, i) * each(n, i);
    n->ram = room_for(n->ram_size);
    n->scratch = room_for(board_cart_scratch_size(&n->cart));
    n->tables = room_for(board_sound_tables_size());
    board_sound_init_tables(n->tables);
    uint8_t *pixels = room_for(fb_size(m->screen_w, m->screen_h));
    fb_init(&n->fb, pixels, m->screen_w, m->screen_h);
    for (int i = 0; i < STACKS; i++) {
        n->stack[i] = room_for(STACK_BYTES);
        memset(n->stack[i], PATTERN, STACK_BYTES);
    }
    run(n, S_SOUND, nothing);
    const size_t thread = used(n->stack[S_SOUND]);
    run(n, S_POWER, power);
    const uint32_t frames = n->demo.frames ? n->demo.frames : FRAMES;
    for (n->frame = 0; n->frame < frames; n->frame++) {
        run(n, S_TICK, tick);
        if (board_last_output(n->board)->fault)
            fail(board_last_output(n->board)->fault->message);
        run(n, S_DRAW, draw);
        if (m->has_sound)
            run(n, S_SOUND, sound);
    }
    printf("| %s | %zu | %d | %.0f | %.0f | %zu | %zu | %zu |", m->title, (n->ram_size + 1023) >> 10, m->lua_kib,
           slots / 1024, ((double)n->ram_size - slots) / 1024 - m->lua_kib,
           (board_snapshot_size(n->board) + 1023) >> 10,
           (fb_size(m->screen_w, m->screen_h) + board_cart_scratch_size(&n->cart) + 1023) >> 10,
           m->has_sound ? (board_sound_tables_size() + 1023) >> 10 : 0);
    for (int i = 0; i < STACKS; i++)
        printf(" %.1f |", (double)(used(n->stack[i]) - thread) / 1024);
    printf("\n");
    free(pixels);
    close_game(n);
}

int main(int argc, char **argv)
{
    struct need n;

    if (argc < 2)
        fail("expected ROM...");
    open_game(&n, argv[1]);
    print_slots(&n);
    close_game(&n);
    printf("| KiB | RAM | Lua | slots | other | snapshot at the end | picture and drawing | sound | stack: power-on "
           "| stack: tick | stack: picture | stack: sound |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; i++)
        print_game(argv[i]);
    return 0;
}
