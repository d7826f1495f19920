/*
 * shade.c - finds darker palette entries (shade.h).
 */
#include "shade.h"

#include <string.h>

static int brightness(const uint8_t c[3])
{
    return 2 * c[0] + 3 * c[1] + c[2];
}

/* Returns the squared distance between a candidate and the colour c reduced by `dim` quarters, times 16. */
static int distance(const uint8_t candidate[3], const uint8_t c[3], int dim)
{
    int sum = 0;

    for (int i = 0; i < 3; i++) {
        int d = 4 * candidate[i] - (4 - dim) * c[i];
        sum += d * d;
    }
    return sum;
}

static bool is_shown(int entry)
{
    return entry == 0 || entry % 16 != 0;
}

static uint8_t find_shade(const uint8_t *rgb, int entry, int dim, int previous)
{
    int best = -1, least = 0;

    for (int candidate = 0; candidate < 256; candidate++) {
        int d = distance(rgb + 3 * candidate, rgb + 3 * entry, dim);
        if (!is_shown(candidate) || brightness(rgb + 3 * candidate) > brightness(rgb + 3 * previous) ||
            (best >= 0 && d >= least))
            continue;
        best = candidate;
        least = d;
    }
    return (uint8_t)(best >= 0 ? best : previous);
}

void shade_make(const uint8_t rgb[CART_PALETTE_SIZE], uint8_t tables[CART_SHADES_SIZE])
{
    for (int i = 0; i < 256; i++) {
        uint8_t previous = (uint8_t)i;
        for (int dim = VIEW_DIM_QUARTER; dim < VIEW_DIMS; dim++) {
            previous = find_shade(rgb, i, dim, previous);
            tables[(dim - 1) * 256 + i] = previous;
        }
    }
}

const uint8_t *shade_get_tables(struct shade_cache *cache, const struct cart *cart)
{
    const uint8_t *palette = cart_palette(cart, "main");

    if (cart->main_tables.shades)
        return NULL;
    if (!cache->made || memcmp(cache->palette, palette, sizeof cache->palette) != 0) {
        memcpy(cache->palette, palette, sizeof cache->palette);
        shade_make(palette, cache->tables);
        cache->made = true;
    }
    return cache->tables;
}
