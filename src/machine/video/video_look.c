/*
 * video_look.c - finds the ROM palette that is loaded, and its tables. RAM stores colours but not which
 * palette they came from, so the palette that matches the most colours counts as loaded.
 */
#include "video.h"

int board_loaded_palette(const struct board *b)
{
    const uint8_t *main = cart_palette(&b->cart, "main");
    int best = -1, best_score = -1;

    for (int i = 0; i < b->cart.count[CART_PALETTES]; i++) {
        const uint8_t *rgb = cart_palette_at(&b->cart, i);
        const int score = 2 * pal_likeness(&b->pal, rgb) + (rgb == main);
        best = score > best_score ? i : best;
        best_score = score > best_score ? score : best_score;
    }
    return best;
}

struct cart_colour_tables video_get_palette_tables(const struct board *b)
{
    return b->cart.has_palette_tables ? b->cart.palette_tables[board_loaded_palette(b)] : b->cart.main_tables;
}
