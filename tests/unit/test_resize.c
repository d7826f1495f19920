/*
 * test_resize.c - pictures at other sizes, against a count of points.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/resize.h"
#include "../../src/base/rng.h"

enum { MOST = 24, FINE = 4 };

static struct rng rng;

static int below(int n)
{
    return (int)rng_below(&rng, (uint64_t)n);
}

/* Blots of few colours, with holes. */
static void draw(uint8_t *pix, int w, int h)
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            pix[y * w + x] = (uint8_t)(below(3) && x ? pix[y * w + x - 1] : below(3) ? 16 + below(4) : 0);
}

static uint8_t scratch[2 * FINE * FINE * MOST * MOST];

/* Cuts each pixel into points so small that none is part of two pixels of the smooth image. */
static uint8_t expected(const struct turn *t, int x, int y, int w, int h)
{
    int sw = FINE * t->w, sh = FINE * t->h, best = 0;
    long count[256] = { 0 }, opaque = 0;

    for (int v = y * sh; v < (y + 1) * sh; v++)
        for (int u = x * sw; u < (x + 1) * sw; u++)
            count[t->smooth[v / h * sw + u / w]]++;
    for (int c = 255; c > 0; c--) {
        opaque += count[c];
        best = count[c] && count[c] >= count[best ? best : c] ? c : best;
    }
    return (uint8_t)(2 * opaque >= (long)sw * sh ? best : 0);
}

TEST(random)
{
    uint8_t in[MOST * MOST], out[64 * 64];
    struct turn t;

    rng_seed(&rng, 8);
    for (int i = 0; i < 300; i++) {
        int w = 1 + below(12), h = 1 + below(12), to_w = 1 + below(30), to_h = 1 + below(30);
        draw(in, w, h);
        turn_init(&t, in, w, h, w, w, h, scratch);
        memset(out, 0xee, sizeof out);
        resize_paint(&t, out, to_w, to_h);
        for (int y = 0; y < to_h; y++)
            for (int x = 0; x < to_w; x++)
                if (out[y * to_w + x] != expected(&t, x, y, to_w, to_h))
                    fail_msg("%dx%d to %dx%d: pixel %d,%d is %d, expected %d", w, h, to_w, to_h, x, y,
                             out[y * to_w + x], expected(&t, x, y, to_w, to_h));
        assert_int_equal(out[to_w * to_h], 0xee);
    }
}

RUN_TESTS(NULL, NULL)
