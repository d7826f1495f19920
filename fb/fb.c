/*
 * fb.c - see fb.h. Coordinates may be any int and are widened to 64 bits before they are added, so nothing overflows;
 * values are small after clipping.
 */
#include "fb.h"
#include "../src/base/int.h"
#include <assert.h>
#include <stdbool.h>
#include <string.h>

static int pitch_of(int w)
{
    return (w + 2 * FB_GUARD + 7) / 8 * 8;
}

size_t fb_size(int w, int h)
{
    assert(w >= 1 && w <= FB_MAX_SIDE && h >= 1 && h <= FB_MAX_SIDE);
    return (size_t)pitch_of(w) * (size_t)(h + 2 * FB_GUARD) + 2 * FB_SLACK;
}

void fb_init(struct fb *fb, void *mem, int w, int h)
{
    memset(mem, 0, fb_size(w, h));
    fb->pitch = pitch_of(w);
    fb->w = w;
    fb->h = h;
    fb->pix = (uint8_t *)mem + FB_SLACK + FB_GUARD * fb->pitch + FB_GUARD;
    fb_reset_clip(fb);
}

void fb_set_clip(struct fb *fb, int x, int y, int w, int h)
{
    fb->x0 = (int)int64_clamp(x, 0, fb->w);
    fb->y0 = (int)int64_clamp(y, 0, fb->h);
    fb->x1 = (int)int64_clamp((int64_t)x + w, 0, fb->w);
    fb->y1 = (int)int64_clamp((int64_t)y + h, 0, fb->h);
    if (fb->x0 >= fb->x1 || fb->y0 >= fb->y1) {
        fb->x0 = fb->y0 = fb->x1 = fb->y1 = 0;
        fb->sx0 = fb->sy0 = fb->sx1 = fb->sy1 = 0;
        return;
    }
    fb->sx0 = fb->x0 == 0 ? -FB_GUARD : fb->x0;
    fb->sy0 = fb->y0 == 0 ? -FB_GUARD : fb->y0;
    fb->sx1 = fb->x1 == fb->w ? fb->w + FB_GUARD : fb->x1;
    fb->sy1 = fb->y1 == fb->h ? fb->h + FB_GUARD : fb->y1;
}

void fb_reset_clip(struct fb *fb)
{
    fb_set_clip(fb, 0, 0, fb->w, fb->h);
}

/* A single memset that includes the band takes less time than one memset per row. */
void fb_fill(struct fb *fb, uint8_t c)
{
    memset(fb->pix, c, (size_t)(fb->h - 1) * (size_t)fb->pitch + (size_t)fb->w);
}

/* Fills the pixels with x in [x0, x1) and y in [y0, y1). */
static void fill_rect(struct fb *fb, int64_t x0, int64_t y0, int64_t x1, int64_t y1, uint8_t c)
{
    x0 = x0 < fb->x0 ? fb->x0 : x0;
    y0 = y0 < fb->y0 ? fb->y0 : y0;
    x1 = x1 > fb->x1 ? fb->x1 : x1;
    y1 = y1 > fb->y1 ? fb->y1 : y1;
    if (x0 >= x1)
        return;
    for (int64_t y = y0; y < y1; y++)
        memset(fb->pix + y * fb->pitch + x0, c, (size_t)(x1 - x0));
}

void fb_fill_rect(struct fb *fb, int x, int y, int w, int h, uint8_t c)
{
    fill_rect(fb, x, y, (int64_t)x + w, (int64_t)y + h, c);
}

void fb_outline(struct fb *fb, int x, int y, int w, int h, uint8_t c)
{
    int64_t x1 = (int64_t)x + w, y1 = (int64_t)y + h;

    if (w < 1 || h < 1)
        return;
    fill_rect(fb, x, y, x1, (int64_t)y + 1, c);
    fill_rect(fb, x, y1 - 1, x1, y1, c);
    fill_rect(fb, x, y, (int64_t)x + 1, y1, c);
    fill_rect(fb, x1 - 1, y, x1, y1, c);
}

/* Draws a rectangle with rounded corners: its first and last three rows are inset by inset[0..2] px, outermost
 * first. */
