/*
 * shade.c - see shade.h.
 */
#include "shade.h"

#include <string.h>

static int brightness(const uint8_t c[3])
{
    return 2 * c[0] + 3 * c[1] + c[2];
}

/* Four times as far as a candidate is from c with `dim` quarters less, squared. */
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

static uint8_t shade(const uint8_t *rgb, int entry, int dim, int before)
{
    int best = -1, least = 0;

    for (int k = 0; k < 256; k++) {
        int d = distance(rgb + 3 * k, rgb + 3 * entry, dim);
        if (!is_shown(k) || brightness(rgb + 3 * k) > brightness(rgb + 3 * before) || (best >= 0 && d >= least))
            continue;
        best = k;
        least = d;
    }
    return (uint8_t)(best >= 0 ? best : before);
}

void shade_make(const uint8_t rgb[CART_PALETTE_SIZE], uint8_t tables[CART_SHADES_SIZE])
{
    for (int i = 0; i < 256; i++) {
        uint8_t before = (uint8_t)i;
        for (int dim = VIEW_DIM_QUARTER; dim < VIEW_DIMS; dim++) {
            before = shade(rgb, i, dim, before);
            tables[(dim - 1) * 256 + i] = before;
        }
    }
}

const uint8_t *shade_for(struct shade_kept *k, const struct cart *cart)
{
    const uint8_t *palette = cart_palette(cart, "main");

    if (cart->main_tables.shades)
        return NULL;
    if (!k->made || memcmp(k->of, palette, sizeof k->of) != 0) {
        memcpy(k->of, palette, sizeof k->of);
        shade_make(palette, k->tables);
        k->made = true;
    }
    return k->tables;
}
