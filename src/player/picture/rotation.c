/*
 * rotation.c - rotates pictures (rotation.h), one source row at a time; a step to the right in the source is a constant
 * step in the result.
 */
#include "rotation.h"

#include <stddef.h>
#include <string.h>

enum rotation rotation_inverse(enum rotation rotation)
{
    return rotation == ROTATION_LEFT ? ROTATION_RIGHT : rotation == ROTATION_RIGHT ? ROTATION_LEFT : rotation;
}

void rotation_size(enum rotation rotation, int *w, int *h)
{
    const int was = *w;

    if (rotation != ROTATION_LEFT && rotation != ROTATION_RIGHT)
        return;
    *w = *h;
    *h = was;
}

void rotation_point(enum rotation rotation, int w, int h, int *x, int *y)
{
    const int px = *x, py = *y;

    *x = rotation == ROTATION_LEFT    ? py
         : rotation == ROTATION_RIGHT ? h - 1 - py
         : rotation == ROTATION_180   ? w - 1 - px
                                      : px;
    *y = rotation == ROTATION_LEFT    ? w - 1 - px
         : rotation == ROTATION_RIGHT ? px
         : rotation == ROTATION_180   ? h - 1 - py
                                      : py;
}

struct area rotation_area(enum rotation rotation, int w, int h, struct area a)
{
    int x0 = a.x, y0 = a.y, x1 = a.x + a.w - 1, y1 = a.y + a.h - 1;

    rotation_point(rotation, w, h, &x0, &y0);
    rotation_point(rotation, w, h, &x1, &y1);
    rotation_size(rotation, &a.w, &a.h);
    return (struct area){ x0 < x1 ? x0 : x1, y0 < y1 ? y0 : y1, a.w, a.h };
}

void rotation_picture(enum rotation rotation, const uint8_t *pix, int pitch, int w, int h, uint8_t *out, int out_pitch)
{
    int x0 = 0, y0 = 0, x1 = 1, y1 = 0;

    rotation_point(rotation, w, h, &x0, &y0);
    rotation_point(rotation, w, h, &x1, &y1);
    const ptrdiff_t step = (ptrdiff_t)(y1 - y0) * out_pitch + x1 - x0;
    for (int y = 0; y < h; y++, pix += pitch) {
        int tx = 0, ty = y;
        rotation_point(rotation, w, h, &tx, &ty);
        uint8_t *to = out + (ptrdiff_t)ty * out_pitch + tx;
        if (step == 1) {
            memcpy(to, pix, (size_t)w);
            continue;
        }
        for (int x = 0; x < w; x++)
            to[x * step] = pix[x];
    }
}
