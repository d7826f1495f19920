/*
 * border.c - paints the border (border.h). A window pixel is the mean of SAMPLES x SAMPLES points in it. The art's
 * column and row for each point are computed once.
 */
#include "border.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../base/int.h"

enum { SAMPLES = 4 };

bool border_open(struct border *b, const uint8_t *rgba, int w, int h, char *err, size_t err_size)
{
    int x0 = w, y0 = h, x1 = -1, y1 = -1;

    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            if (rgba[4 * ((size_t)y * (size_t)w + (size_t)x) + 3])
                continue;
            x0 = int_min(x0, x);
            x1 = int_max(x1, x);
            y0 = int_min(y0, y);
            y1 = y;
        }
    *b = (struct border){ rgba, w, h, { x0, y0, x1 - x0 + 1, y1 - y0 + 1 } };
    if (x1 >= 0)
        return true;
    *b = (struct border){ 0 };
    return err_set(err, err_size, "the border has no hole; make the area of the game's picture fully transparent");
}

/* Returns the art's pixel along one axis, at the point p in units of 1 / SAMPLES window pixels. from, size: the picture
 * in the window; hole, hole_size: the hole in the art, which has n pixels. Beside the hole, the art has the hole's
 * scale, or is stretched to the window's edge if it would not reach it. */
static int art_at(int64_t p, int64_t from, int64_t size, int64_t hole, int64_t hole_size, int64_t window, int64_t n)
{
    const int64_t at = 2 * p + 1, unit = 2 * SAMPLES; /* so that the middle of a point is an integer */
    const int64_t left = from, right = window - from - size, rest = n - hole - hole_size;

    if (at >= from * unit && at < (from + size) * unit)
        return (int)(hole + (at - from * unit) * hole_size / (size * unit));
    if (at < from * unit) {
        const int64_t away = from * unit - at;
        const bool reaches = hole * size >= left * hole_size;
        const int64_t back = reaches ? away * hole_size / (size * unit) : away * hole / (left * unit);
        return (int)int64_clamp(hole - 1 - back, 0, n - 1);
    }
    const int64_t away = at - (from + size) * unit;
    const bool reaches = rest * size >= right * hole_size;
    const int64_t on = reaches ? away * hole_size / (size * unit) : away * rest / (right * unit);
    return (int)int64_clamp(hole + hole_size + on, 0, n - 1);
}

static uint32_t mean_colour(const struct border *b, const int *columns, const int *rows)
{
    uint32_t sum[3] = { 0 };

    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++) {
            const uint8_t *p = b->rgba + 4 * ((size_t)rows[i] * (size_t)b->w + (size_t)columns[j]);
            for (int c = 0; c < 3; c++)
                sum[c] += (uint32_t)p[c] * p[3];
        }
    for (int c = 0; c < 3; c++)
        sum[c] = (sum[c] + 255 * SAMPLES * SAMPLES / 2) / (255 * SAMPLES * SAMPLES);
    return sum[0] << 16 | sum[1] << 8 | sum[2];
}

static void paint_rotated(const struct border *b, uint32_t *out, int w, int h, const int *columns, const int *rows,
                          enum rotation rotation)
{
    int pitch = w, rotated_h = h;

    rotation_size(rotation, &pitch, &rotated_h);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            int tx = x, ty = y;
            rotation_point(rotation, w, h, &tx, &ty);
            out[(size_t)ty * (size_t)pitch + (size_t)tx] = mean_colour(b, columns + x * SAMPLES, rows + y * SAMPLES);
        }
}

void border_paint(const struct border *b, uint32_t *out, int w, int h, struct area picture, enum rotation rotation)
{
    const struct area p = rotation_area(rotation_inverse(rotation), w, h, picture), *hole = &b->hole;

    memset(out, 0, (size_t)w * (size_t)h * sizeof *out);
    rotation_size(rotation, &w, &h); /* from here on as the player sees it */
    int *points = b->rgba ? malloc((size_t)(w + h) * SAMPLES * sizeof *points) : NULL;
    if (!points)
        return;
    for (int i = 0; i < w * SAMPLES; i++)
        points[i] = art_at(i, p.x, p.w, hole->x, hole->w, w, b->w);
    for (int i = 0; i < h * SAMPLES; i++)
        points[w * SAMPLES + i] = art_at(i, p.y, p.h, hole->y, hole->h, h, b->h);
    paint_rotated(b, out, w, h, points, points + w * SAMPLES, rotation);
    free(points);
}
