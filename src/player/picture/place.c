/*
 * place.c - places picture and side panel (place.h), as the player of a rotated monitor sees them, and rotates the
 * areas.
 */
#include "place.h"

#include <stdint.h>
#include "../../base/int.h"

enum { MIN_SIDE_SCALE = 2 /* of a side panel, unless the picture's scale is smaller: text must be readable */ };

static struct area place_integer(const struct place_options *options, int w, int h)
{
    const int scale = int_max(1, int_min(w / options->w, h / options->h));

    return (struct area){ 0, 0, options->w * scale, options->h * scale };
}

static struct area place_smooth(const struct place_options *options, int w, int h)
{
    if ((int64_t)w * options->h < (int64_t)h * options->w)
        return (struct area){ 0, 0, w, int_max(1, (int)((int64_t)w * options->h / options->w)) };
    return (struct area){ 0, 0, int_max(1, (int)((int64_t)h * options->w / options->h)), h };
}

/* Chooses the largest scale that fits. */
static void place_side(struct placed *p, const struct place_options *options, int w, int h)
{
    const int space = w - p->picture.x - p->picture.w, largest = int_max(1, p->picture.w / options->w);

    for (int scale = largest; scale >= int_min(largest, MIN_SIDE_SCALE) && !p->side.w; scale--) {
        if (space / scale < PLACE_MIN_SIDE_WIDTH || h / scale < 1)
            continue;
        p->side_scale = scale;
        p->side_w = space / scale;
        p->side_h = h / scale;
        p->side = (struct area){ w - p->side_w * scale, 0, p->side_w * scale, p->side_h * scale };
    }
}

struct placed place(const struct place_options *options)
{
    struct placed p = { .side_scale = 1 };
    int w = options->window_w, h = options->window_h;

    rotation_size(options->rotation, &w, &h);
    p.picture = options->smooth ? place_smooth(options, w, h) : place_integer(options, w, h);
    p.picture.x = (w - p.picture.w) / 2;
    p.picture.y = (h - p.picture.h) / 2;
    if (options->side_panel)
        place_side(&p, options, w, h);
    p.picture = rotation_area(options->rotation, w, h, p.picture);
    p.side = rotation_area(options->rotation, w, h, p.side);
    return p;
}

bool place_to_picture(const struct place_options *options, const struct placed *placed, int *x, int *y)
{
    const struct area *a = &placed->picture;
    int w = options->w, h = options->h;

    if (*x < a->x || *y < a->y || *x >= a->x + a->w || *y >= a->y + a->h)
        return false;
    rotation_size(options->rotation, &w, &h);
    *x = (int)((int64_t)(*x - a->x) * w / a->w);
    *y = (int)((int64_t)(*y - a->y) * h / a->h);
    rotation_point(rotation_inverse(options->rotation), w, h, x, y);
    return true;
}
