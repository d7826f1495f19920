/*
 * cab_screens.c - the cabinet's own screens in a run: who opens them, what they read, and what settings do at once.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"
#include "../../../platform/platform.h"

static void open_asked(struct cab *cab, enum board_host_screen what)
{
    switch (what) {
    case HOST_SCREEN_SETTINGS:
        cab_open_settings(cab);
        break;
    case HOST_SCREEN_KEYS:
        cab_open_keys(cab);
        break;
    case HOST_SCREEN_REPLAYS:
        cab_open_replays(cab);
        break;
    case HOST_SCREEN_PRACTICE:
        cab_open_practice(cab);
        break;
    default:
        cab_open_menu(cab);
    }
}

void cab_asked(struct cab *cab, enum board_host_screen what)
{
    if (!cab->session.demo && !cab->attracting && cab->session.state == SESSION_PLAYING)
        open_asked(cab, what);
}

/* Who goes away does not want to play: a change from focus to none stops, and so does a window that is made small. A
 * host that never has focus runs. */
static void heed_focus(struct cab *cab, const struct plat_input *in)
{
    const bool here = in->has_focus && !in->hidden, left = cab->here && !here;

    cab->here = here;
    if (!left || !cab->config.away || cab->attracting || cab->console.open || cab->prompt.open)
        return;
    if (cab->session.demo)
        cab->paused = true;
    else if (!cab_fault(cab))
        cab_open_menu(cab);
}

/* The keys that open a screen, while none is open. */
static void opening_keys(struct cab *cab, const struct keys_read *k)
{
    if (cab->console.open)
        return;
    if (k->pressed & (uint32_t)1 << CAB_HELP)
        cab_open_keys(cab);
    else if (k->pressed & (uint32_t)1 << CAB_LOG)
        cab_open_log(cab);
    else if (k->pressed & (uint32_t)1 << CAB_MENU)
        cab_open_menu(cab);
}

/* The keys of a screen, while some are open: that one comes in their place, or goes. */
static void turning_keys(struct cab *cab, const struct keys_read *k)
{
    const bool help = k->pressed >> CAB_HELP & 1, practice = k->pressed >> CAB_PRACTICE & 1;
    const struct screen_def *screen = help ? &keys_screen : &practice_screen;

    if (help || practice) {
        const bool was = screens_have(&cab->screens, screen);
        screens_close_all(&cab->screens);
        if (!was && help)
            cab_open_keys(cab);
        else if (!was)
            cab_open_practice(cab);
    } else if (k->pressed >> CAB_LOG & 1) {
        log_turn(&cab->log, &cab->screens);
    }
}

bool cab_screen_keys(struct cab *cab, const struct plat_input *in, struct keys_read *k)
{
    const bool were = screens_are_open(&cab->screens);

    if (were) {
        const bool practice = screens_top(&cab->screens) == &practice_screen;
        const bool listened = screens_poll(&cab->screens, in, k);
        if (practice)
            cab_practice_screen(cab);
        if (listened)
            k->pressed = 0;
        turning_keys(cab, k);
    } else {
        heed_focus(cab, in);
        if (!screens_are_open(&cab->screens))
            opening_keys(cab, k);
    }
    if (!were && !screens_are_open(&cab->screens))
        return false;
    memcpy(cab->stale, k->pads, sizeof cab->stale);
    memset(cab->pads, 0, sizeof cab->pads);
    return true;
}

/* ---- a game that is dropped on the window ---- */

static void play_dropped(void *of)
{
    struct cab *cab = of;

    snprintf(cab->dropped, sizeof cab->dropped, "%s", cab->asked);
    cab->quit = true;
}

static bool can_be_played(struct cab *cab, const char *path)
{
    char err[FILES_ERR_SIZE];
    struct session_rom *rom = session_rom_load(cab->options.load, path, cab->options.nearest, err, sizeof err);

    if (!rom) {
        cab_notice(cab, CAB_NOTICE_FRAMES, "%s", err);
        cab_say(cab, "curtain: %s", err);
    }
    session_rom_free(rom);
    return rom != NULL;
}

void cab_drop(struct cab *cab)
{
    char path[FILES_PATH_SIZE];

    if (!plat_take_dropped_file(path, sizeof path) || cab->options.sealed || !can_be_played(cab, path))
        return;
    snprintf(cab->asked, sizeof cab->asked, "%s", path);
    if (cab->waiting.on || !cab_run_is_on(cab))
        play_dropped(cab);
    else
        screens_ask(&cab->screens,
                    cab->keep.on && cab->keep.spare ? "Play another game? You can resume this run next time."
                                                    : "Play another game and lose this run?",
                    "Play", play_dropped, cab);
}
