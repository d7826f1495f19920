/*
 * place.c - places picture and side panel (place.h), as the player of a rotated monitor sees them, and rotates the
 * areas.
 */
#include "place.h"

#include <stdint.h>
#include "../../base/int.h"

enum { SMALLEST_SCALE = 2 /* of a side panel, unless the picture's scale is smaller: text must be readable */ };

static struct area place_whole(const struct place_want *want, int w, int h)
{
    const int scale = int_max(1, int_min(w / want->w, h / want->h));

    return (struct area){ 0, 0, want->w * scale, want->h * scale };
}

static struct area place_smooth(const struct place_want *want, int w, int h)
{
    if ((int64_t)w * want->h < (int64_t)h * want->w)
        return (struct area){ 0, 0, w, int_max(1, (int)((int64_t)w * want->h / want->w)) };
    return (struct area){ 0, 0, int_max(1, (int)((int64_t)h * want->w / want->h)), h };
}

/* Chooses the largest scale that fits. */
static void place_side(struct placed *p, const struct place_want *want, int w, int h)
{
    const int room = w - p->picture.x - p->picture.w, largest = int_max(1, p->picture.w / want->w);

    for (int scale = largest; scale >= int_min(largest, SMALLEST_SCALE) && !p->side.w; scale--) {
        if (room / scale < PLACE_SIDE || h / scale < 1)
            continue;
        p->side_scale = scale;
        p->side_w = room / scale;
        p->side_h = h / scale;
        p->side = (struct area){ w - p->side_w * scale, 0, p->side_w * scale, p->side_h * scale };
    }
}

struct placed place(const struct place_want *want)
{
    struct placed p = { .side_scale = 1 };
    int w = want->window_w, h = want->window_h;

    quarter_size(want->turn, &w, &h);
    p.picture = want->smooth ? place_smooth(want, w, h) : place_whole(want, w, h);
    p.picture.x = (w - p.picture.w) / 2;
    p.picture.y = (h - p.picture.h) / 2;
    if (want->beside)
        place_side(&p, want, w, h);
    p.picture = quarter_area(want->turn, w, h, p.picture);
    p.side = quarter_area(want->turn, w, h, p.side);
    return p;
}

bool place_point(const struct place_want *want, const struct placed *placed, int *x, int *y)
{
    const struct area *a = &placed->picture;
    int w = want->w, h = want->h;

    if (*x < a->x || *y < a->y || *x >= a->x + a->w || *y >= a->y + a->h)
        return false;
    quarter_size(want->turn, &w, &h);
    *x = (int)((int64_t)(*x - a->x) * w / a->w);
    *y = (int)((int64_t)(*y - a->y) * h / a->h);
    quarter_point(quarter_back(want->turn), w, h, x, y);
    return true;
}
