/*
 * thumb.c - makes thumbnails (thumb.h).
 */
#include "thumb.h"

#include <string.h>

enum { RED = 6, GREEN = 8, BLUE = 5 };

uint32_t thumb_colour(int i)
{
    const uint32_t r = (uint32_t)(i / (GREEN * BLUE)), g = (uint32_t)(i / BLUE % GREEN), b = (uint32_t)(i % BLUE);

    return r * 255 / (RED - 1) << 16 | g * 255 / (GREEN - 1) << 8 | b * 255 / (BLUE - 1);
}

/* Converts the mean of n values of 0 to 255, given as their sum, to one of `levels` levels. Between two levels, the
 * place in a 4 x 4 dither pattern (0 to 15) decides. */
static int level(uint32_t sum, uint32_t n, int levels, int place)
{
    return (int)((sum * (uint32_t)(levels - 1) * 16 + n * 255u * (uint32_t)place + n * 127) / (n * 255u * 16));
}

static uint8_t mean(const struct fb *fb, const uint32_t rgb[256], int x0, int x1, int y0, int y1, int place)
{
    uint32_t r = 0, g = 0, b = 0, n = (uint32_t)((x1 - x0) * (y1 - y0));

    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) {
            const uint32_t c = rgb[fb->pix[y * fb->pitch + x]];
            r += c >> 16 & 255;
            g += c >> 8 & 255;
            b += c & 255;
        }
    return (uint8_t)((level(r, n, RED, place) * GREEN + level(g, n, GREEN, place)) * BLUE + level(b, n, BLUE, place));
}

void thumb_make(struct thumb *t, const struct fb *fb, const uint32_t rgb[256])
{
    static const uint8_t places[4][4] = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 }, { 15, 7, 13, 5 } };
    const int most = fb->w > fb->h ? fb->w : fb->h, side = most < THUMB_SIDE ? most : THUMB_SIDE;

    memset(t, 0, sizeof *t);
    t->w = (fb->w * side + most / 2) / most;
    t->h = (fb->h * side + most / 2) / most;
    t->w += t->w == 0;
    t->h += t->h == 0;
    for (int y = 0; y < t->h; y++)
        for (int x = 0; x < t->w; x++)
            t->pix[y * t->w + x] = mean(fb, rgb, x * fb->w / t->w, (x + 1) * fb->w / t->w, y * fb->h / t->h,
                                        (y + 1) * fb->h / t->h, places[y & 3][x & 3]);
}
