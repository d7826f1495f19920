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
struct bed {
    struct fb fb;
    uint8_t *mem, *before;
    uint8_t want[H][W];
    size_t size;
    uint8_t *block, *pix; /* pix: the image's pixels, in block */
    struct image image;
    struct rng r;
};

static void noise(struct bed *b)
{
    for (size_t i = 0; i < b->size; i++)
        b->mem[i] = (uint8_t)rng_next(&b->r);
}

/* Remembers the surface as it is. */
static void begin(struct bed *b)
{
    memcpy(b->before, b->mem, b->size);
    for (int y = 0; y < H; y++)
        memcpy(b->want[y], b->fb.pix + y * b->fb.pitch, W);
}

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    rng_seed(&b->r, 21);
    b->size = fb_size(W, H) + 2 * MARGIN;
    b->mem = malloc(b->size);
    b->before = malloc(b->size);
    b->block = malloc(MAX_SIDE * MAX_PITCH);
    assert_non_null(b->block);
    assert_non_null(b->mem);
    assert_non_null(b->before);
    fb_init(&b->fb, b->mem + MARGIN, W, H);
    noise(b);
    *state = b;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *b = *state;

    free(b->mem);
    free(b->before);
    free(b->block);
    free(b);
    return 0;
}

/* An image of zeros. */
static void clear_image(struct bed *b, int w, int h, int pitch)
{
    b->pix = b->block + MAX_SIDE * MAX_PITCH - h * pitch;
    memset(b->pix, 0, (size_t)(h * pitch));
    b->image = (struct image){ b->pix, w, h, pitch };
}

/* w, h pixels, a share of them transparent, any values; zeros up to a pitch that is sometimes more than it need be. */
static void random_image(struct bed *b, int w, int h)
{
    uint64_t holes = rng_below(&b->r, 5);

    clear_image(b, w, h, (w + 7) / 8 * 8 + 8 * (int)rng_below(&b->r, 3));
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            b->pix[y * b->image.pitch + x] = rng_below(&b->r, 4) < holes ? 0 : (uint8_t)rng_next(&b->r);
}

static void random_clip(struct bed *b)
{
    switch (rng_below(&b->r, 4)) {
    case 0: /* one pixel wide or high */
        fb_set_clip(&b->fb, (int)rng_below(&b->r, W), 0, 1, H);
        return;
    case 1:
        fb_set_clip(&b->fb, 0, (int)rng_below(&b->r, H), W, 1);
        return;
    case 2:
        fb_set_clip(&b->fb, (int)rng_below(&b->r, W), (int)rng_below(&b->r, H), (int)rng_below(&b->r, W + 1),
                    (int)rng_below(&b->r, H + 1));
        return;
    default:
        fb_reset_clip(&b->fb);
    }
}

/* Mostly where something is seen; at the guard's edges; at the ends of the range. */
static int any_place(struct rng *r, int side, int size)
{
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, INT32_MAX - 7 };

    switch (rng_below(r, 8)) {
    case 0:
        return ends[rng_below(r, 5)];
    case 1:
        return (int32_t)(uint32_t)rng_next(r);
    case 2:
        return -FB_GUARD - 1 + (int)rng_below(r, 3);
    case 3:
        return side + FB_GUARD - size - 1 + (int)rng_below(r, 3);
    default:
        return (int)rng_below(r, (uint64_t)(side + 2 * size)) - size - size / 2;
    }
}

/* table: of a blend; NULL: none. */
static void paint_through(struct bed *b, int64_t x, int64_t y, uint8_t bank, unsigned flags, const uint8_t *table)
{
    const struct image *im = &b->image;

    for (int v = 0; v < im->h; v++)
        for (int u = 0; u < im->w; u++) {
            int64_t px = x + (flags & BLIT_FLIP_X ? im->w - 1 - u : u);
            int64_t py = y + (flags & BLIT_FLIP_Y ? im->h - 1 - v : v);
            uint8_t c = im->pix[v * im->pitch + u];
            if (c == 0 || px < b->fb.x0 || px >= b->fb.x1 || py < b->fb.y0 || py >= b->fb.y1)
                continue;
            c = (uint8_t)(c + bank * 16);
            b->want[py][px] = table ? table[b->want[py][px] * 256 + c] : c;
        }
}

static void paint(struct bed *b, int64_t x, int64_t y, uint8_t bank, unsigned flags)
{
    paint_through(b, x, y, bank, flags, NULL);
}

