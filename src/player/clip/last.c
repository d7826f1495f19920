/*
 * last.c - see last.h.
 */
#include "last.h"

#include <stdlib.h>
#include <string.h>
#include "../run/lookback.h"

enum { SECOND = 60 };

struct film {
    struct gif *gif;
    struct fb *fb;
    uint32_t *rgb;
    void *scratch;
    uint8_t *pix;      /* malloc: rows on end */
    uint32_t frames;   /* that were looked at */
    uint32_t pictures; /* of them, as many as a GIF can show */
};

static bool add(void *user, const struct board *b)
{
    struct film *film = user;
    const struct fb *fb = film->fb;

    for (; (uint64_t)film->pictures * SECOND / GIF_RATE == film->frames; film->pictures++) {
        board_draw(b, NULL, film->fb, film->rgb, film->scratch);
        for (int y = 0; y < fb->h; y++)
            memcpy(film->pix + (size_t)y * (size_t)fb->w, fb->pix + (ptrdiff_t)y * fb->pitch, (size_t)fb->w);
        gif_add(film->gif, film->pix, film->rgb, film->pictures * (GIF_SECOND / GIF_RATE));
    }
    film->frames++;
    return !film->gif->out.failed;
}

bool last_film(struct gif *g, struct guard *guard, uint32_t first, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    struct film film = { .gif = g, .fb = fb, .rgb = rgb, .scratch = scratch };

    film.pix = malloc((size_t)fb->w * (size_t)fb->h);
    const bool good = gif_open(g, fb->w, fb->h) && film.pix && lookback(guard, first, add, &film) &&
                      gif_end(g, film.pictures * (GIF_SECOND / GIF_RATE));
    free(film.pix);
    return good;
}
