/*
 * test_blit.c - sprites against a painter that sets one byte after the other.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/stamp.h"
#include "../../src/base/rng.h"

enum { W = 88, H = 40, MARGIN = 64, MAX_SIDE = 70, MAX_PITCH = 96, PLACES = 40 };

/* A surface of noise between two margins, a copy of it from before, the picture it should become; and an image, at the
 * very end of its memory, so that a sanitizer sees a read that goes too far. */
static struct fb fb;
static uint8_t *mem, *before;
static uint8_t want[H][W];
static size_t size;
static uint8_t *block, *pix; /* pix: the image's pixels, in block */
static struct image image;
static struct rng rng;

/* Remembers the surface as it is. */
static void begin(void)
{
    memcpy(before, mem, size);
    for (int y = 0; y < H; y++)
        memcpy(want[y], fb.pix + y * fb.pitch, W);
}

static int setup(void **state)
{
    (void)state;
    rng_seed(&rng, 21);
    size = fb_size(W, H) + 2 * MARGIN;
    mem = malloc(size);
    before = malloc(size);
    block = malloc(MAX_SIDE * MAX_PITCH);
    assert_true(block && mem && before);
    fb_init(&fb, mem + MARGIN, W, H);
    for (size_t i = 0; i < size; i++)
        mem[i] = (uint8_t)rng_next(&rng);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    free(mem);
    free(before);
    free(block);
    return 0;
}

/* An image of zeros. */
static void clear_image(int w, int h, int pitch)
{
    pix = block + MAX_SIDE * MAX_PITCH - h * pitch;
    memset(pix, 0, (size_t)(h * pitch));
    image = (struct image){ pix, w, h, pitch };
}

/* w, h pixels, a share of them transparent, any values; zeros up to a pitch that is sometimes more than it need be. */
static void random_image(int w, int h)
{
    uint64_t holes = rng_below(&rng, 5);

    clear_image(w, h, (w + 7) / 8 * 8 + 8 * (int)rng_below(&rng, 3));
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            pix[y * image.pitch + x] = rng_below(&rng, 4) < holes ? 0 : (uint8_t)rng_next(&rng);
}

/* All, or any part; often empty, or one pixel wide or high. */
static void random_clip(void)
{
    const int w = rng_below(&rng, 4) ? (int)rng_below(&rng, W + 1) : 1;
    const int h = rng_below(&rng, 4) ? (int)rng_below(&rng, H + 1) : 1;

    if (rng_below(&rng, 3))
        fb_set_clip(&fb, (int)rng_below(&rng, W), (int)rng_below(&rng, H), w, h);
    else
        fb_reset_clip(&fb);
}

/* Mostly where something is seen; at the guard's edges; at the ends of the range. */
static int any_place(int side, int extent)
{
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, INT32_MAX - 7 };

    switch (rng_below(&rng, 8)) {
    case 0:
        return ends[rng_below(&rng, 5)];
    case 1:
        return (int32_t)(uint32_t)rng_next(&rng);
    case 2:
        return -FB_GUARD - 1 + (int)rng_below(&rng, 3);
    case 3:
        return side + FB_GUARD - extent - 1 + (int)rng_below(&rng, 3);
    default:
        return (int)rng_below(&rng, (uint64_t)(side + 2 * extent)) - extent - extent / 2;
    }
}

/* What drawing an image does to the picture that is wanted. table: of a blend; NULL: none. */
static void paint(int64_t x, int64_t y, uint8_t bank, unsigned flags, const uint8_t *table)
{
    for (int v = 0; v < image.h; v++)
        for (int u = 0; u < image.w; u++) {
            int64_t px = x + (flags & BLIT_FLIP_X ? image.w - 1 - u : u);
            int64_t py = y + (flags & BLIT_FLIP_Y ? image.h - 1 - v : v);
            uint8_t c = image.pix[v * image.pitch + u];
            if (c == 0 || px < fb.x0 || px >= fb.x1 || py < fb.y0 || py >= fb.y1)
                continue;
            c = (uint8_t)(c + bank * 16);
            want[py][px] = table ? table[want[py][px] * 256 + c] : c;
        }
}

/* The picture is as wanted; bytes outside the safe rectangle, before and after the surface too, are as they were. The
 * band may have changed only where it belongs to that rectangle. */