/* The picture is as wanted; bytes outside the safe rectangle, before and after the surface too, are as they were. The
 * band may have changed only where it belongs to that rectangle. */
static void expect(struct bed *b)
{
    struct fb *fb = &b->fb;

    for (int y = 0; y < H; y++)
        assert_memory_equal(fb->pix + y * fb->pitch, b->want[y], W);
    for (int y = fb->sy0; y < fb->sy1; y++) {
        ptrdiff_t at = fb->pix - b->mem + y * fb->pitch + fb->sx0;
        memcpy(b->before + at, b->mem + at, (size_t)(fb->sx1 - fb->sx0));
    }
    assert_memory_equal(b->before, b->mem, b->size);
}

static void one_sprite(struct bed *b, unsigned flags)
{
    int x = any_place(&b->r, W, b->image.w), y = any_place(&b->r, H, b->image.h);
    uint8_t bank = (uint8_t)rng_below(&b->r, 16);

    random_clip(b);
    begin(b);
    paint(b, x, y, bank, flags);
    blit_sprite(&b->fb, &b->image, x, y, bank, flags);
    expect(b);
}

TEST(sprites_of_every_width)
{
    struct bed *b = *state;

    for (int w = 1; w <= MAX_SIDE; w++)
        for (int k = 0; k < 400; k++) {
            if (k % 8 == 0)
                random_image(b, w, 1 + (int)rng_below(&b->r, k % 16 ? 20 : MAX_SIDE));
            one_sprite(b, (unsigned)k % 4);
        }
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

/* What the rules are, for a few. */
TEST(rules)
{
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0x23, 0x54), 0x57);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0x2c, 0x54), 0x5f);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_ADD, 0xff, 0x01), 0x0f);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_HALF, 0x23, 0x54), 0x54);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_HALF, 0x00, 0xf1), 0xf1);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_HALF, 0x1f, 0x3f), 0x3f);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_MAX, 0x23, 0x54), 0x54);
    assert_int_equal(blit_ramp_entry(BLIT_RAMP_MAX, 0x29, 0x54), 0x59);
}

/* A rule draws what its table draws, or says that it does not. */
TEST(ruled_sprites)
{
    struct bed *b = *state;
    int drawn = 0;

    for (int k = 0; k < 9000; k++) {
        const enum blit_mix rule = BLIT_RAMP_ADD + (enum blit_mix)(k % 3);
        const unsigned flags = (unsigned)rng_below(&b->r, 4);
        const uint8_t bank = (uint8_t)rng_below(&b->r, 16);
        random_image(b, 1 + (int)rng_below(&b->r, k % 4 ? 20 : MAX_SIDE), 1 + (int)rng_below(&b->r, 20));
        int x = any_place(&b->r, W, b->image.w), y = any_place(&b->r, H, b->image.h);
        random_clip(b);
        begin(b);
        if (blit_ramped(&b->fb, &b->image, x, y, bank, flags, rule)) {
            paint_through(b, x, y, bank, flags, table_of(rule));
            drawn++;
        }
        expect(b);
    }
    assert_true(drawn > 300);
}

/* Opaque, or a rule. */
static enum blit_mix any_mix(struct rng *r)
{
    static const enum blit_mix mixes[] = { BLIT_OPAQUE, BLIT_RAMP_ADD, BLIT_RAMP_HALF, BLIT_RAMP_MAX };

    return mixes[rng_below(r, 4)];
}

/* Many in one go, of every size: in order, one over the other. */
TEST(batches)
{
    struct bed *b = *state;
    enum { MANY = 9 };

    for (int k = 0; k < 12000; k++) {
        const enum blit_mix mix = any_mix(&b->r);
        struct blit_item items[MANY];
        const int w = 1 + (int)rng_below(&b->r, k % 4 ? 20 : MAX_SIDE), h = 1 + (int)rng_below(&b->r, 20);
        const size_t n = (size_t)rng_below(&b->r, MANY + 1);
        random_image(b, w, h);
        fb_reset_clip(&b->fb);
        begin(b);
        for (size_t i = 0; i < n; i++) {
            int x = (int)rng_below(&b->r, (uint64_t)(W + 2 * FB_GUARD - w + 1)) - FB_GUARD;
            int y = (int)rng_below(&b->r, (uint64_t)(H + 2 * FB_GUARD - h + 1)) - FB_GUARD;
            items[i] = (struct blit_item){ b->pix, b->fb.pix + y * b->fb.pitch + x, rng_below(&b->r, 16) };
            paint_through(b, x, y, (uint8_t)items[i].bank, 0, table_of(mix));
        }
        blit_batch(items, n, b->fb.pitch, w, h, b->image.pitch, mix);
        expect(b);
    }
}

