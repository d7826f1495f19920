/*
 * cab_window.c - the window: how the settings would have it, and what is shown in it, plain by the port or composed
 * here pixel by pixel (picture/).
 *
 * A picture goes to plat_show as long as that can show it: it costs least, and every port has it. A turned one goes
 * there turned. All else is composed for the window as it is at that moment, if the port says how large that is.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../pack/png.h"
#include "../pack/icon.h"

static struct cab_window *const window = &cab.window;

/* ---- the border ---- */

static void drop_border(void)
{
    free(window->border_rgba);
    window->border_rgba = NULL;
    window->border = (struct border){ 0 };
    compose_close(&window->compose); /* it has the one that was */
}

/* Of the ROM that runs; a damaged one is none, and is told. */
static void read_border(void)
{
    const struct rom *rom = cab_cart()->rom;
    const int i = rom_find(rom, BORDER_LUMP);
    struct lump lump;
    char why[256];
    int w, h;

    if (window->border_read && window->border_crc == rom->crc)
        return;
    drop_border();
    window->border_read = true;
    window->border_crc = rom->crc;
    if (i < 0)
        return;
    rom_lump(rom, i, &lump);
    if (png_read(lump.data, lump.size, &window->border_rgba, &w, &h, why, sizeof why) &&
        border_open(&window->border, window->border_rgba, w, h, why, sizeof why))
        return;
    cab_say("curtain: %s: the border is not shown: %s", cab_game(), why);
    drop_border();
}

/* ---- opening ---- */

int cab_sound_rate(void)
{
    return board_has_sound(cab_live()) && (!cab.speaker.muted || cab.want.rate) ? SPEAKER_RATE : 0;
}

/* Of the ROM that runs; a window keeps it. */
static void give_icon(void)
{
    const struct cart *cart = cab_cart();

    if (window->has_icon && window->icon_crc == cart->rom->crc)
        return;
    window->has_icon = true;
    window->icon_crc = cart->rom->crc;
    icon_show(cart);
}

bool cab_open_window(void)
{
    const struct manifest *m = &cab_cart()->m;
    const struct config *c = &cab.config;

    cab.want.rate = cab_sound_rate();
    cab.want.w = m->screen_w;
    cab.want.h = m->screen_h;
    quarter_size((enum quarter)c->turn, &cab.want.w, &cab.want.h);
    cab.want.scale = c->scale;
    cab.want.any = c->scaling == SCALING_SMOOTH;
    cab.want.fullscreen = c->fullscreen;
    cab.want.vsync = c->vsync && !cab.speaker.exact;       /* there the card's clock leads */
    snprintf(cab.title, sizeof cab.title, "%s", m->title); /* the manifest may go */
    cab.want.title = cab.title;
    window->cannot = false;
    if (!plat_open(&cab.want))
        return false;
    give_icon();
    return true;
}

void cab_window_close(void)
{
    drop_border();
    free(window->turned);
    free(window->side_memory);
    *window = (struct cab_window){ 0 };
}

/* ---- before a picture is drawn ---- */

static bool covers(const struct placed *p, int w, int h)
{
    return p->picture.x <= 0 && p->picture.y <= 0 && p->picture.w >= w && p->picture.h >= h;
}

/* Is there more to show than the port can? */
static bool must_compose(const struct compose_want *want)
{
    const struct placed placed = place(&want->place);

    return want->place.smooth || want->crt || (want->place.beside && placed.side.w) ||
           (want->border && !covers(&placed, want->place.window_w, want->place.window_h));
}

/* What stands beside the picture is drawn here. */
static void fit_side(void)
{
    const struct placed *p = &window->compose.placed;

    window->has_side = false;
    if (!p->side.w)
        return;
    if (window->side.w != p->side_w || window->side.h != p->side_h) {
        free(window->side_memory);
        window->side = (struct fb){ 0 };
        window->side_memory = malloc(fb_size(p->side_w, p->side_h));
        if (!window->side_memory)
            return;
        fb_init(&window->side, window->side_memory, p->side_w, p->side_h);
    }
    window->has_side = true;
}

void cab_window_begin(int w, int h)
{
    const struct config *c = &cab.config;
    struct plat_window host = { 0 };
    const bool known = plat_window(&host);

    window->refresh = known && host.waits ? host.refresh : 0;
    window->composes = window->has_side = false;
    if (!known || window->cannot)
        return;
    if (c->border)
        read_border();
    const struct compose_want want = { .place = { host.w, host.h, w, h, (enum quarter)c->turn,
                                                  c->scaling == SCALING_SMOOTH, c->panels == PANELS_BESIDE },
                                       .crt = c->crt,
                                       .border = c->border && window->border.rgba ? &window->border : NULL };
    if (!must_compose(&want))
        return;
    window->composes = compose_fit(&window->compose, &want);
    window->cannot = !window->composes;
    if (window->composes)
        fit_side();
}

struct fb *cab_window_side(void)
{
    return window->has_side ? &window->side : NULL;
}

/* ---- showing ---- */

static bool show_composed(const struct fb *fb, const uint32_t rgb[256], bool side)
{
    struct compose *c = &window->compose;

    compose_picture(c, fb->pix, fb->pitch, rgb);
    compose_side(c, side ? window->side.pix : NULL, window->side.pitch, rgb);
    window->handed = plat_usec();
    return plat_paint(c->pixels, c->w, c->w, c->h);
}

/* Room for a turned picture; NULL: there is none. */
static uint8_t *room_to_turn(size_t size)
{
    if (size > window->turned_room) {
        free(window->turned);
        window->turned = malloc(size);
        window->turned_room = window->turned ? size : 0;
    }
    return window->turned;
}

static void show_plain(const struct fb *fb, const uint32_t rgb[256])
{
    const enum quarter turn = (enum quarter)cab.config.turn;
    uint8_t *turned = turn ? room_to_turn((size_t)fb->w * (size_t)fb->h) : NULL;
    int w = fb->w, h = fb->h;

    window->shown_turn = turned ? turn : QUARTER_NONE;
    if (!turned) {
        window->handed = plat_usec();
        plat_show(fb->pix, fb->pitch, w, h, rgb);
        return;
    }
    quarter_size(turn, &w, &h);
    quarter_picture(turn, fb->pix, fb->pitch, fb->w, fb->h, turned, w);
    window->handed = plat_usec();
    plat_show(turned, w, w, h, rgb);
}

void cab_window_show(const struct fb *fb, const uint32_t rgb[256], bool side)
{
    window->w = fb->w;
    window->h = fb->h;
    window->composed = window->composes && show_composed(fb, rgb, side && window->has_side);
    if (window->composed)
        return;
    window->cannot = window->cannot || window->composes; /* until the window is another */
    show_plain(fb, rgb);
}

void cab_window_mouse(int *x, int *y)
{
    int w = window->w, h = window->h;

    if (*x < 0 || *y < 0 || !w)
        return;
    if (window->composed) {
        if (!compose_point(&window->compose, x, y))
            *x = *y = -1;
        return;
    }
    quarter_size(window->shown_turn, &w, &h);
    quarter_point(quarter_back(window->shown_turn), w, h, x, y);
}
