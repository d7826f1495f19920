/*
 * video_look.c - finds the ROM palette that is loaded, and its tables. RAM stores colours but not which palette they
 * came from, so the palette that matches the most colours counts as loaded.
 */
#include "video.h"

int board_palette(const struct board *b)
{
    const uint8_t *main = cart_palette(&b->cart, "main");
    int best = -1, most = -1;

    for (int i = 0; i < b->cart.palettes; i++) {
        const uint8_t *rgb = cart_palette_at(&b->cart, i);
        const int alike = 2 * pal_likeness(&b->pal, rgb) + (rgb == main);
        best = alike > most ? i : best;
        most = alike > most ? alike : most;
    }
    return best;
}

struct cart_look video_look(const struct board *b)
{
    return b->cart.has_looks ? b->cart.looks[board_palette(b)] : b->cart.main;
}
