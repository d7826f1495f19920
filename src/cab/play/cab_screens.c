/*
 * cab_screens.c - the cabinet's own screens in a run: who opens them, what they read, and what settings do at once.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"
#include "../../../platform/platform.h"

bool cab_run_is_on(void)
{
    const bool menu = board_last(cab_live())->menu && !cab.keep.on;

    return !cab.session.demo && !cab_fault() && board_frame(cab_live()) > 0 && !menu;
}

/* Other settings than these are read where they are used. */
void cab_apply_settings(void)
{
    const struct config *c = &cab.config;
    const int slow = 1 << c->speed;

    cab_pads_apply();
    cab.speaker.volume = c->volume;
    cab.speaker.muted = c->mute;
    speaker_levels(&cab.speaker, c->music, c->sounds);
    if (slow != cab.slow)
        cab_mark_assisted();
    cab.slow = slow;
    cab.quit = !cab_open_window() || cab.quit;
}

static void open_asked(enum board_ask what)
{
    switch (what) {
    case ASK_SETTINGS:
        cab_open_settings();
        break;
    case ASK_KEYS:
        cab_open_keys();
        break;
    case ASK_REPLAYS:
        cab_open_replays();
        break;
    case ASK_PRACTICE:
        cab_open_practice();
        break;
    default:
        cab_open_menu();
    }
}

void cab_asked(enum board_ask what)
{
    if (!cab.session.demo && !cab.attracting && cab.session.state == SESSION_PLAYING)
        open_asked(what);
}

/* Who goes away does not want to play: a change from focus to none stops, and so does a window that is made small. A
 * host that never has focus runs. */
static void heed_focus(const struct plat_input *in)
{
    const bool here = in->focus && !in->hidden, left = cab.here && !here;

    cab.here = here;
    if (!left || !cab.config.away || cab.attracting || cab.console.open || cab.prompt.open)
        return;
    if (cab.session.demo)
        cab.paused = true;
    else if (!cab_fault())
        cab_open_menu();
}

void cab_open_log(void)
{
    if (cab.attracting)
        cab_attract_end();
    log_open(&cab.log, &cab.screens);
}

/* The keys that open a screen, while none is open. */
static void opening_keys(const struct keys_read *k)
{
    if (cab.console.open)
        return;
    if (k->pressed & (uint32_t)1 << CAB_HELP)
        cab_open_keys();
    else if (k->pressed & (uint32_t)1 << CAB_LOG)
        cab_open_log();
    else if (k->pressed & (uint32_t)1 << CAB_MENU)
        cab_open_menu();
}

bool cab_screen_keys(const struct plat_input *in, struct keys_read *k)
{
    const bool were = screens_are_open(&cab.screens);

    if (were) {
        const bool practice = screens_top(&cab.screens) == &practice_screen;
        const bool listened = screens_poll(&cab.screens, in, k);
        if (practice)
            cab_practice_screen();
        if (listened)
            k->pressed = 0;
        if (k->pressed & ((uint32_t)1 << CAB_HELP | (uint32_t)1 << CAB_PRACTICE))
            screens_close_all(&cab.screens);
        else if (k->pressed & (uint32_t)1 << CAB_LOG)
            log_turn(&cab.log, &cab.screens);
    } else {
        heed_focus(in);
        if (!screens_are_open(&cab.screens))
            opening_keys(k);
    }
    if (!were && !screens_are_open(&cab.screens))
        return false;
    memcpy(cab.stale, k->pads, sizeof cab.stale);
    memset(cab.pads, 0, sizeof cab.pads);
    return true;
}

/* ---- a game that is dropped on the window ---- */

static void play_dropped(void *path)
{
    snprintf(cab.dropped, sizeof cab.dropped, "%s", (const char *)path);
    cab.quit = true;
}

static bool can_be_played(const char *path)
{
    char err[FILES_ERR];
    struct session_rom *rom = session_rom_load(path, cab.options.nearest, err, sizeof err);

    if (!rom) {
        cab_notice(CAB_NOTICE_FRAMES, "%s", err);
        cab_say("curtain: %s", err);
    }
    session_rom_free(rom);
    return rom != NULL;
}

void cab_drop(void)
{
    static char asked[FILES_PATH]; /* the question outlives this call */
    char path[FILES_PATH];

    if (!plat_dropped(path, sizeof path) || cab.options.sealed || !can_be_played(path))
        return;
    snprintf(asked, sizeof asked, "%s", path);
    if (cab.waiting.on || !cab_run_is_on())
        play_dropped(path);
    else
        screens_ask(&cab.screens,
                    cab.keep.on && cab.keep.spare ? "Another game begins. The run that is on is kept for next time."
                                                  : "Another game begins. The run that is on is lost.",
                    "play it", play_dropped, asked);
}

/* The player's own switch for it; one that no setting takes away, where the keyboard has none. */
static void foot_switch(const char *action, const char *always, char *name, size_t size)
{
    keys_first(&cab.config.keys, action, name, size);
    if (!cab.config.keys.player[0].controller && (strncmp(name, "pad", 3) == 0 || strcmp(name, "none") == 0))
        snprintf(name, size, "%s", always);
}

void cab_screens_foot(char *text, size_t size)
{
    char yes[32], no[32];

    foot_switch("p1.fire", "enter", yes, sizeof yes);
    foot_switch("p1.bomb", "escape", no, sizeof no);
    snprintf(text, size, "%s: choose  %s: back", yes, no);
}
