/*
 * test_fb.c - the surface, its clip, rectangles and lines, against painters that ask every pixel of the picture.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/fb.h"
#include "../../src/base/rng.h"

enum { W = 72, H = 50, MARGIN = 64, PAINT = 7 };

/* A surface between two margins, filled with noise, and a copy of it from before; the pixels to be painted. */
static struct fb fb;
static uint8_t *mem, *before;
static size_t size;
static bool want[H][W];
static struct rng r;

static int setup(void **state)
{
    (void)state;
    rng_seed(&r, 1);
    size = fb_size(W, H) + 2 * MARGIN;
    mem = malloc(size);
    before = malloc(size);
    assert_true(mem && before);
    fb_init(&fb, mem + MARGIN, W, H);
    for (size_t i = 0; i < size; i++)
        mem[i] = (uint8_t)(8 + rng_below(&r, 200)); /* never PAINT */
    memcpy(before, mem, size);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    free(mem);
    free(before);
    return 0;
}

static bool in_clip(int64_t x, int64_t y)
{
    return x >= fb.x0 && x < fb.x1 && y >= fb.y0 && y < fb.y1;
}

/* mem is before, but for the pixels of want, which are PAINT; these are as before again. */
static void expect(void)
{
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            uint8_t *got = fb.pix + y * fb.pitch + x;
            if (want[y][x]) {
                if (*got != PAINT)
                    fail_msg("pixel %d,%d is not painted", x, y);
                *got = before[got - mem];
            }
        }
    assert_memory_equal(mem, before, size);
}

/* Small, near the edges, or anywhere at all. */
static int any_int(void)
{
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, -1, 0, 1, W, H };

    switch (rng_below(&r, 4)) {
    case 0:
        return ends[rng_below(&r, sizeof ends / sizeof *ends)];
    case 1:
        return (int32_t)(uint32_t)rng_next(&r);
    default:
        return (int)rng_below(&r, 2 * W) - W / 2;
    }
}

/* Sometimes an empty one. */
static void random_clip(void)
{
    if (rng_below(&r, 3) == 0)
        fb_reset_clip(&fb);
    else
        fb_set_clip(&fb, (int)rng_below(&r, W), (int)rng_below(&r, H), (int)rng_below(&r, W), (int)rng_below(&r, H));
}

TEST(size_and_start)
{
    static const int sizes[][2] = { { 1, 1 }, { 7, 3 }, { 320, 240 } };

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const int w = sizes[i][0], h = sizes[i][1];
        const size_t n = fb_size(w, h);
        uint8_t *block = malloc(n);
        struct fb start;
        memset(block, 0xee, n);
        fb_init(&start, block, w, h);
        assert_true(start.w == w && start.h == h);
        assert_true(start.pitch >= w + 2 * FB_GUARD && start.pitch % 8 == 0);
        assert_true(start.pix - FB_GUARD * start.pitch - FB_GUARD - FB_SLACK >= block);
        assert_true(start.pix + (h + FB_GUARD - 1) * start.pitch + w + FB_GUARD + FB_SLACK <= block + n);
        for (size_t k = 0; k < n; k++)
            assert_int_equal(block[k], 0);
        assert_true(start.x0 == 0 && start.y0 == 0 && start.x1 == w && start.y1 == h);
        free(block);
    }
}

TEST(clip_is_the_intersection)
{
    for (int k = 0; k < 3000; k++) {
        const int64_t x = any_int(), y = any_int(), w = any_int(), h = any_int();
        bool empty = true;
        fb_set_clip(&fb, (int)x, (int)y, (int)w, (int)h);
        for (int py = 0; py < H; py++)
            for (int px = 0; px < W; px++) {
                const bool inside = px >= x && px < x + w && py >= y && py < y + h;
                assert_int_equal(inside, in_clip(px, py));
                empty = empty && !inside;
            }
        assert_true(fb.x0 >= 0 && fb.x1 <= W && fb.y0 >= 0 && fb.y1 <= H);
        if (empty) {
            assert_true(fb.sx0 >= fb.sx1 && fb.sy0 >= fb.sy1);
            continue;
        }
        assert_int_equal(fb.sx0, fb.x0 == 0 ? -FB_GUARD : fb.x0);
        assert_int_equal(fb.sy0, fb.y0 == 0 ? -FB_GUARD : fb.y0);
        assert_int_equal(fb.sx1, fb.x1 == W ? W + FB_GUARD : fb.x1);
        assert_int_equal(fb.sy1, fb.y1 == H ? H + FB_GUARD : fb.y1);
    }
}

