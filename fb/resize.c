/*
 * resize.c - see resize.h.
 *
 * Each pixel of the result covers an area of the smooth image (turn.h) and, as in turned copies, the majority of that
 * area decides: first whether the pixel is opaque (half suffices), then its colour (the lowest if areas are equal).
 * Areas are whole numbers: along each axis, a pixel of the smooth image is as many units long as the result has pixels,
 * and a pixel of the result is as many units long as the smooth image has pixels.
 */
#include "resize.h"
#include <assert.h>
#include "fb.h"

enum { SMOOTH_SCALE = 4 /* pixels of the smooth image per pixel of the image, along each axis */ };

/* Returns the length that the k-th of n equal parts and the i-th of m equal parts of a length n * m have in common. */
static uint64_t overlap(int k, int n, int i, int m)
{
    int64_t from = (int64_t)k * m, to = from + m, a = (int64_t)i * n, z = a + n;

    from = from > a ? from : a;
    to = to < z ? to : z;
    return to > from ? (uint64_t)(to - from) : 0;
}

/* Returns pixel (x, y) of the result, which is w x h. */
static uint8_t vote(const struct turn *t, int x, int y, int w, int h)
{
    const int sw = SMOOTH_SCALE * t->w, sh = SMOOTH_SCALE * t->h;
    const int x0 = (int)((int64_t)x * sw / w), y0 = (int)((int64_t)y * sh / h);
    uint64_t area[256] = { 0 }, opaque = 0;
    int best = 0;

    for (int v = y0; v < sh && overlap(v, sh, y, h); v++)
        for (int u = x0; u < sw && overlap(u, sw, x, w); u++)
            area[t->smooth[(ptrdiff_t)v * sw + u]] += overlap(u, sw, x, w) * overlap(v, sh, y, h);
    for (int c = 1; c < 256; c++) {
        opaque += area[c];
        if (area[c] > 0 && (best == 0 || area[c] > area[best]))
            best = c;
    }
    return (uint8_t)(opaque >= area[0] ? best : 0);
}

void resize_paint(const struct turn *t, uint8_t *out, int w, int h)
{
    assert(w >= 1 && h >= 1 && w <= FB_MAX_SIDE && h <= FB_MAX_SIDE);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            out[(ptrdiff_t)y * w + x] = vote(t, x, y, w, h);
}
