/*
 * test_strip.c - the strip drawer: every pixel that is well within half the width of the line is drawn and none that
 * is well outside, with the picture's row by its distance; no pixel is blended twice at a bend; nothing is drawn
 * outside of the clip. The oracle measures with doubles.
 */
#include "../test.h"
#include <math.h>
#include "../../fb/strip.h"
#include "../../src/base/rng.h"

enum { W = 160, H = 120, ROWS = 16 };

static struct fb fb;
static void *mem;
static uint8_t tall[ROWS * 8];
static uint8_t count[65536]; /* a blend that counts */

static int setup(void **state)
{
    (void)state;
    mem = malloc(fb_size(W, H));
    fb_init(&fb, mem, W, H);
    for (int y = 0; y < ROWS; y++)
        tall[y * 8] = (uint8_t)(y + 1);
    for (int under = 0; under < 256; under++)
        for (int over = 0; over < 256; over++)
            count[under << 8 | over] = (uint8_t)(under + 1);
    return mem == NULL;
}

static int teardown(void **state)
{
    (void)state;
    free(mem);
    return 0;
}

/* How far (x, y) is from the line; *side: of the piece it is nearest to, below 0 on the left of the way. */
static double far_from(const struct strip_corner *c, int n, double x, double y, double *side)
{
    double best = 1e9;

    for (int k = 0; k + 1 < n; k++) {
        const double ax = c[k].x / 65536.0, dx = c[k + 1].x / 65536.0 - ax;
        const double ay = c[k].y / 65536.0, dy = c[k + 1].y / 65536.0 - ay;
        double t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        const double far = hypot(x - ax - t * dx, y - ay - t * dy);
        if (far < best) {
            best = far;
            *side = (y - ay) * dx - (x - ax) * dy;
        }
    }
    return best;
}

/* A line of n corners that bends by at most 40 degrees; of two anywhere. */
static int random_line(struct rng *rng, struct strip_corner *c, int n)
{
    double x = (double)rng_below(rng, W), y = (double)rng_below(rng, H), dir = (double)rng_below(rng, 360) / 57.3;

    for (int k = 0; k < n; k++) {
        c[k] = (struct strip_corner){ (int32_t)(x * 65536), (int32_t)(y * 65536) };
        double far = n == 2 ? 5 + (double)rng_below(rng, 150) : 12 + (double)rng_below(rng, 20);
        dir += n == 2 ? 0 : ((double)rng_below(rng, 81) - 40) / 57.3;
        x += far * cos(dir);
        y += far * sin(dir);
    }
    return n;
}

TEST(coverage)
{
    struct rng rng;
    long inside = 0, edges = 0;

    rng_seed(&rng, 9);
    for (int round = 0; round < 400; round++) {
        const struct image img = { tall, 1, ROWS, 8 };
        struct strip_corner c[6];
        const int n = random_line(&rng, c, round % 2 ? 2 : 5);
        const double width = 4 + (double)rng_below(&rng, 160) / 16, half = width / 2;
        const struct strip s = { .image = &img, .bank = 2, .width = (int32_t)(width * 65536) };
        fb_set_clip(&fb, 8, 8, W - 20, H - 16);
        fb_fill(&fb, 0);
        strip_draw(&fb, &s, c, n);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                double side = 0, far = far_from(c, n, x + 0.5, y + 0.5, &side);
                const uint8_t got = fb.pix[y * fb.pitch + x];
                const bool in_clip = x >= 8 && x < W - 12 && y >= 8 && y < H - 8;
                if (!in_clip || far > half * (n == 2 ? 1 : 1.0642) + 0.02) { /* 1 / cos 20 */
                    if (got)
                        fail_msg("round %d: (%d, %d), %.3f away of %.3f: drawn", round, x, y, far, half);
                    continue;
                }
                if (far > half - 0.02) { /* or such a corner */
                    edges++;
                    continue;
                }
                inside++;
                double row = ((side < 0 ? -far : far) + half) / width * ROWS;
                if (!got || fabs(got - 32 - 0.5 - row) > (n == 2 ? 0.6 : 1.6))
                    fail_msg("round %d: (%d, %d), %.3f away of %.3f: got %d, expected about %.2f", round, x, y, far,
                             half, got, row + 32.5);
            }
    }
    if (inside < 60000 || edges > inside / 20)
        fail_msg("%ld pixels inside, %ld at edges", inside, edges);
}

