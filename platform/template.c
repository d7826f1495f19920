/*
 * template.c - the port to copy: it compiles, links and does nothing.
 *
 * Write these six for your machine; the contract of each stands in platform.h. The game is there after the first two
 * that matter, plat_show and plat_poll. Then, if stdio.c's defaults do not suit, add any of plat_rgb, plat_fit,
 * plat_window, plat_paint, plat_icon, plat_dropped, plat_key_label, plat_controller, plat_sound, plat_path,
 * plat_size, plat_load, plat_same, plat_save, plat_append, plat_remove, plat_list, plat_name, plat_program,
 * plat_program_path, plat_alert, plat_beside, plat_runnable, plat_crash, plat_about, plat_system and plat_log to your
 * file: yours win at the link.
 *
 * src/cab/main.c is the loop. Where the host has one, leave that out of the link, and call program_open, program_frame
 * and program_close from here.
 */
#include <string.h>
#include "platform.h"

static uint64_t now;

/* Open the window or the screen; get the speaker ready when want->rate is not 0, and go on without when there is none.
 * Called again on an open port it changes what differs: that is how fullscreen is switched. */
bool plat_open(const struct plat_want *want)
{
    (void)want;
    return true;
}

/* Undo plat_open. It may come twice, or without an open. */
void plat_close(void)
{
}

/* Set a bit of in->keys for each key by its USB HID usage: keep two bitmaps, `down` from press and release, `seen` from
 * presses; hand out down | seen and clear seen. Hosts with other key numbers keep one table from theirs to HID here.
 * This one asks to quit, so that what you have so far ends. */
void plat_poll(struct plat_input *in)
{
    memset(in, 0, sizeof *in);
    in->focus = true;
    in->mouse_x = in->mouse_y = -1;
    in->quit = true;
}

/* Write rgb[pix[y * pitch + x]] to the screen, every pixel a square of the same whole size, in the middle, black around
 * it; plat_rgb turns a picture into colours where the screen takes 32 bits a pixel. Hardware with a palette of 256
 * takes pix and rgb as they are. Waiting for the vertical blank here is fine. */
void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    (void)pix;
    (void)pitch;
    (void)w;
    (void)h;
    (void)rgb;
}

/* Read a timer. This clock moves only when waited for: everything runs as fast as it can. */
uint64_t plat_usec(void)
{
    return now;
}

/* Sleep until then, to the millisecond or better. */
void plat_wait(uint64_t until)
{
    if (until > now)
        now = until;
}
