/*
 * test_readers.c - files nobody meant: every truncation, and thousands of valid ROMs and demos with a few bytes spoilt
 * and the checksums made good. Each is refused in one sentence or runs.
 */
#include <unistd.h>
#include "../spoil.h"

enum { ROM_MUTANTS = 6000, DEMO_MUTANTS = 3000 };

struct tally {
    uint32_t n[SPOIL_OUTCOMES], all;
};

static struct spoil_bench bench;
static struct rig_game game;

/* From the title, and right in the stage. */
static const struct board_start plain = { .seed = 1, .difficulty = -1 };
static const struct board_start practice = { .seed = 1, .difficulty = -1, .practice.section = "one" };

static int set_up(void **state)
{
    (void)state;
    spoil_open(&bench);
    spoil_game(&game);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    spoil_close(&bench);
    rig_game_free(&game);
    return 0;
}

static uint8_t *copy_of(const void *data, size_t n)
{
    uint8_t *p = malloc(n + (n == 0)); /* of exactly this size, for sanitizers */

    if (n > 0)
        memcpy(p, data, n);
    return p;
}

/* Opens and, if it opens, runs. */
static enum spoil_outcome try_rom(const uint8_t *p, size_t n, const struct board_start *start, uint64_t seed)
{
    struct rom rom;
    char err[512] = "";
    bool bad;

    if (!rom_open(&rom, p, n, err, sizeof err)) {
        if (!spoil_sentence(err, sizeof err))
            fail_msg("case %llu: refused with \"%s\"", (unsigned long long)seed, err);
        return SPOIL_REFUSED;
    }
    enum spoil_outcome out = spoil_run(&bench, &rom, seed % 3 ? start : &plain, NULL, seed, &bad);
    if (bad)
        fail_msg("case %llu: outcome %d says \"%s\"", (unsigned long long)seed, (int)out, bench.said);
    return out;
}

static void add(struct tally *t, enum spoil_outcome out)
{
    t->n[out]++;
    t->all++;
}

/* At least 30 % got as far as a powered board, and some of each kind were there. */
static void assert_reach(const struct tally *t)
{
    uint32_t powered = t->n[SPOIL_RAN] + t->n[SPOIL_FAULTED];

    assert_true(powered * 100 >= t->all * 30);
    assert_true(t->n[SPOIL_TOO_LARGE] * 20 <= t->all);
    assert_true(t->n[SPOIL_REFUSED] > 0 && t->n[SPOIL_RAN] > 0);
}

/* ---- ROMs ---- */

/* Cut anywhere, as it is, and with its header and checksums saying that it is whole. */
TEST(truncated)
{
    assert_int_equal(try_rom(game.image.bytes, game.image.size, &practice, 1), SPOIL_RAN);
    for (size_t n = 0; n < game.image.size; n++) {
        uint8_t *p = copy_of(game.image.bytes, n);
        assert_int_equal(try_rom(p, n, &plain, n), SPOIL_REFUSED);
        if (n % 61 == 0 || n < 1200) {
            repair_rom(p, n);
            assert_int_equal(try_rom(p, n, &plain, n), SPOIL_REFUSED);
        }
        free(p);
    }
}

/* One lump after the other left out, and emptied. */
TEST(lumps_gone)
{
    const struct rom *rom = &game.image.rom;
    struct lump lumps[128];
    struct tally t = { 0 };

    assert_true(rom->count <= 128);
    for (uint32_t gone = 0; gone < 2 * rom->count; gone++) {
        int n = 0;
        for (uint32_t i = 0; i < rom->count; i++) {
            rom_lump(rom, (int)i, &lumps[n]);
            if (i == gone / 2 && gone % 2)
                lumps[n++].size = 0;
            else if (i != gone / 2)
                n++;
        }
        size_t size = rom_write_size(lumps, n);
        uint8_t *p = malloc(size);
        rom_write(p, lumps, n);
        add(&t, try_rom(p, size, &practice, gone));
        free(p);
    }
    assert_reach(&t);
}

/* A value a reader may trip over, or any. */
static uint32_t odd_value(struct rng *r)
{
    static const uint32_t odd[] = { 0,     1,      2,      7,      8,          0x7f,       0x80,      0xff,
                                    0x100, 0x7fff, 0x8000, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff };
    uint32_t v = odd[rng_below(r, sizeof odd / sizeof *odd)];

    return rng_below(r, 3) ? v : (uint32_t)rng_next(r);
}

/* Spoils n bytes at p: a bit, a byte, a word, a swap; in text rather a letter for another of the text. */
static void spoil(uint8_t *p, size_t n, struct rng *r)
{
    size_t at = (size_t)rng_below(r, n), from = (size_t)rng_below(r, n);

    switch (rng_below(r, 6)) {
    case 0:
        p[at] ^= (uint8_t)(1u << rng_below(r, 8));
        break;
    case 1:
        p[at] = (uint8_t)rng_next(r);
        break;
    case 2:
        if (n >= 2) {
            at = at & ~(size_t)1 & (n - 2);
            bytes_put16(p + at, (uint16_t)odd_value(r));
        }
        break;
    case 3:
        if (n >= 4)
            bytes_put32(p + (at < n - 4 ? at & ~(size_t)3 : 0), odd_value(r));
        break;
    case 4:
        p[at] = p[from];
        break;
    default:
        for (size_t k = 0; k < 6 && at + k < n && from + k < n; k++)
            p[at + k] = p[from + k];
    }
}

