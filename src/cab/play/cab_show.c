/*
 * cab_show.c - the board's picture, and over a copy of it, or beside it, the message, time bar, panels, console or
 * menu.
 *
 * What is over the picture stands at its bottom, for scores stand at the top of most games.
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

/* ---- the picture ---- */

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

void cab_picture_draw(struct picture *p)
{
    const struct board *b = cab.attracting ? cab.attract_guard.board : cab_live();
    if (cab.attracting || !cab_fault())
        board_draw(b, &p->fb, p->rgb, p->scratch);
}

/* Only where the next tick is the player's own, and nothing asks what stands there now. */
void cab_look_ahead(void)
{
    const bool own = cab.ticked && !cab.session.demo && !cab.attracting && !cab.paused && !cab.rewinding &&
                     cab.slow == 1 && cab.session.state == SESSION_PLAYING;

    if (cab.config.run_ahead && own && !cab.practice.open && !cab.console.open && !cab.quit && !cab_fault())
        ahead_begin(&cab.ahead, &cab.session.now->guard, cab.last_pads);
    cab.picture.ahead = cab.ahead.on;
}

void cab_look_back(void)
{
    ahead_end(&cab.ahead, &cab.session.now->guard);
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

static void draw_progress(const struct canvas *canvas, int y)
{
    int w = canvas->fb->w, done = (int)((int64_t)w * session_progress(&cab.session) / 1000);

    canvas_rect(canvas, 0, y, w, 2, CANVAS_GREY);
    canvas_rect(canvas, 0, y, done, 2, CANVAS_GREEN);
}

/* What is over the picture, or beside it: the texts, and where there is room for them. */
struct over {
    char text[sizeof((struct board_fault *)0)->message + sizeof((struct board_fault *)0)->trace + 4], hint[160];
    struct canvas picture, beside; /* beside.fb NULL: all of it is over the picture */
    int y0, y1;                    /* rows that are free for panels */
};

static bool anything(const struct over *o)
{
    return o->text[0] || o->hint[0] || cab_timebar_shown() || cab.console.open || overlay_on(&cab.overlay);
}

static struct canvas side_canvas(const struct canvas *picture)
{
    struct canvas side = *picture;

    side.fb = cab_window_side();
    if (!side.fb)
        return side;
    fb_clip_all(side.fb);
    fb_fill(side.fb, side.colour[CANVAS_DARK]);
    return side;
}

/* From the bottom upwards: the console or the time bar, the message above it. */
static void draw_over(struct over *o)
{
    const struct canvas *canvas = &o->picture;
    const bool bar = cab_timebar_shown() && !cab.console.open;

    o->y1 = console_draw(&cab.console, canvas) - (bar ? TIMEBAR_H : 0);
    if (o->text[0])
        o->y1 = message_draw_above(canvas, o->y1, o->text);
    if (cab.session.state != SESSION_PLAYING)
        draw_progress(canvas, o->y1 -= 2);
    if (o->hint[0] && !cab.console.open && !bar)
        draw_hint(canvas, o->hint);
}

/* The message at the top, the console at the bottom, panels between them. */
static void draw_beside(struct over *o)
{
    const struct canvas *canvas = &o->beside;

    o->y1 = console_draw(&cab.console, canvas);
    o->y0 = o->text[0] ? message_draw(canvas, 0, o->text) : o->hint[0] ? message_draw(canvas, 0, o->hint) : 0;
    if (cab.session.state != SESSION_PLAYING) {
        draw_progress(canvas, o->y0 + 1);
        o->y0 += 3;
    }
}

static void show_over(struct picture *p, struct over *o)
{
    o->picture = copy_picture(p);
    o->beside = side_canvas(&o->picture);
    if (o->beside.fb)
        draw_beside(o);
    else
        draw_over(o);
    const struct overlay_place place = { &o->picture, o->beside.fb ? &o->beside : NULL, o->y0, o->y1 };
    overlay_draw(&cab.overlay, &place, cab.attracting ? cab.attract_guard.board : cab_live(), cab.mouse_x, cab.mouse_y);
    if (cab_timebar_shown() && (o->beside.fb || !cab.console.open))
        timebar_draw(&o->picture, &cab.session);
    cab_window_show(&p->composed, p->composed_rgb, true);
}

void cab_picture_show(struct picture *p)
{
    struct over o = { .y0 = 0 };

    cab_window_begin(p->fb.w, p->fb.h);
    if (cab.practice.open) {
        struct canvas canvas = copy_picture(p);
        practice_draw(&cab.practice, &canvas);
        cab_window_show(&p->composed, p->composed_rgb, false);
        return;
    }
    message_text(o.text, sizeof o.text);
    hint_text(o.text, o.hint, sizeof o.hint);
    if (anything(&o))
        show_over(p, &o);
    else
        cab_window_show(&p->fb, p->rgb, false);
}

void cab_screenshot(struct picture *p)
{
    char name[CAB_NAME];
    char err[CAB_NAME + 128];
    uint8_t *png;
    size_t size;

    if (p->ahead) /* what is saved has been */
        cab_picture_draw(p);
    cab_free_name(name, "png");
    if (!png_write(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb, &png, &size)) {
        plat_log("curtain: no memory for a screenshot");
        return;
    }
    bool good = files_save(name, png, size, err, sizeof err);
    cab_say(good ? "wrote %s" : "curtain: %s", good ? name : err);
    free(png);
}
