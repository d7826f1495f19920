/*
 * quarter.c - quarter turns (quarter.h). A picture is rotated one source row at a time; a step to the right in the
 * source is a constant step in the result.
 */
#include "quarter.h"

#include <stddef.h>
#include <string.h>

enum quarter quarter_back(enum quarter turn)
{
    return turn == QUARTER_LEFT ? QUARTER_RIGHT : turn == QUARTER_RIGHT ? QUARTER_LEFT : turn;
}

void quarter_size(enum quarter turn, int *w, int *h)
{
    const int was = *w;

    if (turn != QUARTER_LEFT && turn != QUARTER_RIGHT)
        return;
    *w = *h;
    *h = was;
}

void quarter_point(enum quarter turn, int w, int h, int *x, int *y)
{
    const int px = *x, py = *y;

    *x = turn == QUARTER_LEFT ? py : turn == QUARTER_RIGHT ? h - 1 - py : turn == QUARTER_OVER ? w - 1 - px : px;
    *y = turn == QUARTER_LEFT ? w - 1 - px : turn == QUARTER_RIGHT ? px : turn == QUARTER_OVER ? h - 1 - py : py;
}

struct area quarter_area(enum quarter turn, int w, int h, struct area a)
{
    int x0 = a.x, y0 = a.y, x1 = a.x + a.w - 1, y1 = a.y + a.h - 1;

    quarter_point(turn, w, h, &x0, &y0);
    quarter_point(turn, w, h, &x1, &y1);
    quarter_size(turn, &a.w, &a.h);
    return (struct area){ x0 < x1 ? x0 : x1, y0 < y1 ? y0 : y1, a.w, a.h };
}

void quarter_picture(enum quarter turn, const uint8_t *pix, int pitch, int w, int h, uint8_t *out, int out_pitch)
{
    int x0 = 0, y0 = 0, x1 = 1, y1 = 0;

    quarter_point(turn, w, h, &x0, &y0);
    quarter_point(turn, w, h, &x1, &y1);
    const ptrdiff_t step = (ptrdiff_t)(y1 - y0) * out_pitch + x1 - x0;
    for (int y = 0; y < h; y++, pix += pitch) {
        int tx = 0, ty = y;
        quarter_point(turn, w, h, &tx, &ty);
        uint8_t *to = out + (ptrdiff_t)ty * out_pitch + tx;
        if (step == 1) {
            memcpy(to, pix, (size_t)w);
            continue;
        }
        for (int x = 0; x < w; x++)
            to[x * step] = pix[x];
    }
}