static void mutate_rom(uint8_t *p, size_t size, struct rng *r)
{
    size_t at, n;

    for (uint64_t k = rng_below(r, 3) + 1; k > 0; k--) {
        uint32_t lumps = bytes_get32(p + 16);
        if (rng_below(r, 8) == 0 || lumps == 0) {
            spoil(p, size < 2000 ? size : 2000, r); /* header, directory, names */
            continue;
        }
        if (ROM_HEADER_SIZE + (size_t)lumps * ROM_ENTRY_SIZE > size)
            continue;
        spoil_lump(p, (uint32_t)rng_below(r, lumps), &at, &n);
        if (at < size && n > 0 && n <= size - at)
            spoil(p + at, n, r);
    }
    repair_rom(p, size);
}

TEST(mutants)
{
    struct tally t = { 0 };
    struct rng r;

    rng_seed(&r, 100000);
    for (uint64_t i = 0; i < ROM_MUTANTS; i++) {
        uint8_t *p = copy_of(game.image.bytes, game.image.size);
        mutate_rom(p, game.image.size, &r);
        add(&t, try_rom(p, game.image.size, &practice, 100000 + i));
        free(p);
    }
    assert_reach(&t);
}

/* ---- demos ---- */

/* A demo of SPOIL_FRAMES frames of the game, of random pads; free it. */
static uint8_t *record(size_t *size)
{
    struct board_start start = { .seed = 5, .difficulty = -1, .practice.section = "one" };
    uint16_t pads[MAX_PLAYERS] = { 0 };
    struct demo_writer w = { 0 };
    char path[] = "/tmp/curtain-readers-XXXXXX";
    struct rng r;
    struct rig rig;
    int fd = mkstemp(path);

    assert_true(fd >= 0);
    rig_power(&rig, &game, &start);
    rng_seed(&r, 3);
    assert_true(demo_begin(&w, path, &game.cart, rig.b, &start, DEMO_ASSISTED));
    for (int f = 0; f < SPOIL_FRAMES; f++) {
        rig_pads(&r, pads);
        rig_tick(&rig, pads);
        assert_true(demo_record_frame(&w, rig.b, pads));
    }
    assert_true(demo_end(&w, rig.b));
    demo_free(&w.demo);
    rig_free(&rig);
    close(fd); /* the recording has replaced that file */
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    uint8_t *p = malloc(1 << 20);
    *size = fread(p, 1, 1 << 20, f);
    fclose(f);
    remove(path);
    assert_true(*size > 300 && *size < 1 << 20);
    return p;
}

/* Reads and, if it is one of this game, plays. */
static enum spoil_outcome try_demo(const uint8_t *p, size_t n, uint64_t seed)
{
    static struct demo d; /* large for a stack */
    char err[512] = "", doubt[256];
    enum spoil_outcome out = SPOIL_REFUSED;
    bool bad;

    if (demo_read(&d, p, n, err, sizeof err) && demo_check_cart(&d, &game.cart, err, sizeof err)) {
        demo_replay_warning(&d, &game.cart, doubt, sizeof doubt);
        out = spoil_run(&bench, &game.image.rom, &d.start, &d, seed, &bad);
        if (bad)
            fail_msg("case %llu: outcome %d says \"%s\"", (unsigned long long)seed, (int)out, bench.said);
    } else if (!spoil_sentence(err, sizeof err)) {
        fail_msg("case %llu: refused with \"%s\"", (unsigned long long)seed, err);
    }
    demo_free(&d);
    return out;
}

/* Cut anywhere, a demo is read up to its last whole second, or refused. All are read, and one of each length is run. */
TEST(demo_truncated)
{
    static struct demo d; /* large for a stack */
    uint32_t frames = UINT32_MAX;
    struct tally t = { 0 };
    char err[512];
    size_t size;
    uint8_t *whole = record(&size);

    assert_int_equal(try_demo(whole, size, 0), SPOIL_RAN);
    for (size_t n = 0; n < size; n++) {
        uint8_t *p = copy_of(whole, n);
        if (!demo_read(&d, p, n, err, sizeof err)) {
            assert_true(spoil_sentence(err, sizeof err));
            t.n[SPOIL_REFUSED]++;
        } else if (d.frames != frames) {
            assert_false(d.complete);
            frames = d.frames;
            add(&t, try_demo(p, n, n));
        }
        demo_free(&d);
        free(p);
    }
    assert_true(t.n[SPOIL_REFUSED] > 0);
    assert_int_equal(t.n[SPOIL_RAN], 1 + SPOIL_FRAMES / DEMO_SECOND_FRAMES);
    free(whole);
}

TEST(demo_mutants)
{
    struct tally t = { 0 };
    struct rng r;
    size_t size;
    uint8_t *whole = record(&size);

    rng_seed(&r, 300000);
    for (int i = 0; i < DEMO_MUTANTS; i++) {
        uint8_t *p = copy_of(whole, size);
        for (uint64_t k = rng_below(&r, 3) + 1; k > 0; k--)
            spoil(p + 8, size - 8, &r);
        repair_demo(p, size);
        add(&t, try_demo(p, size, 300000 + (uint64_t)i));
        free(p);
    }
    assert_reach(&t);
    free(whole);
}

RUN_TESTS(set_up, tear_down)