static void expect(void)
{
    for (int y = 0; y < H; y++)
        assert_memory_equal(fb.pix + y * fb.pitch, want[y], W);
    for (int y = fb.sy0; y < fb.sy1; y++) {
        ptrdiff_t at = fb.pix - mem + y * fb.pitch + fb.sx0;
        memcpy(before + at, mem + at, (size_t)(fb.sx1 - fb.sx0));
    }
    assert_memory_equal(before, mem, size);
}

/* The table of a rule, or NULL. */
static const uint8_t *table_of(enum blit_mix mix)
{
    static uint8_t table[BLIT_MIXES][65536];
    static bool made[BLIT_MIXES];

    if (mix < BLIT_RAMP_ADD)
        return NULL;
    for (int i = 0; !made[mix] && i < 65536; i++)
        table[mix][i] = blit_ramp_entry(mix, (uint8_t)(i >> 8), (uint8_t)i);
    made[mix] = true;
    return table[mix];
}

/* A sprite anywhere. mix: BLIT_TABLE: of this table. Returns whether it is drawn, which a rule need not do. */
static bool one_sprite(enum blit_mix mix, const uint8_t *table)
{
    const int x = any_place(W, image.w), y = any_place(H, image.h);
    const uint8_t bank = (uint8_t)rng_below(&rng, 16);
    const unsigned flags = (unsigned)rng_below(&rng, 4);
    bool drawn = true;

    random_clip();
    begin();
    if (mix == BLIT_OPAQUE)
        blit_sprite(&fb, &image, x, y, bank, flags);
    else if (mix == BLIT_TABLE)
        blit_blended(&fb, &image, x, y, bank, flags, table);
    else
        drawn = blit_ramped(&fb, &image, x, y, bank, flags, mix);
    if (drawn)
        paint(x, y, bank, flags, mix == BLIT_TABLE ? table : table_of(mix));
    expect();
    return drawn;
}

/* The table is any, also one that makes opaque pixels 0 and lets none stand. */
TEST(sprites_of_every_width)
{
    static const enum blit_mix mixes[] = { BLIT_OPAQUE, BLIT_TABLE, BLIT_RAMP_ADD, BLIT_RAMP_HALF, BLIT_RAMP_MAX };
    static uint8_t table[65536];
    int drawn[BLIT_MIXES] = { 0 };

    for (int i = 0; i < 65536; i++)
        table[i] = (uint8_t)rng_next(&rng);
    for (int w = 1; w <= MAX_SIDE; w++)
        for (int k = 0; k < 1000; k++) {
            if (k % 10 == 0)
                random_image(w, 1 + (int)rng_below(&rng, k % 20 ? 20 : MAX_SIDE));
            drawn[mixes[k % 5]] += one_sprite(mixes[k % 5], table);
        }
    for (int i = 0; i < 5; i++)
        assert_true(drawn[mixes[i]] > 300);
}

TEST(nothing_to_draw)
{
    static uint8_t table[65536];

    fb_reset_clip(&fb);
    begin();
    for (int i = 0; i < 2; i++) {
        clear_image(i ? 24 : 0, i ? 0 : 8, 24);
        for (unsigned flags = 0; flags < 4; flags++) {
            blit_sprite(&fb, &image, 9, 9, 1, flags);
            blit_blended(&fb, &image, 9, 9, 1, flags, table);
        }
    }
    expect();
}

/* What the rules are, for a few. */
TEST(rules)
{
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0x23, 0x54), 0x57);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0x2c, 0x54), 0x5f);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0xff, 0x01), 0x0f);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_HALF, 0x23, 0x54), 0x54);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_HALF, 0x00, 0xf1), 0xf1);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_MAX, 0x23, 0x54), 0x54);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_MAX, 0x29, 0x54), 0x59);
}

/* Opaque, or a rule. */
static enum blit_mix any_mix(void)
{
    static const enum blit_mix mixes[] = { BLIT_OPAQUE, BLIT_RAMP_ADD, BLIT_RAMP_HALF, BLIT_RAMP_MAX };

    return mixes[rng_below(&rng, 4)];
}

