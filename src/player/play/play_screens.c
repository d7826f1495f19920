/*
 * play_screens.c - the program's screens during play: keys and requests that open them, and games dropped on the
 * window.
 */
#include <stdio.h>
#include <string.h>
#include "play_state.h"
#include "../../../platform/platform.h"

void play_open_requested(struct play *play, enum board_host_screen screen)
{
    if (play->session.demo || play->attract.on || play->session.state != SESSION_PLAYING)
        return;
    switch (screen) {
    case HOST_SCREEN_SETTINGS:
        play_open_settings(play);
        break;
    case HOST_SCREEN_KEYS:
        play_open_keys(play);
        break;
    case HOST_SCREEN_REPLAYS:
        play_open_replays(play);
        break;
    case HOST_SCREEN_PRACTICE:
        play_open_practice(play);
        break;
    case HOST_SCREEN_QUIT:
        play_quit(play);
        break;
    default:
        play_open_menu(play);
    }
}

/* Pauses when the window loses focus or is minimized. A host that never reports focus isn't affected. */
static void check_focus(struct play *play, const struct plat_input *in)
{
    const bool focus = in->has_focus && !in->hidden, lost = play->had_focus && !focus;

    play->had_focus = focus;
    if (!lost || !play->config.away || play->attract.on || play->console.open || play->prompt.open)
        return;
    if (play->session.demo)
        play->time.paused = true;
    else if (!play_fault(play))
        play_open_menu(play);
}

/* The keys that open a screen, while none is open. */
static void open_by_key(struct play *play, const struct keys_state *k)
{
    if (play->console.open)
        return;
    if (keys_pressed(k, HOTKEY_HELP))
        play_open_keys(play);
    else if (keys_pressed(k, HOTKEY_LOG))
        play_open_log(play);
    else if (keys_pressed(k, HOTKEY_MENU) && play_page_leads_back(play))
        play->pads.held[0] |= board_last_output(play_board(play))->back;
    else if (keys_pressed(k, HOTKEY_MENU))
        play_open_menu(play);
}

/* The same keys while a screen is open: the key's screen replaces the others, or is closed. */
static void toggle_by_key(struct play *play, const struct keys_state *k)
{
    const bool help = keys_pressed(k, HOTKEY_HELP), practice = keys_pressed(k, HOTKEY_PRACTICE);
    const struct screen_def *screen = help ? &keys_screen : &practice_screen;

    if (help || practice) {
        const bool was_open = screens_contain(&play->screens, screen);
        screens_close_all(&play->screens);
        if (!was_open && help)
            play_open_keys(play);
        else if (!was_open)
            play_open_practice(play);
    } else if (keys_pressed(k, HOTKEY_LOG)) {
        log_toggle(&play->log, &play->screens);
    }
}

bool play_screen_keys(struct play *play, const struct plat_input *in, struct keys_state *k)
{
    const bool was_open = screens_are_open(&play->screens);

    play_translate_screens(play);
    if (was_open) {
        const bool practice = screens_top(&play->screens) == &practice_screen;
        const bool listened = screens_poll(&play->screens, in, k);
        if (practice)
            play_practice_poll(play);
        if (listened)
            k->pressed = 0;
        toggle_by_key(play, k);
    } else {
        check_focus(play, in);
        if (!screens_are_open(&play->screens))
            open_by_key(play, k);
    }
    if (!was_open && !screens_are_open(&play->screens))
        return false;
    memcpy(play->pads.ignored, k->pads, sizeof play->pads.ignored);
    memset(play->pads.held, 0, sizeof play->pads.held);
    return true;
}

/* ---- games dropped on the window ---- */

static void play_dropped(void *context)
{
    struct play *play = context;

    snprintf(play->drop.accepted, sizeof play->drop.accepted, "%s", play->drop.asked);
    play->quit = true;
}

static bool can_be_played(struct play *play, const char *path)
{
    char err[FILES_ERR_SIZE];
    struct session_rom *rom = session_rom_load(play->options.load, path, play->options.nearest, err, sizeof err);

    if (!rom)
        play_warn(play, "%s", err);
    session_rom_free(rom);
    return rom != NULL;
}

void play_check_drop(struct play *play)
{
    char path[FILES_PATH_SIZE];

    if (!plat_take_dropped_file(path, sizeof path))
        return;
    if (files_has_suffix(path, ".demo") && !play->waiting.on) {
        play_import_replay(play, path);
        return;
    }
    if (play->options.sealed || !can_be_played(play, path))
        return;
    snprintf(play->drop.asked, sizeof play->drop.asked, "%s", path);
    if (play->waiting.on || !play_has_run(play))
        play_dropped(play);
    else
        screens_ask(&play->screens,
                    play_is_resumable(play) ? "Play another game? You can resume this run next time."
                                            : "Play another game and lose this run?",
                    "Play", play_dropped, play);
}
