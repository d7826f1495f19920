/*
 * test_heap.c - the allocator against a model: contents, alignment, determinism, limits, snapshots.
 */
#include "../test.h"
#include "../../src/base/heap.h"
#include "../../src/base/rng.h"

enum { THINGS = 3000, BLOCK = 1 << 20 };

struct thing {
    unsigned char *p;
    size_t size;
    unsigned char fill;
};

struct model {
    struct heap *h;
    size_t used;
    struct rng rng;
    struct thing things[THINGS];
};

static unsigned char *block;
static struct model m;

static int setup(void **state)
{
    (void)state;
    block = aligned_alloc(16, 4 * BLOCK);
    assert_non_null(block);
    memset(block, 0, 4 * BLOCK);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    free(block);
    return 0;
}

static void assert_filled(const struct thing *t, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (t->p[i] != t->fill)
            fail_msg("byte %zu of %zu is %d, not %d", i, n, t->p[i], t->fill);
}

/* Mostly small, sometimes large, as Lua's are. */
static size_t some_size(struct rng *r)
{
    return 1 + (size_t)rng_below(r, rng_below(r, 8) ? 120 : 8000);
}

/* One random call. Returns where the result lies in the block, so that runs can be compared. */
static size_t step(struct model *model)
{
    struct thing *t = &model->things[rng_below(&model->rng, THINGS)];
    bool drop = t->p && rng_below(&model->rng, 3) == 0;
    size_t size = drop ? 0 : some_size(&model->rng), old = t->p ? t->size : (size_t)rng_below(&model->rng, 9);
    unsigned char fill = (unsigned char)rng_next(&model->rng);

    if (t->p)
        assert_filled(t, t->size);
    unsigned char *p = heap_realloc(model->h, t->p, old, size);
    if (size && !p) {
        assert_false(t->p && size <= t->size);
        return 0;
    }
    model->used += size - (t->p ? t->size : 0);
    assert_int_equal((uintptr_t)p % HEAP_ALIGN, 0);
    if (t->p && p) {
        t->p = p;
        assert_filled(t, t->size < size ? t->size : size);
    }
    *t = (struct thing){ p, size, fill };
    if (p)
        memset(p, fill, size);
    return p ? (size_t)(p - (unsigned char *)model->h) : 0;
}

static void start(struct model *model, void *at, size_t size, uint64_t seed)
{
    memset(model, 0, sizeof *model);
    model->h = heap_init(at, size);
    rng_seed(&model->rng, seed);
}

static void free_all(void)
{
    for (int i = 0; i < THINGS; i++)
        if (m.things[i].p)
            heap_realloc(m.h, m.things[i].p, m.things[i].size, 0);
    assert_true(heap_check(m.h));
    assert_int_equal(heap_used(m.h), 0);
}

/* Once all is freed one block can have nearly everything again: slabs come back, neighbours coalesce. */
TEST(keeps_contents_and_its_books)
{
    start(&m, block, 4 * BLOCK, 1);
    for (int i = 0; i < 100000; i++) {
        step(&m);
        assert_int_equal(heap_used(m.h), m.used);
        if (i % 1000 == 0)
            assert_true(heap_check(m.h));
    }
    assert_true(heap_work(m.h) > m.used);
    free_all();
    assert_non_null(heap_realloc(m.h, NULL, 0, 3 * BLOCK));
    assert_true(heap_check(m.h));
}

/* In a block too small for the load, calls fail cleanly; shrinking never does. */
TEST(survives_being_full)
{
    int failed = 0;

    start(&m, block, BLOCK / 4, 2);
    for (int i = 0; i < 100000; i++) {
        failed += step(&m) == 0;
        assert_true(heap_extent(m.h) <= BLOCK / 4);
        if (i % 500 == 0)
            assert_true(heap_check(m.h));
    }
    assert_true(failed > 40000); /* a third are frees */
    free_all();
}

TEST(places_by_calls_alone)
{
    static struct model other;
    unsigned char *shifted = block + 2 * BLOCK + 48;

    memset(shifted, 0x5a, BLOCK);
    start(&m, block, BLOCK, 4);
    start(&other, shifted, BLOCK, 4);
    for (int i = 0; i < 100000; i++)
        assert_int_equal(step(&m), step(&other));
    assert_int_equal(heap_extent(m.h), heap_extent(other.h));
}

/* A snapshot of `at` steps, taken back after `on` more, with the block full of rubbish: the heap goes on as it did. */
static void snapshot_restores(uint64_t seed, int at, int on)
{
    static struct model at_save, later;
    unsigned char *saved, *again;

    start(&m, block, BLOCK, seed);
    for (int i = 0; i < at; i++)
        step(&m);
    at_save = m;
    size_t size = heap_save(m.h, NULL);
    saved = calloc(1, size);
    again = calloc(1, size);
    assert_int_equal(heap_save(m.h, saved), size);
    for (int i = 0; i < on; i++)
        step(&m);
    later = m;
    size_t extent = heap_extent(m.h);

    memset(block, 0xa5, BLOCK);
    assert_int_equal(heap_restore(m.h, saved), size);
    assert_true(heap_check(m.h));
    m = at_save;
    assert_int_equal(heap_save(m.h, again), size);
    assert_memory_equal(saved, again, size);
    for (int i = 0; i < THINGS; i++)
        if (m.things[i].p)
            assert_filled(&m.things[i], m.things[i].size);
    for (int i = 0; i < on; i++)
        step(&m);
    assert_int_equal(heap_extent(m.h), extent);
    assert_memory_equal(&m, &later, sizeof m); /* the same places */
    assert_true(heap_check(m.h));
    free(saved);
    free(again);
}

