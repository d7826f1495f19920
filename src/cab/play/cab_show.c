/*
 * cab_show.c - the window: the board's picture, and over a copy of it the message, time bar, panels, console or menu.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../host/files.h"
#include "../overlay/message.h"
#include "../pack/png.h"
#include "timebar.h"

enum { BLINK = 20 }; /* frames; PRESS START is there for two of three */

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
    fb_init(&p->composed, (char *)p->memory + fb_size(w, h), w, h);
    return true;
}

void cab_picture_close(struct picture *p)
{
    free(p->memory);
    free(p->scratch);
    *p = (struct picture){ 0 };
}

int cab_sound_rate(void)
{
    return board_has_sound(cab_live()) && (!cab.speaker.muted || cab.want.rate) ? SPEAKER_RATE : 0;
}

bool cab_open_window(void)
{
    const struct manifest *m = &cab_cart()->m;

    cab.want.rate = cab_sound_rate();
    cab.want.w = m->screen_w;
    cab.want.h = m->screen_h;
    snprintf(cab.title, sizeof cab.title, "%s", m->title); /* the manifest may go */
    cab.want.title = cab.title;
    return plat_open(&cab.want);
}

void cab_picture_draw(struct picture *p)
{
    const struct board *b = cab.attracting ? cab.attract_guard.board : cab_live();
    if (cab.attracting || !cab_fault())
        board_draw(b, &p->fb, p->rgb, p->scratch);
}

static struct canvas copy_picture(struct picture *p)
{
    struct canvas canvas;

    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->composed.pix + y * p->composed.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->composed_rgb, p->rgb, sizeof p->rgb);
    canvas_open(&canvas, &p->composed, p->composed_rgb);
    return canvas;
}

/* ---- the overlay ---- */

/* The message over the picture; "": none. */
static void message_text(char *text, size_t size)
{
    const struct board_fault *f = cab_fault();
    uint32_t at = board_frame(cab_live());

    text[0] = 0;
    if (cab.session.state != SESSION_PLAYING)
        snprintf(text, size, "%s %d%%", cab.session.state == SESSION_SEEKING ? "seeking" : "reloading",
                 session_progress(&cab.session) / 10);
    else if (cab.prompt.open)
        snprintf(text, size, "go to frame %s_", cab.prompt.digits);
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

/* What a player who has just come presses: below a menu before a game, and below a demo. "": neither is there, or there
 * is a message. */
static void hint_text(const char *message, char *text, size_t size)
{
    char start[32], fire[32], bomb[32];

    text[0] = 0;
    if (message[0] || (!cab.attracting && (!board_last(cab_live())->menu || cab.session.demo)))
        return;
    keys_first(&cab.config.keys, "p1.start", start, sizeof start);
    keys_first(&cab.config.keys, "p1.fire", fire, sizeof fire);
    keys_first(&cab.config.keys, "p1.bomb", bomb, sizeof bomb);
    if (!cab.attracting)
        snprintf(text, size, "START is %s  fire is %s  bomb is %s", start, fire, bomb);
    else if (cab.frames / BLINK % 3)
        snprintf(text, size, "PRESS START (%s)", start);
}

static void draw_hint(const struct canvas *canvas, const char *text)
{
    const int w = canvas->fb->w, y = canvas->fb->h - CANVAS_CELL_H;

    canvas_rect(canvas, 0, y - 1, w, CANVAS_CELL_H + 1, CANVAS_DARK);
    canvas_text(canvas, (w - canvas_width(text)) / 2, y, CANVAS_WHITE, text);
}

bool cab_timebar_shown(void)
{
    return !cab.attracting &&
           (cab.prompt.open || cab.rewinding || cab.timebar_left > 0 || (cab.session.demo && cab.paused));
}

static void draw_progress(const struct canvas *canvas)
{
    int w = canvas->fb->w, done = (int)((int64_t)w * session_progress(&cab.session) / 1000);

    canvas_rect(canvas, 0, CANVAS_CELL_H + 1, w, 2, CANVAS_GREY);
    canvas_rect(canvas, 0, CANVAS_CELL_H + 1, done, 2, CANVAS_GREEN);
}

void cab_picture_show(struct picture *p)
{
    char text[sizeof((struct board_fault *)0)->message + sizeof((struct board_fault *)0)->trace + 4], hint[160];

    if (cab.practice.open || screens_are_open(&cab.screens)) {
        struct canvas canvas = copy_picture(p);
        cab_screens_foot(hint, sizeof hint);
        if (cab.practice.open)
            practice_draw(&cab.practice, &canvas);
        else
            screens_draw(&cab.screens, &canvas, hint);
        plat_show(p->composed.pix, p->composed.pitch, p->composed.w, p->composed.h, p->composed_rgb);
        return;
    }
    message_text(text, sizeof text);
    hint_text(text, hint, sizeof hint);
    if (!text[0] && !hint[0] && !cab_timebar_shown() && !cab.console.open && !overlay_on(&cab.overlay)) {
        plat_show(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb);
        return;
    }
    struct canvas canvas = copy_picture(p);
    int y0 = text[0] ? message_draw(&canvas, 0, text) : 0, y1 = console_draw(&cab.console, &canvas);
    overlay_draw(&cab.overlay, &canvas, y0, cab_timebar_shown() && !cab.console.open ? y1 - TIMEBAR_H : y1,
                 cab.attracting ? cab.attract_guard.board : cab_live(), cab.mouse_x, cab.mouse_y);
    if (cab.session.state != SESSION_PLAYING)
        draw_progress(&canvas);
    if (hint[0] && !cab.console.open && !cab_timebar_shown())
        draw_hint(&canvas, hint);
    if (cab_timebar_shown() && !cab.console.open)
        timebar_draw(&canvas, &cab.session);
    plat_show(p->composed.pix, p->composed.pitch, p->composed.w, p->composed.h, p->composed_rgb);
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
    cab_say(good ? "wrote %s" : "curtain: %s", good ? name : err);
    free(png);
}
