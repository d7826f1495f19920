/*
 * cab_wait.c - a game's folder that cannot be played as it is, from the start, or settings that cannot be read: the
 * window says why, in full, and the game begins as soon as the folder or the file is right.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../../common/clean.h"
#include "../overlay/page.h"

enum {
    PAGE_W = 400, /* px: there is no game yet that would say how large the picture is */
    PAGE_H = 300,
    LOOK_EVERY = 15 /* frames between two looks at the folder */
};

static bool open_page(struct cab *cab)
{
    struct picture *p = &cab->picture;

    cab_picture_close(p);
    if (!cab_picture_alloc(p, PAGE_W, PAGE_H))
        return false;
    snprintf(cab->title, sizeof cab->title, "Curtain");
    cab->want.w = PAGE_W;
    cab->want.h = PAGE_H;
    quarter_size((enum quarter)cab->config.turn, &cab->want.w, &cab->want.h);
    cab->want.sound_rate = 0;
    cab->want.scale = cab->config.scale;
    cab->want.fullscreen = cab->config.fullscreen;
    cab->want.title = cab->title;
    return plat_open(&cab->want);
}

/* Why there is no game. */
static void tell(struct cab *cab, const char *why, const char *more)
{
    struct waiting *w = &cab->waiting;

    snprintf(w->why, sizeof w->why, "%s", why);
    snprintf(w->more, sizeof w->more, "%s", more);
    clean_lines(w->why);
    clean_lines(w->more);
    w->top = 0;
    cab_say(cab, "curtain: %s", w->why);
    if (w->more[0])
        plat_log(w->more);
}

static bool show(struct cab *cab, const char *why, const char *more)
{
    tell(cab, why, more);
    cab->result = RESULT_REFUSED;
    return cab->picture.memory || open_page(cab);
}

bool cab_wait_settings(struct cab *cab, const char *why)
{
    struct waiting *w = &cab->waiting;

    w->on = w->settings = show(cab, why, "");
    return w->on;
}

bool cab_wait(struct cab *cab, const char *why, const char *more)
{
    struct waiting *w = &cab->waiting;

    if (!show(cab, why, more))
        return false;
    if (!w->on)
        folder_open(&cab->folder, cab->options.path);
    w->on = true;
    cab_say(cab, "curtain: %s: waiting for a file to change", cab->options.path);
    return true;
}

static void draw(struct cab *cab)
{
    char title[FILES_PATH_SIZE + 64];
    struct picture *p = &cab->picture;
    struct waiting *w = &cab->waiting;
    struct canvas canvas;
    struct page page = { title, w->why, w->more,
                         w->settings ? "Fix and save the file to continue. Enter: play with default settings (the file "
                                       "is not changed). Escape: quit."
                         : w->looks  ? "Checking the changes"
                                     : "Fix and save the file to continue. Escape: quit.",
                         .top = w->top };

    if (w->settings)
        snprintf(title, sizeof title, "Cannot read the settings");
    else
        snprintf(title, sizeof title, "Cannot play %s", cab->options.path);
    memset(p->composed_rgb, 0, sizeof p->composed_rgb);
    fb_fill(&p->composed, 0);
    canvas_open(&canvas, &p->composed, p->composed_rgb);
    canvas_rect(&canvas, 0, 0, PAGE_W, PAGE_H, CANVAS_DARK);
    page_draw(&canvas, &page);
    w->most = page.most;
    cab_window_show(cab, &p->composed, p->composed_rgb, false);
}

/* The settings are right, or those that are standard do. */
static void end_settings(struct cab *cab)
{
    cab->waiting.on = cab->waiting.settings = false;
    cab_begin(cab);
}

/* Looks at the settings' file again. */
static void try_settings(struct cab *cab)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];

    if (config_load(&cab->config, err, sizeof err))
        end_settings(cab);
    else if (strcmp(err, cab->waiting.why) != 0)
        tell(cab, err, "");
}

static void poll(struct cab *cab)
{
    struct plat_input in;
    struct keys_read k;
    const uint32_t leaves = (uint32_t)1 << CAB_QUIT | (uint32_t)1 << CAB_MENU;

    plat_poll(&in);
    cab_seats_poll(cab, &in);
    keys_read(&cab->config.keys, &in, &cab->seats, &k);
    cab->quit = cab->quit || in.quit || k.pressed & leaves || plat_is_key_held(&in, KEY_ESCAPE);
    if (k.pressed & (uint32_t)1 << CAB_FULLSCREEN) {
        cab->config.fullscreen = !cab->config.fullscreen;
        cab->want.fullscreen = cab->config.fullscreen;
        cab->quit = !plat_open(&cab->want) || cab->quit;
    }
    cab_scroll(cab, &cab->waiting.top, cab->waiting.most, k.pads[0], in.wheel);
    cab_drop(cab);
    if (cab->waiting.settings && !cab->quit && (plat_is_key_held(&in, KEY_ENTER) || k.pads[0] & PAD_START))
        end_settings(cab);
}

/* The folder has changed: the game, or another sentence. */
static void try_again(struct cab *cab)
{
    char err[FILES_ERR_SIZE];
    enum cab_opened opened = cab->options.open(cab->options.user, &cab->options, err, sizeof err);

    if (opened == CAB_OPENED) {
        cab->start = cab->options.start;
        cab->waiting.on = !cab_power(cab);
    } else if (opened == CAB_WRONG)
        cab->quit = !cab_wait(cab, err, "") || cab->quit;
    else {
        cab_say(cab, "curtain: %s", err);
        cab->quit = true;
    }
}

static void look_at_folder(struct cab *cab)
{
    struct waiting *w = &cab->waiting;

    if (w->looks) {
        w->looks = false;
        try_again(cab);
    } else if (++cab->since_check >= LOOK_EVERY) {
        cab->since_check = 0;
        w->looks = folder_changed(&cab->folder);
    }
}

static void look_at_settings(struct cab *cab)
{
    if (++cab->since_check < LOOK_EVERY)
        return;
    cab->since_check = 0;
    try_settings(cab);
}

void cab_wait_frame(struct cab *cab)
{
    const struct waiting *w = &cab->waiting;

    poll(cab);
    if (w->on && !cab->quit) {
        if (w->settings)
            look_at_settings(cab);
        else
            look_at_folder(cab);
    }
    if (w->on && !cab->quit)
        draw(cab);
}
