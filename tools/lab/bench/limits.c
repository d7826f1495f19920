/*
 * limits.c - section "machine": what memory and stores give plain C, so that the crowd's figures can be read as shares
 * of it. memcpy is the C library's, which may use more than the flags allow us.
 */
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum {
    ROUNDS = 11,
    BLOCK = 64,
    PITCH = 384, /* of a picture of 320 x 240 with its guard band */
    ROWS = 304,
    PLACES = 4096,
    SIDE = 8
};
static const double SPAN = 1e6; /* ns a measurement lasts at least */

/* Something to be run over and over: it works on `bytes` of memory. */
struct work {
    void (*run)(uint8_t *mem, size_t bytes);
    size_t bytes;
};

static volatile uint64_t sink;

static void copy(uint8_t *mem, size_t bytes)
{
    memcpy(mem + bytes / 2, mem, bytes / 2);
    sink = mem[bytes - 1];
}

static uint32_t fold_block(const uint32_t *restrict p)
{
    uint32_t all = 0;

    for (int i = 0; i < BLOCK; i++)
        all |= p[i];
    return all;
}

static void read_all(uint8_t *mem, size_t bytes)
{
    const uint32_t *p = (const uint32_t *)(void *)mem;
    uint32_t all = 0;

    for (size_t i = 0; i < bytes / sizeof *p; i += BLOCK)
        all |= fold_block(p + i);
    sink = all;
}

static void add_block(uint32_t *restrict x, const uint32_t *restrict v)
{
    for (int i = 0; i < BLOCK; i++)
        x[i] += v[i];
}

static void update(uint8_t *mem, size_t bytes)
{
    size_t n = bytes / 8; /* two columns of 4 bytes */
    uint32_t *x = (uint32_t *)(void *)mem, *v = x + n;

    for (size_t i = 0; i < n; i += BLOCK)
        add_block(x + i, v + i);
}

/* Nanoseconds of one run: the median. */
static double time_of(const struct work *w)
{
    uint8_t *mem = aligned_alloc(BLOCK, w->bytes);
    struct samples s = { 0 };
    int times = 1;

    if (!mem)
        report_fail("out of memory");
    memset(mem, 1, w->bytes);
    bench_own_clock(true);
    for (int round = -1; round < ROUNDS;) {
        double from = bench_now();
        for (int i = 0; i < times; i++)
            w->run(mem, w->bytes);
        double took = bench_since(from);
        if (took < SPAN) {
            times = 2 * times;
            continue;
        }
        if (round >= 0)
            samples_add(&s, took / times);
        round++;
    }
    bench_own_clock(false);
    double ns = samples_median(&s);
    samples_free(&s);
    free(mem);
    return ns;
}

double limit_update(size_t bytes)
{
    size_t whole = (bytes + 8 * BLOCK - 1) / (8 * BLOCK) * (8 * BLOCK);

    return 1.5 * (double)whole / time_of(&(struct work){ update, whole });
}

/* ---- stores ---- */

static int32_t places[PLACES];

/* The compiler may not join these stores. */
static void store_in_turn(uint8_t *mem, size_t bytes)
{
    volatile uint64_t *p = (volatile uint64_t *)(void *)mem;

    for (size_t i = 0; i < bytes / 8; i++)
        p[i] = i;
}

static void store_apart(uint8_t *mem, size_t bytes)
{
    const uint64_t colour = bytes;

    for (int i = 0; i < PLACES; i++) {
        uint8_t *d = mem + places[i];
        for (int row = 0; row < SIDE; row++, d += PITCH)
            memcpy(d, &colour, sizeof colour);
    }
    sink = mem[places[0]];
}

static void scatter(void)
{
    struct rng r;

    rng_seed(&r, 1);
    for (int i = 0; i < PLACES; i++)
        places[i] =
            (int32_t)(rng_next(&r) % (ROWS - SIDE)) * PITCH + (int32_t)(rng_next(&r) % (uint64_t)(PITCH - SIDE));
}

double limit_store(void)
{
    static double ns;

    if (ns == 0) {
        scatter();
        ns = time_of(&(struct work){ store_apart, PITCH * ROWS }) / (PLACES * SIDE);
    }
    return ns;
}

static const char *rate(void (*run)(uint8_t *, size_t), size_t bytes, double moved)
{
    return report_figure((double)bytes * moved / time_of(&(struct work){ run, bytes }));
}

static const char *size_name(size_t bytes)
{
    return bytes >> 20 ? report_string("%d MiB", (int)(bytes >> 20)) : report_string("%d KiB", (int)(bytes >> 10));
}

void section_machine(void)
{
    static const size_t SIZES[] = { 16 << 10, 512 << 10, 8 << 20, 64 << 20, 256 << 20 };

    report_section("The machine");
    report_text("The table shows memory bandwidth in GB/s for repeated passes over a block of memory. The smallest "
                "block fits in the first-level cache; the largest exceeds every cache.\n"
                "\n"
                "* *Copy* is the C library's `memcpy`. Bytes read and bytes written both count.\n"
                "* *Read* reads the whole block, in plain C.\n"
                "* *Update* is `x[i] += v[i]` in plain C, which is how bullets move: two reads and one write.");
    report_table(NULL, "memory> | copy> | read> | update>");
    for (size_t i = 0; i < sizeof SIZES / sizeof *SIZES; i++)
        report_row(0, size_name(SIZES[i]), rate(copy, SIZES[i], 1), rate(read_all, SIZES[i], 1),
                   rate(update, SIZES[i], 1.5), NULL);
    report_table_end();

    size_t l1 = 16 << 10;
    double in_turn = time_of(&(struct work){ store_in_turn, l1 }) / (double)(l1 / 8);
    report_text("An 8-byte store takes %s ns if the stores are sequential. A store takes **%s ns** if each group of 8 "
                "stores goes to 8 different rows of a picture, as when a sprite is drawn. An 8x8 bullet needs 8 such "
                "stores, so drawing it takes at least %s ns.",
                report_figure(in_turn), report_figure(limit_store()), report_figure(SIDE * limit_store()));
}
