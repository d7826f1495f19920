/*
 * test_fb.c - the surface, its clip, rectangles and lines, against painters that ask every pixel of the picture.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/fb.h"
#include "../../src/base/rng.h"

enum { W = 72, H = 50, MARGIN = 64, PAINT = 7 };

/* A surface between two margins, everything filled with noise, and a copy of it from before. */
struct bed {
    struct fb fb;
    uint8_t *mem, *before;
    size_t size;
};

static void bed_open(struct bed *b, struct rng *r)
{
    b->size = fb_size(W, H) + 2 * MARGIN;
    b->mem = malloc(b->size);
    b->before = malloc(b->size);
    assert_non_null(b->mem);
    assert_non_null(b->before);
    fb_init(&b->fb, b->mem + MARGIN, W, H);
    for (size_t i = 0; i < b->size; i++)
        b->mem[i] = (uint8_t)(8 + rng_below(r, 200)); /* never PAINT */
    memcpy(b->before, b->mem, b->size);
}

static void bed_close(struct bed *b)
{
    free(b->mem);
    free(b->before);
}

static void bed_reset(struct bed *b)
{
    memcpy(b->mem, b->before, b->size);
}

static bool in_clip(const struct fb *fb, int64_t x, int64_t y)
{
    return x >= fb->x0 && x < fb->x1 && y >= fb->y0 && y < fb->y1;
}

/* mem is before, but for the pixels of want, which are PAINT. */
static void bed_expect(struct bed *b, bool want[H][W])
{
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            uint8_t *got = b->fb.pix + y * b->fb.pitch + x;
            if (want[y][x]) {
                if (*got != PAINT)
                    fail_msg("pixel %d,%d is not painted", x, y);
                *got = b->before[got - b->mem];
            }
        }
    assert_memory_equal(b->mem, b->before, b->size);
}

/* Small, near the edges, or anywhere at all. */
static int any_int(struct rng *r)
{
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, -1, 0, 1, W, H };

    switch (rng_below(r, 4)) {
    case 0:
        return ends[rng_below(r, sizeof ends / sizeof *ends)];
    case 1:
        return (int32_t)(uint32_t)rng_next(r);
    default:
        return (int)rng_below(r, 2 * W) - W / 2;
    }
}

static void random_clip(struct fb *fb, struct rng *r)
{
    if (rng_below(r, 3) == 0)
        fb_reset_clip(fb);
    else
        fb_set_clip(fb, (int)rng_below(r, W), (int)rng_below(r, H), 1 + (int)rng_below(r, W), 1 + (int)rng_below(r, H));
}

TEST(size_and_start)
{
    static const int sizes[][2] = { { 1, 1 }, { 7, 3 }, { 64, 64 }, { 320, 240 }, { 1024, 1024 } };

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        int w = sizes[i][0], h = sizes[i][1];
        size_t size = fb_size(w, h);
        uint8_t *mem = malloc(size);
        struct fb fb;
        assert_non_null(mem);
        memset(mem, 0xee, size);
        fb_init(&fb, mem, w, h);
        assert_int_equal(fb.w, w);
        assert_int_equal(fb.h, h);
        assert_true(fb.pitch >= w + 2 * FB_GUARD && fb.pitch % 8 == 0);
        assert_true(fb.pix - FB_GUARD * fb.pitch - FB_GUARD - FB_SLACK >= mem);
        assert_true(fb.pix + (h + FB_GUARD - 1) * fb.pitch + w + FB_GUARD + FB_SLACK <= mem + size);
        for (size_t k = 0; k < size; k++)
            assert_int_equal(mem[k], 0);
        assert_true(fb.x0 == 0 && fb.y0 == 0 && fb.x1 == w && fb.y1 == h);
        assert_true(fb.sx0 == -FB_GUARD && fb.sy0 == -FB_GUARD && fb.sx1 == w + FB_GUARD && fb.sy1 == h + FB_GUARD);
        free(mem);
    }
}

TEST(clip_is_the_intersection)
{
    struct rng r;
    struct bed b;

    rng_seed(&r, 1);
    bed_open(&b, &r);
    for (int k = 0; k < 3000; k++) {
        int64_t x = any_int(&r), y = any_int(&r), w = any_int(&r), h = any_int(&r);
        struct fb *fb = &b.fb;
        bool empty = true;
        fb_set_clip(fb, (int)x, (int)y, (int)w, (int)h);
        for (int py = 0; py < H; py++)
            for (int px = 0; px < W; px++) {
                bool inside = px >= x && px < x + w && py >= y && py < y + h;
                assert_int_equal(inside, in_clip(fb, px, py));
                empty = empty && !inside;
            }
        assert_true(fb->x0 >= 0 && fb->x1 <= W && fb->y0 >= 0 && fb->y1 <= H);
        if (empty) {
            assert_true(fb->sx0 >= fb->sx1 && fb->sy0 >= fb->sy1);
            continue;
        }
        assert_int_equal(fb->sx0, fb->x0 == 0 ? -FB_GUARD : fb->x0);
        assert_int_equal(fb->sy0, fb->y0 == 0 ? -FB_GUARD : fb->y0);
        assert_int_equal(fb->sx1, fb->x1 == W ? W + FB_GUARD : fb->x1);
        assert_int_equal(fb->sy1, fb->y1 == H ? H + FB_GUARD : fb->y1);
    }
    bed_close(&b);
}

