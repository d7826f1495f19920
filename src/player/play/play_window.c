/*
 * play_window.c - the window: opening it as the settings say, and showing pictures in it.
 *
 * A picture goes to plat_show, rotated if necessary, as long as the port can show it that way: this costs least, and
 * every port has it. Otherwise the whole window is composed here (picture/), if the port reports the window's size.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "play_state.h"
#include "../picture/png.h"
#include "../picture/icon.h"

/* ---- the border ---- */

static void free_border(struct play_window *w)
{
    free(w->border_rgba);
    w->border_rgba = NULL;
    w->border = (struct border){ 0 };
    compose_close(&w->compose); /* it contains the old border */
}

/* Reads the border of the running ROM, once. Reports a damaged border. */
static void read_border(struct play *play)
{
    struct play_window *window = &play->window;
    const struct rom *rom = play_cart(play)->rom;
    const int i = rom_find(rom, BORDER_LUMP);
    struct lump lump;
    char why[256];
    int w, h;

    if (window->border_read && window->border_crc == rom->crc)
        return;
    free_border(window);
    window->border_read = true;
    window->border_crc = rom->crc;
    if (i < 0)
        return;
    rom_lump(rom, i, &lump);
    if (png_read(lump.data, lump.size, &window->border_rgba, &w, &h, why, sizeof why) &&
        border_open(&window->border, window->border_rgba, w, h, why, sizeof why))
        return;
    play_log(play, "curtain: %s: cannot show the border: %s", play_game_name(play), why);
    free_border(window);
}

/* ---- opening ---- */

int play_sound_rate(struct play *play)
{
    return board_has_sound(play_board(play)) && (!play->speaker.muted || play->window.config.sound_rate) ? SPEAKER_RATE
                                                                                                         : 0;
}

/* Sets the icon of the running ROM, once. */
static void show_icon(struct play_window *w, const struct cart *cart)
{
    if (w->has_icon && w->icon_crc == cart->rom->crc)
        return;
    w->has_icon = true;
    w->icon_crc = cart->rom->crc;
    icon_show(cart);
}

void play_window_configure(struct play *play, int w, int h, const char *title)
{
    struct plat_config *config = &play->window.config;
    const struct config *c = &play->config;

    config->w = w;
    config->h = h;
    rotation_size((enum rotation)c->rotation, &config->w, &config->h);
    config->scale = c->scale;
    config->fullscreen = c->fullscreen;
    snprintf(play->window.title, sizeof play->window.title, "%s", title); /* a manifest's is freed at a reload */
    config->title = play->window.title;
}

bool play_open_window(struct play *play)
{
    const struct manifest *m = &play_cart(play)->manifest;
    struct plat_config *config = &play->window.config;
    const struct config *c = &play->config;

    play_window_configure(play, m->screen_w, m->screen_h, m->title);
    config->sound_rate = play_sound_rate(play);
    config->fractional = c->scaling == SCALING_SMOOTH;
    config->vsync = c->vsync && !play->speaker.exact; /* with exact sound the card's clock sets the pace */
    play->window.cannot_compose = false;
    if (!plat_open(config))
        return false;
    show_icon(&play->window, play_cart(play));
    return true;
}

void play_update_window(struct play *play)
{
    play->quit = !play_open_window(play) || play->quit;
}

void play_toggle_fullscreen(struct play *play)
{
    play->config.fullscreen = !play->config.fullscreen;
    if (play->session.now) {
        play_update_window(play);
        return;
    }
    play->window.config.fullscreen = play->config.fullscreen;
    play->quit = !plat_open(&play->window.config) || play->quit;
}

void play_set_text_input(struct play *play, bool on)
{
    if (play->window.config.text_input == on)
        return;
    play->window.config.text_input = on;
    play_update_window(play);
}

void play_window_close(struct play_window *w)
{
    free_border(w);
    free(w->rotated);
    free(w->side_memory);
    *w = (struct play_window){ 0 };
}

/* ---- before a picture is drawn ---- */

static bool covers_window(const struct placed *p, int w, int h)
{
    return p->picture.x <= 0 && p->picture.y <= 0 && p->picture.w >= w && p->picture.h >= h;
}

