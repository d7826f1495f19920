/*
 * play_wait.c - a game's folder that can't be played from the start, or settings that can't be read: the window shows
 * the whole error, and the game starts as soon as the folder or the file is fixed.
 */
#include <stdio.h>
#include <string.h>
#include "../input/input_code.h"
#include "../../../platform/platform.h"
#include "play_state.h"
#include "../../common/clean.h"
#include "../overlay/page.h"

enum {
    PAGE_W = 400, /* px: there is no game yet that sets the picture's size */
    PAGE_H = 300,
    CHECK_EVERY = 15 /* frames between two checks of the folder or the file */
};

static bool open_page(struct play *play)
{
    struct picture *p = &play->drawing.picture;

    if (p->memory)
        return true;
    picture_close(p);
    if (!picture_alloc(p, PAGE_W, PAGE_H))
        return false;
    play_window_configure(play, PAGE_W, PAGE_H, "Curtain");
    play->window.config.sound_rate = 0;
    return plat_open(&play->window.config);
}

static void set_error(struct play *play, const char *why, const char *more)
{
    struct waiting *w = &play->waiting;

    snprintf(w->why, sizeof w->why, "%s", why);
    snprintf(w->details, sizeof w->details, "%s", more);
    clean_lines(w->why);
    clean_lines(w->details);
    w->top = 0;
    play_log(play, "curtain: %s", w->why);
    if (w->details[0])
        plat_log(w->details);
    play->result = RESULT_REFUSED;
}

bool play_wait_for_settings(struct play *play, const char *why)
{
    struct waiting *w = &play->waiting;

    set_error(play, why, "");
    w->on = w->settings = open_page(play);
    return w->on;
}

bool play_wait_for_folder(struct play *play, const char *why, const char *more)
{
    struct waiting *w = &play->waiting;

    set_error(play, why, more);
    if (!open_page(play))
        return false;
    if (!w->on)
        folder_open(&play->reload.folder, play->options.path);
    w->on = true;
    play_log(play, "curtain: %s: waiting for a file to change", play->options.path);
    return true;
}

static void draw(struct play *play)
{
    char title[FILES_PATH_SIZE + 64];
    struct picture *p = &play->drawing.picture;
    struct waiting *w = &play->waiting;
    struct canvas canvas;
    struct page page = { title, w->why, w->details,
                         w->settings   ? "Fix and save the file to continue. Enter: play with default settings (the "
                                         "file is not changed). Escape: quit."
                         : w->checking ? "Checking the changes"
                                       : "Fix and save the file to continue. Escape: quit.",
                         .top = w->top };

    if (w->settings)
        snprintf(title, sizeof title, "Cannot read the settings");
    else
        snprintf(title, sizeof title, "Cannot play %s", play->options.path);
    memset(p->composed_rgb, 0, sizeof p->composed_rgb);
    fb_fill(&p->composed, 0);
    canvas_open(&canvas, &p->composed, p->composed_rgb);
    canvas_rect(&canvas, 0, 0, PAGE_W, PAGE_H, CANVAS_DARK);
    page_draw(&canvas, &page);
    w->max_top = page.max_top;
    play_window_show(play, &p->composed, p->composed_rgb, false);
}

/* Starts with the settings as they were read, or with the defaults. */
static void end_settings(struct play *play)
{
    play->waiting.on = play->waiting.settings = false;
    play_start(play);
}

static void try_settings(struct play *play)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];

    if (config_load(&play->config, err, sizeof err))
        end_settings(play);
    else if (strcmp(err, play->waiting.why) != 0)
        set_error(play, err, "");
}

static void poll(struct play *play)
{
    struct plat_input in;
    struct keys_state k;

    plat_poll(&in);
    play_poll_controllers(play, &in);
    keys_read(&play->config.keys, &in, &play->pads.controllers, &k);
    play->quit = play->quit || in.quit || keys_pressed(&k, HOTKEY_QUIT) || keys_pressed(&k, HOTKEY_MENU) ||
                 plat_is_key_held(&in, KEY_ESCAPE);
    if (keys_pressed(&k, HOTKEY_FULLSCREEN))
        play_toggle_fullscreen(play);
    play_scroll(play, &play->waiting.top, play->waiting.max_top, k.pads[0], in.wheel);
    play_check_drop(play);
    if (play->waiting.settings && !play->quit && (plat_is_key_held(&in, KEY_ENTER) || k.pads[0] & PAD_START))
        end_settings(play);
}

/* The folder has changed: starts the game, or shows the next error. */
static void try_folder(struct play *play)
{
    char err[FILES_ERR_SIZE];

    switch (play->options.open(play->options.user, &play->options, err, sizeof err)) {
    case PLAY_OPENED:
        play->start = play->options.start;
        play->waiting.on = !play_power_on(play);
        break;
    case PLAY_BROKEN_FOLDER:
        play->quit = !play_wait_for_folder(play, err, "") || play->quit;
        break;
    case PLAY_BAD_ARGUMENTS:
        play_log(play, "curtain: %s", err);
        play->quit = true;
    }
}

static void check(struct play *play)
{
    struct waiting *w = &play->waiting;
    struct play_reload *r = &play->reload;

    if (w->checking) {
        w->checking = false;
        try_folder(play);
        return;
    }
    if (++r->frames_since_check < CHECK_EVERY)
        return;
    r->frames_since_check = 0;
    if (w->settings)
        try_settings(play);
    else
        w->checking = folder_changed(&r->folder);
}

void play_wait_frame(struct play *play)
{
    const struct waiting *w = &play->waiting;

    poll(play);
    if (w->on && !play->quit)
        check(play);
    if (w->on && !play->quit)
        draw(play);
}
