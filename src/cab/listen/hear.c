/*
 * hear.c - see hear.h. The host's own timer may call frame(), so all state is in one struct.
 */
#include "hear.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../board/board.h"
#include "../host/config.h"
#include "../host/report.h"
#include "../speaker/speaker.h"
#include "../overlay/overlay.h"

enum { W = 216, H = 224, SECOND = 1000000, MOST_LATE = 4, KEY_ESCAPE = 41, TITLE = 64 };

static struct {
    struct board *b;
    struct speaker speaker;
    struct overlay overlay;
    struct fb fb;
    void *pix;
    uint64_t base, frames;
    bool over;
} heard;

static void show(void)
{
    uint32_t rgb[256] = { 0 };
    struct canvas canvas;

    memset(heard.fb.pix, 0, (size_t)heard.fb.pitch * H);
    canvas_open(&canvas, &heard.fb, rgb);
    const struct overlay_place at = { &canvas, NULL, 0, H };
    overlay_draw(&heard.overlay, &at, heard.b, -1, -1);
    plat_show(heard.fb.pix, heard.fb.pitch, W, H, rgb);
}

static void tick(int frames)
{
    for (int i = 0; i < frames && !heard.over; i++) {
        heard.over = !board_box_tick(heard.b);
        speaker_hear(&heard.speaker, heard.b, SPEAKER_ON, 1);
    }
}

static bool frame(void)
{
    struct plat_input in;
    const uint64_t due = heard.base + heard.frames * SECOND / 60;

    plat_wait(due);
    const uint64_t now = plat_usec();
    if (now < due)
        return true;
    int n = (int)((now - due) * 60 / SECOND) + 1;
    struct speaker_time time = { .sixtieths = n < MOST_LATE ? n : MOST_LATE, .slow = 1 };
    time.lost = (uint64_t)(n - time.sixtieths) * SECOND / 60;
    heard.frames += (uint64_t)n;
    plat_poll(&in);
    tick(time.sixtieths);
    time.late = plat_usec() - due;
    speaker_frame(&heard.speaker, &time);
    overlay_listen(&heard.overlay, heard.b, &heard.speaker);
    show();
    return !heard.over && !in.quit && !plat_key(&in, KEY_ESCAPE);
}

static enum result open_window(const char *name)
{
    static char title[TITLE];
    struct config config;
    char err[512];

    if (!config_load(&config, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    speaker_open(&heard.speaker, config.volume, false, false);
    snprintf(title, sizeof title, "curtain: %s", name);
    heard.pix = calloc(1, fb_size(W, H));
    if (!heard.pix)
        return report_line(RESULT_HOST, "out of memory");
    fb_init(&heard.fb, heard.pix, W, H);
    if (!plat_open(&(struct plat_want){ .w = W, .h = H, .scale = config.scale, .title = title, .rate = SPEAKER_RATE }))
        return report_line(RESULT_HOST, "sound: there is no window to play in");
    return RESULT_DONE;
}

enum result hear(struct board *b, const char *name)
{
    memset(&heard, 0, sizeof heard);
    heard.b = b;
    heard.overlay.on[OVERLAY_MIXER] = true;
    heard.speaker.meter = true;
    const enum result result = open_window(name);
    if (result == RESULT_DONE) {
        board_box_play(b, name);
        heard.base = plat_usec();
        plat_loop(frame);
        speaker_close(&heard.speaker);
    }
    plat_close();
    free(heard.pix);
    return result;
}