static void draw_rounded_rect(struct fb *fb, int x, int y, int w, int h, const int inset[3], uint8_t colour)
{
    for (int k = 0; k < 3; k++) {
        fb_fill_rect(fb, x + inset[k], y + k, w - 2 * inset[k], 1, colour);
        fb_fill_rect(fb, x + inset[k], y + h - 1 - k, w - 2 * inset[k], 1, colour);
    }
    fb_fill_rect(fb, x, y + 3, w, h - 6, colour);
}

void fb_plate(struct fb *fb, int x, int y, int w, int h, uint8_t inside, uint8_t rim)
{
    static const int edge[3] = { 3, 1, 1 }, middle[3] = { 2, 1, 0 }, inner[3] = { 1, 0, 0 };

    draw_rounded_rect(fb, x, y, w, h, edge, inside);
    draw_rounded_rect(fb, x + 1, y + 1, w - 2, h - 2, middle, rim);
    draw_rounded_rect(fb, x + 2, y + 2, w - 4, h - 4, inner, inside);
}

/* Goes from the bottom right to the top left: every pixel is read before it is written, because it is at or before the
 * one that it becomes. */
void fb_magnify(struct fb *fb, int x, int y, int w, int h, int dx, int dy, int zoom)
{
    uint8_t *const corner = fb->pix + (ptrdiff_t)y * fb->pitch + x;

    for (int j = h - 1; j >= 0; j--) {
        const uint8_t *from = corner + (ptrdiff_t)((j + dy) / zoom) * fb->pitch;
        uint8_t *to = corner + (ptrdiff_t)j * fb->pitch;
        for (int i = w - 1; i >= 0; i--)
            to[i] = from[(i + dx) / zoom];
    }
}

/* One axis of a line: its start, its direction, its length, and the steps that are inside the clip. */
struct axis {
    int64_t start, sign, length; /* 0 <= length < 2^32 */
    int64_t lo, hi;              /* the steps inside the clip: lo <= step <= hi */
};

static struct axis axis_of(int64_t from, int64_t to, int64_t clip0, int64_t clip1)
{
    if (to >= from)
        return (struct axis){ from, 1, to - from, clip0 - from, clip1 - 1 - from };
    return (struct axis){ from, -1, from - to, from - (clip1 - 1), from - clip0 };
}

/* Narrows the long axis' steps [lo, hi] to those inside the clip on both axes. Returns false if none is left. Products
 * stay below 2^64, since a step count that is multiplied is never above its axis' length. */
static bool clip_steps(struct axis *major, const struct axis *minor)
{
    uint64_t n = (uint64_t)major->length, m = (uint64_t)minor->length, half = n / 2;

    major->lo = major->lo < 0 ? 0 : major->lo;
    major->hi = major->hi > major->length ? major->length : major->hi;
    if (minor->lo > minor->length || minor->hi < 0)
        return false;
    if (minor->lo > 0) {
        int64_t first = (int64_t)(((uint64_t)minor->lo * n - half + m - 1) / m);
        major->lo = first > major->lo ? first : major->lo;
    }
    if (minor->hi < minor->length) {
        int64_t last = (int64_t)((((uint64_t)minor->hi + 1) * n - half - 1) / m);
        major->hi = last < major->hi ? last : major->hi;
    }
    return major->lo <= major->hi;
}

void fb_line(struct fb *fb, int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t c)
{
    struct axis x = axis_of(x0, x1, fb->x0, fb->x1), y = axis_of(y0, y1, fb->y0, fb->y1);
    bool steep = y.length > x.length;
    struct axis *major = steep ? &y : &x, *minor = steep ? &x : &y;

    if (!clip_steps(major, minor))
        return;
    uint64_t n = (uint64_t)major->length, m = (uint64_t)minor->length;
    uint64_t fraction = (uint64_t)major->lo * m + n / 2, minor_steps = n ? fraction / n : 0;
    int64_t a = major->start + major->sign * major->lo, b = minor->start + minor->sign * (int64_t)minor_steps;
    int64_t step = major->sign * (steep ? fb->pitch : 1), minor_step = minor->sign * (steep ? 1 : fb->pitch);
    uint8_t *p = fb->pix + (steep ? a : b) * fb->pitch + (steep ? b : a);

    fraction = n ? fraction % n : 0;
    *p = c;
    for (int64_t i = major->lo; i < major->hi; i++) {
        p += step;
        fraction += m;
        if (fraction >= n) {
            fraction -= n;
            p += minor_step;
        }
        *p = c;
    }
}
