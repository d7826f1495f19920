/*
 * compose.c - composes the window (compose.h).
 *
 * The picture is rotated before it is scaled. Each row is scaled once. Most rows of the window are copies of a scaled
 * row; where scaled pixels meet, they are the mean of two.
 */
#include "compose.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/int.h"

void compose_close(struct compose *c)
{
    scale_close(&c->across);
    scale_close(&c->down);
    free(c->pixels);
    free(c->back);
    free(c->mask);
    free(c->small);
    free(c->rows[0]);
    free(c->rows[1]);
    free(c->turned);
    *c = (struct compose){ 0 };
}

static bool same(const struct compose_want *a, const struct compose_want *b)
{
    const struct place_want *p = &a->place, *q = &b->place;

    return p->window_w == q->window_w && p->window_h == q->window_h && p->w == q->w && p->h == q->h &&
           p->turn == q->turn && p->smooth == q->smooth && p->beside == q->beside && a->crt == b->crt &&
           a->border == b->border;
}

static void *room(int n, size_t each)
{
    return malloc((size_t)int_max(n, 1) * each);
}

static bool allocate(struct compose *c, int small_w, int small_h)
{
    const struct area *a = &c->placed.picture;
    const int turned = int_max(small_w * small_h, c->placed.side_w * c->placed.side_h);

    c->pixels = room(c->w * c->h, sizeof *c->pixels);
    c->back = room(c->w * c->h, sizeof *c->back);
    c->mask = room(a->w, sizeof *c->mask);
    c->small = room(int_max(small_w, int_max(c->placed.side_w, c->placed.side_h)), sizeof *c->small);
    c->rows[0] = room(a->w, sizeof *c->rows[0]);
    c->rows[1] = room(a->w, sizeof *c->rows[1]);
    c->turned = room(turned, 1);
    return c->pixels && c->back && c->mask && c->small && c->rows[0] && c->rows[1] && c->turned &&
           scale_open(&c->across, small_w, a->w) && scale_open(&c->down, small_h, a->h);
}

bool compose_fit(struct compose *c, const struct compose_want *want)
{
    static const struct border black;
    struct place_want at = want->place;
    int w = at.w, h = at.h, shrunk = 1;

    if (c->pixels && same(&c->want, want))
        return true;
    compose_close(c);
    while ((int64_t)(at.window_w / shrunk) * (at.window_h / shrunk) > COMPOSE_MOST)
        shrunk++;
    at.window_w = c->w = int_max(1, at.window_w / shrunk);
    at.window_h = c->h = int_max(1, at.window_h / shrunk);
    c->want = *want;
    c->shrunk = shrunk;
    c->placed = place(&at);
    quarter_size(at.turn, &w, &h);
    if (!allocate(c, w, h)) {
        compose_close(c);
        return false;
    }
    crt_mask(c->mask, w, c->placed.picture.w);
    border_paint(want->border ? want->border : &black, c->back, c->w, c->h, c->placed.picture, at.turn);
    memcpy(c->pixels, c->back, (size_t)c->w * (size_t)c->h * sizeof *c->pixels);
    return true;
}

/* Returns columns x0 to x1 of a row of the picture, scaled. */
static const uint32_t *large_row(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256], int row,
                                 int x0, int x1)
{
    const int slot = row & 1;
    int w = c->want.place.w, h = c->want.place.h;

    if (c->of[slot] == row)
        return c->rows[slot];
    quarter_size(c->want.place.turn, &w, &h);
    for (int x = 0; x < w; x++)
        c->small[x] = rgb[pix[row * pitch + x]] & 0xFFFFFF;
    scale_row(&c->across, c->small, c->rows[slot], x0, x1);
    c->of[slot] = row;
    return c->rows[slot];
}

/* Returns the rotated picture. */
static const uint8_t *turned(struct compose *c, const uint8_t *pix, int *pitch, int w, int h)
{
    const enum quarter turn = c->want.place.turn;
    int tw = w, th = h;

    if (turn == QUARTER_NONE)
        return pix;
    quarter_size(turn, &tw, &th);
    quarter_picture(turn, pix, *pitch, w, h, c->turned, tw);
    *pitch = tw;
    return c->turned;
}

void compose_picture(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256])
{
    const struct area *a = &c->placed.picture;
    const int x0 = int_max(0, -a->x), x1 = int_min(a->w, c->w - a->x);
    const int y0 = int_max(0, -a->y), y1 = int_min(a->h, c->h - a->y);
    int small_w = c->want.place.w, small_h = c->want.place.h;
    uint32_t lifted[256];

    pix = turned(c, pix, &pitch, small_w, small_h);
    quarter_size(c->want.place.turn, &small_w, &small_h);
    c->of[0] = c->of[1] = -1;
    if (c->want.crt)
        crt_colours(lifted, rgb);
    for (int y = y0; y < y1; y++) {
        uint32_t *out = c->pixels + (size_t)(a->y + y) * (size_t)c->w + (size_t)(a->x + x0);
        const int from = c->down.from[y], share = c->down.share[y];
        const uint32_t *colours = c->want.crt ? lifted : rgb;
        const uint32_t *first = large_row(c, pix, pitch, colours, from, x0, x1);
        if (share)
            scale_mix(out, first + x0, large_row(c, pix, pitch, colours, from + 1, x0, x1) + x0, share, x1 - x0);
        else
            memcpy(out, first + x0, (size_t)(x1 - x0) * sizeof *out);
        if (c->want.crt)
            crt_row(out, c->mask + x0, crt_line(y, small_h, a->h), x1 - x0);
    }
}

static void copy_back(struct compose *c, const struct area *a)
{
    for (int y = a->y; y < a->y + a->h; y++) {
        const size_t at = (size_t)y * (size_t)c->w + (size_t)a->x;
        memcpy(c->pixels + at, c->back + at, (size_t)a->w * sizeof *c->pixels);
    }
}

void compose_side(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256])
{
    const struct area *a = &c->placed.side;
    const int scale = c->placed.side_scale;

    if (!a->w || (!pix && !c->beside))
        return;
    c->beside = pix != NULL;
    if (!pix) {
        copy_back(c, a);
        return;
    }
    pix = turned(c, pix, &pitch, c->placed.side_w, c->placed.side_h);
    for (int y = 0; y < a->h; y++) {
        uint32_t *out = c->pixels + (size_t)(a->y + y) * (size_t)c->w + (size_t)a->x;
        if (y % scale) {
            memcpy(out, out - c->w, (size_t)a->w * sizeof *out);
            continue;
        }
        for (int x = 0; x < a->w; x++)
            out[x] = rgb[pix[y / scale * pitch + x / scale]] & 0xFFFFFF;
    }
}

bool compose_point(const struct compose *c, int *x, int *y)
{
    return place_point(&c->want.place, &c->placed, x, y);
}