/* Returns whether plat_show cannot show the picture with these options. */
static bool must_compose(const struct compose_options *options)
{
    const struct placed placed = place(&options->place);

    return options->place.smooth || options->crt || (options->place.side_panel && placed.side.w) ||
           (options->border && !covers_window(&placed, options->place.window_w, options->place.window_h));
}

/* Allocates the area next to the picture. */
static void allocate_side(struct play_window *w)
{
    const struct placed *p = &w->compose.placed;

    w->has_side = false;
    if (!p->side.w)
        return;
    if (w->side.w != p->side_w || w->side.h != p->side_h) {
        free(w->side_memory);
        w->side = (struct fb){ 0 };
        w->side_memory = malloc(fb_size(p->side_w, p->side_h));
        if (!w->side_memory)
            return;
        fb_init(&w->side, w->side_memory, p->side_w, p->side_h);
    }
    w->has_side = true;
}

void play_window_begin(struct play *play, int w, int h)
{
    struct play_window *window = &play->window;
    const struct config *c = &play->config;
    struct plat_window host = { 0 };
    const bool known = plat_get_window(&host);

    window->refresh = known && host.vsync ? host.refresh_rate : 0;
    window->will_compose = window->has_side = false;
    if (!known || window->cannot_compose)
        return;
    if (c->border)
        read_border(play);
    const struct compose_options options = { .place = { host.w, host.h, w, h, (enum rotation)c->rotation,
                                                        c->scaling == SCALING_SMOOTH, c->panels == PANELS_BESIDE },
                                             .crt = c->crt,
                                             .border = c->border && window->border.rgba ? &window->border : NULL };
    if (!must_compose(&options))
        return;
    window->will_compose = compose_prepare(&window->compose, &options);
    window->cannot_compose = !window->will_compose;
    if (window->will_compose)
        allocate_side(window);
}

struct fb *play_window_side(struct play_window *w)
{
    return w->has_side ? &w->side : NULL;
}

/* ---- showing ---- */

static bool show_composed(struct play_window *w, const struct fb *fb, const uint32_t rgb[256], bool side)
{
    struct compose *c = &w->compose;

    compose_picture(c, fb->pix, fb->pitch, rgb);
    compose_side(c, side ? w->side.pix : NULL, w->side.pitch, rgb);
    w->handed_over = plat_usec();
    return plat_paint(c->pixels, c->w, c->w, c->h);
}

/* Returns memory for a rotated picture, or NULL when out of memory. */
static uint8_t *rotated_memory(struct play_window *w, size_t size)
{
    if (size > w->rotated_size) {
        free(w->rotated);
        w->rotated = malloc(size);
        w->rotated_size = w->rotated ? size : 0;
    }
    return w->rotated;
}

static void show_plain(struct play_window *window, enum rotation rotation, const struct fb *fb, const uint32_t rgb[256])
{
    uint8_t *rotated = rotation ? rotated_memory(window, (size_t)fb->w * (size_t)fb->h) : NULL;
    const uint8_t *pix = fb->pix;
    int w = fb->w, h = fb->h, pitch = fb->pitch;

    window->shown_rotation = rotated ? rotation : ROTATION_NONE;
    if (rotated) {
        rotation_size(rotation, &w, &h);
        rotation_picture(rotation, fb->pix, fb->pitch, fb->w, fb->h, rotated, w);
        pix = rotated;
        pitch = w;
    }
    window->handed_over = plat_usec();
    plat_show(pix, pitch, w, h, rgb);
}

void play_window_show(struct play *play, const struct fb *fb, const uint32_t rgb[256], bool side)
{
    struct play_window *w = &play->window;

    w->w = fb->w;
    w->h = fb->h;
    w->composed = w->will_compose && show_composed(w, fb, rgb, side && w->has_side);
    if (w->composed)
        return;
    w->cannot_compose = w->cannot_compose || w->will_compose; /* until the window is opened again */
    show_plain(w, (enum rotation)play->config.rotation, fb, rgb);
}

void play_window_mouse(const struct play_window *window, int *x, int *y)
{
    int w = window->w, h = window->h;

    if (*x < 0 || *y < 0 || !w)
        return;
    if (window->composed) {
        if (!compose_to_picture(&window->compose, x, y))
            *x = *y = -1;
        return;
    }
    rotation_size(window->shown_rotation, &w, &h);
    rotation_point(rotation_inverse(window->shown_rotation), w, h, x, y);
}
