/*
 * window.c - see window.h.
 */
#include "window.h"

struct window window_of(const struct board *b)
{
    const struct manifest *m = &b->cart.manifest;
    struct window w = { .x = m->field_x,
                        .y = m->field_y,
                        .w = manifest_view_w(m) * m->zoom,
                        .h = manifest_view_h(m) * m->zoom,
                        .zoom = m->zoom };

    if (b->camera.s.live) {
        w.left = fx_floor(b->camera.x[0]);
        w.top = fx_floor(b->camera.y[0]);
    }
    return w;
}

void window_move_camera(struct board *b)
{
    const struct player *p = &b->player;
    int64_t x = 0, y = 0;
    int n = 0;

    for (uint32_t i = 0; i < MAX_PLAYERS; i++)
        if (p->in_game[i] && !b->input.played[i]) {
            x += p->x[i];
            y += p->y[i];
            n++;
        }
    if (n)
        camera_follow(&b->camera, (fx)(x / n), (fx)(y / n), manifest_view_w(&b->cart.manifest),
                      manifest_view_h(&b->cart.manifest));
}
