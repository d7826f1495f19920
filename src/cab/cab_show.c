/*
 * cab_show.c - the window: the board's picture, and over a copy of it words, bar of time, panels, console or menu.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "cab_parts.h"
#include "files.h"
#include "message.h"
#include "png.h"
#include "timebar.h"

/* ---- the window, and the picture ---- */

bool cab_picture_open(struct picture *p, const struct board *b)
{
    int w, h;
    board_screen(b, &w, &h);
    p->memory = calloc(2, fb_size(w, h));
    p->scratch = malloc(board_scratch(b) + 1);
    if (!p->memory || !p->scratch)
        return false;
    fb_init(&p->fb, p->memory, w, h);
    fb_init(&p->over, (char *)p->memory + fb_size(w, h), w, h);
    return true;
}

void cab_picture_close(struct picture *p)
{
    free(p->memory);
    free(p->scratch);
    *p = (struct picture){ 0 };
}

bool cab_open_window(void)
{
    const struct manifest *m = &cab_cart()->m;

    cab.want.w = m->screen_w;
    cab.want.h = m->screen_h;
    snprintf(cab.title, sizeof cab.title, "%s", m->title); /* the manifest may go */
    cab.want.title = cab.title;
    return plat_open(&cab.want);
}

void cab_picture_draw(struct picture *p)
{
    const struct board *b = cab.attracting ? cab.shown.board : cab_live();
    if (cab.attracting || !cab_fault())
        board_draw(b, &p->fb, p->rgb, p->scratch);
}

static struct ink picture_copy(struct picture *p)
{
    struct ink ink;

    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->over.pix + y * p->over.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->over_rgb, p->rgb, sizeof p->rgb);
    ink_open(&ink, &p->over, p->over_rgb);
    return ink;
}

/* ---- over it ---- */

/* What we have to say over the picture; "": nothing. */
static void words(char *text, size_t size)
{
    const struct board_fault *f = cab_fault();
    uint32_t at = board_frame(cab_live());

    text[0] = 0;
    if (cab.session.way != SESSION_THERE)
        snprintf(text, size, "%s %d%%", cab.session.way == SESSION_SEEKS ? "seeking" : "reloading",
                 session_progress(&cab.session) / 10);
    else if (cab.ask.open)
        snprintf(text, size, "go to frame %s_", cab.ask.digits);
    else if (cab.notice_left)
        snprintf(text, size, "%s", cab.notice);
    else if (f)
        snprintf(text, size, "%s\n\n%s", f->message, f->trace);
    else if (cab.rewinding)
        snprintf(text, size, "rewind  frame %u", (unsigned)at);
    else if (cab.paused)
        snprintf(text, size, "paused at frame %u", (unsigned)at);
    else if (cab.slow > 1)
        snprintf(text, size, "1/%d speed  frame %u", cab.slow, (unsigned)at);
}

bool cab_bar_shown(void)
{
    return !cab.attracting && (cab.ask.open || cab.rewinding || cab.bar > 0 || (cab.session.demo && cab.paused));
}

static void progress_draw(const struct ink *ink)
{
    int w = ink->fb->w, done = (int)((int64_t)w * session_progress(&cab.session) / 1000);

    ink_rect(ink, 0, INK_CELL_H + 1, w, 2, INK_GREY);
    ink_rect(ink, 0, INK_CELL_H + 1, done, 2, INK_GREEN);
}

void cab_picture_show(struct picture *p)
{
    char text[sizeof((struct board_fault *)0)->message + sizeof((struct board_fault *)0)->trace + 4];

    if (cab.practice.open) {
        struct ink ink = picture_copy(p);
        practice_draw(&cab.practice, &ink);
        plat_show(p->over.pix, p->over.pitch, p->over.w, p->over.h, p->over_rgb);
        return;
    }
    words(text, sizeof text);
    if (!text[0] && !cab_bar_shown() && !cab.console.open && !overlay_on(&cab.overlay)) {
        plat_show(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb);
        return;
    }
    struct ink ink = picture_copy(p);
    int y0 = text[0] ? message_draw(&ink, 0, text) : 0, y1 = console_draw(&cab.console, &ink);
    overlay_draw(&cab.overlay, &ink, y0, cab_bar_shown() && !cab.console.open ? y1 - TIMEBAR_H : y1,
                 cab.attracting ? cab.shown.board : cab_live(), cab.mouse_x, cab.mouse_y);
    if (cab.session.way != SESSION_THERE)
        progress_draw(&ink);
    if (cab_bar_shown() && !cab.console.open)
        timebar_draw(&ink, &cab.session);
    plat_show(p->over.pix, p->over.pitch, p->over.w, p->over.h, p->over_rgb);
}

void cab_screenshot(const struct picture *p)
{
    char name[CAB_NAME];
    char err[CAB_NAME + 128];
    uint8_t *png;
    size_t size;

    cab_free_name(name, "png");
    if (!png_write(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb, &png, &size)) {
        plat_log("curtain: no memory for a screenshot");
        return;
    }
    bool good = files_save(name, png, size, err, sizeof err);
    cab_say(good ? "wrote %s%s" : "curtain: %s%s", good ? name : err, "");
    free(png);
}