/* Every place round the edge of picture and band, for the widths whose last word hangs over. */
TEST(sprites_at_every_edge)
{
    struct bed *b = *state;
    static const int widths[] = { 1, 3, 7, 8, 9, 16, 17 };

    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        random_image(b, widths[i], 5);
        fb_reset_clip(&b->fb);
        for (int x = -FB_GUARD - 20; x < W + FB_GUARD + 4; x++)
            for (int y = -FB_GUARD - 6; y < H + FB_GUARD + 2; y += x % 8 ? 13 : 1)
                for (unsigned flags = 0; flags < 4; flags++) {
                    begin(b);
                    paint(b, x, y, 5, flags);
                    blit_sprite(&b->fb, &b->image, x, y, 5, flags);
                    expect(b);
                }
    }
}

/* In one colour, whole or every second pixel of the image, whichever part of it is seen. */
TEST(in_one_colour)
{
    struct bed *b = *state;

    for (int k = 0; k < 6000; k++) {
        const unsigned flags = (unsigned)rng_below(&b->r, 8);
        random_image(b, 1 + (int)rng_below(&b->r, 20), 1 + (int)rng_below(&b->r, 20));
        const int w = b->image.w, h = b->image.h;
        const int x0 = any_place(&b->r, W, w), y0 = any_place(&b->r, H, h);
        random_clip(b);
        begin(b);
        for (int y = b->fb.y0; y < b->fb.y1; y++)
            for (int x = b->fb.x0; x < b->fb.x1; x++) {
                const int64_t u = flags & BLIT_FLIP_X ? w - 1 - ((int64_t)x - x0) : (int64_t)x - x0;
                const int64_t v = (int64_t)y - y0, row = flags & BLIT_FLIP_Y ? h - 1 - v : v;
                if (u < 0 || v < 0 || u >= w || v >= h || !b->pix[row * b->image.pitch + u])
                    continue;
                if (!(flags & BLIT_DOTS) || (u + v) % 2 == 0)
                    b->want[y][x] = 77;
            }
        blit_solid(&b->fb, &b->image, x0, y0, 77, flags);
        expect(b);
    }
}

TEST(banks_wrap)
{
    struct bed *b = *state;

    fb_reset_clip(&b->fb);
    clear_image(b, 64, 4, 64);
    for (int i = 0; i < 256; i++)
        b->pix[i] = (uint8_t)i;
    for (unsigned bank = 0; bank < 16; bank++) {
        noise(b);
        begin(b);
        paint(b, 3, 2, (uint8_t)bank, 0);
        assert_int_equal(b->want[2 + 1][3 + 0], (uint8_t)(64 + bank * 16));
        blit_sprite(&b->fb, &b->image, 3, 2, (uint8_t)bank, 0);
        expect(b);
    }
}

TEST(nothing_to_draw)
{
    struct bed *b = *state;

    random_image(b, 8, 8);
    fb_set_clip(&b->fb, 4, 4, 0, 9);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++)
        blit_sprite(&b->fb, &b->image, 0, 0, 1, flags);
    expect(b);
    fb_reset_clip(&b->fb);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++) {
        b->image.w = 0, b->image.h = 8;
        blit_sprite(&b->fb, &b->image, 9, 9, 1, flags);
        b->image.w = 8, b->image.h = 0;
        blit_sprite(&b->fb, &b->image, 9, 9, 1, flags);
    }
    expect(b);
}

/* Rows shorter and longer than those that are turned round before they are painted, and more of them than are turned at
 * once. */
