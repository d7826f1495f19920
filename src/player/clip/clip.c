/*
 * clip.c - records the last seconds of a run (clip.h): goes back in the board's past, ticks to the present with the
 * same pads, and restores the board.
 */
#include "clip.h"

#include <stdlib.h>
#include <string.h>
#include "../run/ahead.h"

enum { SECOND = 60 };

struct recorder {
    struct gif *gif;
    struct fb *fb;
    uint32_t *rgb;
    void *scratch;
    uint8_t *pix;      /* malloc; rows without padding */
    uint32_t frames;   /* frames replayed so far */
    uint32_t pictures; /* pictures added so far; a GIF has fewer than the run has frames */
};

static bool add_pictures(struct recorder *r, const struct board *b)
{
    const struct fb *fb = r->fb;

    for (; (uint64_t)r->pictures * SECOND / GIF_MAX_FPS == r->frames; r->pictures++) {
        board_draw(b, NULL, r->fb, r->rgb, r->scratch);
        for (int y = 0; y < fb->h; y++)
            memcpy(r->pix + (size_t)y * (size_t)fb->w, fb->pix + (ptrdiff_t)y * fb->pitch, (size_t)fb->w);
        gif_add(r->gif, r->pix, r->rgb, r->pictures * (GIF_UNITS_PER_SECOND / GIF_MAX_FPS));
    }
    r->frames++;
    return !r->gif->out.failed;
}

static bool replay(struct recorder *r, struct guard *g, uint32_t first, uint32_t present)
{
    if (first < present && !guard_rewind(g, first))
        return false;
    for (uint32_t f = first; add_pictures(r, g->board); f++) {
        if (f == present)
            return true;
        if (!guard_tick_ahead(g, rewind_pads(g->past, f)))
            return false;
    }
    return false;
}

/* Adds the frames from `first`, or the oldest one in the past, to the present. */
static bool record_past(struct recorder *r, struct guard *g, uint32_t first)
{
    const uint32_t present = board_frame(g->board), oldest = rewind_first(g->past);
    struct ahead ahead = { .saved = false };
    bool ok = ahead_save(&ahead, g->board);

    first = first < oldest ? oldest : first;
    ok = ok && replay(r, g, first < present ? first : present, present);
    ahead_end(&ahead, g);
    ahead_close(&ahead);
    return ok;
}

bool clip_record(struct gif *g, struct guard *guard, uint32_t first, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    struct recorder recorder = { .gif = g, .fb = fb, .rgb = rgb, .scratch = scratch };

    recorder.pix = malloc((size_t)fb->w * (size_t)fb->h);
    const bool ok = gif_open(g, fb->w, fb->h) && recorder.pix && record_past(&recorder, guard, first) &&
                    gif_end(g, recorder.pictures * (GIF_UNITS_PER_SECOND / GIF_MAX_FPS));
    free(recorder.pix);
    return ok;
}
