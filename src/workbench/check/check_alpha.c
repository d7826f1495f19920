/*
 * check_alpha.c - whether the game's blend and palettes suit translucent pictures. Half of each translucent picture's
 * pixels, or all of them, are drawn with the blend "alpha"; without it, they are only opaque dots.
 */
#include "check_parts.h"

#include "../../rom/cart.h"

enum { MAX_ERROR = 40 /* highest mean difference from the even mix, per channel of 0 to 255 */ };

/* Returns how far the blend's results for a bank over black are from the even mixes, per channel, on average. */
static int mean_error(const uint8_t *rgb, const uint8_t *table, int bank)
{
    int sum = 0, n = 0;

    for (int shade = 1; shade < 16; shade++) {
        const int over = 16 * bank + shade;
        const uint8_t *got = rgb + 3 * table[over], *colour = rgb + 3 * over;
        for (int k = 0; k < 3; k++, n++) {
            const int difference = got[k] - (colour[k] + rgb[k] + 1) / 2;
            sum += difference < 0 ? -difference : difference;
        }
    }
    return sum / n;
}

static bool is_used(const struct cart *cart, int bank)
{
    for (int i = 0; i < cart->count[CART_SPRITES]; i++) {
        struct sprite s;
        cart_sprite(cart, i, &s);
        if (s.bank == bank)
            return true;
    }
    return false;
}

void check_alpha(struct check *c, const struct cart *cart)
{
    const int blend = cart_find(cart, CART_BLENDS, "alpha"), line = CHECK_LINE(c, "blends");

    if (!cart->manifest.has_transforms || !check_all_parsed(c) || !check_is_mentioned(c, "alpha"))
        return;
    if (blend < 0) {
        diagnostics_note(&c->found, "rom.lua", line,
                         "blends: translucent pictures are drawn as dots; add `alpha = { mix = 50 }` to mix them with "
                         "the pixels below");
        return;
    }
    for (int bank = 0; bank < 16; bank++)
        if (is_used(cart, bank) &&
            mean_error(cart_palette(cart, "main"), cart->main_tables.blend[blend], bank) > MAX_ERROR)
            diagnostics_note(&c->found, "rom.lua", line,
                             "blends.alpha: over black, translucent pictures in bank %d have the wrong colours; give "
                             "the palette darker shades of this bank, or set the blend to `{ mix = 50 }`",
                             bank);
}