/* Many in one go, of every size: in order, one over the other. */
TEST(batches)
{
    enum { MANY = 9 };

    for (int k = 0; k < 12000; k++) {
        const enum blit_mix mix = any_mix();
        struct blit_item items[MANY];
        const int w = 1 + (int)rng_below(&rng, k % 4 ? 20 : MAX_SIDE), h = 1 + (int)rng_below(&rng, 20);
        const size_t n = (size_t)rng_below(&rng, MANY + 1);
        random_image(w, h);
        fb_reset_clip(&fb);
        begin();
        for (size_t i = 0; i < n; i++) {
            int x = (int)rng_below(&rng, (uint64_t)(W + 2 * FB_GUARD - w + 1)) - FB_GUARD;
            int y = (int)rng_below(&rng, (uint64_t)(H + 2 * FB_GUARD - h + 1)) - FB_GUARD;
            items[i] = (struct blit_item){ pix, fb.pix + y * fb.pitch + x, rng_below(&rng, 16) };
            paint(x, y, (uint8_t)items[i].bank, 0, table_of(mix));
        }
        blit_batch(items, n, fb.pitch, w, h, image.pitch, mix);
        expect();
    }
}

/* In one colour, whole or every second pixel of the image, whichever part of it is seen. */
TEST(in_one_colour)
{

    for (int k = 0; k < 6000; k++) {
        const unsigned flags = (unsigned)rng_below(&rng, 8);
        random_image(1 + (int)rng_below(&rng, 20), 1 + (int)rng_below(&rng, 20));
        const int w = image.w, h = image.h;
        const int x0 = any_place(W, w), y0 = any_place(H, h);
        random_clip();
        begin();
        for (int y = fb.y0; y < fb.y1; y++)
            for (int x = fb.x0; x < fb.x1; x++) {
                const int64_t u = flags & BLIT_FLIP_X ? w - 1 - ((int64_t)x - x0) : (int64_t)x - x0;
                const int64_t v = (int64_t)y - y0, row = flags & BLIT_FLIP_Y ? h - 1 - v : v;
                if (u < 0 || v < 0 || u >= w || v >= h || !pix[row * image.pitch + u])
                    continue;
                if (!(flags & BLIT_DOTS) || (u + v) % 2 == 0)
                    want[y][x] = 77;
            }
        blit_solid(&fb, &image, x0, y0, 77, flags);
        expect();
    }
}

/* Rows shorter and longer than those that are turned round before they are painted, and more of them than are turned at
 * once. */
TEST(flipped_rows_of_any_length)
{
    static const int widths[] = { 31, 32, 33, 40, 41, 511, 512, 513, 1016, 1017, 1024, 1025, 1040 };
    enum { LONG = 1040, ROWS = 37 };
    static uint8_t rows[LONG * ROWS];
    uint8_t *memory = malloc(fb_size(LONG, ROWS));
    struct fb wide;

    assert_non_null(memory);
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        const int w = widths[i], pitch = (w + 7) / 8 * 8;
        memset(rows, 0, LONG * ROWS);
        for (int y = 0; y < ROWS; y++)
            for (int x = 0; x < w; x++)
                rows[y * pitch + x] = (uint8_t)rng_next(&rng) & 15;
        fb_init(&wide, memory, LONG, ROWS);
        blit_sprite(&wide, &(struct image){ rows, w, ROWS, pitch }, 0, 0, 2, BLIT_FLIP_X);
        for (int y = 0; y < ROWS; y++)
            for (int x = 0; x < LONG; x++) {
                const int c = x < w ? rows[y * pitch + w - 1 - x] : 0;
                assert_int_equal(wide.pix[y * wide.pitch + x], c ? c + 32 : 0);
            }
    }
    free(memory);
}

/* So much too large may destinations be: nothing, a little, or as much as pictures and surfaces allow. */
static uint32_t any_less(void)
{
    const uint32_t most[] = { 1, 1 << 12, 1 << 25 };

    return (uint32_t)rng_below(&rng, most[rng_below(&rng, 3)]);
}

