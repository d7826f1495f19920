/*
 * cab_keys.c - the switches: what each of the cabinet's own does, and which go to the game.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"
#include "timebar.h"

enum { MAX_SLOW = 4 };

static void reopen(void)
{
    cab.want.fullscreen = !cab.want.fullscreen;
    cab.quit = !cab_open_window() || cab.quit;
}

static void cabinet_keys(const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_QUIT) {
        cab.quit = !cab.practice.open;
        cab.practice.open = false;
    }
    if (k->pressed & 1 << CAB_FULLSCREEN)
        reopen();
    if (k->pressed & 1 << CAB_MUTE)
        cab.speaker.muted = !cab.speaker.muted;
    if (k->pressed & 1 << CAB_PAUSE)
        cab.paused = !cab.paused;
    if (k->pressed & 1 << CAB_STEP)
        cab.paused = cab.step = true;
    if (k->pressed & 1 << CAB_SLOW) {
        cab_assisted();
        cab.slow = cab.slow == MAX_SLOW ? 1 : cab.slow * 2;
    }
    if (k->pressed & 1 << CAB_SCREENSHOT)
        cab_screenshot(&cab.picture);
}

/* Those that go to and fro in time. */
static void time_keys(const struct keys_read *k)
{
    const struct session *s = &cab.session;
    uint32_t now = s->way == SESSION_SEEKS ? s->to : board_frame(cab_live()); /* pressed twice, it leads twice as far */

    if (cab.attracting)
        return;
    if (k->pressed & 1 << CAB_BACK) {
        cab.paused = true;
        cab_go_back(1);
    }
    if (k->pressed & 1 << CAB_BEFORE)
        cab_go(timebar_before(&cab.session, now));
    if (k->pressed & 1 << CAB_AFTER)
        cab_go(timebar_after(&cab.session, now));
    if (k->pressed & 1 << CAB_TAKE_OVER)
        cab_take_over();
    if (k->pressed & 1 << CAB_RELOAD)
        cab_reload();
}

/* In a playback, and wherever the bar is shown, a click on it leads there. */
static void mouse(const struct plat_input *in)
{
    uint32_t frame;
    bool held = in->mouse & 1, pressed = held && !cab.mouse;

    cab.mouse = held;
    if (cab.attracting || cab.console.open || !(cab.session.demo || cab_bar_shown()) ||
        !timebar_at(&cab.session, cab.picture.fb.w, cab.picture.fb.h, in->mouse_x, in->mouse_y, &frame))
        return;
    cab.bar = cab.bar ? cab.bar : 1;
    if (pressed || (held && cab.session.way == SESSION_THERE && frame != board_frame(cab_live())))
        cab_go(frame);
}

/* True while a frame is asked for: the keys are for that, and time stands still. */
static bool ask(const struct plat_input *in)
{
    uint32_t frame;

    if (!cab.ask.open)
        return false;
    if (ask_poll(&cab.ask, in, &frame)) {
        cab.paused = true;
        cab_go(frame);
    }
    return true;
}

/* Buttons gather until a tick has seen them. */
static void take_pads(const struct keys_read *k)
{
    for (int i = 0; i < PADS; i++) {
        cab.stale[i] &= k->pads[i];
        cab.pads[i] |= (uint16_t)(k->pads[i] & ~cab.stale[i]);
    }
}

/* While the console is open it has all keys. Scores are saved before a line can touch them. */
static void console_keys(const struct plat_input *in, struct keys_read *k)
{
    bool stands = !cab_fault() && !cab.attracting && !cab.practice.open && cab.session.way == SESSION_THERE;
    if (k->pressed & 1 << CAB_CONSOLE)
        cab_save_nvram();
    console_poll(&cab.console, in, k, stands ? cab_live() : NULL, !cab.session.demo);
    if (console_kept(&cab.console)) {
        cab_wrote(session_touch(&cab.session));
        practice_void(&cab.practice);
    }
    if (cab.want.text == cab.console.open)
        return;
    cab.want.text = cab.console.open;
    cab.quit = !cab_open_window() || cab.quit;
}

void cab_poll(struct keys_read *k)
{
    struct plat_input in;
    plat_poll(&in);
    cab.mouse_x = in.mouse_x;
    cab.mouse_y = in.mouse_y;
    cab.quit = cab.quit || in.quit;
    keys_read(&cab.config.keys, &in, k); /* also while a frame is asked for: what closes that is not to be read then */
    if (ask(&in)) {
        memset(k, 0, sizeof *k);
        return;
    }
    console_keys(&in, k);
    overlay_keys(&cab.overlay, k->pressed);
    take_pads(k);
    cabinet_keys(k);
    cab_practice_keys(k);
    if (cab.practice.open)
        return;
    time_keys(k);
    if (k->pressed & 1 << CAB_GOTO && !cab.attracting)
        ask_open(&cab.ask, &in);
    mouse(&in);
    if (cab.attracting && k->fresh)
        cab_attract_end();
}
