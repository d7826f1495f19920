/*
 * test_blit.c - sprites against a painter that sets one byte after the other.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../fb/blit.h"
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
        fb_clip(&b->fb, (int)rng_below(&b->r, W), 0, 1, H);
        return;
    case 1:
        fb_clip(&b->fb, 0, (int)rng_below(&b->r, H), W, 1);
        return;
    case 2:
        fb_clip(&b->fb, (int)rng_below(&b->r, W), (int)rng_below(&b->r, H), (int)rng_below(&b->r, W + 1),
                (int)rng_below(&b->r, H + 1));
        return;
    default:
        fb_clip_all(&b->fb);
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

static void paint(struct bed *b, int64_t x, int64_t y, uint8_t bank, unsigned flags)
{
    const struct image *im = &b->image;

    for (int v = 0; v < im->h; v++)
        for (int u = 0; u < im->w; u++) {
            int64_t px = x + (flags & BLIT_FLIP_X ? im->w - 1 - u : u);
            int64_t py = y + (flags & BLIT_FLIP_Y ? im->h - 1 - v : v);
            uint8_t c = im->pix[v * im->pitch + u];
            if (c != 0 && px >= b->fb.x0 && px < b->fb.x1 && py >= b->fb.y0 && py < b->fb.y1)
                b->want[py][px] = (uint8_t)(c + bank * 16);
        }
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

static void sprites_of_every_width(void **state)
{
    struct bed *b = *state;

    for (int w = 1; w <= MAX_SIDE; w++)
        for (int k = 0; k < 400; k++) {
            if (k % 8 == 0)
                random_image(b, w, 1 + (int)rng_below(&b->r, k % 16 ? 20 : MAX_SIDE));
            one_sprite(b, (unsigned)k % 4);
        }
}

/* Every place round the edge of picture and band, for the widths whose last word hangs over. */
static void sprites_at_every_edge(void **state)
{
    struct bed *b = *state;
    static const int widths[] = { 1, 3, 7, 8, 9, 16, 17 };

    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        random_image(b, widths[i], 5);
        fb_clip_all(&b->fb);
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

static void banks_wrap(void **state)
{
    struct bed *b = *state;

    fb_clip_all(&b->fb);
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

static void nothing_to_draw(void **state)
{
    struct bed *b = *state;

    random_image(b, 8, 8);
    fb_clip(&b->fb, 4, 4, 0, 9);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++)
        blit_sprite(&b->fb, &b->image, 0, 0, 1, flags);
    expect(b);
    fb_clip_all(&b->fb);
    begin(b);
    for (unsigned flags = 0; flags < 4; flags++) {
        b->image.w = 0, b->image.h = 8;
        blit_sprite(&b->fb, &b->image, 9, 9, 1, flags);
        b->image.w = 8, b->image.h = 0;
        blit_sprite(&b->fb, &b->image, 9, 9, 1, flags);
    }
    expect(b);
    b->image.h = 8;
    blit_batch(&b->fb, &b->image, NULL, 0, 1);
    expect(b);
}

static void batches_are_sprites(void **state)
{
    struct bed *b = *state;
    int32_t xy[2 * PLACES];

    for (int k = 0; k < 2500; k++) {
        size_t n = rng_below(&b->r, PLACES + 1);
        uint8_t bank = (uint8_t)rng_below(&b->r, 16);
        random_image(b, 1 + (int)rng_below(&b->r, k % 5 ? 20 : MAX_SIDE),
                     1 + (int)rng_below(&b->r, k % 5 ? 20 : MAX_SIDE));
        random_clip(b);
        begin(b);
        for (size_t i = 0; i < n; i++) {
            xy[2 * i] = any_place(&b->r, W, b->image.w);
            xy[2 * i + 1] = any_place(&b->r, H, b->image.h);
            paint(b, xy[2 * i], xy[2 * i + 1], bank, 0);
        }
        blit_batch(&b->fb, &b->image, xy, n, bank);
        expect(b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sprites_of_every_width), cmocka_unit_test(sprites_at_every_edge), cmocka_unit_test(banks_wrap),
        cmocka_unit_test(nothing_to_draw),        cmocka_unit_test(batches_are_sprites),
    };
    return cmocka_run_group_tests(tests, bed_open, bed_close);
}
