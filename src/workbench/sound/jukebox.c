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

enum { W = 216, H = 224, SECOND = 1000000, MAX_LATE_FRAMES = 4, TITLE = 64 };

struct jukebox {
    struct board *board;
    struct speaker speaker;
    struct overlay overlay;
    struct fb fb;
    void *pix;
    uint64_t start_usec, frames_due;
    bool over;
    char title[TITLE];
};

static void show(struct jukebox *j)
{
    uint32_t rgb[256] = { 0 };
    struct canvas canvas;

    memset(j->fb.pix, 0, (size_t)j->fb.pitch * H);
    canvas_open(&canvas, &j->fb, rgb);
    const struct overlay_target at = { &canvas, NULL, 0, H };
    overlay_draw(&j->overlay, &at, j->board, -1, -1);
    plat_show(j->fb.pix, j->fb.pitch, W, H, rgb);
}

static void tick(struct jukebox *j, int frames)
{
    for (int i = 0; i < frames && !j->over; i++) {
        j->over = !board_jukebox_tick(j->board);
        speaker_add_frame(&j->speaker, j->board, NULL, SPEAKER_FORWARD);
    }
}

bool jukebox_frame(struct jukebox *j)
{
    struct plat_input in;
    const uint64_t due = j->start_usec + j->frames_due * SECOND / 60;

    if (plat_usec() + SECOND < due) { /* the clock was set back */
        j->start_usec = plat_usec();
        j->frames_due = 0;
        return true;
    }
    plat_wait(due);
    const uint64_t now = plat_usec();
    if (now < due)
        return true;
    const uint64_t n = (now - due) * 60 / SECOND + 1;
    struct speaker_elapsed time = { .sixtieths = n < MAX_LATE_FRAMES ? (int)n : MAX_LATE_FRAMES, .speed = 100 };
    time.lost = (n - (uint64_t)time.sixtieths) * SECOND / 60;
    j->frames_due += n;
    plat_poll(&in);
    tick(j, time.sixtieths);
    time.late = clock_since(due);
    speaker_advance(&j->speaker, &time);
    overlay_update_mixer(&j->overlay, j->board, &j->speaker);
    show(j);
    return !j->over && !in.quit && !plat_is_key_held(&in, KEY_ESCAPE);
}

static enum result open_window(struct jukebox *j, const char *name)
{
    struct config config;
    char err[512];

    if (!config_load(&config, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    speaker_open(&j->speaker, config.volume, false, false);
    snprintf(j->title, sizeof j->title, "curtain: %s", name);
    j->pix = calloc(1, fb_size(W, H));
    if (!j->pix)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    fb_init(&j->fb, j->pix, W, H);
    if (!plat_open(&(struct plat_config){
            .w = W, .h = H, .scale = config.scale, .title = j->title, .sound_rate = SPEAKER_RATE }))
        return report_line(RESULT_HOST_FAILED, "sound: cannot open a window to play in");
    return RESULT_DONE;
}

enum result jukebox_open(struct jukebox **out, struct board *b, const char *name)
{
    struct jukebox *j = calloc(1, sizeof *j);

    *out = NULL;
    if (!j)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    j->board = b;
    j->overlay.on[OVERLAY_MIXER] = true;
    j->speaker.metering = true;
    const enum result result = open_window(j, name);
    if (result != RESULT_DONE) {
        jukebox_close(j);
        return result;
    }
    board_jukebox_play(b, name);
    j->start_usec = plat_usec();
    *out = j;
    return RESULT_DONE;
}

void jukebox_close(struct jukebox *j)
{
    speaker_close(&j->speaker);
    plat_close();
    free(j->pix);
    free(j);
}
