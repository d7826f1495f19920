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
    free(c->background);
    free(c->mask);
    free(c->small);
    free(c->rows[0]);
    free(c->rows[1]);
    free(c->rotated);
    *c = (struct compose){ 0 };
}

static bool same_options(const struct compose_options *a, const struct compose_options *b)
{
    const struct place_options *p = &a->place, *q = &b->place;

    return p->window_w == q->window_w && p->window_h == q->window_h && p->w == q->w && p->h == q->h &&
           p->rotation == q->rotation && p->smooth == q->smooth && p->side_panel == q->side_panel && a->crt == b->crt &&
           a->border == b->border;
}

static void *allocate_items(int n, size_t each)
{
    return malloc((size_t)int_max(n, 1) * each);
}

static bool allocate(struct compose *c, int small_w, int small_h)
{
    const struct area *a = &c->placed.picture;
    const int rotated = int_max(small_w * small_h, c->placed.side_w * c->placed.side_h);

    c->pixels = allocate_items(c->w * c->h, sizeof *c->pixels);
    c->background = allocate_items(c->w * c->h, sizeof *c->background);
    c->mask = allocate_items(a->w, sizeof *c->mask);
    c->small = allocate_items(int_max(small_w, int_max(c->placed.side_w, c->placed.side_h)), sizeof *c->small);
    c->rows[0] = allocate_items(a->w, sizeof *c->rows[0]);
    c->rows[1] = allocate_items(a->w, sizeof *c->rows[1]);
    c->rotated = allocate_items(rotated, 1);
    return c->pixels && c->background && c->mask && c->small && c->rows[0] && c->rows[1] && c->rotated &&
           scale_open(&c->across, small_w, a->w) && scale_open(&c->down, small_h, a->h);
}

bool compose_prepare(struct compose *c, const struct compose_options *options)
{
    static const struct border black;
    struct place_options at = options->place;
    int w = at.w, h = at.h, shrink = 1;

    if (c->pixels && same_options(&c->options, options))
        return true;
    compose_close(c);
    while ((int64_t)(at.window_w / shrink) * (at.window_h / shrink) > COMPOSE_MAX_PIXELS)
        shrink++;
    at.window_w = c->w = int_max(1, at.window_w / shrink);
    at.window_h = c->h = int_max(1, at.window_h / shrink);
    c->options = *options;
    c->shrink = shrink;
    c->placed = place(&at);
    rotation_size(at.rotation, &w, &h);
    if (!allocate(c, w, h)) {
        compose_close(c);
        return false;
    }
    crt_mask(c->mask, w, c->placed.picture.w);
    border_paint(options->border ? options->border : &black, c->background, c->w, c->h, c->placed.picture, at.rotation);
    memcpy(c->pixels, c->background, (size_t)c->w * (size_t)c->h * sizeof *c->pixels);
    return true;
}

/* Returns columns x0 to x1 of a row of the picture, scaled. */
static const uint32_t *scale_picture_row(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256],
                                         int row, int x0, int x1)
{
    const int slot = row & 1;
    int w = c->options.place.w, h = c->options.place.h;

    if (c->row_numbers[slot] == row)
        return c->rows[slot];
    rotation_size(c->options.place.rotation, &w, &h);
    for (int x = 0; x < w; x++)
        c->small[x] = rgb[pix[row * pitch + x]] & 0xFFFFFF;
    scale_row(&c->across, c->small, c->rows[slot], x0, x1);
    c->row_numbers[slot] = row;
    return c->rows[slot];
}

/* Returns the rotated picture. */
static const uint8_t *rotated(struct compose *c, const uint8_t *pix, int *pitch, int w, int h)
{
    const enum rotation rotation = c->options.place.rotation;
    int tw = w, th = h;

    if (rotation == ROTATION_NONE)
        return pix;
    rotation_size(rotation, &tw, &th);
    rotation_picture(rotation, pix, *pitch, w, h, c->rotated, tw);
    *pitch = tw;
    return c->rotated;
}

void compose_picture(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256])
{
    const struct area *a = &c->placed.picture;
    const int x0 = int_max(0, -a->x), x1 = int_min(a->w, c->w - a->x);
    const int y0 = int_max(0, -a->y), y1 = int_min(a->h, c->h - a->y);
    int small_w = c->options.place.w, small_h = c->options.place.h;
    uint32_t brightened[256];

    pix = rotated(c, pix, &pitch, small_w, small_h);
    rotation_size(c->options.place.rotation, &small_w, &small_h);
    c->row_numbers[0] = c->row_numbers[1] = -1;
    if (c->options.crt)
        crt_colours(brightened, rgb);
    for (int y = y0; y < y1; y++) {
        uint32_t *out = c->pixels + (size_t)(a->y + y) * (size_t)c->w + (size_t)(a->x + x0);
        const int from = c->down.from[y], share = c->down.share[y];
        const uint32_t *colours = c->options.crt ? brightened : rgb;
        const uint32_t *first = scale_picture_row(c, pix, pitch, colours, from, x0, x1);
        if (share)
            scale_mix(out, first + x0, scale_picture_row(c, pix, pitch, colours, from + 1, x0, x1) + x0, share,
                      x1 - x0);
        else
            memcpy(out, first + x0, (size_t)(x1 - x0) * sizeof *out);
        if (c->options.crt)
            crt_row(out, c->mask + x0, crt_line(y, small_h, a->h), x1 - x0);
    }
}

static void restore_background(struct compose *c, const struct area *a)
{
    for (int y = a->y; y < a->y + a->h; y++) {
        const size_t at = (size_t)y * (size_t)c->w + (size_t)a->x;
        memcpy(c->pixels + at, c->background + at, (size_t)a->w * sizeof *c->pixels);
    }
}

void compose_side(struct compose *c, const uint8_t *pix, int pitch, const uint32_t rgb[256])
{
    const struct area *a = &c->placed.side;
    const int scale = c->placed.side_scale;

    if (!a->w || (!pix && !c->side_panel))
        return;
    c->side_panel = pix != NULL;
    if (!pix) {
        restore_background(c, a);
        return;
    }
    pix = rotated(c, pix, &pitch, c->placed.side_w, c->placed.side_h);
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

bool compose_to_picture(const struct compose *c, int *x, int *y)
{
    return place_to_picture(&c->options.place, &c->placed, x, y);
}