/* A list of places, between them what is none; stamps stop there. */
TEST(stamps_are_sprites)
{
    uint32_t list[PLACES];
    long drawn = 0;

    for (int k = 0; k < 6000; k++) {
        size_t n = (size_t)rng_below(&rng, PLACES + 1);
        random_image(1 + (int)rng_below(&rng, k % 5 ? 20 : MAX_SIDE),
                     k % 3 ? 8 : 1 + (int)rng_below(&rng, k % 5 ? 20 : MAX_SIDE));
        random_clip();
        const enum blit_mix mix = any_mix();
        const uint32_t less = any_less();
        struct stamp_unclipped_area c = stamp_find_unclipped_area(&fb, image.w, image.h);
        begin();
        for (size_t i = 0; i < n; i++) {
            int x = any_place(W, image.w), y = any_place(H, image.h);
            uint32_t dx = (uint32_t)x - (uint32_t)c.x0, dy = (uint32_t)y - (uint32_t)c.y0;
            uint8_t bank = (uint8_t)rng_below(&rng, 16);
            list[i] = STAMP_CALLER_ENTRY | (uint32_t)i;
            if (dx < c.width && dy < c.height) {
                list[i] = stamp_dest(&fb, dx, dy, bank) + less;
                paint(x, y, bank, 0, table_of(mix));
                drawn++;
            }
        }
        for (size_t i = 0; i < n; i++) {
            i += stamp_draw(&fb, &image, mix, &(struct stamp_list){ list + i, n - i, less });
            if (i < n)
                assert_int_equal(list[i], STAMP_CALLER_ENTRY | i);
        }
        expect();
    }
    assert_true(drawn > 10000);
}

/* Anywhere, or not far beside the last one, as bullets that have just been fired. */
static void place_copy(const struct stamp_unclipped_area *c, uint32_t *x, uint32_t *y)
{
    const uint32_t beside = *x + (uint32_t)rng_below(&rng, 21) - 10;

    if (rng_below(&rng, 4) && beside < c->width) {
        *x = beside;
        return;
    }
    *x = (uint32_t)rng_below(&rng, c->width);
    *y = (uint32_t)rng_below(&rng, c->height);
}

/* Copies of one size behind each other: each destination shows the one that it is said to. */
TEST(stamps_of_copies)
{
    enum { COPIES = 7, FEW = 200, MOST = 700 };
    static uint8_t bytes[COPIES * 24 * 24];
    uint32_t list[MOST], at[MOST];

    for (int k = 0; k < 4000; k++) {
        const int w = k % 2 ? 8 : 1 + (int)rng_below(&rng, 20), h = k % 3 ? 8 : 1 + (int)rng_below(&rng, 20);
        const bool many = k % 16 == 1; /* of one picture */
        const uint32_t copies = many ? 1 : 1 + (uint32_t)rng_below(&rng, COPIES), banks = k % 5 ? 1 : 16;
        const enum blit_mix mix = any_mix();
        uint32_t dx = 0, dy = 0;
        image = (struct image){ bytes, w, h, (w + 7) / 8 * 8 };
        const uint32_t each = (uint32_t)(image.pitch * h), n = many ? MOST : (uint32_t)rng_below(&rng, FEW + 1);
        for (uint32_t i = 0; i < copies * each; i++)
            bytes[i] = (int)(i % (uint32_t)image.pitch) < w && rng_below(&rng, 3) ? (uint8_t)rng_next(&rng) : 0;
        fb_reset_clip(&fb);
        const struct stamp_list all = { list, n, any_less() };
        struct stamp_unclipped_area c = stamp_find_unclipped_area(&fb, w, h);
        begin();
        for (uint32_t i = 0; i < n; i++) {
            place_copy(&c, &dx, &dy);
            uint8_t bank = (uint8_t)(rng_below(&rng, 9) ? rng_below(&rng, banks) : 3);
            list[i] = stamp_dest(&fb, dx, dy, bank);
        }
        for (uint32_t i = 0; i < n; i++) {
            uint32_t copy = (uint32_t)rng_below(&rng, copies);
            uint32_t place = list[i] & (STAMP_CALLER_ENTRY - 1), pitch = (uint32_t)fb.pitch;
            at[i] = copy * each;
            list[i] += all.bias;
            image.pix = bytes + at[i];
            paint((int)(place % pitch) + c.x0, (int)(place / pitch) + c.y0, (uint8_t)(list[i] >> 28), 0, table_of(mix));
        }
        image.pix = bytes;
        if (copies == 1)
            assert_int_equal(n, stamp_draw(&fb, &image, mix, &all));
        else
            assert_int_equal(n, stamp_draw_each(&fb, &image, at, mix, &all));
        expect();
    }
}

RUN_TESTS(setup, teardown)
