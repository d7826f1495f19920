/*
 * camera.c - see camera.h.
 */
#include "camera.h"

static const struct column columns[] = {
    COLUMN(camera, x),   COLUMN(camera, y), COLUMN(camera, follow), COLUMN(camera, left),
    COLUMN(camera, top), COLUMN(camera, w), COLUMN(camera, h),
};

const struct chip camera_chip = { .name = "camera", CHIP_COLUMNS(columns), .is_list = true };

void camera_reset(struct camera *c, int field_w, int field_h, int view_w, int view_h)
{
    c->x[0] = fx_int(field_w - view_w) / 2;
    c->y[0] = fx_int(field_h - view_h);
    c->follow[0] = FX_ONE;
    c->left[0] = c->top[0] = 0;
    c->w[0] = fx_int(field_w);
    c->h[0] = fx_int(field_h);
}

/* Returns the position nearest to v at which `view` px fit into the `size` after `start`. */
static fx clamp_to_limits(int64_t v, fx start, fx size, int view)
{
    const int64_t end = (int64_t)start + size - fx_int(view);

    return (fx)(v > end ? end : v < start ? start : v);
}

void camera_set_x(struct camera *c, fx v, int view_w)
{
    c->x[0] = clamp_to_limits(v, c->left[0], c->w[0], view_w);
}

void camera_set_y(struct camera *c, fx v, int view_h)
{
    c->y[0] = clamp_to_limits(v, c->top[0], c->h[0], view_h);
}

/* Returns the way that the camera goes of a distance. It is rounded away from 0, so that the camera arrives. */
static fx step_of(int64_t distance, fx share)
{
    const int64_t step = distance * share;

    return (fx)((step > 0 ? step + FX_ONE - 1 : step) >> 16);
}

void camera_follow(struct camera *c, fx x, fx y, int view_w, int view_h)
{
    const fx to_x = clamp_to_limits((int64_t)x - fx_int(view_w) / 2, c->left[0], c->w[0], view_w);
    const fx to_y = clamp_to_limits((int64_t)y - fx_int(view_h) / 2, c->top[0], c->h[0], view_h);

    c->x[0] += step_of(to_x - c->x[0], c->follow[0]);
    c->y[0] += step_of(to_y - c->y[0], c->follow[0]);
}
