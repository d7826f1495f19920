/*
 * icon.c - game icons (icon.h).
 */
#include "icon.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "png.h"

struct rgba {
    uint8_t *pix; /* malloc */
    int w, h;
};

static bool check_side(int w, int h, char *err, size_t err_size)
{
    const int most = w > h ? w : h;

    if (most >= ICON_MIN_SIDE && most <= ICON_MAX_SIDE)
        return true;
    return err_set(err, err_size, "expected an icon whose longer side is %d to %d px, got %d x %d", ICON_MIN_SIDE,
                   ICON_MAX_SIDE, w, h);
}

static bool read_png(const uint8_t *png, size_t size, struct rgba *out, char *err, size_t err_size)
{
    if (!png_read(png, size, &out->pix, &out->w, &out->h, err, err_size))
        return false;
    if (check_side(out->w, out->h, err, err_size))
        return true;
    free(out->pix);
    return false;
}

bool icon_check(const uint8_t *png, size_t size, char *err, size_t err_size)
{
    struct rgba picture;

    if (!read_png(png, size, &picture, err, err_size))
        return false;
    free(picture.pix);
    return true;
}

/* Reads the first frame of a sprite, in the colours of palette/main. */
static bool read_sprite(const struct cart *cart, const struct lump *lump, struct rgba *out)
{
    char name[ART_NAME_SIZE];
    struct sprite s;

    snprintf(name, sizeof name, "%.*s", (int)lump->size, (const char *)lump->data);
    const int i = cart_find(cart, CART_SPRITES, name);
    if (i < 0)
        return false;
    cart_sprite(cart, i, &s);
    *out = (struct rgba){ calloc((size_t)s.w * s.h, 4), s.w, s.h };
    for (int y = 0; out->pix && y < s.h; y++)
        for (int x = 0; x < s.w; x++) {
            const uint8_t pixel = s.pix[y * s.pitch + x];
            uint8_t *to = out->pix + 4 * (y * s.w + x);
            if (!pixel)
                continue;
            memcpy(to, cart_palette(cart, "main") + 3 * pixel, 3);
            to[3] = 255;
        }
    return out->pix != NULL;
}

static bool read_icon(const struct cart *cart, struct rgba *out)
{
    const int i = rom_find(cart->rom, ICON_LUMP);
    struct lump lump;
    char why[256];

    if (i < 0)
        return false;
    rom_lump(cart->rom, i, &lump);
    if (lump.size > 0 && lump.data[0] == 0x89)
        return read_png(lump.data, lump.size, out, why, sizeof why);
    return read_sprite(cart, &lump, out);
}

uint8_t *icon_make(const struct cart *cart, int min_side, int *side)
{
    struct rgba p;

    if (!read_icon(cart, &p))
        return NULL;
    const int longer = p.w > p.h ? p.w : p.h, scale = longer >= min_side ? 1 : (min_side + longer - 1) / longer;
    const int left = (longer - p.w) * scale / 2, top = (longer - p.h) * scale / 2;
    *side = longer * scale;
    uint8_t *out = calloc((size_t)*side * (size_t)*side, 4);
    for (int y = 0; out && y < p.h * scale; y++)
        for (int x = 0; x < p.w * scale; x++)
            memcpy(out + 4 * ((y + top) * *side + x + left), p.pix + 4 * (y / scale * p.w + x / scale), 4);
    free(p.pix);
    return out;
}

uint8_t *icon_fit(const struct cart *cart, int side)
{
    int from;
    uint8_t *in = icon_make(cart, side, &from), *out = in ? calloc((size_t)side * (size_t)side, 4) : NULL;

    for (int i = 0; out && i < side * side; i++) {
        /* the square of the larger picture that the pixel covers, in 1 / side of its pixels */
        const int x0 = i % side * from, y0 = i / side * from, x1 = x0 + from, y1 = y0 + from;
        uint64_t sum[4] = { 0 };
        for (int y = y0 / side; y * side < y1; y++)
            for (int x = x0 / side; x * side < x1; x++) {
                const int left = x * side > x0 ? x * side : x0, right = (x + 1) * side < x1 ? (x + 1) * side : x1;
                const int top = y * side > y0 ? y * side : y0, low = (y + 1) * side < y1 ? (y + 1) * side : y1;
                const uint8_t *p = in + 4 * (y * from + x);
                const uint64_t covered = (uint64_t)(right - left) * (uint64_t)(low - top) * p[3];
                for (int c = 0; c < 4; c++)
                    sum[c] += covered * (c < 3 ? p[c] : 1);
            }
        for (int c = 0; c < 3; c++)
            out[4 * i + c] = (uint8_t)(sum[3] ? sum[c] / sum[3] : 0);
        out[4 * i + 3] = (uint8_t)(sum[3] / ((uint64_t)from * (uint64_t)from));
    }
    free(in);
    return out;
}

void icon_show(const struct cart *cart)
{
    int side;
    uint8_t *rgba = icon_make(cart, ICON_WINDOW_SIDE, &side);

    if (rgba)
        plat_set_icon(rgba, side, side);
    free(rgba);
}
