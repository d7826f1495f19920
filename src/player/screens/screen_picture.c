/*
 * screen_picture.c - draws portraits and thumbnails (screen_picture.h).
 */
#include "screen_picture.h"

#include <string.h>

bool screen_picture_of_sprite(struct screen_picture *p, const struct cart *cart, const char *name)
{
    const int i = cart_find(cart, CART_SPRITES, name);
    struct sprite s;

    if (i < 0)
        return false;
    cart_sprite(cart, i, &s);
    *p = (struct screen_picture){ .w = s.w, .h = s.h, .pitch = s.pitch, .pix = s.pix, .has_holes = true };
    const uint8_t *rgb = s.palette ? cart_palette_at(cart, s.palette - 1) : cart_palette(cart, "main");
    for (int c = 0; c < 256; c++)
        p->rgb[c] = (uint32_t)rgb[3 * c] << 16 | (uint32_t)rgb[3 * c + 1] << 8 | rgb[3 * c + 2];
    return true;
}

/* Stores the palette entry of each value that the picture uses, in every step-th pixel. */
static void add_colours(const struct screen_picture *p, const struct canvas *canvas, int step, uint8_t entry[256])
{
    uint32_t colours[256] = { 0 };
    uint8_t entries[256], values[256];
    bool seen[256] = { false };
    int n = 0;

    for (int y = 0; y < p->h; y += step)
        for (int x = 0; x < p->w; x += step) {
            const uint8_t v = p->pix[y * p->pitch + x];
            if (seen[v] || (v == 0 && p->has_holes))
                continue;
            seen[v] = true;
            colours[n] = p->rgb[v];
            values[n++] = v;
        }
    canvas_add_colours(canvas, colours, n, entries);
    for (int i = 0; i < n; i++)
        entry[values[i]] = entries[i];
}

int screen_picture_draw(const struct screen_picture *p, const struct canvas *canvas, struct screen_area to)
{
    int step = 1;
    uint8_t entry[256];

    if (to.w < 1 || to.h < 1)
        return 0;
    while ((p->w + step - 1) / step > to.w || (p->h + step - 1) / step > to.h)
        step++;
    add_colours(p, canvas, step, entry);
    const int w = (p->w + step - 1) / step, h = (p->h + step - 1) / step, top = to.y + (to.h - h) / 2;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            const uint8_t v = p->pix[y * step * p->pitch + x * step];
            if (v == 0 && p->has_holes)
                continue;
            canvas->fb->pix[(top + y) * canvas->fb->pitch + to.x + x] = entry[v];
        }
    return w;
}
