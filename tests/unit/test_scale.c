/*
 * test_scale.c - pictures scaled for drawing, against slower ways to make the same picture.
 */
#include "../test.h"
#include "../../fb/scale.h"
#include "../../src/base/rng.h"

enum { MOST = 24, LARGEST = 4 * MOST };

static struct rng rng;
static uint8_t pix[MOST * MOST], twice[4 * MOST * MOST], four[16 * MOST * MOST], out[LARGEST * LARGEST],
    scratch[(2 * MOST + 2) * (2 * MOST + 2)];

static int below(int n)
{
    return (int)rng_below(&rng, (uint64_t)n);
}

/* Blots of few colours, with holes. */
static void draw(int w, int h)
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            pix[y * w + x] = (uint8_t)(below(3) && x ? pix[y * w + x - 1] : below(3) ? 16 + below(4) : 0);
}

/* Scale2x as its author defines it: of the pixels A (above), B (right), C (left), D (below) around P. */
static void double_plainly(uint8_t *to, const uint8_t *from, int w, int h)
{
#define AT(x, y) ((x) < 0 || (y) < 0 || (x) >= w || (y) >= h ? 0 : from[(y)*w + (x)])
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            const int a = AT(x, y - 1), b = AT(x + 1, y), c = AT(x - 1, y), d = AT(x, y + 1), p = AT(x, y);
            uint8_t *q = to + 4 * w * y + 2 * x;
            q[0] = (uint8_t)(c == a && c != d && a != b ? a : p);
            q[1] = (uint8_t)(a == b && a != c && b != d ? b : p);
            q[2 * w] = (uint8_t)(d == c && d != b && c != a ? c : p);
            q[2 * w + 1] = (uint8_t)(b == d && b != a && d != c ? d : p);
        }
}

/* The colour at the middle of pixel (x, y) of an enlarged picture: of the picture four times as large or, if the middle
 * is on the line between two of its pixels that are halves of one pixel, of the picture twice as large. */
static uint8_t enlarged(int iw, int ih, int x, int y, int w, int h)
{
    const int u = (2 * x + 1) * 2 * iw, v = (2 * y + 1) * 2 * ih; /* in 1 / 2w, 1 / 2h of a doubled pixel */
    const int halves = u % (2 * w) == w || v % (2 * h) == h;

    if (u % (4 * w) == 2 * w || v % (4 * h) == 2 * h) /* the middle of a pixel */
        return pix[v / (4 * h) * iw + u / (4 * w)];
    return halves ? twice[v / (2 * h) * 2 * iw + u / (2 * w)] : four[v / h * 4 * iw + u / w];
}

/* The majority in pixel (x, y) of a reduced picture, by cutting it into points that are each part of one pixel. */
static uint8_t reduced(int iw, int ih, int x, int y, int w, int h)
{
    long count[256] = { 0 }, opaque = 0, most = 0;
    uint8_t order[MOST * MOST], best = 0;
    int n = 0;

    for (int v = y * ih; v < (y + 1) * ih; v++)
        for (int u = x * iw; u < (x + 1) * iw; u++)
            count[pix[v / h * iw + u / w]]++;
    for (int v = y * ih / h; v * h < (y + 1) * ih; v++) /* in reading order */
        for (int u = x * iw / w; u * w < (x + 1) * iw; u++)
            order[n++] = pix[v * iw + u];
    for (int i = 0; i < n; i++) {
        const long c = count[order[i]];
        best = order[i] && c > most ? order[i] : best;
        most = order[i] && c > most ? c : most;
    }
    for (int c = 1; c < 256; c++)
        opaque += count[c];
    return opaque >= count[0] ? best : 0;
}

static void compare(int iw, int ih, int w, int h)
{
    const int pitch = (w + 7) & ~7;
    const struct image in = { pix, iw, ih, iw };

    memset(out, 0xee, sizeof out);
    scale_paint(&in, out, w, h, pitch, scratch);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < pitch; x++) {
            const int want = x >= w               ? 0
                             : w >= iw && h >= ih ? enlarged(iw, ih, x, y, w, h)
                                                  : reduced(iw, ih, x, y, w, h);
            if (out[y * pitch + x] != want)
                fail_msg("%dx%d to %dx%d: pixel %d,%d is %d, expected %d", iw, ih, w, h, x, y, out[y * pitch + x],
                         want);
        }
}

TEST(random_pictures)
{
    rng_seed(&rng, 8);
    for (int i = 0; i < 400; i++) {
        const int w = 1 + below(MOST), h = 1 + below(MOST);
        draw(w, h);
        double_plainly(twice, pix, w, h);
        double_plainly(four, twice, 2 * w, 2 * h);
        compare(w, h, (w + 4) / 5 + below(4 * w - (w + 4) / 5 + 1), (h + 4) / 5 + below(4 * h - (h + 4) / 5 + 1));
        compare(w, h, w, h);
        compare(w, h, 2 * w, 2 * h);
        compare(w, h, 3 * w, 3 * h);
        compare(w, h, 4 * w, 4 * h);
    }
}

TEST(doubled)
{
    uint8_t got[(2 * MOST + 3) * 2 * MOST];

    rng_seed(&rng, 9);
    for (int i = 0; i < 100; i++) {
        const int w = 1 + below(MOST), h = 1 + below(MOST), pitch = 2 * w + below(4);
        draw(w, h);
        double_plainly(twice, pix, w, h);
        scale_double(got, pitch, pix, w, h, w);
        for (int y = 0; y < 2 * h; y++)
            assert_memory_equal(got + y * pitch, twice + y * 2 * w, (size_t)(2 * w));
    }
}

RUN_TESTS(NULL, NULL)