TEST(flipped_rows_of_any_length)
{
    static const int widths[] = { 31, 32, 33, 40, 41, 127, 511, 512, 513, 1015, 1016, 1017, 1023, 1024, 1025, 1040 };
    enum { LONG = 1040, ROWS = 37 };
    uint8_t *pix = malloc(LONG * ROWS), *mem = malloc(fb_size(LONG, ROWS));
    struct rng r;
    struct fb fb;

    assert_non_null(pix);
    assert_non_null(mem);
    rng_seed(&r, 4);
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        int w = widths[i], pitch = (w + 7) / 8 * 8;
        memset(pix, 0, LONG * ROWS);
        for (int y = 0; y < ROWS; y++)
            for (int x = 0; x < w; x++)
                pix[y * pitch + x] = (uint8_t)rng_next(&r) & 15;
        struct image image = { pix, w, ROWS, pitch };
        fb_init(&fb, mem, LONG, ROWS);
        blit_sprite(&fb, &image, 0, 0, 2, BLIT_FLIP_X);
        for (int y = 0; y < ROWS; y++)
            for (int x = 0; x < LONG; x++) {
                int c = x < w ? pix[y * pitch + w - 1 - x] : 0;
                assert_int_equal(fb.pix[y * fb.pitch + x], c ? c + 32 : 0);
            }
    }
    free(pix);
    free(mem);
}

/* Any table, also one that makes opaque pixels 0 and lets none stand. */
static void random_table(struct bed *b, uint8_t *table)
{
    for (int i = 0; i < 65536; i++)
        table[i] = (uint8_t)rng_next(&b->r);
}

TEST(blended_sprites)
{
    struct bed *b = *state;
    uint8_t *table = malloc(65536);

    assert_non_null(table);
    random_table(b, table);
    for (int w = 1; w <= MAX_SIDE; w++)
        for (int k = 0; k < 400; k++) {
            if (k % 8 == 0)
                random_image(b, w, 1 + (int)rng_below(&b->r, k % 16 ? 20 : MAX_SIDE));
            int x = any_place(&b->r, W, b->image.w), y = any_place(&b->r, H, b->image.h);
            uint8_t bank = (uint8_t)rng_below(&b->r, 256);
            random_clip(b);
            begin(b);
            paint_through(b, x, y, bank, (unsigned)k % 4, table);
            blit_blended(&b->fb, &b->image, x, y, bank, (unsigned)k % 4, table);
            expect(b);
        }
    free(table);
}

/* What lies under a pixel, and what is drawn over it: all pairs. */
TEST(blended_pairs)
{
    struct bed *b = *state;
    uint8_t *table = malloc(65536);
    uint8_t one = 7;

    assert_non_null(table);
    random_table(b, table);
    b->image = (struct image){ NULL, 1, 1, 8 };
    fb_reset_clip(&b->fb);
    for (int under = 0; under < 256; under++)
        for (int bank = 0; bank < 16; bank++) {
            uint8_t row[8] = { one };
            b->image.pix = row;
            b->fb.pix[0] = (uint8_t)under;
            blit_blended(&b->fb, &b->image, 0, 0, (uint8_t)bank, 0, table);
            assert_int_equal(b->fb.pix[0], table[under * 256 + (one + bank * 16) % 256]);
        }
    free(table);
}

TEST(blended_nothing)
{
    struct bed *b = *state;
    uint8_t *table = calloc(1, 65536);

    assert_non_null(table);
    random_image(b, 24, 8);
    fb_set_clip(&b->fb, 4, 4, 0, 9);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++)
        blit_blended(&b->fb, &b->image, 0, 0, 1, flags, table);
    expect(b);
    fb_reset_clip(&b->fb);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++) {
        b->image.w = 0, b->image.h = 8;
        blit_blended(&b->fb, &b->image, 9, 9, 1, flags, table);
        b->image.w = 24, b->image.h = 0;
        blit_blended(&b->fb, &b->image, 9, 9, 1, flags, table);
    }
    expect(b);
    free(table);
}

/* So much too large may destinations be: nothing, a little, or as much as pictures and surfaces allow. */
static uint32_t any_less(struct bed *b)
{
    const uint32_t most[] = { 1, 1 << 12, 1 << 25 };

    return (uint32_t)rng_below(&b->r, most[rng_below(&b->r, 3)]);
}

