/*
 * last.c - records the last seconds of a run (last.h): goes back in the board's past, ticks to the present with the
 * same pads, and restores the board.
 */
#include "last.h"

#include <stdlib.h>
#include <string.h>
#include "../run/ahead.h"

enum { SECOND = 60 };

struct film {
    struct gif *gif;
    struct fb *fb;
    uint32_t *rgb;
    void *scratch;
    uint8_t *pix;      /* malloc; rows without padding */
    uint32_t frames;   /* frames replayed so far */
    uint32_t pictures; /* pictures added so far; a GIF has fewer than the run has frames */
};

static bool add(struct film *film, const struct board *b)
{
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

static bool replay(struct film *film, struct guard *g, uint32_t first, uint32_t now)
{
    if (first < now && !guard_back(g, first))
        return false;
    for (uint32_t f = first; add(film, g->board); f++) {
        if (f == now)
            return true;
        if (!guard_ahead(g, rewind_pads(g->past, f)))
            return false;
    }
    return false;
}

/* Adds the frames from `first`, or the oldest one in the past, to the present. */
static bool lookback(struct film *film, struct guard *g, uint32_t first)
{
    const uint32_t now = board_frame(g->board), begin = rewind_first(g->past);
    struct ahead present = { .on = false };
    bool good = ahead_save(&present, g->board);

    first = first < begin ? begin : first;
    good = good && replay(film, g, first < now ? first : now, now);
    ahead_end(&present, g);
    ahead_close(&present);
    return good;
}

bool last_film(struct gif *g, struct guard *guard, uint32_t first, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    struct film film = { .gif = g, .fb = fb, .rgb = rgb, .scratch = scratch };

    film.pix = malloc((size_t)fb->w * (size_t)fb->h);
    const bool good = gif_open(g, fb->w, fb->h) && film.pix && lookback(&film, guard, first) &&
                      gif_end(g, film.pictures * (GIF_SECOND / GIF_RATE));
    free(film.pix);
    return good;
}
