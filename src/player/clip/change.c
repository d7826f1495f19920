/*
 * change.c - compares pictures (change.h).
 */
#include "change.h"

#include <stdbool.h>
#include <stddef.h>

static bool row_matches(const uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w)
{
    for (int x = 0; x < w; x++)
        if (shown[x] != rgb[pix[x]])
            return false;
    return true;
}

struct change change_find(const uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, int h)
{
    int top = 0, end = h, left = w, right = 0;

    while (top < h && row_matches(shown + (ptrdiff_t)top * w, pix + (ptrdiff_t)top * w, rgb, w))
        top++;
    if (top == h)
        return (struct change){ 0 };
    while (row_matches(shown + (ptrdiff_t)(end - 1) * w, pix + (ptrdiff_t)(end - 1) * w, rgb, w))
        end--;
    for (int y = top; y < end; y++) {
        const uint32_t *was = shown + (ptrdiff_t)y * w;
        const uint8_t *is = pix + (ptrdiff_t)y * w;
        int x = 0, last = w;
        while (x < left && was[x] == rgb[is[x]])
            x++;
        left = x;
        while (last > right && was[last - 1] == rgb[is[last - 1]])
            last--;
        right = last;
    }
    return (struct change){ left, top, right - left, end - top };
}

void change_copy(uint32_t *shown, const uint8_t *pix, const uint32_t rgb[256], int w, const struct change *c)
{
    for (int y = c->y; y < c->y + c->h; y++)
        for (int x = c->x; x < c->x + c->w; x++)
            shown[(ptrdiff_t)y * w + x] = rgb[pix[(ptrdiff_t)y * w + x]];
}