/* Every pixel once, also where it bends. */
TEST(once)
{
    struct rng rng;
    long drawn = 0;

    rng_seed(&rng, 10);
    fb_reset_clip(&fb);
    for (int round = 0; round < 300; round++) {
        const struct image img = { tall, 1, ROWS, 8 };
        struct strip_corner c[6];
        const int n = random_line(&rng, c, 5);
        const struct strip s = { .image = &img, .blend_table = count, .width = 7 << 16 };
        fb_fill(&fb, 0);
        bool crosses = false; /* a line that comes back to itself is another matter */
        for (int k = 2; k < n; k++) {
            double side;
            crosses = crosses || far_from(c, k, c[k].x / 65536.0, c[k].y / 65536.0, &side) < 9;
        }
        if (crosses)
            continue;
        strip_draw(&fb, &s, c, n);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                if (fb.pix[y * fb.pitch + x] > 1)
                    fail_msg("round %d: (%d, %d) was drawn %d times", round, x, y, fb.pix[y * fb.pitch + x]);
                drawn += fb.pix[y * fb.pitch + x];
            }
    }
    assert_true(drawn > 40000);
}

/* The picture repeats along the line, whichever way that goes. */
TEST(along)
{
    uint8_t wide[8 * 4];
    const struct image img = { wide, 5, 4, 8 };
    const struct strip s = { .image = &img, .width = 4 << 16, .offset_along = 3 };
    const struct strip_corner right[] = { { 10 << 16, 50 << 16 }, { 60 << 16, 50 << 16 } },
                              up[] = { { 80 << 16, 100 << 16 }, { 80 << 16, 20 << 16 } };

    for (int i = 0; i < 32; i++)
        wide[i] = (uint8_t)(i % 8 < 5 ? 1 + i % 8 + 16 * (i / 8) : 0);
    fb_reset_clip(&fb);
    fb_fill(&fb, 0);
    strip_draw(&fb, &s, right, 2);
    strip_draw(&fb, &s, up, 2);
    for (int k = 0; k < 50; k++)
        for (int row = 0; row < 4; row++)
            assert_int_equal(fb.pix[(48 + row) * fb.pitch + 10 + k], 1 + (k + 3) % 5 + 16 * row);
    for (int k = 0; k < 80; k++)
        for (int row = 0; row < 4; row++) /* the left of the way up is the left of the screen */
            assert_int_equal(fb.pix[(99 - k) * fb.pitch + 78 + row], 1 + (k + 3) % 5 + 16 * row);
}

/* Corners anywhere, widths to the most: nothing is written outside of the clip. */
TEST(extremes)
{
    static const int32_t ends[] = { 0, 1, -1, 65535, 1966080000, -1966080000, 100 << 16, -(9 << 16) };
    struct rng rng;

    rng_seed(&rng, 11);
    fb_set_clip(&fb, 30, 30, 40, 40);
    fb_fill(&fb, 0);
    for (int round = 0; round < 3000; round++) {
        const struct image img = { tall, 1, ROWS, 8 };
        struct strip_corner c[4];
        for (int k = 0; k < 4; k++)
            c[k] =
                (struct strip_corner){ ends[rng_below(&rng, 8)], rng_below(&rng, 2) ? ends[rng_below(&rng, 8)]
                                                                                    : (int32_t)(rng_next(&rng) >> 36) };
        const struct strip s = { .image = &img,
                                 .width = (int32_t)rng_below(&rng, 4096 * 65536ll),
                                 .dashed = round % 3 == 0 };
        strip_draw(&fb, &s, c, 1 + (int)rng_below(&rng, 4));
    }
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            if (x < 30 || x >= 70 || y < 30 || y >= 70)
                assert_int_equal(fb.pix[y * fb.pitch + x], 0);
}

RUN_TESTS(setup, teardown)
