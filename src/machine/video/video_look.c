/*
 * video_look.c - which palette of the ROM is loaded, and its tables. Nothing in RAM says so, for colours are RAM: the
 * palette is loaded that most of them come from.
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
