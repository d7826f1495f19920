/*
 * jukebox.c - see jukebox.h.
 */
#include "jukebox.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../board/board.h"
#include "../../player/settings/config.h"
#include "../../common/report.h"
#include "../../player/speaker/speaker.h"
#include "../../player/overlay/overlay.h"

enum { W = 216, H = 224, SECOND = 1000000, MOST_LATE = 4, TITLE = 64 };

struct jukebox {
    struct board *b;
    struct speaker speaker;
    struct overlay overlay;
    struct fb fb;
    void *pix;
    uint64_t base, frames;
    bool over;
    char title[TITLE];
};

static void show(struct jukebox *h)
{
    uint32_t rgb[256] = { 0 };
    struct canvas canvas;

    memset(h->fb.pix, 0, (size_t)h->fb.pitch * H);
    canvas_open(&canvas, &h->fb, rgb);
    const struct overlay_target at = { &canvas, NULL, 0, H };
    overlay_draw(&h->overlay, &at, h->b, -1, -1);
    plat_show(h->fb.pix, h->fb.pitch, W, H, rgb);
}

static void tick(struct jukebox *h, int frames)
{
    for (int i = 0; i < frames && !h->over; i++) {
        h->over = !board_jukebox_tick(h->b);
        speaker_add_frame(&h->speaker, h->b, SPEAKER_FORWARD, 1);
    }
}

bool jukebox_frame(struct jukebox *h)
{
    struct plat_input in;
    const uint64_t due = h->base + h->frames * SECOND / 60;

    if (plat_usec() + SECOND < due) { /* the clock was set back */
        h->base = plat_usec();
        h->frames = 0;
        return true;
    }
    plat_wait(due);
    const uint64_t now = plat_usec();
    if (now < due)
        return true;
    const uint64_t n = (now - due) * 60 / SECOND + 1;
    struct speaker_elapsed time = { .sixtieths = n < MOST_LATE ? (int)n : MOST_LATE, .slow = 1 };
    time.lost = (n - (uint64_t)time.sixtieths) * SECOND / 60;
    h->frames += n;
    plat_poll(&in);
    tick(h, time.sixtieths);
    time.late = clock_since(due);
    speaker_advance(&h->speaker, &time);
    overlay_update_mixer(&h->overlay, h->b, &h->speaker);
    show(h);
    return !h->over && !in.quit && !plat_is_key_held(&in, KEY_ESCAPE);
}

static enum result open_window(struct jukebox *h, const char *name)
{
    struct config config;
    char err[512];

    if (!config_load(&config, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    speaker_open(&h->speaker, config.volume, false, false);
    snprintf(h->title, sizeof h->title, "curtain: %s", name);
    h->pix = calloc(1, fb_size(W, H));
    if (!h->pix)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    fb_init(&h->fb, h->pix, W, H);
    if (!plat_open(&(struct plat_config){
            .w = W, .h = H, .scale = config.scale, .title = h->title, .sound_rate = SPEAKER_RATE }))
        return report_line(RESULT_HOST_FAILED, "sound: cannot open a window to play in");
    return RESULT_DONE;
}

enum result jukebox_open(struct jukebox **out, struct board *b, const char *name)
{
    struct jukebox *h = calloc(1, sizeof *h);

    *out = NULL;
    if (!h)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    h->b = b;
    h->overlay.on[OVERLAY_MIXER] = true;
    h->speaker.metering = true;
    const enum result result = open_window(h, name);
    if (result != RESULT_DONE) {
        jukebox_close(h);
        return result;
    }
    board_jukebox_play(b, name);
    h->base = plat_usec();
    *out = h;
    return RESULT_DONE;
}

void jukebox_close(struct jukebox *h)
{
    speaker_close(&h->speaker);
    plat_close();
    free(h->pix);
    free(h);
}
