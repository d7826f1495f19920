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
#include "../picture/png.h"
#include "../picture/icon.h"

/* ---- the border ---- */

static void drop_border(struct cab *cab)
{
    free(cab->window.border_rgba);
    cab->window.border_rgba = NULL;
    cab->window.border = (struct border){ 0 };
    compose_close(&cab->window.compose); /* it has the one that was */
}

/* Of the ROM that runs; a damaged one is none, and is told. */
static void read_border(struct cab *cab)
{
    const struct rom *rom = cab_cart(cab)->rom;
    const int i = rom_find(rom, BORDER_LUMP);
    struct lump lump;
    char why[256];
    int w, h;

    if (cab->window.border_read && cab->window.border_crc == rom->crc)
        return;
    drop_border(cab);
    cab->window.border_read = true;
    cab->window.border_crc = rom->crc;
    if (i < 0)
        return;
    rom_lump(rom, i, &lump);
    if (png_read(lump.data, lump.size, &cab->window.border_rgba, &w, &h, why, sizeof why) &&
        border_open(&cab->window.border, cab->window.border_rgba, w, h, why, sizeof why))
        return;
    cab_say(cab, "curtain: %s: cannot show the border: %s", cab_game(cab), why);
    drop_border(cab);
}

/* ---- opening ---- */

int cab_sound_rate(struct cab *cab)
{
    return board_has_sound(cab_live(cab)) && (!cab->speaker.muted || cab->want.sound_rate) ? SPEAKER_RATE : 0;
}

/* Of the ROM that runs; a window keeps it. */
static void give_icon(struct cab *cab)
{
    const struct cart *cart = cab_cart(cab);

    if (cab->window.has_icon && cab->window.icon_crc == cart->rom->crc)
        return;
    cab->window.has_icon = true;
    cab->window.icon_crc = cart->rom->crc;
    icon_show(cart);
}

bool cab_open_window(struct cab *cab)
{
    const struct manifest *m = &cab_cart(cab)->manifest;
    const struct config *c = &cab->config;

    cab->want.sound_rate = cab_sound_rate(cab);
    cab->want.w = m->screen_w;
    cab->want.h = m->screen_h;
    quarter_size((enum quarter)c->turn, &cab->want.w, &cab->want.h);
    cab->want.scale = c->scale;
    cab->want.fractional = c->scaling == SCALING_SMOOTH;
    cab->want.fullscreen = c->fullscreen;
    cab->want.vsync = c->vsync && !cab->speaker.exact;       /* there the card's clock leads */
    snprintf(cab->title, sizeof cab->title, "%s", m->title); /* the manifest may go */
    cab->want.title = cab->title;
    cab->window.cannot = false;
    if (!plat_open(&cab->want))
        return false;
    give_icon(cab);
    return true;
}

void cab_window_close(struct cab *cab)
{
    drop_border(cab);
    free(cab->window.turned);
    free(cab->window.side_memory);
    cab->window = (struct cab_window){ 0 };
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
static void fit_side(struct cab *cab)
{
    const struct placed *p = &cab->window.compose.placed;

    cab->window.has_side = false;
    if (!p->side.w)
        return;
    if (cab->window.side.w != p->side_w || cab->window.side.h != p->side_h) {
        free(cab->window.side_memory);
        cab->window.side = (struct fb){ 0 };
        cab->window.side_memory = malloc(fb_size(p->side_w, p->side_h));
        if (!cab->window.side_memory)
            return;
        fb_init(&cab->window.side, cab->window.side_memory, p->side_w, p->side_h);
    }
    cab->window.has_side = true;
}

void cab_window_begin(struct cab *cab, int w, int h)
{
    const struct config *c = &cab->config;
    struct plat_window host = { 0 };
    const bool known = plat_get_window(&host);

    cab->window.refresh = known && host.vsync ? host.refresh_rate : 0;
    cab->window.composes = cab->window.has_side = false;
    if (!known || cab->window.cannot)
        return;
    if (c->border)
        read_border(cab);
    const struct compose_want want = { .place = { host.w, host.h, w, h, (enum quarter)c->turn,
                                                  c->scaling == SCALING_SMOOTH, c->panels == PANELS_BESIDE },
                                       .crt = c->crt,
                                       .border = c->border && cab->window.border.rgba ? &cab->window.border : NULL };
    if (!must_compose(&want))
        return;
    cab->window.composes = compose_fit(&cab->window.compose, &want);
    cab->window.cannot = !cab->window.composes;
    if (cab->window.composes)
        fit_side(cab);
}

struct fb *cab_window_side(struct cab *cab)
{
    return cab->window.has_side ? &cab->window.side : NULL;
}

/* ---- showing ---- */

static bool show_composed(struct cab *cab, const struct fb *fb, const uint32_t rgb[256], bool side)
{
    struct compose *c = &cab->window.compose;

    compose_picture(c, fb->pix, fb->pitch, rgb);
    compose_side(c, side ? cab->window.side.pix : NULL, cab->window.side.pitch, rgb);
    cab->window.handed = plat_usec();
    return plat_paint(c->pixels, c->w, c->w, c->h);
}

/* Room for a turned picture; NULL: there is none. */
static uint8_t *room_to_turn(struct cab *cab, size_t size)
{
    if (size > cab->window.turned_room) {
        free(cab->window.turned);
        cab->window.turned = malloc(size);
        cab->window.turned_room = cab->window.turned ? size : 0;
    }
    return cab->window.turned;
}

static void show_plain(struct cab *cab, const struct fb *fb, const uint32_t rgb[256])
{
    const enum quarter turn = (enum quarter)cab->config.turn;
    uint8_t *turned = turn ? room_to_turn(cab, (size_t)fb->w * (size_t)fb->h) : NULL;
    int w = fb->w, h = fb->h;

    cab->window.shown_turn = turned ? turn : QUARTER_NONE;
    if (!turned) {
        cab->window.handed = plat_usec();
        plat_show(fb->pix, fb->pitch, w, h, rgb);
        return;
    }
    quarter_size(turn, &w, &h);
    quarter_picture(turn, fb->pix, fb->pitch, fb->w, fb->h, turned, w);
    cab->window.handed = plat_usec();
    plat_show(turned, w, w, h, rgb);
}

void cab_window_show(struct cab *cab, const struct fb *fb, const uint32_t rgb[256], bool side)
{
    cab->window.w = fb->w;
    cab->window.h = fb->h;
    cab->window.composed = cab->window.composes && show_composed(cab, fb, rgb, side && cab->window.has_side);
    if (cab->window.composed)
        return;
    cab->window.cannot = cab->window.cannot || cab->window.composes; /* until the window is another */
    show_plain(cab, fb, rgb);
}

void cab_window_mouse(struct cab *cab, int *x, int *y)
{
    int w = cab->window.w, h = cab->window.h;

    if (*x < 0 || *y < 0 || !w)
        return;
    if (cab->window.composed) {
        if (!compose_point(&cab->window.compose, x, y))
            *x = *y = -1;
        return;
    }
    quarter_size(cab->window.shown_turn, &w, &h);
    quarter_point(quarter_back(cab->window.shown_turn), w, h, x, y);
}