TEST(snapshots_restore_all)
{
    snapshot_restores(5, 3000, 20000);
    snapshot_restores(6, 20000, 3000);
    for (int i = 0; i < 40; i++)
        snapshot_restores(8 + (uint64_t)i, 200 * i + i, 500);
}

/* What is free is not in a snapshot. */
TEST(snapshots_leave_holes_out)
{
    struct heap *h = heap_init(block, BLOCK);
    size_t empty = heap_save(h, NULL);
    void *low = heap_realloc(h, NULL, 0, 1000), *hole = heap_realloc(h, NULL, 0, 100000);
    void *high = heap_realloc(h, NULL, 0, 1000);

    assert_true(heap_save(h, NULL) >= empty + 102000);
    heap_realloc(h, hole, 100000, 0);
    assert_in_range(heap_save(h, NULL), empty + 2000, empty + 2300);
    heap_realloc(h, high, 1000, 0);
    heap_realloc(h, low, 1000, 0);
    assert_in_range(heap_save(h, NULL), empty, empty + 200);
    assert_true(heap_extent(h) > 102000);
}

TEST(refuses_what_cannot_fit)
{
    struct heap *h = heap_init(block, HEAP_MIN);
    size_t n = 0;
    unsigned char *p, *last = NULL;

    assert_null(heap_realloc(h, NULL, 5, 0));
    assert_null(heap_realloc(h, NULL, 0, SIZE_MAX));
    assert_null(heap_realloc(h, NULL, 0, SIZE_MAX - 7));
    assert_null(heap_realloc(h, NULL, 0, HEAP_MIN));
    p = heap_realloc(h, NULL, 0, 1000);
    assert_null(heap_realloc(h, p, 1000, SIZE_MAX));
    assert_int_equal(heap_used(h), 1000);
    assert_ptr_equal(heap_realloc(h, p, 1000, 600), p);
    heap_realloc(h, p, 600, 0);
    for (; (p = heap_realloc(h, NULL, 0, 16)) != NULL; n++)
        last = p;
    assert_true(n > 2 * 250);
    assert_true(last + 16 <= block + HEAP_MIN);
    assert_true(heap_check(h));
}

/* The highest use counts what a block that moves takes twice, and goes back with a snapshot. */
TEST(knows_its_highest_use)
{
    void *kept = block + 2 * BLOCK;
    struct heap *h = heap_init(block, BLOCK);
    assert_int_equal(heap_peak(h), 0);
    void *p = heap_realloc(h, NULL, 0, 1000), *q = heap_realloc(h, NULL, 0, 3000);
    assert_int_equal(heap_peak(h), 4000);
    heap_realloc(h, q, 3000, 0);
    assert_int_equal(heap_peak(h), 4000);
    heap_save(h, kept);
    p = heap_realloc(h, p, 1000, 4500);
    p = heap_realloc(h, p, 4500, 9000);
    assert_true(heap_peak(h) >= 9000);
    heap_restore(h, kept);
    assert_int_equal(heap_peak(h), 4000);
    assert_int_equal(heap_used(h), 1000);
}

/* A block shrunk in a full heap stays where it is and can grow back into its own room. */
TEST(shrinks_in_place_when_full)
{
    struct heap *h = heap_init(block, HEAP_MIN);
    void *p = heap_realloc(h, NULL, 0, 512);

    memset(p, 7, 512);
    for (size_t size = 600; size > 400; size -= 100)
        while (heap_realloc(h, NULL, 0, size))
            ;
    assert_ptr_equal(heap_realloc(h, p, 512, 20), p);
    assert_ptr_equal(heap_realloc(h, p, 20, 30), p);
    assert_null(heap_realloc(h, p, 30, 513));
    assert_int_equal(((char *)p)[19], 7);
    heap_realloc(h, p, 30, 0);
    assert_ptr_equal(heap_realloc(h, NULL, 0, 512), p);
    assert_true(heap_check(h));
}

/* An array that doubles beside nothing else does not move. */
TEST(grows_at_the_top)
{
    struct heap *h = heap_init(block, BLOCK);
    char *p = heap_realloc(h, NULL, 0, 1024);

    for (size_t n = 1024; n < BLOCK / 2; n *= 2)
        assert_ptr_equal(heap_realloc(h, p, n, n * 2), p);
    assert_true(heap_check(h));
}

RUN_TESTS_EACH(setup, teardown)