/* It fills the band between the picture's rows too, and nothing before the first or after the last. */
TEST(fill_ignores_the_clip)
{
    fb_set_clip(&fb, 5, 6, 7, 8);
    fb_fill(&fb, PAINT);
    memset(want, 1, sizeof want);
    for (int y = 0; y < H - 1; y++)
        for (int x = W; x < fb.pitch; x++) {
            uint8_t *got = fb.pix + y * fb.pitch + x;
            assert_int_equal(*got, PAINT);
            *got = before[got - mem];
        }
    expect();
}

TEST(magnified_in_place)
{
    memset(want, 0, sizeof want);
    for (int k = 0; k < 2000; k++) {
        const int zoom = 1 + (int)rng_below(&r, 4), dx = (int)rng_below(&r, (uint64_t)zoom),
                  dy = (int)rng_below(&r, (uint64_t)zoom), x = (int)rng_below(&r, W), y = (int)rng_below(&r, H),
                  w = (int)rng_below(&r, (uint64_t)(W - x + 1)), h = (int)rng_below(&r, (uint64_t)(H - y + 1));
        random_clip();
        fb_magnify(&fb, x, y, w, h, dx, dy, zoom);
        for (int j = 0; j < h; j++)
            for (int i = 0; i < w; i++) {
                uint8_t *got = fb.pix + (y + j) * fb.pitch + x + i;
                const uint8_t *from = fb.pix + (y + (j + dy) / zoom) * fb.pitch + x + (i + dx) / zoom;
                assert_int_equal(*got, before[from - mem]);
            }
        for (int j = 0; j < h; j++)
            for (int i = 0; i < w; i++) {
                uint8_t *got = fb.pix + (y + j) * fb.pitch + x + i;
                *got = before[got - mem];
            }
        expect();
    }
}

TEST(rects_and_frames)
{
    for (int k = 0; k < 3000; k++) {
        const int64_t x = any_int(), y = any_int(), w = any_int(), h = any_int();
        const bool frame = rng_below(&r, 2);
        random_clip();
        for (int py = 0; py < H; py++)
            for (int px = 0; px < W; px++) {
                const bool inside = px >= x && px < x + w && py >= y && py < y + h;
                const bool edge = px == x || py == y || px == x + w - 1 || py == y + h - 1;
                want[py][px] = inside && (edge || !frame) && in_clip(px, py);
            }
        (frame ? fb_outline : fb_fill_rect)(&fb, (int)x, (int)y, (int)w, (int)h, PAINT);
        expect();
    }
}

/* The header's formula, for every column or row of the picture that the line crosses: any ends. */
static void want_line(int64_t x0, int64_t y0, int64_t x1, int64_t y1)
{
    int64_t dx = x1 > x0 ? x1 - x0 : x0 - x1, dy = y1 > y0 ? y1 - y0 : y0 - y1;
    bool steep = dy > dx;
    int64_t from = steep ? y0 : x0, to = steep ? y1 : x1, side = steep ? x0 : y0, side_to = steep ? x1 : y1;
    uint64_t n = (uint64_t)(steep ? dy : dx), m = (uint64_t)(steep ? dx : dy);

    for (int64_t a = 0; a < (steep ? H : W); a++) {
        uint64_t i = (uint64_t)(to >= from ? a - from : from - a);
        if ((to >= from ? a < from : a > from) || i > n)
            continue;
        int64_t off = n ? (int64_t)((i * m + n / 2) / n) : 0, c = side_to >= side ? side + off : side - off;
        int64_t x = steep ? c : a, y = steep ? a : c;
        if (in_clip(x, y))
            want[y][x] = true;
    }
}

/* Short ones, and long ones: a line that took its time per step of the whole length would not end here. */
TEST(lines)
{
    int seen = 0;

    for (int k = 0; k < 20000; k++) {
        const int span = k % 2 ? 5 : 300, far = (int)rng_below(&r, INT32_MAX - W), off = (int)rng_below(&r, 2000);
        int v[4] = { W / 2 - far, -far + off, W / 2 + far, far - off }; /* through the picture, from far away */
        for (int i = 0; k % 4 && i < 4; i++)
            v[i] = k % 4 == 1 ? any_int() : (int)rng_below(&r, (uint64_t)(2 * span)) - span + 20;
        random_clip();
        memset(want, 0, sizeof want);
        want_line(v[0], v[1], v[2], v[3]);
        fb_line(&fb, v[0], v[1], v[2], v[3], PAINT);
        for (int i = 0; i < W * H; i++)
            seen += want[i / W][i % W];
        expect();
    }
    assert_true(seen > 20000); /* many of them do cross the picture */
    memset(want, 0, sizeof want);
    fb_reset_clip(&fb);
    want[3][2] = want[4][3] = want[4][4] = true; /* a tie goes away from the start */
    fb_line(&fb, 2, 3, 4, 4, PAINT);
    expect();
}

RUN_TESTS_EACH(setup, teardown)