/* A list of places, between them what is none; stamps stop there. */
TEST(stamps_are_sprites)
{
    struct bed *b = *state;
    uint32_t list[PLACES];
    long drawn = 0;

    for (int k = 0; k < 6000; k++) {
        size_t n = (size_t)rng_below(&b->r, PLACES + 1);
        random_image(b, 1 + (int)rng_below(&b->r, k % 5 ? 20 : MAX_SIDE),
                     k % 3 ? 8 : 1 + (int)rng_below(&b->r, k % 5 ? 20 : MAX_SIDE));
        random_clip(b);
        const enum blit_mix mix = any_mix(&b->r);
        const uint32_t less = any_less(b);
        struct stamp_unclipped_area c = stamp_find_unclipped_area(&b->fb, b->image.w, b->image.h);
        begin(b);
        for (size_t i = 0; i < n; i++) {
            int x = any_place(&b->r, W, b->image.w), y = any_place(&b->r, H, b->image.h);
            uint32_t dx = (uint32_t)x - (uint32_t)c.x0, dy = (uint32_t)y - (uint32_t)c.y0;
            uint8_t bank = (uint8_t)rng_below(&b->r, 16);
            list[i] = STAMP_CALLER_ENTRY | (uint32_t)i;
            if (dx < c.width && dy < c.height) {
                list[i] = stamp_dest(&b->fb, dx, dy, bank) + less;
                paint_through(b, x, y, bank, 0, table_of(mix));
                drawn++;
            }
        }
        for (size_t i = 0; i < n; i++) {
            i += stamp_draw(&b->fb, &b->image, mix, &(struct stamp_list){ list + i, n - i, less });
            if (i < n)
                assert_int_equal(list[i], STAMP_CALLER_ENTRY | i);
        }
        expect(b);
    }
    print_message("# %ld drawn\n", drawn);
    assert_true(drawn > 10000);
}

/* Anywhere, or not far beside the last one, as bullets that have just been fired. */
static void place_copy(struct bed *b, const struct stamp_unclipped_area *c, uint32_t *x, uint32_t *y)
{
    const uint32_t beside = *x + (uint32_t)rng_below(&b->r, 21) - 10;

    if (rng_below(&b->r, 4) && beside < c->width) {
        *x = beside;
        return;
    }
    *x = (uint32_t)rng_below(&b->r, c->width);
    *y = (uint32_t)rng_below(&b->r, c->height);
}

/* Copies of one size behind each other: each destination shows the one that it is said to. */
TEST(stamps_of_copies)
{
    struct bed *b = *state;
    enum { COPIES = 7, FEW = 200, MOST = 700 };
    static uint8_t pix[COPIES * 24 * 24];
    uint32_t list[MOST], at[MOST];

    for (int k = 0; k < 4000; k++) {
        const int w = k % 2 ? 8 : 1 + (int)rng_below(&b->r, 20), h = k % 3 ? 8 : 1 + (int)rng_below(&b->r, 20);
        const bool many = k % 16 == 1; /* of one picture */
        const uint32_t copies = many ? 1 : 1 + (uint32_t)rng_below(&b->r, COPIES), banks = k % 5 ? 1 : 16;
        const enum blit_mix mix = any_mix(&b->r);
        uint32_t dx = 0, dy = 0;
        b->image = (struct image){ pix, w, h, (w + 7) / 8 * 8 };
        const uint32_t size = (uint32_t)(b->image.pitch * h), n = many ? MOST : (uint32_t)rng_below(&b->r, FEW + 1);
        for (uint32_t i = 0; i < copies * size; i++)
            pix[i] = (int)(i % (uint32_t)b->image.pitch) < w && rng_below(&b->r, 3) ? (uint8_t)rng_next(&b->r) : 0;
        fb_reset_clip(&b->fb);
        const struct stamp_list all = { list, n, any_less(b) };
        struct stamp_unclipped_area c = stamp_find_unclipped_area(&b->fb, w, h);
        begin(b);
        for (uint32_t i = 0; i < n; i++) {
            place_copy(b, &c, &dx, &dy);
            uint8_t bank = (uint8_t)(rng_below(&b->r, 9) ? rng_below(&b->r, banks) : 3);
            list[i] = stamp_dest(&b->fb, dx, dy, bank);
        }
        for (uint32_t i = 0; i < n; i++) {
            uint32_t copy = (uint32_t)rng_below(&b->r, copies);
            uint32_t place = list[i] & (STAMP_CALLER_ENTRY - 1), pitch = (uint32_t)b->fb.pitch;
            at[i] = copy * size;
            list[i] += all.bias;
            b->image.pix = b->pix = pix + at[i];
            paint_through(b, (int)(place % pitch) + c.x0, (int)(place / pitch) + c.y0, (uint8_t)(list[i] >> 28), 0,
                          table_of(mix));
        }
        b->image.pix = pix;
        if (copies == 1)
            assert_int_equal(n, stamp_draw(&b->fb, &b->image, mix, &all));
        else
            assert_int_equal(n, stamp_draw_each(&b->fb, &b->image, at, mix, &all));
        expect(b);
    }
}

RUN_TESTS(bed_open, bed_close)
