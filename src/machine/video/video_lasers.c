/*
 * video_lasers.c - draws lasers: a strip along the line, then the pictures at its two ends.
 */
#include "../../../fb/strip.h"
#include "../../base/host.h"
#include "../../base/trig.h"
#include "../lasers_run.h"
#include "video.h"

/* Draws the picture at one end of laser i, facing dir if the sprite has rotated copies. sprite: index + 1. */
static void draw_end_sprite(struct draw_target *c, uint32_t i, uint16_t sprite, fx x, fx y, ang dir)
{
    const struct laser_kinds *k = &c->b->laser_kinds;
    const uint16_t kind = c->b->laser_heads.kind[i];
    const struct sprite *s = &c->b->sprite_images[sprite - 1];
    struct image img = video_image(s, lasers_shown_age(c->b, i), true, dir);

    video_paint(c, &img, c->x + fx_floor(x) - s->ox, c->y + fx_floor(y) - s->oy, c->b->laser_heads.bank[i], 0,
                (k->flags[kind] & LASER_BLEND) / LASER_BLEND_ONE);
    c->drawn_count++;
}

static void draw_ends(struct draw_target *c, uint32_t i)
{
    const struct laser_kinds *k = &c->b->laser_kinds;
    const struct bullets *h = &c->b->laser_heads;
    const uint16_t kind = h->kind[i];
    const uint32_t n = lasers_corner_count(c->b, i);
    fx x, y, ax, ay;

    if (k->tail_sprite[kind]) {
        lasers_get_corner(c->b, i, n - 1, &x, &y);
        lasers_get_corner(c->b, i, n > 1 ? n - 2 : 0, &ax, &ay);
        ang dir = x != ax || y != ay ? trig_atan2(fx_sub(ay, y), fx_sub(ax, x)) : h->dir[i];
        draw_end_sprite(c, i, k->tail_sprite[kind], x, y, c->b->lasers.form[i] == LASER_BEAM ? h->dir[i] : dir);
    }
    if (k->head_sprite[kind])
        draw_end_sprite(c, i, k->head_sprite[kind], h->x[i], h->y[i], h->dir[i]);
}

static int32_t to_surface(fx v, int corner)
{
    const int64_t limit = 30000 * 65536ll, at = v + (int64_t)corner * 65536;

    return (int32_t)(at > limit ? limit : at < -limit ? -limit : at);
}

enum { MAX_RUN = 12, SLACK = 65536 / 4 };

/* Returns whether all corners between corners `from` and `to` lie within SLACK (Q16 px) of the segment from one to the
 * other. The larger of |dx| and |dy| is used as the segment's length; it never exceeds the true length, so the test
 * errs towards false. */
static bool is_straight(const struct strip_corner *c, int from, int to)
{
    const int64_t dx = (int64_t)c[to].x - c[from].x, dy = (int64_t)c[to].y - c[from].y;
    const int64_t ax = dx < 0 ? -dx : dx, ay = dy < 0 ? -dy : dy, max_cross = (ax > ay ? ax : ay) * SLACK;

    if (ax > 1 << 29 || ay > 1 << 29) /* so that the products stay below 2^62 */
        return false;
    for (int k = from + 1; k < to; k++) {
        const int64_t ex = (int64_t)c[k].x - c[from].x, ey = (int64_t)c[k].y - c[from].y, cross = dx * ey - dy * ex;
        if (cross > max_cross || cross < -max_cross || ex * dx + ey * dy < 0)
            return false;
    }
    return true;
}

/* Removes corners along nearly straight runs of up to MAX_RUN segments, because a curve has a corner per frame, far
 * more than are needed to draw it. Returns the number of corners left. */
static uint32_t thin_out_corners(struct strip_corner *c, uint32_t n)
{
    uint32_t corner_count = 0, from = 0;

    while (from + 1 < n) {
        uint32_t to = from + 1;
        while (to + 1 < n && to - from < MAX_RUN && is_straight(c, (int)from, (int)to + 1))
            to++;
        c[++corner_count] = c[to];
        from = to;
    }
    return corner_count + 1;
}

/* Draws the line of laser i. The strip's picture is oriented along a beam's direction, or along the flight of any other
 * laser. */
static void draw_line(struct draw_target *c, uint32_t i, int32_t width, bool dashed)
{
    const struct laser_kinds *k = &c->b->laser_kinds;
    const uint16_t kind = c->b->laser_heads.kind[i];
    const unsigned blend = (k->flags[kind] & LASER_BLEND) / LASER_BLEND_ONE;
    const uint32_t age = lasers_shown_age(c->b, i), n = lasers_corner_count(c->b, i);
    const struct image img = video_image(&c->b->sprite_images[k->strip[kind]], age, false, 0);
    struct strip_corner corner[LASER_MAX_POINTS];
    const struct strip s = { .image = &img,
                             .bank = c->b->laser_heads.bank[i],
                             .blend_table = blend ? c->palette_tables.blend[blend - 1] : NULL,
                             .width = width,
                             .offset_along = dashed ? 8 - age / 2 % 8 : 0,
                             .dashed = dashed };

    for (uint32_t p = 0; p < n; p++) {
        fx x, y;
        lasers_get_corner(c->b, i, p, &x, &y);
        corner[c->b->lasers.form[i] == LASER_BEAM ? p : n - 1 - p] =
            (struct strip_corner){ to_surface(x, c->x), to_surface(y, c->y) };
    }
    strip_draw(c->fb, &s, corner, (int)thin_out_corners(corner, n));
    c->drawn_count++;
}

void video_draw_lasers(struct draw_target *c, bool shoots)
{
    const struct board *b = c->b;
    struct host host;

    if (!b->lasers.s.live)
        return;
    host_enter(&host); /* square roots and angles start from an estimate in doubles */
    EACH_LIVE (i, &b->lasers.s) {
        const uint32_t age = lasers_shown_age(b, i);
        if (!(b->laser_kinds.flags[b->laser_heads.kind[i]] & LASER_HITS_ENEMIES) == shoots)
            continue;
        if (lasers_state_of(b, i, age) == LASER_WARN) {
            if (b->lasers.form[i] == LASER_BEAM)
                draw_line(c, i, 65536, true);
            continue;
        }
        draw_line(c, i, lasers_width(&b->lasers, i, age), false);
        draw_ends(c, i);
    }
    host_leave(&host);
}