/* It fills the band between the picture's rows too, and nothing before the first or after the last. */
TEST(fill_ignores_the_clip)
{
    struct rng r;
    struct bed b;
    bool want[H][W];

    rng_seed(&r, 2);
    bed_open(&b, &r);
    fb_set_clip(&b.fb, 5, 6, 7, 8);
    fb_fill(&b.fb, PAINT);
    memset(want, 1, sizeof want);
    for (int y = 0; y < H - 1; y++)
        for (int x = W; x < b.fb.pitch; x++) {
            uint8_t *got = b.fb.pix + y * b.fb.pitch + x;
            assert_int_equal(*got, PAINT);
            *got = b.before[got - b.mem];
        }
    bed_expect(&b, want);
    bed_close(&b);
}

TEST(rects_and_frames)
{
    struct rng r;
    struct bed b;

    rng_seed(&r, 3);
    bed_open(&b, &r);
    for (int k = 0; k < 3000; k++) {
        int64_t x = any_int(&r), y = any_int(&r), w = any_int(&r), h = any_int(&r);
        bool frame = rng_below(&r, 2), want[H][W];
        random_clip(&b.fb, &r);
        bed_reset(&b);
        for (int py = 0; py < H; py++)
            for (int px = 0; px < W; px++) {
                bool inside = px >= x && px < x + w && py >= y && py < y + h;
                bool edge = px == x || py == y || px == x + w - 1 || py == y + h - 1;
                want[py][px] = inside && (edge || !frame) && in_clip(&b.fb, px, py);
            }
        (frame ? fb_outline : fb_fill_rect)(&b.fb, (int)x, (int)y, (int)w, (int)h, PAINT);
        bed_expect(&b, want);
    }
    bed_close(&b);
}

/* The line as school teaches it, one step after the other, all the way. */
static void walk(const struct fb *fb, int x0, int y0, int x1, int y1, bool want[H][W])
{
    int sx = x1 < x0 ? -1 : 1, sy = y1 < y0 ? -1 : 1, dx = abs(x1 - x0), dy = abs(y1 - y0);
    int n = dx > dy ? dx : dy, m = dx > dy ? dy : dx, err = n / 2;

    for (int i = 0; i <= n; i++) {
        if (in_clip(fb, x0, y0))
            want[y0][x0] = true;
        bool aside = (err += m) >= n;
        err -= aside ? n : 0;
        x0 += dx >= dy || aside ? sx : 0;
        y0 += dx < dy || aside ? sy : 0;
    }
}

/* The same from the header's formula, for every column or row of the picture that the line crosses: any ends. */
static void formula(const struct fb *fb, int64_t x0, int64_t y0, int64_t x1, int64_t y1, bool want[H][W])
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
        if (in_clip(fb, x, y))
            want[y][x] = true;
    }
}

TEST(lines_near)
{
    struct rng r;
    struct bed b;
    static const int reach[] = { 5, 100, 3000 };

    rng_seed(&r, 4);
    bed_open(&b, &r);
    for (int k = 0; k < 6000; k++) {
        int v[4], span = reach[k % 3];
        bool want[H][W] = { { false } };
        for (int i = 0; i < 4; i++)
            v[i] = (int)rng_below(&r, (uint64_t)(2 * span)) - span + 20;
        random_clip(&b.fb, &r);
        bed_reset(&b);
        walk(&b.fb, v[0], v[1], v[2], v[3], want);
        fb_line(&b.fb, v[0], v[1], v[2], v[3], PAINT);
        bed_expect(&b, want);
    }
    bed_close(&b);
}

/* A line that took its time per step of the whole length would not end here. */
TEST(lines_far)
{
    struct rng r;
    struct bed b;
    int seen = 0;

    rng_seed(&r, 5);
    bed_open(&b, &r);
    for (int k = 0; k < 20000; k++) {
        int v[4];
        bool want[H][W] = { { false } };
        for (int i = 0; i < 4; i++)
            v[i] = any_int(&r);
        if (k % 4 == 0) { /* through the picture, from far away on both sides */
            int far = (int)rng_below(&r, INT32_MAX - W), off = (int)rng_below(&r, 2000);
            v[0] = W / 2 - far, v[1] = -far + off, v[2] = W / 2 + far, v[3] = far - off;
        }
        random_clip(&b.fb, &r);
        bed_reset(&b);
        formula(&b.fb, v[0], v[1], v[2], v[3], want);
        fb_line(&b.fb, v[0], v[1], v[2], v[3], PAINT);
        for (int i = 0; i < W * H; i++)
            seen += want[i / W][i % W];
        bed_expect(&b, want);
    }
    assert_true(seen > 20000); /* many of them do cross the picture */
    bed_close(&b);
}

TEST(lines_known)
{
    struct rng r;
    struct bed b;
    static const int known[][4] = {
        { INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX }, /* the diagonal of the world: x = y */
        { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN },
    };

    rng_seed(&r, 6);
    bed_open(&b, &r);
    for (int k = 0; k < 2; k++) {
        bool want[H][W] = { { false } };
        bed_reset(&b);
        for (int i = 0; i < H; i++)
            want[i][i] = true;
        fb_line(&b.fb, known[k][0], known[k][1], known[k][2], known[k][3], PAINT);
        bed_expect(&b, want);
    }
    bool half[H][W] = { { false } }; /* a tie goes away from the start */
    bed_reset(&b);
    half[3][2] = half[4][3] = half[4][4] = true;
    fb_line(&b.fb, 2, 3, 4, 4, PAINT);
    bed_expect(&b, half);
    bool none[H][W] = { { false } };
    bed_reset(&b);
    fb_set_clip(&b.fb, 3, 3, 0, 5);
    fb_line(&b.fb, 0, 0, 40, 40, PAINT);
    fb_fill_rect(&b.fb, 0, 0, 40, 40, PAINT);
    fb_outline(&b.fb, 0, 0, 40, 40, PAINT);
    bed_expect(&b, none);
    bed_close(&b);
}

RUN_TESTS(NULL, NULL)
