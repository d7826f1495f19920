/*
 * cab_film.c - the last seconds of the play as a GIF, by a key.
 *
 * They are looked at again in one go, between two frames of the cabinet, after a picture that says so: ten seconds take
 * about one. Nothing of the run is another for it: the board is put back to the byte, and what it handed out too.
 */
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../film/gif.h"
#include "../run/lookback.h"
#include "cab_parts.h"

enum { SECOND = 60 };

struct film {
    struct gif gif;
    uint8_t *pix;      /* malloc: rows on end */
    uint32_t frames;   /* that were looked at */
    uint32_t pictures; /* of them, as many as a GIF can show */
};

static bool add(void *user, const struct board *b)
{
    struct film *film = user;
    struct picture *p = &cab.picture;

    for (; (uint64_t)film->pictures * SECOND / GIF_RATE == film->frames; film->pictures++) {
        board_draw(b, NULL, &p->composed, p->composed_rgb, p->scratch);
        for (int y = 0; y < p->composed.h; y++)
            memcpy(film->pix + (size_t)y * (size_t)p->composed.w, p->composed.pix + (ptrdiff_t)y * p->composed.pitch,
                   (size_t)p->composed.w);
        gif_add(&film->gif, film->pix, p->composed_rgb, film->pictures * (GIF_SECOND / GIF_RATE));
    }
    film->frames++;
    return !film->gif.out.failed;
}

static bool shoot(struct film *film)
{
    const struct fb *fb = &cab.picture.composed;
    const uint32_t now = board_frame(cab_live()), wanted = (uint32_t)cab.config.capture_seconds * SECOND - 1;

    film->pix = malloc((size_t)fb->w * (size_t)fb->h);
    return film->pix && gif_open(&film->gif, fb->w, fb->h) &&
           lookback(&cab.session.now->guard, now > wanted ? now - wanted : 0, add, film) &&
           gif_end(&film->gif, film->pictures * (GIF_SECOND / GIF_RATE));
}

static void save(const struct film *film)
{
    char name[CAB_NAME], shown[FILES_PATH], err[FILES_ERR];

    cab_free_name(name, "pictures:", "gif");
    const bool good = files_save(name, film->gif.out.bytes, film->gif.out.n, err, sizeof err);
    cab_say(good ? "wrote %s" : "curtain: %s", good ? files_shown(name, shown) : err);
    cab_notice(CAB_NOTICE_FRAMES, good ? "wrote %s" : "%s", good ? shown : err);
}

void cab_film_ask(void)
{
    if (cab.attracting || cab_fault() || cab.session.state != SESSION_PLAYING) {
        cab_notice(CAB_NOTICE_FRAMES, "nothing is played that could be filmed");
        return;
    }
    cab.film_due = true;
    cab_notice(CAB_NOTICE_FRAMES, "filming the last %d seconds", cab.config.capture_seconds);
}

void cab_film(void)
{
    struct film film = { .pix = NULL };

    if (!cab.film_due || cab.waiting.on || !cab.session.now)
        return;
    cab.film_due = false;
    if (cab.attracting || cab_fault() || cab.session.state != SESSION_PLAYING)
        return;
    if (shoot(&film)) {
        save(&film);
    } else {
        cab_say("curtain: the last seconds could not be filmed: too little memory, or a frame took too long");
        cab_notice(CAB_NOTICE_FRAMES, "the last seconds could not be filmed");
    }
    gif_close(&film.gif);
    free(film.pix);
}
